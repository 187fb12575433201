#include "SegmentCount.h"

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

    SegmentCount::SegmentCount(const ob::StateSpacePtr &space, double fraction) : space_(space.get())
    {
        if (isOneOf<ob::CompoundStateSpace, ob::SE2StateSpace, ob::SE3StateSpace, ob::DubinsStateSpace,
                    ob::ReedsSheppStateSpace>(*space))
            for (const ob::StateSpacePtr &part : space->as<ob::CompoundStateSpace>()->getSubspaces())
                parts_.emplace_back(part, fraction);
        else if (isOneOf<ob::RealVectorStateSpace, ob::SO2StateSpace, ob::SO3StateSpace>(*space))
            longest_ = space->getMaximumExtent() * fraction;
        else
            space->setLongestValidSegmentFraction(fraction);
    }

    unsigned int SegmentCount::operator()(const ob::State *state1, const ob::State *state2) const
    {
        unsigned int most = 0;
        for (std::size_t i = 0; i < parts_.size(); ++i)
            most = std::max(most, parts_[i](state1->as<ob::CompoundState>()->components[i],
                                            state2->as<ob::CompoundState>()->components[i]));
        if (!parts_.empty())
            return most;
        if (longest_ == 0.0)
            return space_->validSegmentCount(state1, state2);
        const double count = std::ceil(space_->distance(state1, state2) / longest_);
        // OMPL's count, converted as it is, is 0 then.
        if (!std::isfinite(count))
            return 0;
        constexpr double largest = std::numeric_limits<int>::max();
        return space_->getValidSegmentCountFactor() * static_cast<unsigned int>(std::min(count, largest));
    }
}
