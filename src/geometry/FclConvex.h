#ifndef OMPL_CERTIFICATES_GEOMETRY_FCL_CONVEX_
#define OMPL_CERTIFICATES_GEOMETRY_FCL_CONVEX_

#include "ompl_certificates/geometry/ConvexHull.h"

#include <fcl/geometry/collision_geometry.h>
#include <memory>

namespace ompl_certificates
{
    /** \brief FCL's convex polytope for a hull. A polygon becomes a prism of the given height about the plane z = 0. */
    std::shared_ptr<fcl::CollisionGeometryd> makeConvex(const ConvexHull &hull, double prismHeight);
}

#endif
