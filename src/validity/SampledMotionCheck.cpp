#include "SampledMotionCheck.h"

#include "DiscreteMotionCheck.h"
#include "SampleOrder.h"

#include <algorithm>

namespace ompl_certificates
{
    namespace
    {
        /** A motion of so many segments is long. If so many of its samples are free, the others probably are, and most
            can be skipped. */
        constexpr int LONG_MOTION = 128;
        constexpr std::size_t FIRST_SAMPLES = 31;
    }

    SampledMotionCheck::SampledMotionCheck(const TeamCheck &check, CheckContext &context, const ompl::base::State *s1,
                                           const ompl::base::State *s2, bool exactly)
      : check_(check), context_(context), s1_(s1), s2_(s2), exactly_(exactly)
    {
        ++context_.counts.motions;
    }

    SampledMotionCheck::~SampledMotionCheck()
    {
        context_.counts.motionSamples = context_.counts.robotPoses + context_.counts.motionSamplesSkipped;
    }

    int SampledMotionCheck::countSegments()
    {
        segments_ = static_cast<int>(check_.getTeam().getStateSpace()->validSegmentCount(s1_, s2_));
        return segments_;
    }

    bool SampledMotionCheck::isStateFree(const ompl::base::State *state) const
    {
        return exactly_ ? check_.isExactlyFree(state, context_) : check_.isFreeByMethod(state, context_);
    }

    bool SampledMotionCheck::isSampleFree(int sample) const
    {
        check_.getTeam().getStateSpace()->interpolate(s1_, s2_, static_cast<double>(sample) / segments_,
                                                      context_.sample);
        return isStateFree(context_.sample);
    }

    bool SampledMotionCheck::isFree()
    {
        if (!isStateFree(s2_))
            return false;
        BreadthFirstSamples samples(context_.openSamples, countSegments());
        const auto isFreeAt = [this](int sample) { return isSampleFree(sample); };
        if (!exactly_ || segments_ < LONG_MOTION || !check_.getTeam().interpolatesRobots())
            return samples.areFree(isFreeAt);
        return samples.areFree(FIRST_SAMPLES, isFreeAt) && isRestFree([&] { return samples.areFree(isFreeAt); });
    }

    template <typename Exact>
    bool SampledMotionCheck::isRestFree(const Exact &exact)
    {
        const auto certified = [this]
        {
            CheckCounts &counts = context_.counts;
            const CheckCounts before = counts;
            const bool free = DiscreteMotionCheck(check_, context_, s1_, s2_).isFree();
            // It begins anew. What was checked before is not counted twice.
            counts.motions = before.motions;
            counts.motionSamplesSkipped -= std::min(counts.motionSamplesSkipped, before.robotPoses);
            return free;
        };
        return check_.decide(context_.longMotionPolicy, context_, 0, certified, exact);
    }

    bool SampledMotionCheck::isFree(double &free)
    {
        const int end = std::max(countSegments(), 1);
        int invalid = 1;
        while (invalid < end && isSampleFree(invalid))
            ++invalid;
        if (invalid == end && isStateFree(s2_))
            return true;
        free = static_cast<double>(invalid - 1) / end;
        return false;
    }
}
