#include "SampledMotionCheck.h"

#include "BatchCheck.h"
#include "DiscreteMotionCheck.h"

#include <algorithm>
#include <limits>

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
                                           const ompl::base::State *s2, bool byStandard)
      : check_(check)
      , context_(context)
      , s1_(s1)
      , s2_(s2)
      , byStandard_(byStandard)
      , posesBefore_(context.counts.robotPoses)
    {
        ++context_.counts.motions;
        context_.beginCurves();
    }

    SampledMotionCheck::~SampledMotionCheck()
    {
        context_.counts.motionSamples = context_.counts.robotPoses + context_.counts.motionSamplesSkipped;
    }

    int SampledMotionCheck::countSegments()
    {
        const Team &team = check_.getTeam();
        segments_ = static_cast<int>(team.getStateSpace()->validSegmentCount(s1_, s2_));
        if (segments_ == 0)
            team.requireResolution();
        return segments_;
    }

    bool SampledMotionCheck::isStateFree(const ompl::base::State *state) const
    {
        return byStandard_ ? check_.isFreeByStandard(state, context_) : check_.isFreeByMethod(state, context_);
    }

    bool SampledMotionCheck::isSampleFree(int sample) const
    {
        context_.interpolate(s1_, s2_, static_cast<double>(sample) / segments_, context_.sample);
        return isStateFree(context_.sample);
    }

    bool SampledMotionCheck::isFree()
    {
        const bool batched = context_.batch.isPossible() && (byStandard_ || check_.getMethod() == Method::STANDARD);
        if (!batched && !isStateFree(s2_))
            return false;
        BreadthFirstSamples samples(context_.openSamples, countSegments());
        const auto areFree = [&](std::size_t most, bool withEnd)
        {
            return batched ? areBatchesFree(samples, most, withEnd)
                           : samples.areFree(most, [this](int sample) { return isSampleFree(sample); });
        };
        constexpr std::size_t all = std::numeric_limits<std::size_t>::max();
        if (!byStandard_ || segments_ < LONG_MOTION || !check_.getTeam().interpolatesRobots())
            return areFree(all, true);
        return areFree(FIRST_SAMPLES, true) && isRestFree([&] { return areFree(all, false); });
    }

    bool SampledMotionCheck::areBatchesFree(BreadthFirstSamples &samples, std::size_t least, bool withEnd)
    {
        const auto &subjects = check_.getSubjects();
        BatchCheck batches(check_, context_, {subjects.data(), static_cast<unsigned int>(subjects.size())});
        const auto place = [this](int sample, std::size_t number)
        {
            const ompl::base::State *state = s2_;
            if (sample < segments_)
            {
                ompl::base::State *between = context_.batch.teamSamples[number];
                context_.interpolate(s1_, s2_, static_cast<double>(sample) / segments_, between);
                state = between;
            }
            context_.batch.setState(number, state);
        };
        return batches.areFree(samples, least, withEnd, segments_, place);
    }

    template <typename Standard>
    bool SampledMotionCheck::isRestFree(const Standard &standard)
    {
        CheckCounts &counts = context_.counts;
        const std::uint64_t posesOfFirst = counts.robotPoses - posesBefore_;
        const auto certified = [&]
        {
            const CheckCounts before = counts;
            const bool free = DiscreteMotionCheck(check_, context_, s1_, s2_).isFree();
            // It begins anew. What was checked before is not counted twice.
            counts.motions = before.motions;
            counts.motionSamplesSkipped -=
                std::min(counts.motionSamplesSkipped - before.motionSamplesSkipped, posesOfFirst);
            return free;
        };
        return check_.decide(context_.longMotionPolicy, context_, 0, certified, standard);
    }

    bool SampledMotionCheck::isFree(double &freeUntil)
    {
        const int end = std::max(countSegments(), 1);
        int invalid = 1;
        while (invalid < end && isSampleFree(invalid))
            ++invalid;
        if (invalid == end && isStateFree(s2_))
            return true;
        freeUntil = static_cast<double>(invalid - 1) / end;
        return false;
    }
}
