#ifndef OMPL_CERTIFICATES_OBSTACLES_FCL_OBSTACLES_
#define OMPL_CERTIFICATES_OBSTACLES_FCL_OBSTACLES_

#include "ompl_certificates/geometry/ZInterval.h"
#include "ompl_certificates/obstacles/Obstacles.h"

#include <fcl/narrowphase/collision_object.h>
#include <memory>
#include <vector>

namespace ompl_certificates
{
    class ClearanceTree;
    class ContactTest;
    class FclCheck;
    class MeshSurface;

    /** \brief Obstacles made of primitives and meshes, checked by FCL: a broadphase tree of their boxes and an exact check of
        each pair of shapes that the boxes do not separate.

        Among primitives an exact check takes some 0.1 to 1 µs for up to thousands of them, a clearance 0.02 to 0.5 µs.
        Of meshes with meshes an exact check takes 2 to 60 µs, a clearance about 1 µs.

        Planar meshes have true heights: two of them touch where they do so in space. A planar primitive stands for an
        upright prism without end, as an obstacle and as a robot, and is checked against meshes as one that is high
        enough. */
    class FclObstacles : public Obstacles
    {
    public:
        /** \brief Obstacles in a workspace of \e dimension 2 or 3, possibly none
            \param zInterval in the plane: how far up and down the robots reach, which TeamStateSpace::getZInterval() tells; what
            planar meshes have above or below does not count then. Checkers refuse robots that reach farther; primitives
            reach through all heights.
            \throws ompl::Exception if one has another dimension or a pose that is not finite, or if one in the plane is
            tilted or, being no mesh, not at z = 0 */
        FclObstacles(unsigned int dimension, const std::vector<PlacedBody> &obstacles, const ZInterval &zInterval = {});

        /** \brief Obstacles from the collision objects of an FCL program: spheres, boxes, capsules, cylinders, convex
            polytopes and meshes (fcl::BVHModel of OBBRSS or OBB) at their present poses.

            For a planar workspace (\e dimension 2) they are taken for their outline seen from above: boxes, cylinders and
            capsules, which must stand upright, spheres, and convex polytopes, however they lie. Meshes must stand upright
            and are taken as they are.
            \throws ompl::Exception if an object is null, of another kind, or not upright where it must be */
        explicit FclObstacles(const std::vector<std::shared_ptr<fcl::CollisionObjectd>> &objects,
                              unsigned int dimension = 3, const ZInterval &zInterval = {});

        ~FclObstacles() override;

        unsigned int getDimension() const override
        {
            return dimension_;
        }

        ZInterval getZInterval() const override
        {
            return zInterval_;
        }

        bool collides(const Body &body, const Pose &pose) const override;

        double clearance(const Eigen::Vector3d &point) const override;

        /** \brief The parts are triangles; NO_PART where a primitive is nearest. */
        double findNearest(const Eigen::Vector3d &point, ObstaclePart &part) const override;

        /** \brief Knows of bodies of meshes among meshes in nearly all cases, of others only that meshes among them cross. Takes
            0.1 to 20 µs, mostly a tenth of what collides() takes; nothing is allocated, FCL is not asked. */
        Touching touches(const Body &body, const Pose &pose, ObstaclePart *hit = nullptr) const override;

        /** \brief Looks for a triangle of the body that crosses triangle \e part of the obstacles, or for a point of the
            triangle inside a primitive of the body. Takes 0.05 to 0.5 µs. */
        bool certainlyHits(const Body &body, const Pose &pose, ObstaclePart part) const override;

        double getTolerance() const override
        {
            return tolerance_;
        }

        /** \brief True if there are at most 16 shapes and no meshes */
        bool isClearanceCheap() const override;

        /** \brief A checksum of the shapes, their poses and the heights, whatever their order. Linear in the size of it all. */
        std::uint64_t getFingerprint() const override;

        /** \brief The obstacles that these were made of */
        const std::vector<PlacedBody> &getBodies() const
        {
            return bodies_;
        }

    private:
        unsigned int dimension_;
        ZInterval zInterval_;
        std::vector<PlacedBody> bodies_;

        std::unique_ptr<ClearanceTree> primitives_;
        std::unique_ptr<MeshSurface> surface_;
        std::unique_ptr<FclCheck> check_;
        std::unique_ptr<ContactTest> contactTest_;
        double tolerance_{0.0};
    };
}

#endif
