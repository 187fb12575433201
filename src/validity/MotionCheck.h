#ifndef OMPL_CERTIFICATES_VALIDITY_MOTION_CHECK_
#define OMPL_CERTIFICATES_VALIDITY_MOTION_CHECK_

#include "MotionScratch.h"

#include "ompl_certificates/validity/CertificateChecker.h"

namespace ompl_certificates
{
    /** \brief The check of one motion. Its subjects, the groups of robots and the pairs of robots, are proved free one by one:
        at some time a subject is settled, and the verdict's reach proves it free for a while around.

        Derived classes say what it takes for a motion to be free. */
    class MotionCheck
    {
    public:
        /** \brief What the check counted */
        const CheckCounts &getCounts();

    protected:
        /** \brief The check of the motion from \e s1 to \e s2 */
        MotionCheck(const CertificateChecker &checker, MotionScratch &scratch, const ompl::base::State *s1,
                    const ompl::base::State *s2);

        /** \brief The number of subjects: groups first, then pairs */
        unsigned int subjectCount() const
        {
            return groups_ + checker_.getPairs().getPairCount();
        }

        /** \brief Settle a subject at time \e t
            \param requiredInterval see PoseQuery::requiredInterval
            \param samplesAhead see PoseQuery::samplesAhead */
        PoseVerdict settle(unsigned int subject, double t, double requiredInterval, double samplesAhead);

        /** \brief Begin with the certificates that \e state refers to; with those of \e other for a robot that has none */
        void takeReferences(const TeamStateSpace::StateType *state, const TeamStateSpace::StateType *other);

        /** \brief Let \e state refer to the certificates found last */
        void giveReferences(const TeamStateSpace::StateType *state) const;

        /** \brief Have the poses of a robot's bodies at time \e t in the scratch; at first, how fast they move, too */
        void pose(unsigned int robot, double t);

        /** \brief Note that samples of a subject need not be looked at */
        void skip(unsigned int subject, int samples)
        {
            counts_.motionSamplesSkipped += static_cast<std::uint64_t>(samples) * robotsOf(subject);
        }

        const CertificateChecker &checker_;
        MotionScratch &scratch_;
        const TeamStateSpace::StateType *s1_, *s2_;

        /** \brief Where the motion is interpolated from and to: \e s1_ and \e s2_, or the other way round. Times are those
            of this interpolation. */
        const TeamStateSpace::StateType *from_, *to_;

        const unsigned int groups_;
        CheckCounts counts_;

        /** \brief Intervals overlap by this fraction, which pays for the rounding of times */
        static constexpr double OVERLAP = 1e-9;

    private:
        /** \brief How many robots' samples a sample of the subject stands for; a pair's are not counted */
        unsigned int robotsOf(unsigned int subject) const;
    };
}

#endif
