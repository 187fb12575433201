#ifndef OMPL_CERTIFICATES_GEOMETRY_BODY_
#define OMPL_CERTIFICATES_GEOMETRY_BODY_

#include "ompl_certificates/geometry/SphereTree.h"
#include "ompl_certificates/geometry/ZInterval.h"
#include "ompl_certificates/geometry/Pose.h"
#include "ompl_certificates/geometry/Shape.h"

#include <atomic>
#include <memory>
#include <mutex>
#include <vector>

namespace ompl_certificates
{
    class ConvexCover;
    struct PlacedBody;

    /** \brief A rigid body: one or more shapes, fixed to each other, in the body's frame, and a padding: all points
        within that distance of a shape belong to the body, too.

        A body never changes and is cheap to copy: copies share its shapes, its sphere tree and its inner spheres. The
        factories throw ompl::Exception for sizes that are not positive and finite, unless 0 is allowed. Lengths are in
        the scene's unit.

        Points and meshes may have any coordinates: a shape that is small beside its distance from the origin gets a
        frame about its middle, and a pose. FCL's tolerance would grow with that distance. */
    class Body
    {
    public:
        /** \brief A shape and where it is in the body's frame */
        struct Part
        {
            /** \brief The shape */
            Shape shape;

            /** \brief Its pose in the body's frame */
            Pose pose;
        };

        /** \brief A disc, in the plane; radius 0 is a point */
        static Body disc(double radius);

        /** \brief A sphere, in space; radius 0 is a point */
        static Body sphere(double radius);

        /** \brief A rectangle about the origin, with the given extents along x and y */
        static Body box(double x, double y);

        /** \brief A box about the origin, with the given extents along x, y and z */
        static Body box(double x, double y, double z);

        /** \brief All points of the plane within \e radius of a segment of the given length along x about the origin */
        static Body planarCapsule(double radius, double length);

        /** \brief All points of space within \e radius of a segment of the given length along z about the origin */
        static Body capsule(double radius, double length);

        /** \brief A cylinder along z about the origin, in space */
        static Body cylinder(double radius, double length);

        /** \brief The convex polygon with the given corners, in any order. Repeated points and points on its edges are
            allowed.
            \throws ompl::Exception if a point lies inside the hull of the others by more than a millionth of its size,
            as a concave outline's do; if they span no area, or are too many (see ompl_certificates::convexHull()) */
        static Body convexPolygon(const std::vector<Eigen::Vector2d> &points);

        /** \brief The convex polytope with the given corners, in any order. Repeated points and points on its faces are
            allowed.
            \throws ompl::Exception if a point lies inside the hull of the others, as in convexPolygon(); if they span
            no volume, or are too many (see ompl_certificates::convexHull()) */
        static Body convexPolytope(const std::vector<Eigen::Vector3d> &points);

        /** \brief The convex hull of any points of the plane
            \throws ompl::Exception if they span no area or are too many (see ompl_certificates::convexHull()) */
        static Body convexHull(const std::vector<Eigen::Vector2d> &points);

        /** \brief The convex hull of any points of space
            \throws ompl::Exception if they span no volume or are too many (see ompl_certificates::convexHull()) */
        static Body convexHull(const std::vector<Eigen::Vector3d> &points);

        /** \brief A triangle mesh, in space
            \throws ompl::Exception if it is null
            Cost: n log n for n triangles, once for a mesh. */
        static Body mesh(TriangleMeshPtr mesh);

        /** \brief A triangle mesh in the plane: it keeps its z, moves in x and y and turns about z. Two of them touch
            only where their z-intervals overlap.
            \throws ompl::Exception if it is null
            Cost: n log n for n triangles, once for a mesh. */
        static Body planarMesh(TriangleMeshPtr mesh);

        /** \brief One body of all the shapes of \e bodies, whose poses are in its frame
            \throws ompl::Exception as the constructor */
        static Body join(const std::vector<PlacedBody> &bodies);

        /** \brief One body of several shapes, at poses in the body's frame. A rotation may be rounded to three
            decimals: the nearest true one is taken.
            \throws ompl::Exception if there is none, if planar and spatial shapes are mixed, if a planar mesh is
            tilted, or if a pose is not finite, scales or mirrors */
        explicit Body(std::vector<Part> parts);

