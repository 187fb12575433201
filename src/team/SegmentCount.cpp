#include "SegmentCount.h"

#include "robots/CarStateSpace.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <ompl/base/spaces/DubinsStateSpace.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/base/spaces/ReedsSheppStateSpace.h>
#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/base/spaces/SE3StateSpace.h>
#include <ompl/base/spaces/SO2StateSpace.h>
#include <ompl/base/spaces/SO3StateSpace.h>
#include <typeinfo>

namespace ompl_certificates
{
    namespace ob = ompl::base;

    namespace
    {
        /** Whether a space is of one of these classes, and not of one derived from it */
        template <typename... Classes>
        bool isOneOf(const ob::StateSpace &space)
        {
            return ((typeid(space) == typeid(Classes)) || ...);
        }
    }

    SegmentCount::SegmentCount(const ob::StateSpacePtr &space, std::optional<double> fraction) : space_(space.get())
    {
        isCurve_ = isOneOf<ob::DubinsStateSpace, ob::ReedsSheppStateSpace, CarStateSpace>(*space);
        if (isCurve_ || isOneOf<ob::CompoundStateSpace, ob::SE2StateSpace, ob::SE3StateSpace>(*space))
            for (const ob::StateSpacePtr &part : space->as<ob::CompoundStateSpace>()->getSubspaces())
                parts_.emplace_back(part, fraction);
        else if (fraction && isOneOf<ob::RealVectorStateSpace, ob::SO2StateSpace, ob::SO3StateSpace>(*space))
            longest_ = space->getMaximumExtent() * *fraction;
        else if (fraction)
            space->setLongestValidSegmentFraction(*fraction);
    }

    bool SegmentCount::hasCurves() const
    {
        return isCurve_ ||
               std::any_of(parts_.begin(), parts_.end(), [](const SegmentCount &part) { return part.hasCurves(); });
    }

    unsigned int SegmentCount::along(double length, double longest) const
    {
        const double count = std::ceil(length / longest);
        // OMPL's count, converted as it is, is 0 then.
        if (!std::isfinite(count))
            return 0;
        constexpr double largest = std::numeric_limits<int>::max();
        return space_->getValidSegmentCountFactor() * static_cast<unsigned int>(std::min(count, largest));
    }

    unsigned int SegmentCount::alongCurve(const ob::State *state1, const ob::State *state2) const
    {
        // Of states that are not finite OMPL finds no curve.
        const auto &straight = *space_->as<ob::CompoundStateSpace>();
        if (!std::isfinite(straight.ob::CompoundStateSpace::distance(state1, state2)))
            return 0;
        const SegmentCount &position = parts_.front();
        const double longest =
            position.longest_ > 0.0 ? position.longest_ : position.space_->getLongestValidSegmentLength();
        return along(space_->distance(state1, state2), longest);
    }

    unsigned int SegmentCount::operator()(const ob::State *state1, const ob::State *state2) const
    {
        unsigned int most = 0;
        for (std::size_t i = 0; i < parts_.size(); ++i)
            most = std::max(most, parts_[i](state1->as<ob::CompoundState>()->components[i],
                                            state2->as<ob::CompoundState>()->components[i]));
        if (isCurve_ && most > 0)
            most = std::max(most, alongCurve(state1, state2));
        if (!parts_.empty())
            return most;
        return longest_ == 0.0 ? space_->validSegmentCount(state1, state2)
                               : along(space_->distance(state1, state2), longest_);
    }
}
