#ifndef OMPL_CERTIFICATES_VALIDITY_CHECK_METHOD_
#define OMPL_CERTIFICATES_VALIDITY_CHECK_METHOD_

#include "CheckContext.h"

#include "certificates/CertificateRepair.h"
#include "certificates/PoseQuery.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace ompl_certificates
{
    /** \brief Why poses are settled: for a single state, or for a sample of a motion */
    struct MotionSample
    {
        /** \brief Whether the bodies move; CheckContext::motionBounds says how fast */
        bool moves{false};

        /** \brief How long a robot must be proved free to count as free, or 0; see PoseQuery::requiredInterval */
        double requiredInterval{0.0};

        /** \brief See PoseQuery::samplesAhead */
        double samplesAhead{0.0};

        /** \brief The time of the motion */
        double time{0.0};

        /** \brief Whether what is known of single bodies at other times of the motion may settle them. In continuous
            mode each time has a verdict of its own. */
        bool usesOtherTimes() const
        {
            return moves && requiredInterval == 0.0;
        }
    };

    /** \brief The answer about all bodies of some robots, at one time of a motion */
    struct SubjectVerdict
    {
        /** \brief Whether they touch nothing */
        bool free{false};

        /** \brief They stay free for so long before that time, and after it */
        double before{0.0}, after{0.0};

        /** \brief Free at all times, until narrow() says otherwise */
        static SubjectVerdict always()
        {
            return {true, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
        }

        /** \brief Takes into account the verdict about one of them */
        void narrow(const SubjectVerdict &one)
        {
            free = free && one.free;
            before = std::min(before, one.before);
            after = std::min(after, one.after);
        }

        /** \brief Takes into account that this, too, was found to be free, and for how long */
        void widen(const PoseVerdict &other)
        {
            if (!other.free)
                return;
            free = true;
            before = std::max(before, other.validInterval);
            after = std::max(after, other.validInterval);
        }

        /** \brief Takes into account that one of them stays free for no longer than this */
        void narrow(double least)
        {
            before = std::min(before, least);
            after = std::min(after, least);
        }

        /** \brief Takes into account that one of them stays free in \e interval, which contains \e time */
        void narrow(const ProvenTimes::Interval &interval, double time)
        {
            before = std::min(before, time - interval.first);
            after = std::min(after, interval.last - time);
        }
    };

    /** \brief Settles all robots of a team at once */
    class TeamMethod
    {
    public:
        virtual ~TeamMethod() = default;

        /** \brief Settles all robots; see CheckMethod::settleRobot() */
        virtual SubjectVerdict settleTeam(CheckContext &context, const MotionSample &sample) const = 0;

        /** \brief How long the hints prove all robots free; 0 if they do not */
        virtual double provenTeamInterval(const CheckContext &context) const = 0;
    };

    /** \brief The strategy behind a Method: settles robots against the obstacles, and keeps certificates of these */
    class CheckMethod
    {
    public:
        CheckMethod() = default;
        virtual ~CheckMethod() = default;

        CheckMethod(const CheckMethod &) = delete;
        CheckMethod &operator=(const CheckMethod &) = delete;

        /** \brief Settles a robot whose poses are in \e context, first by its hints. Updates hints and counts in \e
            context. */
        virtual SubjectVerdict settleRobot(unsigned int robot, CheckContext &context,
                                           const MotionSample &sample) const = 0;

        /** \brief How long its hints prove a robot free after the start of a motion, where its bodies are; 0 if they do
            not. Looks no further. Notes in \e context what it finds of each body. */
        virtual double provenInterval(unsigned int /*robot*/, CheckContext & /*context*/) const
        {
            return 0.0;
        }

        /** \brief The method for the team as a whole; null if robots are settled one by one */
        virtual const TeamMethod *getTeamMethod() const
        {
            return nullptr;
        }

        /** \brief Removes all certificates and measurements. Not while others use the method. */
        virtual void clear() = 0;

        /** \brief The stores of all certificates, for their repair */
        virtual std::vector<CertificateStore *> getStores()
        {
            return {};
        }

        /** \brief Replaces the obstacles, of which all certificates must be true. Not while others use the method. */
        virtual void setObstacles(const ObstaclesPtr &obstacles) = 0;

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

        /** \brief Adds certificates that are true of the obstacles
            \return false if the method keeps no single certificates */
        virtual bool addCertificates(const std::vector<Certificate> & /*certificates*/)
        {
            return false;
        }

    protected:
        /** \brief The verdict about a body that may touch the obstacles, at a pose */
        static PoseVerdict verdictOfUnchecked(const Pose &pose)
        {
            PoseVerdict verdict;
            verdict.free = isFinite(pose);
            verdict.validInterval = verdict.free ? std::numeric_limits<double>::infinity() : 0.0;
            return verdict;
        }

        /** \brief The query about a body of a robot; \e body is its index within the robot */
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
