#ifndef OMPL_CERTIFICATES_VALIDITY_MOTION_CHECK_
#define OMPL_CERTIFICATES_VALIDITY_MOTION_CHECK_

#include "TeamCheck.h"

#include <initializer_list>

namespace ompl_certificates
{
    /** \brief The check of one motion. Its subjects are settled one by one at single times. The verdict's valid
        interval proves a subject free around such a time.

        Derived classes define when a motion is free. */
    class MotionCheck
    {
    protected:
        using States = std::initializer_list<const ompl::base::State *>;

        /** \brief Checks the team's motion from \e s1 to \e s2 */
        MotionCheck(const TeamCheck &check, CheckContext &context, const ompl::base::State *s1,
                    const ompl::base::State *s2);

        /** \brief Checks subjects of the same one or two robots, which move \e from \e to states of their own
            spaces */
        MotionCheck(const TeamCheck &check, CheckContext &context, const SubjectRange &subjects, States from,
                    States to);

        ~MotionCheck();

        MotionCheck(const MotionCheck &) = delete;
        MotionCheck &operator=(const MotionCheck &) = delete;

        /** \brief Settles a subject at time \e t
            \param requiredInterval see PoseQuery::requiredInterval
            \param samplesAhead see PoseQuery::samplesAhead */
        SubjectVerdict settle(const Subject &subject, double t, double requiredInterval, double samplesAhead);

        /** \brief The same, of a subject by its number */
        SubjectVerdict settle(unsigned int subject, double t, double requiredInterval, double samplesAhead)
        {
            return settle(subjects_[subject], t, requiredInterval, samplesAhead);
        }

        /** \brief Settles a subject at time \e t and no other. Takes no motion bounds, which cost as much as the test
            of a sample. */
        SubjectVerdict test(unsigned int subject, double t);

        /** \brief Puts the poses of a subject's robots at time \e t into the context; the first time, also their motion
            bounds */
        void pose(const Subject &posed, double t);

        /** \brief The same without motion bounds */
        void place(const Subject &subject, double t);

        /** \brief Takes the hints of \e state; those of \e other for a body that has none */
        void takeReferences(const ompl::base::State *state, const ompl::base::State *other)
        {
            if (state)
                check_.takeReferences(state, other, context_);
        }

        /** \brief Lets \e state refer to the certificates found last */
        void giveReferences(const ompl::base::State *state) const
        {
            if (state)
                check_.giveReferences(state, context_);
        }

        /** \brief Whether all motion bounds are finite. Else nothing proves a stretch of the motion: one of its ends is
            not finite, a robot knows no bound, or the space does not move robots as their own spaces do. */
        bool isBounded();

        /** \brief The number of segments between samples at the resolution of the space */
        unsigned int countSegments() const;

        /** \brief Counts samples of a subject as skipped */
        void skip(unsigned int subject, int samples);

        /** \brief Counts the poses settled so far as ends of the motion */
        void countEnds();

        const TeamCheck &check_;
        CheckContext &context_;

        /** \brief For how large a turn a jump is taken (Robot::getJump()), as a multiple of it: if 1 / n, then whatever
            is proved free for n before and after a time has room for the jump. 0 if jumps prove nothing. */
        double turnsOfJump_{0.0};

        /** \brief The ends of the team's motion; null for that of some subjects */
        const ompl::base::State *const s1_{nullptr}, *const s2_{nullptr};

        const Subject *const subjects_;
        const unsigned int subjectCount_;

        /** \brief See CheckContext::OVERLAP */
        static constexpr double OVERLAP = CheckContext::OVERLAP;

    private:
        void begin();
        void poseRobot(unsigned int robot, double t);
        void computeMotionBounds(unsigned int robot);
        void computePairMotionBounds(unsigned int robot);

        /** \brief The counts before this motion */
        CheckCounts before_;
    };
}

#endif
