#ifndef OMPL_CERTIFICATES_VALIDITY_MOTION_CHECK_
#define OMPL_CERTIFICATES_VALIDITY_MOTION_CHECK_

#include "MotionScratch.h"

#include "ompl_certificates/validity/CertificateChecker.h"

namespace ompl_certificates
{
    /** \brief The check of one motion. Its subjects, the groups of robots and the pairs of robots, are proved free one by one:
        at some time a subject is settled, and the verdict's reach proves it free for a while around. */
    class MotionCheck
    {
    public:
        MotionCheck(const CertificateChecker &checker, MotionScratch &scratch, const ompl::base::State *s1,
                    const ompl::base::State *s2);

        /** \brief Whether all samples of the motion, at the resolution of the space, are valid */
        bool areSamplesFree();

        /** \brief The same; if not, \e free is set to the time of the last sample before the first invalid one */
        bool areSamplesFree(double &free);

        /** \brief Whether proofs cover all of the motion */
        bool isWholeFree();

        /** \brief The same; if not, \e free is set to a time up to which they do */
        bool isWholeFree(double &free);

        /** \brief What the check counted */
        const CheckCounts &getCounts();

    private:
        /** \brief The number of subjects: groups first, then pairs */
        unsigned int subjectCount() const
        {
            return groups_ + checker_.getPairs().getPairCount();
        }

        /** \brief How many robots' samples a sample of the subject stands for; a pair's are not counted */
        unsigned int robotsOf(unsigned int subject) const;

        /** \brief Have the poses of a robot's bodies at time \e t in the scratch */
        void pose(unsigned int robot, double t);

        /** \brief Settle a subject at time \e t */
        PoseVerdict settle(unsigned int subject, double t);

        /** \brief Find the number of segments between samples. Not needed where the end of the motion is invalid. */
        void countSegments();

        /** \brief Find how fast all robots move, those too that settleEnd() did not come to */
        void measureTravel();

        /** \brief Settle all subjects at the end of the motion; fills endReach. False if one is not free. */
        bool settleEnd();

        /** \brief Fill startReach with how long the references of the first state prove the subjects free */
        void proveFromStart();

        /** \brief The first and the last sample that neither end of the motion proves free */
        std::pair<int, int> openSamples(unsigned int subject) const;

        /** \brief Whether the samples that openSamples() leaves are free */
        bool areInnerSamplesFree();

        /** \brief How many samples a proof at time \e t probably spares, if it lasts for all of the motion */
        double samplesAhead(double t) const;

        /** \brief How many samples to either side of one are closer in time than \e reach */
        int samplesWithin(double reach) const;

        double timeOf(int sample) const
        {
            return static_cast<double>(sample) / static_cast<double>(segments_);
        }

        void skip(unsigned int subject, int samples);

        const CertificateChecker &checker_;
        MotionScratch &scratch_;
        const TeamStateSpace::StateType *s1_, *s2_;
        const unsigned int groups_;
        int segments_{0};
        double minimumReach_{0.0};
        CheckCounts counts_;
    };
}

#endif
