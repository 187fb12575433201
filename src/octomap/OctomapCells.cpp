#include "OctomapCells.h"

#include <algorithm>
#include <cmath>
#include <ompl/util/Exception.h>

namespace ompl_certificates
{
    namespace
    {
        /** Of a cell, in which a slice must reach so far to count: what pays for the rounding of heights */
        constexpr double ROUNDING = 1e-6;

        CellBox intersection(const CellBox &a, const CellBox &b)
        {
            CellBox both = a;
            for (std::size_t axis = 0; axis < 3; ++axis)
            {
                both.low[axis] = std::max(a.low[axis], b.low[axis]);
                both.high[axis] = std::min(a.high[axis], b.high[axis]);
            }
            return both;
        }

        bool isEmpty(const CellBox &box)
        {
            return box.low[0] >= box.high[0] || box.low[1] >= box.high[1] || box.low[2] >= box.high[2];
        }

        /** The nodes of an octree as MapNodes has them */
        class OcTreeNodes
        {
        public:
            using Node = octomap::OcTreeNode;

            explicit OcTreeNodes(const octomap::OcTree &map) : map_(map)
            {
            }

            const Node *getRoot() const
            {
                return map_.getRoot();
            }

            const Node *getChild(const Node &node, unsigned int i) const
            {
                return map_.nodeChildExists(&node, i) ? map_.getNodeChild(&node, i) : nullptr;
            }

            bool hasChildren(const Node &node) const
            {
                return map_.nodeHasChildren(&node);
            }

            bool isOccupied(const Node &leaf) const
            {
                return map_.isNodeOccupied(&leaf);
            }

        private:
            const octomap::OcTree &map_;
        };

        /** Goes through the nodes of a map with the cubes that they stand for */
        template <typename Map>
        class MapWalk
        {
        public:
            MapWalk(const Map &map, const OctomapOptions &options, const CellBox &region)
              : map_(map), options_(options), region_(region)
            {
                if (options.unknownIsOccupied && map.getRoot())
                    extend(map.getRoot(), WHOLE_OCTOMAP);
            }

            std::vector<CellBox> getCells()
            {
                if (map_.getRoot())
                    collect(map_.getRoot(), WHOLE_OCTOMAP, 0);
                return std::move(cells_);
            }

        private:
            /** What is in a cube */
            struct Content
            {
                bool occupied{false};
                bool unknown{false};
            };

            using Node = typename Map::Node;

            static CellBox childOf(const CellBox &cube, unsigned int i)
            {
                const std::int32_t half = (cube.high[0] - cube.low[0]) / 2;
                CellBox child = cube;
                for (std::size_t axis = 0; axis < 3; ++axis)
                {
                    child.low[axis] += (i >> axis & 1U) != 0 ? half : 0;
                    child.high[axis] = child.low[axis] + half;
                }
                return child;
            }

            /** Extends the box of what is known by the leaves below a node */
            void extend(const Node *node, const CellBox &cube)
            {
                if (!map_.hasChildren(*node))
                {
                    for (std::size_t axis = 0; axis < 3; ++axis)
                    {
                        known_.low[axis] = std::min(known_.low[axis], cube.low[axis]);
                        known_.high[axis] = std::max(known_.high[axis], cube.high[axis]);
                    }
                    return;
                }
                for (unsigned int i = 0; i < 8; ++i)
                    if (const Node *child = map_.getChild(*node, i))
                        extend(child, childOf(cube, i));
            }

            /** Notes the obstacles in a cube; \e node is null where nothing is known. */
            void collect(const Node *node, const CellBox &cube, unsigned int depth)
            {
                if (isEmpty(intersection(cube, region_)))
                    return;
                if (node && map_.hasChildren(*node) && depth < options_.depth)
                {
                    for (unsigned int i = 0; i < 8; ++i)
                        collect(map_.getChild(*node, i), childOf(cube, i), depth + 1);
                    return;
                }
                const Content content = contentOf(node, cube);
                if (content.occupied)
                    cells_.push_back(intersection(cube, region_));
                else if (content.unknown)
                    cells_.push_back(intersection(intersection(cube, known_), region_));
            }

            Content contentOf(const Node *node, const CellBox &cube) const
            {
                if (!node)
                    return {false, options_.unknownIsOccupied && !isEmpty(intersection(cube, known_))};
                if (!map_.hasChildren(*node))
                    return {map_.isOccupied(*node), false};
                Content all;
                for (unsigned int i = 0; i < 8 && !all.occupied; ++i)
                {
                    const Content content = contentOf(map_.getChild(*node, i), childOf(cube, i));
                    all.occupied = content.occupied;
                    all.unknown = all.unknown || content.unknown;
                }
                return all;
            }

            const Map &map_;
            const OctomapOptions &options_;
            const CellBox &region_;

            /** The smallest box that contains all known cells */
            CellBox known_{WHOLE_OCTOMAP.high, WHOLE_OCTOMAP.low};
            std::vector<CellBox> cells_;
        };
    }

    void requireValid(const OctomapOptions &options)
    {
        if (options.depth < 1 || options.depth > OCTOMAP_DEPTH)
            throw ompl::Exception("The depth of an octomap's cells must be from 1 to " + std::to_string(OCTOMAP_DEPTH) +
                                  ", not " + std::to_string(options.depth));
        if (options.slice && !(options.slice->low < options.slice->high))
            throw ompl::Exception("The slice of an octomap must have its low end below its high one");
        constexpr double farthest = 1e9;
        if (!(options.origin.cwiseAbs().array() <= farthest).all())
            throw ompl::Exception("The origin of an octomap must be finite, and no number of it beyond 1e9");
    }

    bool isInSlice(const OctomapOptions &options, double resolution, const CellBox &box)
    {
        const double z = options.origin.z();
        return !options.slice || (box.high[2] > (options.slice->low - z) / resolution + ROUNDING &&
                                  box.low[2] < (options.slice->high - z) / resolution - ROUNDING);
    }

    namespace
    {
        std::vector<CellBox> inSlice(std::vector<CellBox> cells, const OctomapOptions &options, double resolution)
        {
            const auto isOutside = [&](const CellBox &box) { return !isInSlice(options, resolution, box); };
            if (options.slice)
                cells.erase(std::remove_if(cells.begin(), cells.end(), isOutside), cells.end());
            return cells;
        }
    }

    std::vector<CellBox> cellsOf(const octomap::OcTree &map, const OctomapOptions &options, const CellBox &region)
    {
        requireValid(options);
        return inSlice(MapWalk(OcTreeNodes(map), options, region).getCells(), options, map.getResolution());
    }

    std::vector<CellBox> cellsOf(const MapNodes &map, const OctomapOptions &options)
    {
        requireValid(options);
        return inSlice(MapWalk(map, options, WHOLE_OCTOMAP).getCells(), options, map.getResolution());
    }
}
