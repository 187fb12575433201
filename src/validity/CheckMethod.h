#ifndef OMPL_CERTIFICATES_VALIDITY_CHECK_METHOD_
#define OMPL_CERTIFICATES_VALIDITY_CHECK_METHOD_

#include "CheckContext.h"

#include "certificates/PoseQuery.h"

#include "ompl_certificates/obstacles/ObstacleChange.h"

#include <cstddef>
#include <vector>

namespace ompl_certificates
{
    /** \brief What poses are to be settled for: a state, or a sample of a motion */
    struct MotionSample
    {
        /** \brief Whether the bodies move, as fast as CheckContext::motionBounds says */
        bool moves{false};

        /** \brief For how long robots must be proved free to count as free, or 0; see PoseQuery::requiredInterval */
        double requiredInterval{0.0};

        /** \brief How many samples a proof for all of the motion probably spares, if this one lies between free ends; else 0 */
        double samplesAhead{0.0};
    };

    /** \brief Settles all robots of a team together */
    class TeamMethod
    {
    public:
        virtual ~TeamMethod() = default;

        /** \brief Settle all robots; see CheckMethod::settleRobot() */
        virtual PoseVerdict settleTeam(CheckContext &context, const MotionSample &sample) const = 0;

        /** \brief For how long the hints prove all robots free; 0 if they do not */
        virtual double provenTeamInterval(const CheckContext &context) const = 0;
    };

    /** \brief How robots are settled against the obstacles, and what is remembered of these: the strategy behind a Method */
    class CheckMethod
    {
    public:
        CheckMethod() = default;
        virtual ~CheckMethod() = default;

        CheckMethod(const CheckMethod &) = delete;
        CheckMethod &operator=(const CheckMethod &) = delete;

        /** \brief Settle a robot whose poses are in \e context, by its hints first; leaves better hints and counts there */
        virtual PoseVerdict settleRobot(unsigned int robot, CheckContext &context,
                                        const MotionSample &sample) const = 0;

        /** \brief For how long its hints prove a robot free; 0 if they do not. Looks no further. */
        virtual double provenInterval(unsigned int /*robot*/, const CheckContext & /*context*/) const
        {
            return 0.0;
        }

        /** \brief The same for a team as a whole, or null if the robots are to be settled one by one */
        virtual const TeamMethod *getTeamMethod() const
        {
            return nullptr;
        }

        /** \brief Forget all. Not while others use the method. */
        virtual void clear() = 0;

        /** \brief Take other obstacles, and repair what is known. Not while others use the method. */
        virtual void change(const ObstacleChange &change) = 0;

        /** \brief See TeamValidityChecker::setAdaptive() */
        virtual void setAdaptive(bool /*adaptive*/)
        {
        }

        /** \brief The number of certificates */
        virtual std::size_t getCertificateCount() const
        {
            return 0;
        }

        /** \brief All certificates */
        virtual std::vector<Certificate> getCertificates() const
        {
            return {};
        }

        /** \brief Add certificates that are true of the obstacles
            \return false if the method keeps no single certificates */
        virtual bool addCertificates(const std::vector<Certificate> & /*certificates*/)
        {
            return false;
        }

    protected:
        /** \brief What a body is asked of its environment; \e body counts within the robot */
        static PoseQuery queryOf(unsigned int robot, std::size_t body, const CheckContext &context,
                                 const MotionSample &sample)
        {
            const std::size_t index = context.team.getFirstBody(robot) + body;
            return {context.team.getRobot(robot).getBodies()[body], context.poses[index],
                    sample.moves ? &context.motionBounds[index] : nullptr, sample.requiredInterval,
                    sample.samplesAhead};
        }
    };
}

#endif
