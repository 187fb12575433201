#include "ompl_certificates/octomap/OctomapSet.h"

#include "OctomapCells.h"

#include <algorithm>
#include <ompl/util/Exception.h>
#include <set>

namespace ompl_certificates
{
    namespace
    {
        /** Cells are read anew by cubes of so many along an axis, the blocks of a CellSet. */
        constexpr std::int32_t BLOCK = 16;

        /** How many cells of the map a cell of a depth has along an axis */
        std::int32_t edgeOf(const OctomapOptions &options)
        {
            requireValid(options);
            return OCTOMAP_CELLS >> options.depth;
        }

        /** A box of cells of the map in cells with an edge of so many */
        CellBox inCellsOf(std::int32_t edge, CellBox box)
        {
            for (std::size_t axis = 0; axis < 3; ++axis)
            {
                box.low[axis] /= edge;
                box.high[axis] /= edge;
            }
            return box;
        }
    }

    OctomapSet::OctomapSet(octomap::OcTree &map, const OctomapOptions &options)
      : map_(map), options_(options), edge_(edgeOf(options)), cells_(edge_ * map.getResolution(), options.slice ? 2 : 3)
    {
        if (options.unknownIsOccupied)
            throw ompl::Exception("Unknown cells of an octomap that changes cannot be occupied");
        if (map_.isChangeDetectionEnabled())
            throw ompl::Exception("An octomap's change detection is on: another OctomapSet, or somebody else, uses it");
        map_.enableChangeDetection(true);
    }

    OctomapSet::~OctomapSet()
    {
        map_.enableChangeDetection(false);
        map_.resetChangeDetection();
    }

    void OctomapSet::read(const CellBox &region)
    {
        std::vector<CellBox> boxes = cellsOf(map_, options_, region);
        for (CellBox &box : boxes)
            box = inCellsOf(edge_, box);
        cells_.remove({inCellsOf(edge_, region)});
        cells_.insert(boxes);
    }

    void OctomapSet::reread()
    {
        isRead_ = false;
    }

    ObstacleChange OctomapSet::takeChange()
    {
        if (!isRead_)
            read(WHOLE_OCTOMAP);
        else
        {
            const std::int32_t edge = BLOCK * edge_;
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
