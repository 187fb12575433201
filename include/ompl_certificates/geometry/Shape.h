#ifndef OMPL_CERTIFICATES_GEOMETRY_SHAPE_
#define OMPL_CERTIFICATES_GEOMETRY_SHAPE_

#include "ompl_certificates/geometry/ConvexHull.h"
#include "ompl_certificates/geometry/Pose.h"
#include "ompl_certificates/geometry/TriangleMesh.h"

#include <Eigen/Geometry>
#include <fcl/geometry/collision_geometry.h>
#include <memory>
#include <vector>

namespace ompl_certificates
{
    /** \brief A solid primitive or a triangle mesh, of the plane or of space, in its own frame.

        All lengths are in the scene's unit. Planar primitives lie in the plane z = 0. FCL sees them as prisms, or as
        spheres and capsules centered in the plane, so its verdict is the planar one. A mesh is a surface, as for FCL:
        what lies wholly inside a closed mesh does not touch it. A planar mesh keeps its z and its triangles. The
        factories throw ompl::Exception for sizes that are not positive and finite. A ball's radius may be zero: a
        point. */
    class Shape
    {
    public:
        /** \brief What a shape is */
        enum class Kind
        {
            /// A disc or a sphere about the origin.
            BALL,
            /// A rectangle or a box about the origin, along the axes.
            BOX,
            /// All points within a radius of a segment along z about the origin, as in FCL. In a planar body the part's
            /// pose lays it into the plane.
            CAPSULE,
            /// A cylinder about the origin, along z.
            CYLINDER,
            /// A convex polygon or polytope.
            POLYTOPE,
            /// A triangle mesh.
            MESH
        };

        /** \brief A disc (\e dimension 2) or a sphere (3) */
        static Shape ball(unsigned int dimension, double radius);

        /** \brief A rectangle with the given extents along x and y */
        static Shape box(const Eigen::Vector2d &size);

        /** \brief A box with the given extents along x, y and z */
        static Shape box(const Eigen::Vector3d &size);

        /** \brief A capsule whose segment lies along z and has the given length */
        static Shape capsule(unsigned int dimension, double radius, double length);

        /** \brief A cylinder along z, in space */
        static Shape cylinder(double radius, double length);

        /** \brief The convex hull of any points of the plane (\e dimension 2; z is ignored) or of space (3), see
            convexHull(). Body::convexPolygon() and Body::convexPolytope() refuse points inside it. */
        static Shape polytope(unsigned int dimension, const std::vector<Eigen::Vector3d> &points);

        /** \brief The surface of a mesh, for the plane (\e dimension 2) or for space (3)
            \throws ompl::Exception if it is null */
        static Shape mesh(unsigned int dimension, TriangleMeshPtr mesh);

        /** \brief What this shape is */
        Kind getKind() const
        {
            return kind_;
        }

        /** \brief The dimension of the workspace that this shape is for: 2 or 3 */
        unsigned int getDimension() const
        {
            return dimension_;
        }

        /** \brief The radius of a ball, a capsule or a cylinder; else 0 */
        double getRadius() const
        {
            return radius_;
        }

        /** \brief Extents of a box along its axes, (0, 0, length) of a capsule or a cylinder; else zero */
        const Eigen::Vector3d &getSize() const
        {
            return size_;
        }

        /** \brief The hull of a POLYTOPE and of a BOX; else nullptr */
        const ConvexHull *getHull() const
        {
            return hull_.get();
        }

        /** \brief The triangles of a MESH; else nullptr */
        const TriangleMesh *getMesh() const
        {
            return mesh_.get();
        }

        /** \brief Signed distance from \e point, in the shape's frame, to the shape: exact, negative inside. A mesh has
            no inside. For a planar mesh it is the distance to its projection into the plane. Cost: a few nanoseconds;
            linear in the faces of a polytope and in the triangles of a mesh. */
        double signedDistance(const Eigen::Vector3d &point) const;

        /** \brief Whether signedDistance() is at most \e distance, which is not negative. Cost: as signedDistance(),
            but logarithmic in the triangles of a mesh. */
        bool isWithin(const Eigen::Vector3d &point, double distance) const;

        /** \brief Whether a planar shape at \e pose stays in the plane, but for rounding of at most 1e-12. It must be
            upright and, unless it is a mesh, at z = 0. Balls may be turned anyhow; capsules must lie. If so, that
            rounding is removed from \e pose, so that what is computed from it lies exactly in the plane. Spatial shapes
            may be anywhere. */
        bool snapToPlane(Pose &pose) const;

        /** \brief The smallest box along the axes of the shape's frame that contains the shape */
        Eigen::AlignedBox3d getBounds() const;

        /** \brief FCL is given all lengths times this power of two. Its solvers have absolute tolerances made for sizes
            above one. At a thousandth of that they report collisions across gaps of one per cent of a shape's size. */
        static constexpr double FCL_SCALE = 1024.0;

        /** \brief The shape as FCL sees it, FCL_SCALE times as large, shared by all copies. It is made when it is first
            asked for, which any thread may do. Cost then: n log n for the n triangles of a mesh, for FCL's tree of
            bounding volumes; later nothing. */
        const std::shared_ptr<fcl::CollisionGeometryd> &getCollisionGeometry() const;

        /** \brief Whether the two are the same shape in the same frame */
        bool operator==(const Shape &other) const;

    private:
        Shape(Kind kind, unsigned int dimension, double radius, const Eigen::Vector3d &size);

        /** \brief Where the shape as FCL sees it is kept, for all copies */
        struct ForFcl;

        std::shared_ptr<fcl::CollisionGeometryd> makeCollisionGeometry() const;

        Kind kind_;
        unsigned int dimension_;
        double radius_;
        Eigen::Vector3d size_;
        std::shared_ptr<const ConvexHull> hull_;
        TriangleMeshPtr mesh_;
        std::shared_ptr<ForFcl> forFcl_;
    };
}

#endif
