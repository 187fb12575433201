#ifndef OMPL_CERTIFICATES_OCTOMAP_OCTOMAP_CELLS_
#define OMPL_CERTIFICATES_OCTOMAP_OCTOMAP_CELLS_

#include "MapNodes.h"

#include "ompl_certificates/octomap/OctomapObstacles.h"

#include <octomap/OcTree.h>

namespace ompl_certificates
{
    /** \brief How many levels an octomap has below its root */
    constexpr unsigned int OCTOMAP_DEPTH = 16;

    /** \brief How many cells of the greatest depth it has along an axis */
    constexpr std::int32_t OCTOMAP_CELLS = 1 << OCTOMAP_DEPTH;

    /** \brief All of an octomap's cells */
    constexpr CellBox WHOLE_OCTOMAP{{-OCTOMAP_CELLS / 2, -OCTOMAP_CELLS / 2, -OCTOMAP_CELLS / 2},
                                    {OCTOMAP_CELLS / 2, OCTOMAP_CELLS / 2, OCTOMAP_CELLS / 2}};

    /** \brief Refuses options that make no sense
        \throws ompl::Exception if the depth, the slice or the origin is not valid */
    void requireValid(const OctomapOptions &options);

    /** \brief Whether the slice of \e options, if there is one, reaches into a box of cells with the edge length
        \e resolution */
    bool isInSlice(const OctomapOptions &options, double resolution, const CellBox &box);

    /** \brief The cells of \e map that \e options make obstacles, in cells of the map's resolution; they do not overlap
        \param region only the cells within it
        \throws ompl::Exception as requireValid() */
    std::vector<CellBox> cellsOf(const octomap::OcTree &map, const OctomapOptions &options,
                                 const CellBox &region = WHOLE_OCTOMAP);

    /** \brief The same for a map that was read from a file */
    std::vector<CellBox> cellsOf(const MapNodes &map, const OctomapOptions &options);
}

#endif
