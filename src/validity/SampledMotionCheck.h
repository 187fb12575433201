#ifndef OMPL_CERTIFICATES_VALIDITY_SAMPLED_MOTION_CHECK_
#define OMPL_CERTIFICATES_VALIDITY_SAMPLED_MOTION_CHECK_

#include "TeamCheck.h"

namespace ompl_certificates
{
    class BreadthFirstSamples;

    /** \brief Checks a motion sample by sample, as the team's space interpolates it. Verdict and order of samples are
        those of ompl::base::DiscreteMotionValidator. For methods without certificates, and for spaces whose motions
        have no motion bounds. Also for motions for which certificates do not pay: there a long motion whose first
        samples are free may still be worth them. */
    class SampledMotionCheck
    {
    public:
        /** \param byStandard whether to check by Method::STANDARD in place of the team's own method */
        SampledMotionCheck(const TeamCheck &check, CheckContext &context, const ompl::base::State *s1,
                           const ompl::base::State *s2, bool byStandard = false);
        ~SampledMotionCheck();

        SampledMotionCheck(const SampledMotionCheck &) = delete;
        SampledMotionCheck &operator=(const SampledMotionCheck &) = delete;

        /** \brief Whether all samples are valid */
        bool isFree();

        /** \brief The same; if not, \e freeUntil is set to the time of the last sample before the first invalid one */
        bool isFree(double &freeUntil);

    private:
        /** \brief Whether all other samples of a long motion are free whose first samples are: by certificates, or by
            \e standard, whichever is quicker */
        template <typename Standard>
        bool isRestFree(const Standard &standard);

        /** \brief Whether the next samples are free, several at once; see BatchCheck::areFree() */
        bool areBatchesFree(BreadthFirstSamples &samples, std::size_t least, bool withEnd);

        int countSegments();
        bool isStateFree(const ompl::base::State *state) const;
        bool isSampleFree(int sample) const;

        const TeamCheck &check_;
        CheckContext &context_;
        const ompl::base::State *s1_, *s2_;
        const bool byStandard_;
        /** \brief The poses counted before this motion */
        const std::uint64_t posesBefore_;
        int segments_{0};
    };
}

#endif
