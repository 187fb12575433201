#include "ompl_certificates/octomap/OctomapSet.h"

#include "OctomapCells.h"

#include <algorithm>
#include <ompl/util/Exception.h>
#include <utility>

namespace ompl_certificates
{
    namespace
    {
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

        /** The cell with an edge of so many of the map's that a key is in, in cells of the map */
        CellBox cellAt(const octomap::OcTreeKey &key, std::int32_t edge)
        {
            CellBox cell;
            for (std::size_t axis = 0; axis < 3; ++axis)
            {
                cell.low[axis] = (key[static_cast<unsigned int>(axis)] / edge) * edge - CellBox::FARTHEST;
                cell.high[axis] = cell.low[axis] + edge;
            }
            return cell;
        }
    }

    OctomapSet::OctomapSet(octomap::OcTree &map, const OctomapOptions &options)
      : map_(map)
      , options_(options)
      , edge_(edgeOf(options))
      , cells_(edge_ * map.getResolution(), options.slice ? 2 : 3, options.origin)
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

    void OctomapSet::readChanged()
    {
        // Unknown cells are free, and the map prunes and expands only what stays as it is. So no other cells can differ
        // from the set's, and most of these do not: they are newly known, and free.
        std::vector<CellBox> occupied, freed;
        for (auto changed = map_.changedKeysBegin(); changed != map_.changedKeysEnd(); ++changed)
        {
            const CellBox cell = cellAt(changed->first, edge_);
            if (!isInSlice(options_, map_.getResolution(), cell))
                continue;
            const octomap::OcTreeNode *node = map_.search(changed->first);
            const bool isOccupied = node && map_.isNodeOccupied(node);
            const CellBox ours = inCellsOf(edge_, cell);
            if (isOccupied != cells_.contains(ours.low))
                isOccupied ? occupied.push_back(ours) : freed.push_back(cell);
        }
        cells_.insert(occupied);
        free(std::move(freed));
    }

    void OctomapSet::free(std::vector<CellBox> cells)
    {
        if (edge_ == 1 && !options_.slice)
            return cells_.remove(cells);
        // Other cells of the map may keep one of the set's occupied.
        if (options_.slice)
            for (CellBox &column : cells)
            {
                column.low[2] = WHOLE_OCTOMAP.low[2];
                column.high[2] = WHOLE_OCTOMAP.high[2];
            }
        const auto isBefore = [](const CellBox &a, const CellBox &b) { return a.low < b.low; };
        const auto isSame = [](const CellBox &a, const CellBox &b) { return a.low == b.low; };
        std::sort(cells.begin(), cells.end(), isBefore);
        cells.erase(std::unique(cells.begin(), cells.end(), isSame), cells.end());
        for (const CellBox &cell : cells)
            read(cell);
    }

    ObstacleChange OctomapSet::takeChange()
    {
        isRead_ ? readChanged() : read(WHOLE_OCTOMAP);
        isRead_ = true;
        map_.resetChangeDetection();
        return cells_.takeChange();
    }
}
