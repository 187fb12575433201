#ifndef OMPL_CERTIFICATES_GEOMETRY_TRIANGLE_TREE_
#define OMPL_CERTIFICATES_GEOMETRY_TRIANGLE_TREE_

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <vector>

namespace ompl_certificates
{
    /** \brief A tree of boxes over triangles that finds the distance of a point to the nearest of them. */
    class TriangleTree
    {
    public:
        /** \brief Add the triangle with the given corners; it may have no area. Call build() after the last. */
        void add(const Eigen::Vector3d &a, const Eigen::Vector3d &b, const Eigen::Vector3d &c)
        {
            triangles_.push_back({a, b, c});
        }

        /** \brief Build the tree. Cost: n log n for n triangles. */
        void build();

        /** \brief The distance of \e point to the nearest triangle, or \e limit if that is not larger. Cost: logarithmic in
            the number of triangles, unless many are about equally far. */
        double distance(const Eigen::Vector3d &point, double limit) const;

        /** \brief The number of triangles */
        std::size_t size() const
        {
            return triangles_.size();
        }

    private:
        using Corners = std::array<Eigen::Vector3d, 3>;

        /** A node: an inner one has its left child next to it and its right one at \e right; a leaf has right == 0 and
            its triangles from \e first on. */
        struct Node
        {
            Eigen::AlignedBox3d box;
            std::uint32_t right{0};
            std::uint32_t first{0};
            std::uint32_t count{0};
        };

        std::uint32_t buildNode(std::uint32_t first, std::uint32_t count);

        /** \brief Lower \e nearest, a squared distance, to that of the triangles below a node */
        void search(std::uint32_t index, const Eigen::Vector3d &point, double &nearest) const;

        std::vector<Corners> triangles_;
        std::vector<Node> nodes_;
    };
}

#endif
