#ifndef OMPL_CERTIFICATES_GEOMETRY_CONVEX_HULL_
#define OMPL_CERTIFICATES_GEOMETRY_CONVEX_HULL_

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace ompl_certificates
{
    /** \brief A convex polygon (in the plane z = 0) or a convex polytope, by its vertices and faces */
    struct ConvexHull
    {
        /** \brief A face lies in the plane normal . x = offset; the hull is where normal . x <= offset for all
            faces. */
        struct Face
        {
            /** \brief Unit normal, pointing outwards */
            Eigen::Vector3d normal;

            /** \brief Distance of the plane from the origin along the normal */
            double offset;

            /** \brief Indices of the face's vertices, counter-clockwise seen from outside; an edge's two in the
                plane */
            std::vector<std::size_t> vertices;
        };

        /** \brief The vertices; in the plane in counter-clockwise order */
        std::vector<Eigen::Vector3d> vertices;

        /** \brief The faces of a polytope, or the edges of a polygon */
        std::vector<Face> faces;

        /** \brief Signed distance of \e point: exact outside and inside (there negative). Cost: linear in the faces. */
        double signedDistance(const Eigen::Vector3d &point) const;
    };

    /** \brief The most points that convexHull() takes */
    constexpr std::size_t MAX_HULL_POINTS = 256;

    /** \brief The convex hull of points of the plane (\e dimension 2; z is ignored) or of space (3).
        \throws ompl::Exception if there are more than MAX_HULL_POINTS points, if one is not finite, or if they span no
        area, or no volume: if they are thinner than 3e-7 of their extent
        Cost in space: some 40 microseconds for a box, 2 milliseconds for 256 points. */
    ConvexHull convexHull(const std::vector<Eigen::Vector3d> &points, unsigned int dimension);
}

#endif
