#ifndef OMPL_CERTIFICATES_OBSTACLES_FCL_OBSTACLES_
#define OMPL_CERTIFICATES_OBSTACLES_FCL_OBSTACLES_

#include "ompl_certificates/geometry/ZInterval.h"
#include "ompl_certificates/obstacles/Obstacles.h"

#include <fcl/narrowphase/collision_object.h>
#include <memory>
#include <mutex>
#include <vector>

namespace ompl_certificates
{
    class ClearanceTree;
    class ContactTest;
    class FclCheck;
    class MeshSurface;
    class PrimitiveList;

    /** \brief Obstacles made of primitives and meshes, checked by FCL. A broadphase compares their boxes, then an exact
        check compares each pair of shapes that the boxes do not separate.

        Among primitives, up to thousands of them, an exact check takes some 0.1 to 1 µs and a clearance 0.02 to 0.5 µs.
        For meshes among meshes an exact check takes 2 to 60 µs and a clearance about 1 µs.

        Planar meshes keep their z: two of them touch where they do so in space. A planar primitive stands for an
        endless upright prism, as an obstacle and as a robot. Against meshes it is checked as a prism that is high
        enough. */
    class FclObstacles : public Obstacles
    {
    public:
        /** \brief Obstacles in a workspace of \e dimension 2 or 3, possibly none
            \param zInterval in the plane: the z-interval of the robots, see TeamStateSpace::getZInterval(). Parts of
            planar meshes outside it do not count, and checkers refuse robots that exceed it. The z-interval of
            primitives is unbounded.
            \throws ompl::Exception if an obstacle has a padding, another dimension, or a pose that is not finite,
            scales or mirrors. In the plane also if it is tilted, or is no mesh and not at z = 0. A rotation may be rounded to
            three decimals: the nearest true one is taken. */
        FclObstacles(const std::vector<PlacedBody> &obstacles, unsigned int dimension, const ZInterval &zInterval = {});

        /** \brief Other obstacles in the workspace of \e known, with its z-interval. If their meshes are those of
            \e known, at the same places, this takes no time for them, and their triangles are shared.
            \throws ompl::Exception as the first constructor */
        FclObstacles(const std::vector<PlacedBody> &obstacles, const FclObstacles &known);

        /** \brief Obstacles from the collision objects of an FCL program, at their present poses: spheres, boxes,
            capsules, cylinders, convex polytopes and meshes (fcl::BVHModel of OBBRSS or OBB).

            For a planar workspace (\e dimension 2) primitives become their outline seen from above. Boxes, cylinders
            and capsules must stand upright, to within 2e-6 radians; spheres and convex polytopes may lie anyhow. Meshes
            must stand upright, too, and are taken as they are.
            \throws ompl::Exception if an object is null, of another kind, or not upright where it must be */
        explicit FclObstacles(const std::vector<std::shared_ptr<fcl::CollisionObjectd>> &objects,
                              unsigned int dimension = 3, const ZInterval &zInterval = {});

        ~FclObstacles() override;

        /** \brief Ask whether the first constructor takes an obstacle; costs nothing
            \throws ompl::Exception if not */
        static void requireObstacle(const PlacedBody &obstacle, unsigned int dimension);

        unsigned int getDimension() const override
        {
            return dimension_;
        }

        ZInterval getZInterval() const override
        {
            return zInterval_;
        }

        bool collides(const Body &body, const Pose &pose) const override;

        bool knowsPadding() const override
        {
            return true;
        }

        double clearance(const Eigen::Vector3d &point) const override;

        double clearanceUpTo(const Eigen::Vector3d &point, double most) const override;

        /** \brief A part is a triangle or a primitive; here NO_PART where a primitive is nearest. */
        double findNearest(const Eigen::Vector3d &point, ObstaclePart &part) const override;

        /** \brief Decides nearly all queries. In the plane it leaves meshes near primitives, primitives among
            meshes, and all among more than 100 000 triangles to collides(). Takes 0.1 to 20 µs, mostly a tenth of
            collides(). Allocates nothing and does not ask FCL. */
        Touching touches(const Body &body, const Pose &pose, ObstaclePart *hit = nullptr) const override;

        /** \brief In space, by bounding spheres and boxes; meshes among the obstacles have one box together. Takes some 10
            ns for each 8 primitives and each one that is near. */
        BatchMask mayTouch(const Body &body, const PoseBatch &poses, const PoseError &error) const override;

        /** \brief By the bounding spheres and the convex covers of shapes. Unknown where there are meshes among the
            obstacles. Takes some 0.1 to 0.5 µs for each primitive near the body. */
        double gap(const Body &body, const Pose &pose, double needed, double wanted) const override;

        bool hasGap() const override;

        /** \brief By the test of touches() with a margin */
        bool staysFree(const Body &body, const Pose &pose, double distance) const override;

        /** \brief Looks for a part of the body that crosses a triangle or a primitive of the obstacles, \e part. Takes
            0.05 to 1 µs. */
        bool certainlyHits(const Body &body, const Pose &pose, ObstaclePart part) const override;

        double getTolerance() const override
        {
            return tolerance_;
        }

        /** \brief True if there are at most 16 shapes and no meshes */
        bool isClearanceCheap() const override;

        /** \brief A checksum of the shapes, their poses and the z-interval, whatever their order. Cost: linear in the
            size of all shapes. */
        std::uint64_t getFingerprint() const override;

        /** \brief The obstacles given to the constructor */
        const std::vector<PlacedBody> &getBodies() const
        {
            return bodies_;
        }

    private:
        FclObstacles(const std::vector<PlacedBody> &obstacles, unsigned int dimension, const ZInterval &zInterval,
                     const FclObstacles *known);

        /** \brief FCL's view of the obstacles. It is made when it is first asked for: that takes most of the time and
            memory of a mesh, and the contact test leaves FCL little to do. */
        const FclCheck &fclCheck() const;

        unsigned int dimension_;
        ZInterval zInterval_;
        std::vector<PlacedBody> bodies_;

        std::unique_ptr<ClearanceTree> clearances_;
        std::shared_ptr<const MeshSurface> surface_;
        std::unique_ptr<PrimitiveList> primitives_;
        mutable std::once_flag fclCheckMade_;
        mutable std::unique_ptr<const FclCheck> fclCheck_;
        std::unique_ptr<ContactTest> contactTest_;
        double tolerance_{0.0};
    };
}

#endif
