#ifndef OMPL_CERTIFICATES_OBSTACLES_CELL_SET_
#define OMPL_CERTIFICATES_OBSTACLES_CELL_SET_

#include "ompl_certificates/obstacles/CellBox.h"
#include "ompl_certificates/obstacles/ObstacleChange.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <utility>
#include <vector>

namespace ompl_certificates
{
    class CellBlock;
    struct BoxShapes;

    /** \brief Occupied cells of a grid that come and go, such as those of a map that a robot makes.

        The obstacles that a checker uses never change themselves: each change makes new ones, which share with the old
        ones what is in both.
        @code
        CellSet set(0.05);
        set.insert(occupied);
        TeamSetup setup(team, set.takeChange().after);
        ...
        set.remove(seenFree);
        set.insert(seenOccupied);
        setup.getTeamChecker()->changeObstacles(set.takeChange());
        @endcode
        The grid is divided into blocks of 16 cells along each axis. Those in which something changes are built anew.
        Not for several threads at once. The obstacles made of it are. */
    class CellSet
    {
    public:
        /** \brief An empty set of cells with the edge length \e cellSize, in a workspace of \e dimension 2 or 3
            \param origin where cell (0, 0, 0) has its lowest corner; in the plane z does not count
            \throws ompl::Exception for another dimension, if the size is not positive and finite, or if the origin is
            not finite */
        explicit CellSet(double cellSize, unsigned int dimension = 3,
                         const Eigen::Vector3d &origin = Eigen::Vector3d::Zero());

        ~CellSet();

        /** \brief Takes over the cells of another set, which is then of no use */
        CellSet(CellSet &&) noexcept;

        /** \brief Takes over the cells of another set, which is then of no use */
        CellSet &operator=(CellSet &&) noexcept;

        /** \brief Add all cells of some boxes; those that are there stay. In the plane a cell stands for an endless
            prism, and its place along z does not count. Cost: linear in the cells.
            \throws ompl::Exception if a box is empty or too far away, see CellBox::FARTHEST, or if those that are larger
            than a block of 16 cells a side reach into more than a million blocks, gigabytes, and so does the box around
            them. Then none is added. */
        void insert(const std::vector<CellBox> &boxes);

        /** \brief Remove all cells of some boxes that are there. Cost: linear in the cells of blocks that the
            boxes reach into; and some 0.1 µs for each column of blocks along z, and each slice of them across x, that
            they reach into.
            \throws ompl::Exception as insert(). Then none is removed. */
        void remove(const std::vector<CellBox> &boxes);

        /** \brief Whether a cell is there, with all that was inserted and removed; in the plane its place along z does
            not count. Cost: logarithmic in the number of blocks. */
        bool contains(const std::array<std::int32_t, 3> &cell) const;

        /** \brief The number of cells. Cost: linear in the number of blocks. */
        std::size_t size() const;

        /** \brief The obstacles now, and what was added and removed since the last call: the boxes that cells are
            joined into, as far as they have changed. If none have, the same obstacles again. Cells that came and went
            between are in neither. Cost: some tens of µs for each block in which a cell came or went, and some 0.1 µs
            for each other block. */
        ObstacleChange takeChange();

    private:
        /** \brief How many cells a block has along an axis: as many as a box may have, so that blocks take apart few */
        static constexpr std::int32_t BLOCK = 16;

        /** \brief The cells of a block: for each row of them along x, which are occupied, a bit for each */
        using Cells = std::array<std::uint16_t, std::size_t(BLOCK) * BLOCK>;

        /** \brief The first cell of a block, divided by BLOCK */
        using Place = std::array<std::int32_t, 3>;

        /** \brief Where the row is in a block that has so much of y and z, counted from the block's first cell */
        static std::size_t rowOf(std::int32_t y, std::int32_t z);

        /** \brief The cells of a block, and the boxes that they are joined into */
        struct Block
        {
            Cells cells;
            std::shared_ptr<const CellBlock> made;
        };

        /** \brief The cells of a block as they were at the last takeChange() */
        Cells cellsOf(const Place &place) const;

        /** \brief How many blocks a box reaches into */
        double countBlocks(const CellBox &box) const;

        /** \brief The first and the last block that a box reaches into */
        std::pair<Place, Place> placesOf(const CellBox &box) const;

        /** \brief Sets those cells of a box that are in a block */
        void setWithin(const Place &place, const CellBox &box, bool occupied);

        /** \brief The cells of a block as boxes, joined */
        std::vector<CellBox> boxesOf(const Place &place, const Cells &cells) const;

        double cellSize_;
        unsigned int dimension_;
        Eigen::Vector3d origin_;
        /** \brief The shapes of all boxes that there have been: at most 4096 sizes */
        std::unique_ptr<BoxShapes> shapes_;
        /** \brief The blocks that are not empty, as they were at the last takeChange() */
        std::map<Place, Block> blocks_;
        /** \brief The cells now of those blocks in which one may have come or gone since */
        std::map<Place, Cells> edited_;
        /** \brief What the last takeChange() made */
        ObstaclesPtr after_;
    };
}

#endif
