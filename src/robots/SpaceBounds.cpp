#include "SpaceBounds.h"

#include "CarStateSpace.h"

#include <cmath>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/util/Exception.h>
#include <typeinfo>

namespace ompl_certificates
{
    namespace ob = ompl::base;

    namespace
    {
        /** The class of a space. That a car's remembers its curves makes no other states of them. */
        const std::type_info &classOf(const ob::StateSpace &space)
        {
            return typeid(space) == typeid(CarStateSpace) ? typeid(ob::ReedsSheppStateSpace) : typeid(space);
        }
    }

    bool areAlike(const ob::StateSpace &a, const ob::StateSpace &b)
    {
        if (classOf(a) != classOf(b) || a.getDimension() != b.getDimension())
            return false;
        const auto *first = dynamic_cast<const ob::CompoundStateSpace *>(&a);
        const auto *second = dynamic_cast<const ob::CompoundStateSpace *>(&b);
        if (!first)
            return true;
        if (first->getSubspaceCount() != second->getSubspaceCount())
            return false;
        for (unsigned int i = 0; i < first->getSubspaceCount(); ++i)
            if (!areAlike(*first->getSubspace(i), *second->getSubspace(i)))
                return false;
        return true;
    }

    bool haveEqualBounds(const ob::StateSpace &a, const ob::StateSpace &b)
    {
        if (const auto *vector = dynamic_cast<const ob::RealVectorStateSpace *>(&a))
        {
            const auto &first = vector->getBounds(), &second = b.as<ob::RealVectorStateSpace>()->getBounds();
            return first.low == second.low && first.high == second.high;
        }
        const auto *first = dynamic_cast<const ob::CompoundStateSpace *>(&a);
        if (!first)
            return true;
        const auto *second = b.as<ob::CompoundStateSpace>();
        for (unsigned int i = 0; i < first->getSubspaceCount(); ++i)
            if (first->getSubspaceWeight(i) != second->getSubspaceWeight(i) ||
                !haveEqualBounds(*first->getSubspace(i), *second->getSubspace(i)))
                return false;
        return true;
    }

    const ob::RealVectorBounds *findPositionBounds(const ob::StateSpace &space)
    {
        const ob::StateSpace *first = &space;
        while (const auto *compound = dynamic_cast<const ob::CompoundStateSpace *>(first))
            first = compound->getSubspaceCount() == 0 ? nullptr : compound->getSubspace(0).get();
        const auto *position = dynamic_cast<const ob::RealVectorStateSpace *>(first);
        return position ? &position->getBounds() : nullptr;
    }

    void requirePositionBounds(const std::string &robot, const ob::RealVectorBounds &bounds, std::size_t dimension)
    {
        if (bounds.low.size() != dimension || bounds.high.size() != dimension)
            throw ompl::Exception(robot, "the bounds must have " + std::to_string(dimension) +
                                             " dimensions, as its bodies do, not " + std::to_string(bounds.low.size()));
        for (std::size_t i = 0; i < dimension; ++i)
        {
            const double low = bounds.low[i], high = bounds.high[i];
            if (!std::isfinite(low) || !std::isfinite(high) || low > high)
                throw ompl::Exception(robot,
                                      "the bounds of its position must be finite, each low at most its high, not " +
                                          std::to_string(low) + " to " + std::to_string(high));
        }
    }
}
