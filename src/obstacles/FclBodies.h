#ifndef OMPL_CERTIFICATES_OBSTACLES_FCL_BODIES_
#define OMPL_CERTIFICATES_OBSTACLES_FCL_BODIES_

#include "ompl_certificates/geometry/Body.h"

#include <fcl/narrowphase/collision_object.h>

namespace ompl_certificates
{
    /** \brief The body that an FCL object stands for, at its present pose
        \throws ompl::Exception if it is of a kind that FclObstacles refuses, or not upright in the plane */
    PlacedBody bodyOf(const fcl::CollisionObjectd &object, unsigned int dimension);
}

#endif
