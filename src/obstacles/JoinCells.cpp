#include "JoinCells.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <ompl/util/Exception.h>
#include <string>
#include <tuple>
#include <utility>

namespace ompl_certificates
{
    namespace
    {
        /** The extents of a box across an axis, then its place along it */
        auto orderAlong(std::size_t axis)
        {
            return [other = (axis + 1) % 3, another = (axis + 2) % 3, axis](const CellBox &box) {
                return std::make_tuple(box.low[other], box.high[other], box.low[another], box.high[another],
                                       box.low[axis]);
            };
        }

        /** Joins boxes that share a whole face across \e axis */
        void joinAlong(std::size_t axis, std::vector<CellBox> &boxes, std::int32_t most)
        {
            const auto order = orderAlong(axis);
            std::sort(boxes.begin(), boxes.end(),
                      [&](const CellBox &a, const CellBox &b) { return order(a) < order(b); });
            std::size_t kept = 0;
            for (const CellBox &box : boxes)
            {
                if (kept > 0)
                {
                    CellBox &last = boxes[kept - 1];
                    CellBox moved = box;
                    moved.low[axis] = last.low[axis];
                    if (last.high[axis] == box.low[axis] && order(moved) == order(last) &&
                        box.high[axis] - last.low[axis] <= most)
                    {
                        last.high[axis] = box.high[axis];
                        continue;
                    }
                }
                boxes[kept++] = box;
            }
            boxes.resize(kept);
        }
    }

    void requireGrid(double cellSize, unsigned int dimension, const Eigen::Vector3d &origin)
    {
        if (dimension != 2 && dimension != 3)
            throw ompl::Exception("A workspace has 2 or 3 dimensions, not " + std::to_string(dimension));
        if (!(cellSize > 0.0) || !std::isfinite(cellSize))
            throw ompl::Exception("The size of a cell must be positive and finite, not " + std::to_string(cellSize));
        if (!origin.allFinite())
            throw ompl::Exception("The origin of a grid must be finite");
    }

    void requireCells(const std::vector<CellBox> &cells, unsigned int dimension)
    {
        for (const CellBox &box : cells)
            for (std::size_t axis = 0; axis < dimension; ++axis)
            {
                if (box.low[axis] >= box.high[axis])
                    throw ompl::Exception("A box of cells must not be empty");
                if (box.low[axis] < -CellBox::FARTHEST || box.high[axis] > CellBox::FARTHEST)
                    throw ompl::Exception("The index of a cell must be from " + std::to_string(-CellBox::FARTHEST) +
                                          " to " + std::to_string(CellBox::FARTHEST - 1));
            }
    }

    std::vector<CellBox> joinCells(std::vector<CellBox> boxes, std::int32_t most)
    {
        for (std::size_t axis = 0; axis < 3; ++axis)
            joinAlong(axis, boxes, most);
        // Mostly few are left.
        boxes.shrink_to_fit();
        return boxes;
    }

    std::vector<CellBox> flattenCells(const std::vector<CellBox> &boxes)
    {
        // For each row of cells, what the boxes cover along x
        std::map<std::int32_t, std::vector<std::pair<std::int32_t, std::int32_t>>> rows;
        for (const CellBox &box : boxes)
            for (std::int32_t y = box.low[1]; y < box.high[1]; ++y)
                rows[y].emplace_back(box.low[0], box.high[0]);
        std::vector<CellBox> flat;
        for (auto &[y, intervals] : rows)
        {
            std::sort(intervals.begin(), intervals.end());
            auto [low, high] = intervals.front();
            for (const auto &[nextLow, nextHigh] : intervals)
            {
                if (nextLow > high)
                {
                    flat.push_back({{low, y, 0}, {high, y + 1, 0}});
                    low = nextLow;
                }
                high = std::max(high, nextHigh);
            }
            flat.push_back({{low, y, 0}, {high, y + 1, 0}});
        }
        return flat;
    }
}
