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

        /** \brief Whether a point is inside a closed piece, in the mesh's frame. Cost: linear in the triangles of the
            pieces whose boxes contain it, some nanoseconds for each. */
        bool contains(const Eigen::Vector3d &point) const;

    private:
        struct Piece
        {
            Eigen::AlignedBox3d box;
            /** \brief The corners of each triangle, in one order for the whole mesh: then two triangles agree on which
                side of their edge a point is. */
            std::vector<std::array<Eigen::Vector3d, 3>> triangles;
        };

        std::vector<Piece> pieces_;
    };
}

#endif
