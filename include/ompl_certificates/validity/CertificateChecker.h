#ifndef OMPL_CERTIFICATES_VALIDITY_CERTIFICATE_CHECKER_
#define OMPL_CERTIFICATES_VALIDITY_CERTIFICATE_CHECKER_

#include "ompl_certificates/validity/TeamValidityChecker.h"

#include <ompl/base/GenericParam.h>

namespace ompl_certificates
{
    /** \brief A validity checker that remembers clearances and checks only what they do not settle. Its verdicts are those of
        TeamValidityChecker.

        The robots are settled in groups: each for itself, or all together in the Basic method. Derived classes say where
        a group's certificates are looked up and kept; isValid() and CertificateMotionValidator do the rest.

        @par External documentation
        J. Bialkowski, M. Otte, E. Frazzoli, Fast Collision Checking: From Single Robots to Multi-Robot Teams, 2013,
        section II. */
    class CertificateChecker : public TeamValidityChecker
    {
    public:
        /** \brief See TeamValidityChecker::TeamValidityChecker() */
        CertificateChecker(const ompl::base::SpaceInformationPtr &si, const ObstaclesPtr &obstacles);

        /** \brief Whether no robot of the team touches an obstacle or another robot */
        bool isValid(const ompl::base::State *state) const override;

        using TeamValidityChecker::isValid;

        /** \brief Forget all certificates; references in states become stale, which costs time but changes no verdict. Not
            while others use the checker. */
        virtual void clear();

        /** \brief The parameters of the checker, for programs that set them by name: max_certificates and adaptive */
        ompl::base::ParamSet &params()
        {
            return params_;
        }

        /** \brief Keep no more than \e most certificates, of obstacles and of pairs of robots together; by default as many
            as come. When they are that many, no more are added, and poses that they do not settle are checked each time.
            Those that are there already stay until clear(). */
        void setMaxCertificates(std::size_t most)
        {
            limit_->setMost(most);
        }

        /** \brief How many certificates may be kept */
        std::size_t getMaxCertificates() const
        {
            return limit_->getMost();
        }

        /** \brief How many certificates are kept, of obstacles and of pairs of robots together */
        std::size_t getKeptCertificates() const
        {
            return limit_->getCount();
        }

        /** \brief Whether certificates and clearances are passed over where they have not paid lately, as by default; see
            SwitchingPolicy. If not, all are tried for every pose, so that what is counted depends on the states alone and
            not on the clock: for experiments that must repeat themselves. No verdict depends on it. Not while others use
            the checker. */
        void setAdaptive(bool adaptive)
        {
            adaptive_ = adaptive;
            pairs_.setAdaptive(adaptive);
        }

        /** \brief Whether what does not pay is passed over; see setAdaptive() */
        bool isAdaptive() const
        {
            return adaptive_;
        }

        /** \brief The number of certificates kept for the obstacles' side */
        virtual std::size_t getCertificateCount() const = 0;

        /** \brief All certificates kept for the obstacles' side, for pictures and analysis */
        virtual std::vector<Certificate> getCertificates() const = 0;

        /** \brief Add certificates of these obstacles, such as were made in another run. They must be true.
            \throws ompl::Exception if this method keeps no single certificates, as Basic */
        virtual void addCertificates(const std::vector<Certificate> &certificates);

        /** \brief The motion that the poses to settle are a sample of */
        struct Motion
        {
            /** \brief How fast all bodies of the team move, or null if they do not move */
            const MotionBound *travel{nullptr};

            /** \brief For how long robots must be proved free to count as free, or 0; see PoseQuery::requiredInterval */
            double requiredInterval{0.0};

            /** \brief How many samples a proof for all of the motion probably spares, if this one lies between free ends;
                else 0 */
            double samplesAhead{0.0};
        };

        /** \brief Robots that are settled together: those from \e first to \e last - 1 */
        struct Group
        {
            /** \brief The first robot */
            unsigned int first;

            /** \brief One more than the last robot */
            unsigned int last;
        };

        /** \brief The number of groups */
        virtual unsigned int getGroupCount() const
        {
            return team_.getRobotCount();
        }

        /** \brief The robots of a group */
        virtual Group getGroup(unsigned int group) const
        {
            return {group, group + 1};
        }

        /** \brief Settle the robots of a group against the obstacles.
            \param poses poses of all bodies of the team, of which those of the group are filled in
            \param motion the motion that they are a sample of
            \param references certificates, one for each robot of the team, that may be near; replaced by better ones
            \param counts where to count */
        virtual PoseVerdict settleGroup(unsigned int group, const Pose *poses, const Motion &motion,
                                        CertificateIndex *references, CheckCounts &counts) const = 0;

        /** \brief For how long the certificates referred to prove a group free; 0 if they do not. Looks no further. */
        virtual double intervalOfReferences(unsigned int group, const Pose *poses, const MotionBound *travel,
                                            const CertificateIndex *references) const = 0;

    protected:
        /** \brief What a body is asked of its environment; \e body counts within the robot */
        PoseQuery queryOf(unsigned int robot, std::size_t body, const Pose *poses, const Motion &motion) const
        {
            const std::size_t index = getFirstBody(robot) + body;
            return {team_.getRobot(robot).getBodies()[body], poses[index],
                    motion.travel ? motion.travel + index : nullptr, motion.requiredInterval, motion.samplesAhead};
        }

    private:
        bool adaptive_{true};
        ompl::base::ParamSet params_;
    };
}

#endif
