#include "SampledMotionCheck.h"

#include <algorithm>

namespace ompl_certificates
{
    SampledMotionCheck::SampledMotionCheck(const TeamCheck &check, CheckContext &context, const ompl::base::State *s1,
                                           const ompl::base::State *s2)
      : check_(check), context_(context), s1_(s1), s2_(s2)
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

    bool SampledMotionCheck::isSampleFree(int sample)
    {
        check_.getTeam().getStateSpace()->interpolate(s1_, s2_, static_cast<double>(sample) / segments_,
                                                      context_.sample);
        return check_.isFree(context_.sample, context_);
    }

    bool SampledMotionCheck::isFree()
    {
        if (!check_.isFree(s2_, context_))
            return false;
        auto &queue = context_.open;
        queue.clear();
        if (countSegments() > 1)
            queue.push_back({0, 1, segments_ - 1});
        for (std::size_t next = 0; next < queue.size(); ++next)
        {
            const auto [subject, first, last] = queue[next];
            const int middle = (first + last) / 2;
            if (!isSampleFree(middle))
                return false;
            if (first < middle)
                queue.push_back({0, first, middle - 1});
            if (last > middle)
                queue.push_back({0, middle + 1, last});
        }
        return true;
    }

    bool SampledMotionCheck::isFree(double &free)
    {
        const int end = std::max(countSegments(), 1);
        int invalid = 1;
        while (invalid < end && isSampleFree(invalid))
            ++invalid;
        if (invalid == end && check_.isFree(s2_, context_))
            return true;
        free = static_cast<double>(invalid - 1) / end;
        return false;
    }
}
