#include "TwoBodies.h"

#include <algorithm>

namespace ompl_certificates
{
    // The same arithmetic as in FCL's test of two spheres
    double TwoBodies::gap(const CheckContext &context) const
    {
        const Ball &a = first->getSphereTree().getRoot(), &b = second->getSphereTree().getRoot();
        return (context.poses[firstIndex] * a.center - context.poses[secondIndex] * b.center).norm() -
               (a.radius + b.radius);
    }

    double TwoBodies::speed(const CheckContext &context) const
    {
        const double a = first->getSphereTree().getRoot().center.norm(),
                     b = second->getSphereTree().getRoot().center.norm();
        const double sum = context.motionBounds[firstIndex].at(a) + context.motionBounds[secondIndex].at(b);
        if (ownPair == NOT_OWN || !centersWithin)
            return sum;
        const PairMotionBound &relative = context.pairMotionBounds[robot][ownPair];
        return std::min({sum, relative.first.at(a), relative.second.at(b)});
    }

    MotionBound TwoBodies::relativeMotionBound(const CheckContext &context) const
    {
        const Body &other = swapped ? *first : *second;
        const MotionBound &a = context.motionBounds[firstIndex], &b = context.motionBounds[secondIndex];
        const MotionBound &own = swapped ? b : a, &others = swapped ? a : b;
        // In the environment's frame, the motion bounds of both bodies add up.
        MotionBound least{own.linear + others.at(other.getBoundingRadius()), own.angular};
        if (ownPair == NOT_OWN)
            return least;
        const double radius = lookedUp().getBoundingRadius();
        const auto take = [&](const MotionBound &bound)
        {
            if (bound.at(radius) < least.at(radius))
                least = bound;
        };
        const PairMotionBound &relative = context.pairMotionBounds[robot][ownPair];
        take(swapped ? relative.second : relative.first);
        // Seen from the other end: no point of the environment moves faster than this.
        if (centersWithin)
            take({(swapped ? relative.first : relative.second).at(other.getBoundingRadius()), 0.0});
        return least;
    }
}
