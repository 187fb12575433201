#include "ompl_certificates/obstacles/CellSet.h"

#include "CellForest.h"
#include "JoinCells.h"

#include "ompl_certificates/obstacles/CellObstacles.h"

#include <algorithm>
#include <iterator>
#include <set>
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

        std::size_t countCells(const CellBox &box)
        {
            std::size_t count = 1;
            for (std::size_t axis = 0; axis < 3; ++axis)
                // In the plane boxes are flat.
                count *= static_cast<std::size_t>(std::max(box.high[axis] - box.low[axis], axis == 2 ? 1 : 0));
            return count;
        }
    }

    CellSet::CellSet(double cellSize, unsigned int dimension) : cellSize_(cellSize), dimension_(dimension)
    {
        static_assert(BLOCK == MOST_CELLS, "Blocks should take apart no more boxes than need be");
        requireGrid(cellSize, dimension);
    }

    CellSet::~CellSet() = default;
    CellSet::CellSet(CellSet &&) noexcept = default;
    CellSet &CellSet::operator=(CellSet &&) noexcept = default;

    void CellSet::insert(const std::vector<CellBox> &boxes)
    {
        requireCells(boxes, dimension_);
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
            std::set<Place> met;
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
                        met.insert((block++)->first);
                }
            };
            meet(blocks_);
            meet(edited_);
            for (const Place &place : met)
                setWithin(place, box, false);
        }
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

    std::size_t CellSet::indexOf(std::int32_t x, std::int32_t y, std::int32_t z)
    {
        constexpr auto block = static_cast<std::size_t>(BLOCK);
        return static_cast<std::size_t>(x) +
               block * (static_cast<std::size_t>(y) + block * static_cast<std::size_t>(z));
    }

    CellSet::Cells CellSet::cellsOf(const Place &place) const
    {
        Cells cells;
        if (const auto block = blocks_.find(place); block != blocks_.end())
            for (const CellBox &box : block->second->getTree().getBoxes())
                for (std::int32_t x = box.low[0]; x < box.high[0]; ++x)
                    for (std::int32_t y = box.low[1]; y < box.high[1]; ++y)
                        for (std::int32_t z = box.low[2]; z < std::max(box.high[2], box.low[2] + 1); ++z)
                            cells.set(indexOf(x - BLOCK * place[0], y - BLOCK * place[1], z - BLOCK * place[2]));
        return cells;
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
        for (std::int32_t z = low[2]; z < high[2]; ++z)
            for (std::int32_t y = low[1]; y < high[1]; ++y)
                for (std::int32_t x = low[0]; x < high[0]; ++x)
                    edited->second.set(indexOf(x, y, z), occupied);
    }

    std::vector<CellBox> CellSet::boxesOf(const Place &place, const Cells &cells) const
    {
        std::vector<CellBox> boxes;
        const std::int32_t thickness = dimension_ == 2 ? 0 : 1;
        for (std::int32_t z = 0; z < BLOCK; ++z)
            for (std::int32_t y = 0; y < BLOCK; ++y)
                for (std::int32_t x = 0; x < BLOCK; ++x)
                    if (cells.test(indexOf(x, y, z)))
                    {
                        const std::array<std::int32_t, 3> low{x + BLOCK * place[0], y + BLOCK * place[1],
                                                              z + BLOCK * place[2]};
                        boxes.push_back({low, {low[0] + 1, low[1] + 1, low[2] + thickness}});
                    }
        return joinCells(std::move(boxes), MOST_CELLS);
    }

    std::size_t CellSet::size() const
    {
        std::size_t count = 0;
        for (const auto &[place, block] : blocks_)
            if (edited_.count(place) == 0)
                for (const CellBox &box : block->getTree().getBoxes())
                    count += countCells(box);
        for (const auto &[place, cells] : edited_)
            count += cells.count();
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
                old = block->second->getTree().getBoxes();
            std::sort(old.begin(), old.end(), isBoxBefore);
            std::sort(now.begin(), now.end(), isBoxBefore);
            std::set_difference(now.begin(), now.end(), old.begin(), old.end(), std::back_inserter(added), isBoxBefore);
            std::set_difference(old.begin(), old.end(), now.begin(), now.end(), std::back_inserter(removed),
                                isBoxBefore);
            if (now.empty())
                blocks_.erase(place);
            else
                blocks_[place] = std::make_shared<const CellBlock>(cellSize_, std::move(now), dimension_);
        }
        edited_.clear();
        if (after_ && added.empty() && removed.empty())
            return {after_, nullptr, nullptr, {}, after_};
        const auto obstaclesOf = [this](std::vector<CellBox> boxes) -> ObstaclesPtr
        {
            std::vector<std::shared_ptr<const CellBlock>> blocks;
            if (!boxes.empty())
                blocks.push_back(std::make_shared<const CellBlock>(cellSize_, std::move(boxes), dimension_));
            return ObstaclesPtr(
                new CellObstacles(std::make_unique<const CellForest>(std::move(blocks)), cellSize_, dimension_));
        };
        std::vector<std::shared_ptr<const CellBlock>> blocks;
        blocks.reserve(blocks_.size());
        for (const auto &[place, block] : blocks_)
            blocks.push_back(block);
        ObstacleChange change;
        change.after.reset(
            new CellObstacles(std::make_unique<const CellForest>(std::move(blocks)), cellSize_, dimension_));
        if (!added.empty())
            change.added = obstaclesOf(std::move(added));
        if (!removed.empty())
            change.removed = obstaclesOf(std::move(removed));
        change.before = after_ ? after_ : obstaclesOf({});
        after_ = change.after;
        return change;
    }
}
