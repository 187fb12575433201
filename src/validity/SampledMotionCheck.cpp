#include "SampledMotionCheck.h"

#include "SampleOrder.h"

#include <algorithm>

namespace ompl_certificates
{
    SampledMotionCheck::SampledMotionCheck(const TeamCheck &check, CheckContext &context, const ompl::base::State *s1,
                                           const ompl::base::State *s2, bool exactly)
      : check_(check), context_(context), s1_(s1), s2_(s2), exactly_(exactly)
    {
        ++context_.counts.motions;
    }

    SampledMotionCheck::~SampledMotionCheck()
    {
        context_.counts.motionSamples = context_.counts.robotPoses;
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
        return isStateFree(s2_) &&
               areFreeBreadthFirst(context_.open, countSegments(), [this](int sample) { return isSampleFree(sample); });
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
