#include "ompl_certificates/geometry/TriangleTree.h"

#include "TriangleDistance.h"

#include <algorithm>
#include <cmath>

namespace ompl_certificates
{
    namespace
    {
        constexpr std::uint32_t LEAF_SIZE = 2;
    }

    void TriangleTree::build()
    {
        nodes_.clear();
        if (!triangles_.empty())
            buildNode(0, static_cast<std::uint32_t>(triangles_.size()));
    }

    std::uint32_t TriangleTree::buildNode(std::uint32_t first, std::uint32_t count)
    {
        const auto index = static_cast<std::uint32_t>(nodes_.size());
        nodes_.emplace_back();
        const auto centerOf = [](const Corners &t) -> Eigen::Vector3d { return (t[0] + t[1] + t[2]) / 3.0; };
        Eigen::AlignedBox3d box, centers;
        for (std::uint32_t i = first; i < first + count; ++i)
        {
            for (const auto &corner : triangles_[i])
                box.extend(corner);
            centers.extend(centerOf(triangles_[i]));
        }
        nodes_[index].box = box;
        nodes_[index].first = first;
        nodes_[index].count = count;
        if (count > LEAF_SIZE)
        {
            Eigen::Index axis;
            centers.sizes().maxCoeff(&axis);
            const auto begin = triangles_.begin() + first;
            std::nth_element(begin, begin + count / 2, begin + count,
                             [&](const Corners &a, const Corners &b) { return centerOf(a)[axis] < centerOf(b)[axis]; });
            buildNode(first, count / 2);
            nodes_[index].right = buildNode(first + count / 2, count - count / 2);
        }
        return index;
    }

    double TriangleTree::distance(const Eigen::Vector3d &point, double limit) const
    {
        if (nodes_.empty() || limit <= 0.0)
            return limit;
        double nearest = limit * limit;
        search(0, point, nearest);
        return std::min(limit, std::sqrt(nearest));
    }

    void TriangleTree::search(std::uint32_t index, const Eigen::Vector3d &point, double &nearest) const
    {
        const Node &node = nodes_[index];
        if (node.right == 0)
        {
            for (std::uint32_t i = node.first; i < node.first + node.count; ++i)
                nearest = std::min(
                    nearest, squaredDistanceToTriangle(point, triangles_[i][0], triangles_[i][1], triangles_[i][2]));
            return;
        }
        std::uint32_t near = index + 1, far = node.right;
        double nearBound = nodes_[near].box.squaredExteriorDistance(point);
        double farBound = nodes_[far].box.squaredExteriorDistance(point);
        if (farBound < nearBound)
        {
            std::swap(near, far);
            std::swap(nearBound, farBound);
        }
        if (nearBound < nearest)
            search(near, point, nearest);
        if (farBound < nearest)
            search(far, point, nearest);
    }
}
