#ifndef OMPL_CERTIFICATES_NEIGHBORS_SPACE_CLASS_
#define OMPL_CERTIFICATES_NEIGHBORS_SPACE_CLASS_

#include "ompl_certificates/team/TeamStateSpace.h"

#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/base/spaces/SE3StateSpace.h>
#include <typeinfo>

namespace ompl_certificates
{
    /** \brief Whether \e space is of this very class. Not dynamic_cast: a derived class, such as Dubins' cars, may have a
        distance of its own. */
    template <typename Space>
    bool isOfClass(const ompl::base::StateSpace &space)
    {
        return typeid(space) == typeid(Space);
    }

    /** \brief Whether the distance of \e space is Euclidean over a team's robots */
    inline bool isEuclideanTeam(const ompl::base::StateSpace &space)
    {
        return isOfClass<TeamStateSpace>(space) && space.as<TeamStateSpace>()->getMetric() == TeamStateSpace::EUCLIDEAN;
    }

    /** \brief Whether the distance of \e space is the weighted sum of its subspaces' */
    inline bool isCompound(const ompl::base::StateSpace &space)
    {
        return (isOfClass<TeamStateSpace>(space) && !isEuclideanTeam(space)) ||
               isOfClass<ompl::base::CompoundStateSpace>(space) || isOfClass<ompl::base::SE2StateSpace>(space) ||
               isOfClass<ompl::base::SE3StateSpace>(space);
    }
}

#endif
