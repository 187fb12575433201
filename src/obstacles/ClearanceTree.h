#ifndef OMPL_CERTIFICATES_OBSTACLES_CLEARANCE_TREE_
#define OMPL_CERTIFICATES_OBSTACLES_CLEARANCE_TREE_

#include "ompl_certificates/geometry/Pose.h"
#include "ompl_certificates/geometry/Shape.h"

#include <cstdint>
#include <limits>
#include <vector>

namespace ompl_certificates
{
    /** \brief A tree of boxes over shapes that finds the signed distance of a point to the nearest of them. */
    class ClearanceTree
    {
    public:
        /** \brief Add \e shape at \e pose. Call build() after the last. */
        void add(const Shape &shape, const Pose &pose);

        /** \brief Build the tree. Cost: n log² n for n shapes. */
        void build();

        /** \brief The smallest signed distance of \e point to any of the shapes; \e most if none is nearer. Cost:
            logarithmic in the number of shapes, unless many are about equally far. */
        double signedDistance(const Eigen::Vector3d &point,
                              double most = std::numeric_limits<double>::infinity()) const;

        /** \brief The number of shapes */
        std::size_t size() const
        {
            return items_.size();
        }

    private:
        struct Item
        {
            Eigen::AlignedBox3d box;
            Pose toShape;
            Shape shape;
        };

        /** An inner node has its left child next to it and its right one at \e right. A leaf has right == 0 and its
            items from \e first on. */
        struct Node
        {
            Eigen::AlignedBox3d box;
            std::uint32_t right{0};
            std::uint32_t first{0};
            std::uint32_t count{0};
        };

        std::uint32_t buildNode(std::uint32_t first, std::uint32_t count);

        /** \brief Lower \e nearest to the smallest signed distance in the subtree of \e index, if that is smaller */
        void search(std::uint32_t index, const Eigen::Vector3d &point, double &nearest) const;

        std::vector<Item> items_;
        std::vector<Node> nodes_;
    };
}

#endif
