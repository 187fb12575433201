#include "CellTree.h"

#include <algorithm>
#include <cmath>

namespace ompl_certificates
{
    namespace
    {
        /** Pays for the rounding of squared distances in single precision */
        constexpr float SHRINK = 1.0F - 2e-6F;

        /** The squares of larger coordinates do not fit into single precision. */
        constexpr double FARTHEST_POINT = 1e18;

        /** The square of how far a coordinate is outside an interval */
        double squaredOutside(double low, double high, double coordinate)
        {
            const double outside = std::max(std::max(low - coordinate, coordinate - high), 0.0);
            return outside * outside;
        }

        /** Orders the boxes from \e begin to \e end so that each \e size of them, one group after the other, are close
            together */
        void group(std::vector<CellBox>::iterator begin, std::vector<CellBox>::iterator end, std::ptrdiff_t size)
        {
            const std::ptrdiff_t groups = (end - begin + size - 1) / size;
            if (groups < 2)
                return;
            std::array<std::int32_t, 3> low = begin->low, high = begin->high;
            for (auto i = begin; i != end; ++i)
                for (std::size_t axis = 0; axis < 3; ++axis)
                {
                    low[axis] = std::min(low[axis], i->low[axis]);
                    high[axis] = std::max(high[axis], i->high[axis]);
                }
            std::size_t longest = 0;
            for (std::size_t axis = 1; axis < 3; ++axis)
                if (high[axis] - low[axis] > high[longest] - low[longest])
                    longest = axis;
            const auto middle = begin + groups / 2 * size;
            std::nth_element(begin, middle, end,
                             [longest](const CellBox &a, const CellBox &b)
                             { return a.low[longest] + a.high[longest] < b.low[longest] + b.high[longest]; });
            group(begin, middle, size);
            group(middle, end, size);
        }
    }

    CellTree::CellTree(std::vector<CellBox> boxes) : boxes_(std::move(boxes))
    {
        for (const CellBox &box : boxes_)
            for (std::size_t axis = 0; axis < 3; ++axis)
                extent_ = std::max({extent_, std::abs(double(box.low[axis])), std::abs(double(box.high[axis]))});
        if (!boxes_.empty())
            build(0, static_cast<std::uint32_t>(boxes_.size()));
        nodes_.shrink_to_fit();
    }

    std::uint32_t CellTree::build(std::uint32_t first, std::uint32_t count)
    {
        // All children but the last are full, so that the nodes are few.
        std::uint32_t capacity = 1;
        while (4 * capacity < count)
            capacity *= 4;
        group(boxes_.begin() + first, boxes_.begin() + first + count, capacity);
        const auto index = static_cast<std::uint32_t>(nodes_.size());
        nodes_.emplace_back();
        for (std::uint32_t k = 0; k < 4; ++k)
        {
            const std::uint32_t begin = std::min(first + k * capacity, first + count),
                                end = std::min(begin + capacity, first + count);
            for (std::size_t axis = 0; axis < 3; ++axis)
            {
                std::int32_t low = CellBox::FARTHEST - 1, high = -CellBox::FARTHEST + 1;
                for (std::uint32_t i = begin; i < end; ++i)
                {
                    low = std::min(low, boxes_[i].low[axis]);
                    high = std::max(high, boxes_[i].high[axis]);
                }
                nodes_[index].set(axis, static_cast<int>(k), low, high);
            }
            const std::uint32_t child = end - begin > 1    ? build(begin, end - begin)
                                        : end - begin == 1 ? LEAF | begin
                                                           : NONE;
            nodes_[index].child[k] = child;
        }
        return index;
    }

    double CellTree::depth(std::uint32_t box, const Eigen::Vector3d &point) const
    {
        double deepest = -std::numeric_limits<double>::infinity();
        for (std::size_t axis = 0; axis < 3; ++axis)
            if (boxes_[box].low[axis] < boxes_[box].high[axis])
            {
                const double coordinate = point[static_cast<Eigen::Index>(axis)];
                deepest = std::max({deepest, boxes_[box].low[axis] - coordinate, coordinate - boxes_[box].high[axis]});
            }
        return deepest;
    }

    double CellTree::signedDistance(const Eigen::Vector3d &point, std::uint32_t &nearest) const
    {
        double lowest = std::numeric_limits<double>::infinity();
        nearest = point.cwiseAbs().maxCoeff() < FARTHEST_POINT ? search(point, lowest) : searchAll(point, lowest);
        // The boxes do not overlap: within one, no other is nearer.
        return lowest == 0.0 && nearest != NONE ? depth(nearest, point) : std::sqrt(lowest);
    }

    std::uint32_t CellTree::searchAll(const Eigen::Vector3d &point, double &lowest) const
    {
        std::uint32_t found = NONE;
        for (std::uint32_t i = 0; i < boxes_.size(); ++i)
        {
            double squared = 0.0;
            for (std::size_t axis = 0; axis < 3; ++axis)
                squared += squaredOutside(boxes_[i].low[axis], boxes_[i].high[axis], point[Eigen::Index(axis)]);
            if (squared < lowest)
            {
                lowest = squared;
                found = i;
            }
        }
        return found;
    }

    std::uint32_t CellTree::search(const Eigen::Vector3d &point, double &lowest) const
    {
        std::uint32_t found = NONE;
        if (nodes_.empty())
            return found;
        // In single precision the point is somewhere between these.
        const auto rounding = static_cast<float>(1.5e-7 * point.cwiseAbs().maxCoeff());
        const Eigen::Vector3f least = point.cast<float>().array() - rounding,
                              most = point.cast<float>().array() + rounding;
        struct Open
        {
            float bound;
            std::uint32_t node;
        };
        Open stack[STACK_SIZE];
        std::size_t open = 0;
        std::uint32_t current = 0;
        for (;;)
        {
            const Node &node = nodes_[current];
            const FloatNode boxes(node);
            FourFloats bounds = {0.0F, 0.0F, 0.0F, 0.0F};
            for (int axis = 0; axis < 3; ++axis)
            {
                const FourFloats below = boxes.low[axis] - most[axis], above = least[axis] - boxes.high[axis],
                                 farther = below > above ? below : above, none = {0.0F, 0.0F, 0.0F, 0.0F},
                                 outside = farther > none ? farther : none;
                bounds += outside * outside;
            }
            bounds *= SHRINK;
            // The nearest child goes on top of the stack.
            Open *const begin = stack + open;
            for (int k = 0; k < 4; ++k)
            {
                const float bound = bounds[k];
                const std::uint32_t child = node.child[k];
                if (!(bound < lowest) || child == NONE)
                    continue;
                if (isLeaf(child))
                {
                    double squared = 0.0;
                    for (int axis = 0; axis < 3; ++axis)
                        squared += squaredOutside(boxes.low[axis][k], boxes.high[axis][k], point[axis]);
                    if (squared < lowest)
                    {
                        lowest = squared;
                        found = child & ~LEAF;
                    }
                    continue;
                }
                Open *slot = stack + open++;
                for (; slot != begin && slot[-1].bound < bound; --slot)
                    *slot = slot[-1];
                *slot = {bound, child};
            }
            do
            {
                if (open == 0)
                    return found;
                --open;
            } while (!(stack[open].bound < lowest));
            current = stack[open].node;
        }
    }
}
