#ifndef OMPL_CERTIFICATES_GEOMETRY_BROADPHASE_
#define OMPL_CERTIFICATES_GEOMETRY_BROADPHASE_

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
    /** \brief FCL's tree of boxes over obstacles, and its exact check of those that the boxes do not separate */
    class Broadphase
    {
    public:
        /** \brief An FCL object of \e geometry, which is Shape::FCL_SCALE times as large as \e pose has it */
        static fcl::CollisionObjectd makeObject(const std::shared_ptr<fcl::CollisionGeometryd> &geometry, Pose pose)
        {
            pose.translation() *= Shape::FCL_SCALE;
            return {geometry, pose};
        }

        /** \brief Add an obstacle. Call setup() after the last. */
        void add(const std::shared_ptr<fcl::CollisionGeometryd> &geometry, const Pose &pose)
        {
            objects_.push_back(std::make_unique<fcl::CollisionObjectd>(makeObject(geometry, pose)));
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
            fcl::CollisionObjectd object = makeObject(geometry, pose);
            bool hit = false;
            manager_.collide(&object, &hit, stopAtFirstContact);
            return hit;
        }

    private:
        static bool stopAtFirstContact(fcl::CollisionObjectd *a, fcl::CollisionObjectd *b, void *data)
        {
            // FCL's default tolerance is a millionth of the length unit; this one is a millionth of the smaller shape.
            fcl::CollisionRequestd request;
            request.gjk_tolerance =
                1e-6 * std::min(a->collisionGeometry()->aabb_radius, b->collisionGeometry()->aabb_radius);
            fcl::CollisionResultd result;
            if (fcl::collide(a, b, request, result) == 0)
                return false;
            *static_cast<bool *>(data) = true;
            return true;
        }

        std::vector<std::unique_ptr<fcl::CollisionObjectd>> objects_;
        fcl::DynamicAABBTreeCollisionManagerd manager_;
    };
}

#endif
