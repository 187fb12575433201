#include "CellTree.h"

#include <algorithm>
#include <cmath>

namespace ompl_certificates
{
    namespace
    {
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
}
