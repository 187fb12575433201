#ifndef OMPL_CERTIFICATES_SRC_PICTURES_CELL_OUTLINE_
#define OMPL_CERTIFICATES_SRC_PICTURES_CELL_OUTLINE_

#include "ompl_certificates/obstacles/CellObstacles.h"

#include <vector>

namespace ompl_certificates
{
    /** \brief What is seen of occupied cells by a viewer who has axis 0 to the right and axis \e up upwards: rectangles
        that do not overlap, flat along the axis of sight. The whole comes first, then parts nearer and nearer to the
        viewer.
        \param finest smaller cells are drawn as squares that are at least so wide
        \param levels how many parts, the whole included; in the plane there is only that */
    std::vector<std::vector<Eigen::AlignedBox3d>> cellOutlines(const CellObstacles &cells, int up, double finest,
                                                               int levels);
}

#endif
