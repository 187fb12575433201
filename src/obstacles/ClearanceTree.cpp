#include "ClearanceTree.h"

#include <algorithm>

namespace ompl_certificates
{
    namespace
    {
        constexpr std::uint32_t SHAPES_PER_LEAF = 2;

        /** Signed distance to a box: a lower bound of the signed distance to anything in the box. The depth in a flat
            box (in the plane) is bounded by its other extents. */
        double signedDistanceToBox(const Eigen::AlignedBox3d &box, const Eigen::Vector3d &point)
        {
            const Eigen::Vector3d outside = (box.min() - point).cwiseMax(point - box.max());
            const double deepest = box.sizes().z() == 0.0 ? outside.head<2>().maxCoeff() : outside.maxCoeff();
            return deepest <= 0.0 ? deepest : outside.cwiseMax(0.0).norm();
        }
    }

    void ClearanceTree::add(const Shape &shape, const Pose &pose)
    {
        Eigen::AlignedBox3d box = shape.getBounds().transformed(pose);
        // A planar capsule is round out of the plane too, which would hide how deep a point is in its flat neighbors.
        if (shape.getDimension() == 2)
            box.min().z() = box.max().z() = 0.0;
        items_.push_back({box, pose.inverse(), shape});
    }

    void ClearanceTree::build()
    {
        nodes_.clear();
        if (!items_.empty())
            buildNode(0, static_cast<std::uint32_t>(items_.size()));
    }

    std::uint32_t ClearanceTree::buildNode(std::uint32_t first, std::uint32_t count)
    {
        const auto index = static_cast<std::uint32_t>(nodes_.size());
        nodes_.emplace_back();
        Eigen::AlignedBox3d box, centers;
        for (std::uint32_t i = first; i < first + count; ++i)
        {
            box.extend(items_[i].box);
            centers.extend(items_[i].box.center());
        }
        nodes_[index].box = box;
        nodes_[index].first = first;
        nodes_[index].count = count;
        if (count > SHAPES_PER_LEAF)
        {
            Eigen::Index axis;
            centers.sizes().maxCoeff(&axis);
            const auto begin = items_.begin() + first, middle = begin + count / 2;
            std::nth_element(begin, middle, begin + count,
                             [axis](const Item &a, const Item &b)
                             { return a.box.center()[axis] < b.box.center()[axis]; });
            buildNode(first, count / 2);
            nodes_[index].right = buildNode(first + count / 2, count - count / 2);
        }
        return index;
    }

    double ClearanceTree::signedDistance(const Eigen::Vector3d &point, double most) const
    {
        double nearest = most;
        if (!nodes_.empty())
            search(0, point, nearest);
        return nearest;
    }

    void ClearanceTree::search(std::uint32_t index, const Eigen::Vector3d &point, double &nearest) const
    {
        const Node &node = nodes_[index];
        if (node.right == 0)
        {
            for (std::uint32_t i = node.first; i < node.first + node.count; ++i)
                if (const Item &item = items_[i]; signedDistanceToBox(item.box, point) < nearest)
                    nearest = std::min(nearest, item.shape.signedDistance(item.toShape * point));
            return;
        }
        std::uint32_t near = index + 1, far = node.right;
        double nearBound = signedDistanceToBox(nodes_[near].box, point);
        double farBound = signedDistanceToBox(nodes_[far].box, point);
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
