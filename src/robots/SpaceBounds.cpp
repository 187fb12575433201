#include "SpaceBounds.h"

#include <ompl/base/spaces/RealVectorStateSpace.h>

namespace ompl_certificates
{
    namespace ob = ompl::base;

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
}
