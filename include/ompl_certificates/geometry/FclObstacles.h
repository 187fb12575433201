#ifndef OMPL_CERTIFICATES_GEOMETRY_FCL_OBSTACLES_
#define OMPL_CERTIFICATES_GEOMETRY_FCL_OBSTACLES_

#include "ompl_certificates/geometry/ClearanceTree.h"
#include "ompl_certificates/geometry/Obstacles.h"

#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/narrowphase/collision_object.h>
#include <memory>
#include <vector>

namespace ompl_certificates
{
    /** \brief Obstacles made of primitives, checked by FCL: a broadphase tree of their boxes and an exact check of each
        pair of shapes that the boxes do not separate.

        An exact check takes some 0.1 to 1 µs among up to thousands of obstacles, a clearance 0.02 to 0.5 µs. */
    class FclObstacles : public Obstacles
    {
    public:
        /** \brief Obstacles in a workspace of \e dimension 2 or 3, possibly none
            \throws ompl::Exception if one has another dimension or a pose that is not finite */
        FclObstacles(unsigned int dimension, const std::vector<PlacedBody> &obstacles);

        /** \brief Obstacles from the collision objects of an FCL program: spheres, boxes, capsules, cylinders and convex
            polytopes at their present poses.

            For a planar workspace (\e dimension 2) they are taken for their outline seen from above: boxes and
            cylinders that stand upright, spheres, and convex polytopes, which are taken for upright prisms.
            \throws ompl::Exception if an object is null, of another kind, or not upright in a planar workspace */
        explicit FclObstacles(const std::vector<std::shared_ptr<fcl::CollisionObjectd>> &objects,
                              unsigned int dimension = 3);

        unsigned int getDimension() const override
        {
            return dimension_;
        }

        bool collides(const Body &body, const Pose &pose) const override;

        double clearance(const Eigen::Vector3d &point) const override;

        double getTolerance() const override
        {
            return tolerance_;
        }

        /** \brief True if there are at most 16 shapes */
        bool isClearanceCheap() const override
        {
            return clearances_.size() <= 16;
        }

        /** \brief The obstacles that these were made of */
        const std::vector<PlacedBody> &getBodies() const
        {
            return bodies_;
        }

    private:
        /** \brief Fill the broadphase and the clearance tree from bodies_ */
        void build();

        unsigned int dimension_;
        std::vector<PlacedBody> bodies_;
        std::vector<std::unique_ptr<fcl::CollisionObjectd>> objects_;
        std::unique_ptr<fcl::DynamicAABBTreeCollisionManagerd> manager_;
        ClearanceTree clearances_;
        double tolerance_{0.0};
    };
}

#endif
