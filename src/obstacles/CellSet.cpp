#include "ompl_certificates/obstacles/CellSet.h"

#include "CellForest.h"
#include "JoinCells.h"

#include "ompl_certificates/obstacles/CellObstacles.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <ompl/util/Exception.h>
#include <utility>

namespace ompl_certificates
{
    namespace
    {
        /** The quotient, rounded down */
        std::int32_t divided(std::int32_t number, std::int32_t divisor)
        {
            return number >= 0 ? number / divisor : -((divisor - 1 - number) / divisor);
        }

        bool isBoxBefore(const CellBox &a, const CellBox &b)
        {
            return a.low != b.low ? a.low < b.low : a.high < b.high;
        }

        /** The bits from \e low to below \e high */
        std::uint32_t rowBits(std::int32_t low, std::int32_t high)
        {
            return (1U << static_cast<std::uint32_t>(high)) - (1U << static_cast<std::uint32_t>(low));
        }

        /** How many blocks boxes that are larger than a block may reach into. A block takes one or two kilobytes. */
        constexpr double MOST_BLOCKS = 1 << 20;

        /** A box of a block's size may reach into so many, or fewer in the plane. */
        constexpr double BLOCKS_OF_ONE = 8.0;

        constexpr std::size_t NO_BOX = std::numeric_limits<std::size_t>::max();

        /** For each place in a layer the last box whose first corner is there */
        using LastBoxes = std::array<std::size_t, std::size_t(MOST_CELLS) * MOST_CELLS>;

        /** Adds the cells of a layer of a block, joined along x, then along y
            \param rows the bits of the layer's cells, a number for each row */
        void joinLayer(const std::uint16_t *rows, std::int32_t z, std::vector<CellBox> &boxes)
        {
            std::array<std::size_t, MOST_CELLS> last;
            last.fill(NO_BOX);
            for (std::int32_t y = 0; y < MOST_CELLS; ++y)
                for (std::uint32_t row = rows[y]; row != 0;)
                {
                    const std::int32_t low = __builtin_ctz(row), high = low + __builtin_ctz(~(row >> low));
                    row &= ~rowBits(low, high);
                    std::size_t &box = last[static_cast<std::size_t>(low)];
                    if (box != NO_BOX && boxes[box].high[0] == high && boxes[box].high[1] == y)
                        ++boxes[box].high[1];
                    else
                    {
                        box = boxes.size();
                        boxes.push_back({{low, y, z}, {high, y + 1, z + 1}});
                    }
                }
        }

        /** Joins the boxes from \e layer on with those of the same size below them */
        void joinBelow(std::size_t layer, std::vector<CellBox> &boxes, LastBoxes &below)
        {
            std::size_t kept = layer;
            for (std::size_t i = layer; i < boxes.size(); ++i)
            {
                const CellBox box = boxes[i];
                std::size_t &last = below[static_cast<std::size_t>(box.low[0]) +
                                          std::size_t(MOST_CELLS) * static_cast<std::size_t>(box.low[1])];
                if (last != NO_BOX && boxes[last].high == std::array{box.high[0], box.high[1], box.low[2]})
                    boxes[last].high[2] = box.high[2];
                else
                {
                    last = kept;
                    boxes[kept++] = box;
                }
            }
            boxes.resize(kept);
        }
    }

    CellSet::CellSet(double cellSize, unsigned int dimension, const Eigen::Vector3d &origin)
      : cellSize_(cellSize), dimension_(dimension), origin_(origin), shapes_(std::make_unique<BoxShapes>())
    {
        static_assert(BLOCK == MOST_CELLS, "Blocks should take apart no more boxes than need be");
        requireGrid(cellSize, dimension, origin);
    }

    CellSet::~CellSet() = default;
    CellSet::CellSet(CellSet &&) noexcept = default;
    CellSet &CellSet::operator=(CellSet &&) noexcept = default;

