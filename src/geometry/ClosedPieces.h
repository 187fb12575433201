#ifndef OMPL_CERTIFICATES_GEOMETRY_CLOSED_PIECES_
#define OMPL_CERTIFICATES_GEOMETRY_CLOSED_PIECES_

#include "TriangleTree.h"

#include <vector>

namespace ompl_certificates
{
    /** \brief Triangles, as indices of their corners */
    using Surface = std::vector<std::array<std::uint32_t, 3>>;

    /** \brief The triangles that hang together by their corners
        \param vertexCount how many vertices there are */
    std::vector<Surface> piecesOf(const Surface &triangles, std::size_t vertexCount);

    /** \brief A piece of a mesh: triangles that hang together by their corners. Each edge has as many of them on one
        side as on the other. So the piece has an inside, and every path from there to far away meets a triangle. */
    struct ClosedPiece
    {
        /** \brief The triangles */
        TriangleTree surface;

        /** \brief The box around them */
        Eigen::AlignedBox3d box;

        /** \brief For each side of the box, a corner of a triangle that lies on it */
        std::array<Eigen::Vector3d, 6> corners;
    };

    /** \brief The closed pieces of a mesh that are not flat, the largest first. Cost: n log n for n triangles. */
    std::vector<ClosedPiece> closedPiecesOf(const TriangleTree &mesh);

    /** \brief Whether a point is inside a closed piece. False where it is so near to a triangle that rounding matters.
        Cost: linear in the number of triangles, some 40 ns for each. */
    bool isInside(const TriangleTree &surface, const Eigen::Vector3d &point);
}

#endif
