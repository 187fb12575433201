#ifndef OMPL_CERTIFICATES_OBSTACLES_CELL_BOX_
#define OMPL_CERTIFICATES_OBSTACLES_CELL_BOX_

#include <array>
#include <cstdint>

namespace ompl_certificates
{
    /** \brief A box of cells of a regular grid. Cell (i, j, k) reaches from (i, j, k) to (i + 1, j + 1, k + 1), times
        the edge length of a cell. */
    struct CellBox
    {
        /** \brief The index of a cell is at least minus this, and less than this, as in an octomap */
        static constexpr std::int32_t FARTHEST = 1 << 15;

        /** \brief Its first cell along x, y and z */
        std::array<std::int32_t, 3> low;

        /** \brief One more than its last cell along x, y and z */
        std::array<std::int32_t, 3> high;

        /** \brief Whether both have the same cells */
        bool operator==(const CellBox &other) const
        {
            return low == other.low && high == other.high;
        }
    };
}

#endif
