#ifndef OMPL_CERTIFICATES_GEOMETRY_MESH_SOLID_
#define OMPL_CERTIFICATES_GEOMETRY_MESH_SOLID_

#include "ompl_certificates/geometry/TriangleMesh.h"

namespace ompl_certificates
{
    /** \brief The solid that the closed pieces of a mesh bound: all points inside one of them.

        Meshes of real robots have triangles that are wound the wrong way, that are there twice, or that hang loose. So
        twins are left out, then triangles with an edge that no other has, until there is none. What hangs together of
        the rest is a closed piece if each edge has an even number of triangles. A point is inside a piece if a ray from
        there meets it an odd number of times, whichever way its triangles are wound. */
    class MeshSolid
    {
    public:
        /** \brief Cost: n log n for n triangles */
        explicit MeshSolid(const TriangleMesh &mesh);

        /** \brief Whether a point is inside a closed piece, in the mesh's frame. Cost: some nanoseconds for each
            triangle of the cells of a grid that the ray from there passes: a few, unless all are in one place. */
        bool contains(const Eigen::Vector3d &point) const;

    private:
        struct Piece
        {
            /** \brief Sorts the triangles into the columns */
            void sort();

            /** \brief The column of a grid, seen along the rays, that has a coordinate on an axis */
            std::size_t columnOf(std::size_t axis, double coordinate) const;

            bool contains(const Eigen::Vector3d &point) const;

            Eigen::AlignedBox3d box;
            /** \brief The corners of each triangle, in one order for the whole mesh: then two triangles agree on which
                side of their edge a point is. */
            std::vector<std::array<Eigen::Vector3d, 3>> triangles;
            /** \brief How many columns there are on either axis, and where the triangles of each begin in \e sorted */
            std::size_t columns{1};
            std::vector<std::uint32_t> begins, sorted;
        };

        std::vector<Piece> pieces_;
    };
}

#endif
