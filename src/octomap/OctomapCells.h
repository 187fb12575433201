#ifndef OMPL_CERTIFICATES_OCTOMAP_OCTOMAP_CELLS_
#define OMPL_CERTIFICATES_OCTOMAP_OCTOMAP_CELLS_

#include "ompl_certificates/octomap/OctomapObstacles.h"

#include <octomap/OcTree.h>

namespace ompl_certificates
{
    /** \brief The cells of \e map that \e options make obstacles, in cells of the map's resolution; they do not overlap
        \throws ompl::Exception if the depth or the slice is not valid */
    std::vector<CellBox> cellsOf(const octomap::OcTree &map, const OctomapOptions &options);
}

#endif
