#include "RobotPairs.h"

#include <algorithm>
#include <cstdint>
#include <cstring>

namespace ompl_certificates
{
    namespace
    {
        /** So many masks fill a word. */
        constexpr std::size_t MASKS_AT_ONCE = sizeof(std::uint64_t) / sizeof(BatchMask);

        /** Whether one of up to MASKS_AT_ONCE masks contains a sample. Most pairs are far apart, so that this leaves out
            most masks. */
        bool anyContains(const BatchMask *masks, std::size_t count, std::size_t sample)
        {
            constexpr std::uint64_t firstSamples = 0x0101010101010101;
            static_assert(MASKS_AT_ONCE == 8, "A mask is a byte");
            std::uint64_t word = 0;
            // Where the size is a constant, this is one load.
            if (count == MASKS_AT_ONCE)
                std::memcpy(&word, masks, MASKS_AT_ONCE);
            else
                std::memcpy(&word, masks, count * sizeof(BatchMask));
            return (word & (firstSamples << sample)) != 0;
        }
    }

    void RobotPairs::findNear(unsigned int pair, CheckContext &context) const
    {
        SampleBatch &batch = context.batch;
        BatchMask *near = batch.nearEachOther.data() + firstBodyPairs_[pair];
        const PoseError &one = batch.errors[pairs_[pair].first], &other = batch.errors[pairs_[pair].second];
        for (const TwoBodies &bodies : pairs_[pair].bodies)
        {
            const std::size_t a = bodies.firstIndex, b = bodies.secondIndex;
            const double off = one.at(bodies.first->getBoundingRadius()) + other.at(bodies.second->getBoundingRadius());
            *near = arePointsNear(batch.centers[a], batch.centers[b], bodies.farthest + off);
            // A planar body stands for a prism without end, which its box does not show.
            if (*near != 0 && bodies.first->getDimension() == 3)
                *near &= mayOverlap({bodies.first->getBounds(), batch.poses[a], one},
                                    {bodies.second->getBounds(), batch.poses[b], other}, bodies.margin);
            ++near;
        }
    }

    template <typename IsApart>
    bool RobotPairs::areNearApart(std::size_t sample, unsigned int pair, CheckContext &context,
                                  const IsApart &isApart) const
    {
        const std::vector<TwoBodies> &all = pairs_[pair].bodies;
        const BatchMask *near = context.batch.nearEachOther.data() + firstBodyPairs_[pair];
        std::size_t &likely = context.lastCollidingPair[pair];
        const auto touch = [&](std::size_t i)
        { return contains(near[i], sample) && !isApart(all[i], firstBodyPairs_[pair] + i); };
        if (!all.empty() && touch(likely))
            return false;
        for (std::size_t first = 0; first < all.size(); first += MASKS_AT_ONCE)
        {
            const std::size_t count = std::min(all.size() - first, MASKS_AT_ONCE);
            if (!anyContains(near + first, count, sample))
                continue;
            for (std::size_t i = first; i < first + count; ++i)
                if (i != likely && touch(i))
                {
                    likely = i;
                    return false;
                }
        }
        return true;
    }

    bool RobotPairs::settleNearByCells(std::size_t sample, unsigned int pair, CheckContext &context) const
    {
        ++context.counts.pairPoses;
        const auto mayBeApart = [&](const TwoBodies &bodies, std::size_t number)
        {
            const auto answer = bodies.cells ? bodies.cells->settle(context, number) : JointCells::Answer::OPEN;
            if (answer == JointCells::Answer::APART)
                context.batch.nearEachOther[number] &= static_cast<BatchMask>(~(1U << sample));
            return answer != JointCells::Answer::TOUCHING;
        };
        return areNearApart(sample, pair, context, mayBeApart);
    }

    bool RobotPairs::areApartAt(std::size_t sample, unsigned int pair, CheckContext &context) const
    {
        const auto isApart = [&](const TwoBodies &bodies, std::size_t number)
        {
            // As settleTwo() does, but without the cells, which settleNearByCells() has asked.
            const double gap = bodies.gap(context);
            if (gap > bodies.margin)
                return true;
            return bodies.frame ? settleBodies(bodies, number, context, {}).free : gap > 0.0;
        };
        return areNearApart(sample, pair, context, isApart);
    }
}
