#ifndef OMPL_CERTIFICATES_NEIGHBORS_SPACE_CLASS_
#define OMPL_CERTIFICATES_NEIGHBORS_SPACE_CLASS_

#include "ompl_certificates/neighbors/SearchableStateSpace.h"

#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/base/spaces/SE3StateSpace.h>
#include <typeinfo>

namespace ompl_certificates
{
    /** \brief Whether \e space is of exactly this class. Not dynamic_cast: a derived class, such as Dubins' cars, may
        have its own distance. */
    template <typename Space>
    bool isOfClass(const ompl::base::StateSpace &space)
    {
        return typeid(space) == typeid(Space);
    }

    /** \brief Whether \e space says that its distance is composed in this way */
    inline bool isSearchable(const ompl::base::StateSpace &space, SearchableStateSpace::Composition composition)
    {
        const auto *searchable = dynamic_cast<const SearchableStateSpace *>(&space);
        return searchable && searchable->getComposition() == composition;
    }

    /** \brief Whether the distance of \e space is the root of the sum of the squares of its subspaces' weighted
        distances */
    inline bool isEuclidean(const ompl::base::StateSpace &space)
    {
        return isSearchable(space, SearchableStateSpace::Composition::EUCLIDEAN);
    }

    /** \brief Whether the distance of \e space is the weighted sum of its subspaces' */
    inline bool isCompound(const ompl::base::StateSpace &space)
    {
        return isSearchable(space, SearchableStateSpace::Composition::SUM) ||
               isOfClass<ompl::base::CompoundStateSpace>(space) || isOfClass<ompl::base::SE2StateSpace>(space) ||
               isOfClass<ompl::base::SE3StateSpace>(space);
    }
}

#endif