    void CellSet::insert(const std::vector<CellBox> &boxes)
    {
        requireCells(boxes, dimension_);
        // Many of them may be in one block, such as the rows of a picture: those of the box around all are enough.
        double sum = 0.0;
        CellBox around{{CellBox::FARTHEST, CellBox::FARTHEST, CellBox::FARTHEST},
                       {-CellBox::FARTHEST, -CellBox::FARTHEST, -CellBox::FARTHEST}};
        for (const CellBox &box : boxes)
            if (const double blocks = countBlocks(box); blocks > BLOCKS_OF_ONE)
            {
                sum += blocks;
                for (std::size_t axis = 0; axis < 3; ++axis)
                {
                    around.low[axis] = std::min(around.low[axis], box.low[axis]);
                    around.high[axis] = std::max(around.high[axis], box.high[axis]);
                }
            }
        if (sum > MOST_BLOCKS && countBlocks(around) > MOST_BLOCKS)
            throw ompl::Exception("CellSet",
                                  "boxes of cells are too large to be changed cell by cell: they reach into up to " +
                                      std::to_string(static_cast<std::uint64_t>(std::min(sum, countBlocks(around)))) +
                                      " blocks of " + std::to_string(BLOCK) + " cells a side, more than " +
                                      std::to_string(static_cast<std::uint64_t>(MOST_BLOCKS)) +
                                      ". Use larger cells, or leave what is unknown free");
        for (const CellBox &box : boxes)
        {
            const auto [first, last] = placesOf(box);
            for (Place place = first; place[0] <= last[0]; ++place[0])
                for (place[1] = first[1]; place[1] <= last[1]; ++place[1])
                    for (place[2] = first[2]; place[2] <= last[2]; ++place[2])
                        setWithin(place, box, true);
        }
    }

    void CellSet::remove(const std::vector<CellBox> &boxes)
    {
        requireCells(boxes, dimension_);
        for (const CellBox &box : boxes)
        {
            const auto [first, last] = placesOf(box);
            std::vector<Place> met;
            const auto meet = [&met, first = first, last = last](const auto &blocks)
            {
                auto block = blocks.lower_bound(first);
                while (block != blocks.end() && block->first[0] <= last[0])
                {
                    const auto [x, y, z] = block->first;
                    if (y < first[1] || (y <= last[1] && z < first[2]))
                        block = blocks.lower_bound({x, std::max(y, first[1]), first[2]});
                    else if (y > last[1])
                        block = blocks.lower_bound({x + 1, first[1], first[2]});
                    else if (z > last[2])
                        block = blocks.lower_bound({x, y + 1, first[2]});
                    else
                        met.push_back((block++)->first);
                }
            };
            meet(blocks_);
            meet(edited_);
            std::sort(met.begin(), met.end());
            met.erase(std::unique(met.begin(), met.end()), met.end());
            for (const Place &place : met)
                setWithin(place, box, false);
        }
    }

    double CellSet::countBlocks(const CellBox &box) const
    {
        const auto [first, last] = placesOf(box);
        double blocks = 1.0;
        for (std::size_t axis = 0; axis < dimension_; ++axis)
            blocks *= last[axis] - first[axis] + 1.0;
        return blocks;
    }

    std::pair<CellSet::Place, CellSet::Place> CellSet::placesOf(const CellBox &box) const
    {
        Place first{}, last{};
        for (std::size_t axis = 0; axis < dimension_; ++axis)
        {
            first[axis] = divided(box.low[axis], BLOCK);
            last[axis] = divided(box.high[axis] - 1, BLOCK);
        }
        return {first, last};
    }

    std::size_t CellSet::rowOf(std::int32_t y, std::int32_t z)
    {
        return static_cast<std::size_t>(y) + std::size_t(BLOCK) * static_cast<std::size_t>(z);
    }

    CellSet::Cells CellSet::cellsOf(const Place &place) const
    {
        const auto block = blocks_.find(place);
        return block == blocks_.end() ? Cells{} : block->second.cells;
    }

    void CellSet::setWithin(const Place &place, const CellBox &box, bool occupied)
    {
        auto edited = edited_.find(place);
        if (edited == edited_.end())
            edited = edited_.emplace(place, cellsOf(place)).first;
        // In the plane all cells are at height 0.
        Place low{}, high{1, 1, 1};
        for (std::size_t axis = 0; axis < dimension_; ++axis)
        {
            low[axis] = std::max(box.low[axis] - BLOCK * place[axis], 0);
            high[axis] = std::min(box.high[axis] - BLOCK * place[axis], BLOCK);
        }
        const auto bits = static_cast<std::uint16_t>(rowBits(low[0], high[0]));
        for (std::int32_t z = low[2]; z < high[2]; ++z)
            for (std::int32_t y = low[1]; y < high[1]; ++y)
            {
                std::uint16_t &row = edited->second[rowOf(y, z)];
                row = static_cast<std::uint16_t>(occupied ? row | bits : row & ~bits);
            }
    }

