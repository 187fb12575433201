#include "PlanarCheck.h"

#include <algorithm>

namespace ompl_certificates
{
    namespace
    {
        /** The pose of a part for FCL. Its solver is wrong about prisms of equal height that are exactly level, as all
            polygons of a plane are. It finds them touching across gaps of up to a hundredth of their size. So they are
            lifted by a part of their height, which changes nothing in the plane. */
        Pose liftedForFcl(const Shape &shape, const Pose &pose)
        {
            if (shape.getKind() != Shape::Kind::POLYTOPE)
                return pose;
            const double radius = shape.getCollisionGeometry()->aabb_radius / Shape::FCL_SCALE;
            Pose moved = pose;
            moved.translation().z() += 0.1 * radius;
            return moved;
        }
    }

    PlanarCheck::PlanarCheck(const PlacedShapes &obstacles, const ZInterval &meshZInterval)
      : meshZInterval_(meshZInterval)
    {
        for (const PlacedShape &placed : obstacles)
        {
            const bool isMesh = placed.shape.getMesh() != nullptr;
            (isMesh ? meshes_ : primitives_).add(placed.shape.getCollisionGeometry(), placed.pose);
            if (!isMesh)
                obstaclePrisms_.add(placed);
        }
        primitives_.setup();
        meshes_.setup();
    }

    bool PlanarCheck::collides(const Body &body, const Pose &pose) const
    {
        return std::any_of(body.getParts().begin(), body.getParts().end(),
                           [&](const Body::Part &part)
                           {
                               const Pose partPose = pose * part.pose;
                               return part.shape.getMesh() ? meshCollides(part.shape, partPose)
                                                           : primitiveCollides(part.shape, partPose);
                           });
    }

    bool PlanarCheck::meshCollides(const Shape &shape, const Pose &partPose) const
    {
        if (!meshes_.isEmpty() && meshes_.collides(shape.getCollisionGeometry(), partPose))
            return true;
        if (primitives_.isEmpty())
            return false;
        // The prisms are about the plane z = 0.
        const Eigen::AlignedBox3d bounds = shape.getMesh()->getBounds();
        Pose lowered = partPose;
        lowered.translation().z() = -0.5 * (bounds.min().z() + bounds.max().z());
        const double extent = shape.getBounds().sizes().maxCoeff();
        return obstaclePrisms_.get(2.0 * extent).collides(shape.getCollisionGeometry(), lowered);
    }

    bool PlanarCheck::primitiveCollides(const Shape &shape, const Pose &partPose) const
    {
        if (!primitives_.isEmpty() && primitives_.collides(shape.getCollisionGeometry(), liftedForFcl(shape, partPose)))
            return true;
        if (meshes_.isEmpty() || meshZInterval_.low > meshZInterval_.high)
            return false;
        const double height = meshZInterval_.high - meshZInterval_.low,
                     middle = 0.5 * (meshZInterval_.low + meshZInterval_.high);
        return robotPrisms_.collide(shape, height, meshes_, partPose, middle);
    }
}
