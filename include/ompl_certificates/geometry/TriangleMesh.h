#ifndef OMPL_CERTIFICATES_GEOMETRY_TRIANGLE_MESH_
#define OMPL_CERTIFICATES_GEOMETRY_TRIANGLE_MESH_

#include <Eigen/Geometry>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace ompl_certificates
{
    class MeshInside;
    class MeshSolid;
    class TriangleTree;

    /** \brief A triangle soup in its own frame, in the scene's length unit. It never changes and is shared by pointer.

        Open, duplicated and degenerate triangles are normal input. Degenerate ones have practically no area (see
        isDegenerate()). They are kept, but never collide and have no clearance: FCL's triangle test is undefined for
        them, and what they touch is touched by their neighbors. Two kinds are not, and are not checked; a warning
        tells of them: parts that are a ten-millionth as large as the whole, and wires, which leave all other
        triangles. */
    class TriangleMesh
    {
    public:
        /** \brief Indices of three vertices */
        using Triangle = std::array<std::uint32_t, 3>;

        /** \brief A mesh of the given triangles
            \param name what warnings call it, such as the name of a file
            \throws ompl::Exception if there is no triangle, if all are degenerate, if an index is out of range, or if a
            coordinate is not finite or larger than 10^15 */
        TriangleMesh(std::vector<Eigen::Vector3d> vertices, std::vector<Triangle> triangles,
                     const std::string &name = "a mesh");
        ~TriangleMesh();

        /** \brief The vertices, in the given order */
        const std::vector<Eigen::Vector3d> &getVertices() const
        {
            return vertices_;
        }

        /** \brief The triangles, in the given order */
        const std::vector<Triangle> &getTriangles() const
        {
            return triangles_;
        }

        /** \brief The corners of a triangle */
        std::array<Eigen::Vector3d, 3> getCorners(std::size_t triangle) const
        {
            const Triangle &corners = triangles_[triangle];
            return {vertices_[corners[0]], vertices_[corners[1]], vertices_[corners[2]]};
        }

        /** \brief The smallest box along the axes that contains all triangles */
        const Eigen::AlignedBox3d &getBounds() const
        {
            return bounds_;
        }

        /** \brief Whether a triangle's height is at most a ten-millionth of half the diagonal of getBounds(). That is the
            rounding of mesh files, which mostly have single precision. A height of at most 1e-12 of the largest distance
            of a corner from the origin counts, too. */
        bool isDegenerate(std::size_t triangle) const;

        /** \brief Whether the mesh encloses a volume: each edge has exactly two triangles, after welding equal vertices
            and dropping triangles with two equal corners. Cost: n log n for n triangles, at every call. */
        bool isClosed() const;

        /** \brief A tree over the triangles that are not degenerate, in the mesh's frame, for the library's own checks;
            made when first asked for */
        const TriangleTree &getTree() const;

        /** \brief The same of the triangles as seen from above, that is with z = 0: upright ones are segments. For the
            library's own checks in the plane; made when first asked for */
        const TriangleTree &getOutline() const;

        /** \brief Balls inside the mesh's closed pieces, for the library's own checks; made when first asked for */
        const MeshInside &getInside() const;

        /** \brief The solid that the mesh's closed pieces bound, for the library's own filters; made when first asked
            for */
        const MeshSolid &getSolid() const;

    private:
        std::vector<Eigen::Vector3d> vertices_;
        std::vector<Triangle> triangles_;
        Eigen::AlignedBox3d bounds_;
        double leastHeight_{0.0};
        mutable std::once_flag once_;
        mutable std::unique_ptr<TriangleTree> tree_;
        mutable std::once_flag outlineOnce_;
        mutable std::unique_ptr<TriangleTree> outline_;
        mutable std::once_flag insideOnce_;
        mutable std::unique_ptr<MeshInside> inside_;
        mutable std::once_flag solidOnce_;
        mutable std::unique_ptr<MeshSolid> solid_;
    };

    /** \brief A shared pointer to a mesh */
    using TriangleMeshPtr = std::shared_ptr<const TriangleMesh>;
}

#endif
