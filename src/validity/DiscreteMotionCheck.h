#ifndef OMPL_CERTIFICATES_VALIDITY_DISCRETE_MOTION_CHECK_
#define OMPL_CERTIFICATES_VALIDITY_DISCRETE_MOTION_CHECK_

#include "MotionCheck.h"

namespace ompl_certificates
{
    /** \brief Checks whether all samples of a motion are valid, at the resolution of the space: the verdict of
        ompl::base::DiscreteMotionValidator. Skips samples within valid intervals. */
    class DiscreteMotionCheck : public MotionCheck
    {
    public:
        /** \brief Checks the team's motion from \e s1 to \e s2 */
        DiscreteMotionCheck(const TeamCheck &check, CheckContext &context, const ompl::base::State *s1,
                            const ompl::base::State *s2);

        /** \brief Checks some subjects; see MotionCheck */
        DiscreteMotionCheck(const TeamCheck &check, CheckContext &context, const SubjectRange &subjects, States from,
                            States to);

        /** \brief Whether all samples are valid */
        bool isFree();

        /** \brief The same; if not, \e freeUntil is set to the time of the last sample before the first invalid one */
        bool isFree(double &freeUntil);

        /** \brief The same verdict by Method::STANDARD, sample by sample. For motions of some subjects. */
        bool isFreeByStandard();

    private:
        /** \brief Whether the subjects are free at a time, by Method::STANDARD */
        bool isFreeByStandardAt(double time);

        /** \brief Puts the states of all robots at \e time into the batch, as those of a sample */
        void placeInBatch(std::size_t number, double time);

        /** \brief Settles all subjects at the end of the motion and sets endInterval. False if one is not free. */
        bool settleEnd();

        /** \brief Sets startInterval: how long the references of the first state prove the subjects free */
        void proveFromStart();

        /** \brief Settles a subject at an inner sample */
        SubjectVerdict settleSample(unsigned int subject, int sample);

        /** \brief The first and the last sample that neither end of the motion proves free */
        std::pair<int, int> openSamples(unsigned int subject) const;

        /** \brief Whether a few samples of robots of several bodies are free, if the motion probably is not. Proves no
            stretches. */
        bool areFirstSamplesFree();

        /** \brief Whether all samples are free between the ends, which are */
        bool areInnerSamplesFree();

        /** \brief How many samples on either side of one lie within \e interval */
        int samplesWithin(double interval) const;

        /** \brief Stays 0 if settleEnd() fails in isFree() */
        int segments_{0};
    };
}

#endif
