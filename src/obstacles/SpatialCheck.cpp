#include "SpatialCheck.h"

#include <algorithm>

namespace ompl_certificates
{
    namespace
    {
        /** The pose of a part for FCL. Its solver is wrong about prisms of equal height that are exactly level: it
            finds them touching across gaps of up to a hundredth of their size. So polytopes are moved by less than
            decides a verdict. */
        Pose shiftedForFcl(const Shape &shape, const Pose &pose)
        {
            if (shape.getKind() != Shape::Kind::POLYTOPE)
                return pose;
            const double radius = shape.getCollisionGeometry()->aabb_radius / Shape::FCL_SCALE;
            Pose moved = pose;
            moved.translation() += 1e-9 * radius * Eigen::Vector3d(0.5, 0.6, 0.7);
            return moved;
        }
    }

    SpatialCheck::SpatialCheck(const PlacedShapes &obstacles)
    {
        for (const auto &[shape, pose] : obstacles)
            shapes_.add(shape.getCollisionGeometry(), pose);
        shapes_.setup();
    }

    bool SpatialCheck::collides(const Body &body, const Pose &pose) const
    {
        return !shapes_.isEmpty() &&
               std::any_of(body.getParts().begin(), body.getParts().end(),
                           [&](const Body::Part &part) {
                               return shapes_.collides(part.shape.getCollisionGeometry(),
                                                       shiftedForFcl(part.shape, pose * part.pose));
                           });
    }
}
