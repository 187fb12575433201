#include "CellOutline.h"

#include "obstacles/JoinCells.h"

#include <algorithm>
#include <cmath>

namespace ompl_certificates
{
    namespace
    {
        /** The quotient, rounded down */
        std::int32_t quotient(std::int32_t number, std::int32_t divisor)
        {
            return number / divisor - (number % divisor < 0 ? 1 : 0);
        }

        /** How near a box is to the viewer */
        double nearnessOf(const CellBox &box, int up)
        {
            // One who has y upwards looks down, one who has z upwards looks along y.
            return up == 1 ? 0.5 * (box.low[2] + box.high[2]) : -0.5 * (box.low[1] + box.high[1]);
        }
    }

    std::vector<std::vector<Eigen::AlignedBox3d>> cellOutlines(const CellObstacles &cells, int up, double finest,
                                                               int levels)
    {
        const auto &boxes = cells.getBoxes();
        if (boxes.empty())
            return {};
        const auto upAxis = static_cast<std::size_t>(up);
        const auto factor = static_cast<std::int32_t>(
            std::clamp(std::ceil(finest / cells.getCellSize()), 1.0, double(CellBox::FARTHEST)));
        const double size = cells.getCellSize() * factor;
        const auto [farthest, nearest] = std::minmax_element(boxes.begin(), boxes.end(),
                                                             [up](const CellBox &a, const CellBox &b)
                                                             { return nearnessOf(a, up) < nearnessOf(b, up); });
        const double far = nearnessOf(*farthest, up), depth = nearnessOf(*nearest, up) - far;
        std::vector<std::vector<Eigen::AlignedBox3d>> outlines;
        for (int level = 0; level < (cells.getDimension() == 3 ? levels : 1); ++level)
        {
            std::vector<CellBox> seen;
            for (const CellBox &box : boxes)
                if (nearnessOf(box, up) >= far + depth * level / levels)
                    seen.push_back(
                        {{quotient(box.low[0], factor), quotient(box.low[upAxis], factor), 0},
                         {quotient(box.high[0] - 1, factor) + 1, quotient(box.high[upAxis] - 1, factor) + 1, 0}});
            outlines.emplace_back();
            for (const auto &[low, high] : joinCells(flattenCells(seen), 2 * CellBox::FARTHEST))
            {
                Eigen::AlignedBox3d rectangle(Eigen::Vector3d::Zero().eval(), Eigen::Vector3d::Zero().eval());
                rectangle.min()[0] = cells.getOrigin()[0] + size * low[0];
                rectangle.max()[0] = cells.getOrigin()[0] + size * high[0];
                rectangle.min()[up] = cells.getOrigin()[up] + size * low[1];
                rectangle.max()[up] = cells.getOrigin()[up] + size * high[1];
                outlines.back().push_back(rectangle);
            }
        }
        return outlines;
    }
}
