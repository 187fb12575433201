#include "CellTree.h"

#include "geometry/WideRegisters.h"

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
            // Divided along the axis along which they are scattered most
            std::array<double, 3> sum{}, squares{};
            for (auto i = begin; i != end; ++i)
                for (std::size_t axis = 0; axis < 3; ++axis)
                {
                    const double middle = i->low[axis] + i->high[axis];
                    sum[axis] += middle;
                    squares[axis] += middle * middle;
                }
            const auto scatter = [&](std::size_t axis)
            { return squares[axis] - sum[axis] * sum[axis] / static_cast<double>(end - begin); };
            std::size_t widest = 0;
            for (std::size_t axis = 1; axis < 3; ++axis)
                if (scatter(axis) > scatter(widest))
                    widest = axis;
            const auto middle = begin + groups / 2 * size;
            std::nth_element(begin, middle, end,
                             [widest](const CellBox &a, const CellBox &b)
                             { return a.low[widest] + a.high[widest] < b.low[widest] + b.high[widest]; });
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
            const std::uint32_t child = begin == end ? NONE : capacity > 1 ? build(begin, end - begin) : LEAF | begin;
            nodes_[index].child[k] = child;
        }
        return index;
    }

    OMPL_CERTIFICATES_WIDE_WHOLE std::uint32_t CellTree::findNearest(const Eigen::Vector3d &point, double &lowest) const
    {
        std::uint32_t found = NONE;
        visitByDistance(point, lowest,
                        [&](std::uint32_t box, double squared)
                        {
                            lowest = squared;
                            found = box;
                        });
        return found;
    }

    OMPL_CERTIFICATES_WIDE_WHOLE double CellTree::gap(const Eigen::AlignedBox3d &bounds, const Pose &pose,
                                                      double needed, double wanted) const
    {
        const TurnedBox turned(bounds, pose, extent_);
        double least = wanted;
        std::uint32_t limit = toBound(wanted);
        walk([&](const Node &node)
             { return toBounds(gaps(FloatNode(node), turned.box, turned.turn) - turned.rounding); },
             limit,
             [&](const Node & /*node*/, std::uint32_t /*k*/, std::uint32_t bound)
             {
                 float nearest;
                 std::memcpy(&nearest, &bound, sizeof(nearest));
                 least = nearest;
                 limit = bound;
                 return least <= needed;
             });
        return least;
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
