#ifndef OMPL_CERTIFICATES_OBSTACLES_JOIN_CELLS_
#define OMPL_CERTIFICATES_OBSTACLES_JOIN_CELLS_

#include "ompl_certificates/obstacles/CellBox.h"

#include <Eigen/Core>
#include <vector>

namespace ompl_certificates
{
    /** \brief The most cells of a joined box along an axis. Longer boxes make no check quicker, and FCL's tolerance
        grows with their size. */
    constexpr std::int32_t MOST_CELLS = 16;

    /** \brief Refuses a grid that makes no sense
        \throws ompl::Exception if the size of a cell is not positive and finite, the dimension is not 2 or 3, or the
        origin is not finite */
    void requireGrid(double cellSize, unsigned int dimension, const Eigen::Vector3d &origin);

    /** \brief Refuses boxes that are empty or too far away, in the first \e dimension axes
        \throws ompl::Exception if there is one */
    void requireCells(const std::vector<CellBox> &cells, unsigned int dimension);

    /** \brief Fewer boxes of the same cells: those that share a whole face are joined, up to \e most cells along an
        axis. The boxes must not overlap. Cost: n log n for n of them. */
    std::vector<CellBox> joinCells(std::vector<CellBox> boxes, std::int32_t most);

    /** \brief The squares that \e boxes cover, seen from above, as flat boxes at z = 0 that do not overlap. Cost:
        linear in their cells along y. */
    std::vector<CellBox> flattenCells(const std::vector<CellBox> &boxes);
}

#endif
