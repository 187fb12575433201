#ifndef OMPL_CERTIFICATES_OBSTACLES_JOIN_CELLS_
#define OMPL_CERTIFICATES_OBSTACLES_JOIN_CELLS_

#include "ompl_certificates/obstacles/CellBox.h"

#include <vector>

namespace ompl_certificates
{
    /** \brief Fewer boxes of the same cells: those that share a whole face are joined, up to \e most cells along an axis.
        The boxes must not overlap. Cost: n log n for n of them. */
    std::vector<CellBox> joinCells(std::vector<CellBox> boxes, std::int32_t most);

    /** \brief The squares that \e boxes cover, seen from above, as flat boxes at z = 0 that do not overlap. Cost: linear in
        their cells along y. */
    std::vector<CellBox> flattenCells(const std::vector<CellBox> &boxes);
}

#endif
