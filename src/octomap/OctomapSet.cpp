#include "ompl_certificates/octomap/OctomapSet.h"

#include "OctomapCells.h"

#include <algorithm>
#include <ompl/util/Exception.h>
#include <set>

namespace ompl_certificates
{
    namespace
    {
        /** Cells are read anew by cubes of at least so many along an axis, those of a CellSet. */
        constexpr std::int32_t BLOCK = 16;
    }

    OctomapSet::OctomapSet(octomap::OcTree &map, const OctomapOptions &options)
      : map_(map), options_(options), cells_(map.getResolution(), options.slice ? 2 : 3)
    {
        requireValid(options);
        if (options.unknownIsOccupied)
            throw ompl::Exception("Unknown cells of an octomap that changes cannot be occupied");
        map_.enableChangeDetection(true);
    }

    void OctomapSet::read(const CellBox &region)
    {
        cells_.remove({region});
        cells_.insert(cellsOf(map_, options_, region));
    }

    ObstacleChange OctomapSet::takeChange()
    {
        if (!isRead_)
            cells_.insert(cellsOf(map_, options_));
        else
        {
            // A cell of a depth less may be larger than a block.
            const std::int32_t edge = std::max(BLOCK, OCTOMAP_CELLS >> options_.depth);
            std::set<std::array<std::int32_t, 3>> regions;
            for (auto changed = map_.changedKeysBegin(); changed != map_.changedKeysEnd(); ++changed)
            {
                std::array<std::int32_t, 3> low;
                for (std::size_t axis = 0; axis < 3; ++axis)
                    low[axis] = (changed->first[static_cast<unsigned int>(axis)] / edge) * edge - CellBox::FARTHEST;
                if (options_.slice)
                    low[2] = -CellBox::FARTHEST;
                regions.insert(low);
            }
            for (const auto &low : regions)
                read({low, {low[0] + edge, low[1] + edge, options_.slice ? CellBox::FARTHEST : low[2] + edge}});
        }
        isRead_ = true;
        map_.resetChangeDetection();
        return cells_.takeChange();
    }
}