        /** \brief The same shapes with a padding: a body that keeps this distance from obstacles, zones and other
            robots. Two robots keep the sum of their paddings from each other, bodies of one robot keep none. It is
            exact, with round corners: a padded box is no larger box. FCL has no such check, so padded bodies have one
            of this library, whatever the method. Obstacles and zones are not padded.

            In the plane a mesh is seen from above, but by other meshes: these it keeps the distance from in space.
            \param padding the distance, in the scene's length unit, in place of the present one; 0 for none
            \throws ompl::Exception if it is negative or not finite */
        Body padded(double padding) const;

        /** \brief The distance around the shapes that belongs to the body, too; 0 unless padded() */
        double getPadding() const
        {
            return data_->padding;
        }

        /** \brief The shapes alone; the body itself unless padded() */
        Body withoutPadding() const
        {
            return data_->base ? Body(data_->base) : *this;
        }

        /** \brief The dimension of the workspace that this body is for: 2 or 3 */
        unsigned int getDimension() const;

        /** \brief The shapes that the body is made of */
        const std::vector<Part> &getParts() const
        {
            return data_->parts;
        }

        /** \brief A tree of balls whose union contains the body, coarse to fine */
        const SphereTree &getSphereTree() const
        {
            return data_->getBalls().sphereTree;
        }

        /** \brief A convex set around each of the shapes and its padding, in the body's frame. Made when first asked
            for: see ConvexCover. */
        const std::vector<ConvexCover> &getConvexCovers() const;

        /** \brief Balls that lie inside the body, the largest first. Empty for meshes, which are surfaces, and for
            nothing else: a point has a ball of radius 0. */
        const std::vector<Ball> &getInnerSpheres() const
        {
            return data_->getBalls().innerSpheres;
        }

        /** \brief The radius of the largest ball about the center of the sphere tree's root that lies inside the body.
            Minus infinity if that center is outside. */
        double getCentralRadius() const
        {
            return data_->getBalls().centralRadius;
        }

        /** \brief Whether the body is one disc or one sphere, which root ball and inner sphere describe exactly */
        bool isBall() const
        {
            return data_->isBall;
        }

        /** \brief The largest distance of a point of the body from the origin of its frame (an upper bound) */
        double getBoundingRadius() const
        {
            return data_->boundingRadius;
        }

        /** \brief The smallest box along the axes of the body's frame that contains the boxes of its shapes, each
            along its own axes, and the padding around them */
        const Eigen::AlignedBox3d &getBounds() const
        {
            return data_->bounds;
        }

        /** \brief A ball around each of the shapes and its padding, in the body's frame */
        const std::vector<Ball> &getPartBalls() const
        {
            return data_->partBalls;
        }

        /** \brief The z-interval of a planar body of meshes. Unbounded for spatial bodies, and for planar primitives,
            which stand for endless upright prisms. */
        const ZInterval &getZInterval() const
        {
            return data_->zInterval;
        }

        /** \brief Signed distance of \e point, in the body's frame, to the nearest shape of the body, less the padding;
            negative inside primitives. Linear in the number of triangles of a mesh. */
        double signedDistance(const Eigen::Vector3d &point) const;

        /** \brief Whether the two bodies have the same shapes at the same poses, in the same order, and one padding */
        bool operator==(const Body &other) const;

    private:
        /** \brief The balls of a body, made when first asked for: obstacles need none */
        struct Balls
        {
            SphereTree sphereTree;
            std::vector<Ball> innerSpheres;
            double centralRadius;
        };

        struct Data
        {
            std::vector<Part> parts;
            double padding{0.0};
            /** \brief The body without its padding; null if it has none */
            std::shared_ptr<Data> base;
            bool isBall{false};
            double boundingRadius{0.0};
            Eigen::AlignedBox3d bounds;
            std::vector<Ball> partBalls;
            ZInterval zInterval;
            mutable std::mutex mutex;
            mutable std::unique_ptr<const Balls> balls;
            mutable std::atomic<const Balls *> made{nullptr};
            mutable std::shared_ptr<const std::vector<ConvexCover>> covers;
            mutable std::atomic<const std::vector<ConvexCover> *> madeCovers{nullptr};

            const Balls &getBalls() const
            {
                const Balls *known = made.load(std::memory_order_acquire);
                return known ? *known : makeBalls();
            }

            const Balls &makeBalls() const;
        };

        explicit Body(std::shared_ptr<Data> data) : data_(std::move(data))
        {
        }

        std::shared_ptr<Data> data_;
    };

    /** \brief A body at a fixed pose, such as an obstacle */
    struct PlacedBody
    {
        /** \brief The body */
        Body body;

        /** \brief Its pose in the workspace, or in the frame of a body that it is a part of */
        Pose pose{Pose::Identity()};
    };
}

#endif
