#ifndef OMPL_CERTIFICATES_OBSTACLES_BROADPHASE_
#define OMPL_CERTIFICATES_OBSTACLES_BROADPHASE_

#include "ompl_certificates/geometry/Pose.h"
#include "ompl_certificates/geometry/Shape.h"

#include <algorithm>
#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/collision_object.h>
#include <memory>
#include <vector>

namespace ompl_certificates
{
    /** \brief An FCL object of a geometry whose local box is known. The geometry is Shape::FCL_SCALE times as large as
        in its pose's frame.

        FCL's own constructors compute that box again, in the geometry itself. That is linear in the vertices of a mesh,
        and other threads that check the same geometry see it change and may get another verdict. */
    class PlacedGeometry : public fcl::CollisionObjectd
    {
    public:
        PlacedGeometry(const std::shared_ptr<fcl::CollisionGeometryd> &geometry, const Pose &pose)
          : fcl::CollisionObjectd(nullptr)
        {
            cgeom = geometry;
            cgeom_const = geometry;
            t = pose;
            t.translation() *= Shape::FCL_SCALE;
            computeAABB();
        }
    };

    /** \brief FCL's broadphase over obstacles, and its exact check of those that the boxes do not separate */
    class Broadphase
    {
    public:
        /** \brief Add an obstacle. Call setup() after the last. */
        void add(const std::shared_ptr<fcl::CollisionGeometryd> &geometry, const Pose &pose)
        {
            objects_.push_back(std::make_unique<PlacedGeometry>(geometry, pose));
            manager_.registerObject(objects_.back().get());
        }

        void setup()
        {
            manager_.setup();
        }

        bool isEmpty() const
        {
            return objects_.empty();
        }

        /** \brief Whether \e geometry at \e pose touches an obstacle */
        bool collides(const std::shared_ptr<fcl::CollisionGeometryd> &geometry, const Pose &pose) const
        {
            PlacedGeometry object(geometry, pose);
            bool hit = false;
            manager_.collide(&object, &hit, stopAtFirstContact);
            return hit;
        }

    private:
        static bool stopAtFirstContact(fcl::CollisionObjectd *a, fcl::CollisionObjectd *b, void *data)
        {
            // FCL's default tolerance is a millionth of the length unit. This one is a millionth of the smaller shape,
            // but at least what the larger one's rounding allows: below that, FCL's solver never ends.
            const auto [small, large] =
                std::minmax(a->collisionGeometry()->aabb_radius, b->collisionGeometry()->aabb_radius);
            fcl::CollisionRequestd request;
            request.gjk_tolerance = std::max(1e-6 * small, 1e-10 * large);
            fcl::CollisionResultd result;
            if (fcl::collide(a, b, request, result) == 0)
                return false;
            *static_cast<bool *>(data) = true;
            return true;
        }

        std::vector<std::unique_ptr<PlacedGeometry>> objects_;
        fcl::DynamicAABBTreeCollisionManagerd manager_;
    };
}

#endif