    std::vector<CellBox> CellSet::boxesOf(const Place &place, const Cells &cells) const
    {
        // The boxes that joinCells() makes of the single cells, without sorting these
        std::vector<CellBox> boxes;
        LastBoxes below;
        below.fill(NO_BOX);
        for (std::int32_t z = 0; z < (dimension_ == 2 ? 1 : BLOCK); ++z)
        {
            const std::size_t layer = boxes.size();
            joinLayer(&cells[rowOf(0, z)], z, boxes);
            joinBelow(layer, boxes, below);
        }
        for (CellBox &box : boxes)
            for (std::size_t axis = 0; axis < 3; ++axis)
            {
                box.low[axis] += BLOCK * place[axis];
                // In the plane boxes are flat.
                box.high[axis] = axis < dimension_ ? box.high[axis] + BLOCK * place[axis] : box.low[axis];
            }
        return boxes;
    }

    bool CellSet::contains(const std::array<std::int32_t, 3> &cell) const
    {
        Place place{}, within{};
        for (std::size_t axis = 0; axis < dimension_; ++axis)
        {
            place[axis] = divided(cell[axis], BLOCK);
            within[axis] = cell[axis] - BLOCK * place[axis];
        }
        const auto isIn = [&within](const Cells &cells)
        { return (cells[rowOf(within[1], within[2])] & rowBits(within[0], within[0] + 1)) != 0; };
        if (const auto edited = edited_.find(place); edited != edited_.end())
            return isIn(edited->second);
        const auto block = blocks_.find(place);
        return block != blocks_.end() && isIn(block->second.cells);
    }

    std::size_t CellSet::size() const
    {
        std::size_t count = 0;
        const auto add = [&count](const Cells &cells)
        {
            for (const std::uint16_t row : cells)
                count += static_cast<std::size_t>(__builtin_popcount(row));
        };
        for (const auto &[place, block] : blocks_)
            if (edited_.count(place) == 0)
                add(block.cells);
        for (const auto &[place, cells] : edited_)
            add(cells);
        return count;
    }

    ObstacleChange CellSet::takeChange()
    {
        std::vector<CellBox> added, removed;
        for (const auto &[place, cells] : edited_)
        {
            if (cells == cellsOf(place))
                continue;
            // What a certificate says of a point within a box is true of the whole box. So boxes come and go, not
            // cells.
            std::vector<CellBox> old, now = boxesOf(place, cells);
            if (const auto block = blocks_.find(place); block != blocks_.end())
                old = block->second.made->getTree().getBoxes();
            std::sort(old.begin(), old.end(), isBoxBefore);
            std::sort(now.begin(), now.end(), isBoxBefore);
            std::set_difference(now.begin(), now.end(), old.begin(), old.end(), std::back_inserter(added), isBoxBefore);
            std::set_difference(old.begin(), old.end(), now.begin(), now.end(), std::back_inserter(removed),
                                isBoxBefore);
            if (now.empty())
                blocks_.erase(place);
            else
                blocks_[place] = {cells,
                                  std::make_shared<const CellBlock>(cellSize_, std::move(now), dimension_, *shapes_)};
        }
        edited_.clear();
        if (after_ && added.empty() && removed.empty())
            return {after_, nullptr, nullptr, {}, after_};
        const auto obstaclesOf = [this](std::vector<CellBox> boxes) -> ObstaclesPtr
        {
            std::vector<std::shared_ptr<const CellBlock>> blocks;
            if (!boxes.empty())
                blocks.push_back(std::make_shared<const CellBlock>(cellSize_, std::move(boxes), dimension_, *shapes_));
            return ObstaclesPtr(new CellObstacles(std::make_unique<const CellForest>(std::move(blocks)), cellSize_,
                                                  dimension_, origin_));
        };
        std::vector<std::shared_ptr<const CellBlock>> blocks;
        blocks.reserve(blocks_.size());
        for (const auto &[place, block] : blocks_)
            blocks.push_back(block.made);
        ObstacleChange change;
        change.after.reset(
            new CellObstacles(std::make_unique<const CellForest>(std::move(blocks)), cellSize_, dimension_, origin_));
        if (!added.empty())
            change.added = obstaclesOf(std::move(added));
        if (!removed.empty())
            change.removed = obstaclesOf(std::move(removed));
        change.before = after_ ? after_ : obstaclesOf({});
        after_ = change.after;
        return change;
    }
}
