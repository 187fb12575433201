#include "RobotPairs.h"

namespace ompl_certificates
{
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
        const std::size_t likely = context.lastCollidingPair[pair];
        for (std::size_t k = 0; k < all.size(); ++k)
        {
            const std::size_t i = CheckContext::inOrder(k, likely), number = firstBodyPairs_[pair] + i;
            if (contains(context.batch.nearEachOther[number], sample) && !isApart(all[i], number))
            {
                context.lastCollidingPair[pair] = i;
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
            const auto answer = bodies.cells ? bodies.cells->settle(context) : JointCells::Answer::OPEN;
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
