#include "ompl_certificates/robots/JointCells.h"

#include "CellTable.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <ompl/util/Exception.h>
#include <string>
#include <utility>

namespace ompl_certificates
{
    namespace
    {
        /** A cell has two to this power parts along each coordinate on the next level. */
        constexpr unsigned int BITS = 2;

        /** How many cells there are on the third level, for 0, 1, 2 and 3 coordinates. With more of them, more checks
            find an answer in the end, but later. */
        constexpr std::size_t CELL_COUNTS[] = {1, 1U << 10, 1U << 15, 1U << 15};

        /** A motion is followed through so many cells. */
        constexpr int MOST_STEPS = 24;

        void require(const JointCells::Coordinate &coordinate)
        {
            if (!(coordinate.lower < coordinate.upper) || !std::isfinite(coordinate.upper - coordinate.lower) ||
                !(coordinate.reach >= 0.0) || !std::isfinite(coordinate.reach))
                throw ompl::Exception("Coordinate " + std::to_string(coordinate.index) +
                                      " of joint cells needs finite bounds, the lower one first, and a reach that is "
                                      "finite and not negative, not " +
                                      std::to_string(coordinate.lower) + ", " + std::to_string(coordinate.upper) +
                                      " and " + std::to_string(coordinate.reach));
        }

        /** How many smallest cells make one of a level along a coordinate, as a power of two */
        constexpr unsigned int shiftOf(unsigned int level, unsigned int levels)
        {
            return BITS * (levels - 1 - level);
        }
    }

    JointCells::JointCells(std::vector<Coordinate> coordinates)
      : coordinates_(std::move(coordinates)), smallest_(std::make_unique<CellTable>())
    {
        if (coordinates_.size() > MOST_COORDINATES)
            throw ompl::Exception("Joint cells can have " + std::to_string(MOST_COORDINATES) + " coordinates, not " +
                                  std::to_string(coordinates_.size()));
        constexpr std::uint32_t parts = 1U << shiftOf(0, ROW_LEVELS);
        std::size_t all = 1;
        Values widths{};  // how far each coordinate moves points within a cell
        for (std::size_t i = 0; i < coordinates_.size(); ++i)
        {
            const Coordinate &one = coordinates_[i];
            require(one);
            counts_[i] = parts;
            all *= parts;
            widths[i] = one.reach * (one.upper - one.lower) / parts;
        }
        for (; all < CELL_COUNTS[coordinates_.size()]; all *= 2)
        {
            const auto widest =
                std::max_element(widths.begin(), widths.begin() + static_cast<std::ptrdiff_t>(coordinates_.size()));
            *widest *= 0.5;
            counts_[static_cast<std::size_t>(widest - widths.begin())] *= 2;
        }
        for (std::size_t i = 0; i < coordinates_.size(); ++i)
        {
            counts_[i] <<= BITS;
            scales_[i] = counts_[i] / (coordinates_[i].upper - coordinates_[i].lower);
        }
        std::size_t total = 0;
        for (unsigned int level = 0; level < LEVELS; ++level)
        {
            firsts_[level] = total;
            std::size_t cells = 1;
            for (std::size_t i = 0; i < coordinates_.size(); ++i)
                cells *= counts_[i] >> shiftOf(level, LEVELS);
            total += cells;
        }
        answers_ = std::make_unique<std::atomic<Answer>[]>(firsts_[ROW_LEVELS]);
    }

    JointCells::~JointCells() = default;

    void JointCells::note(const Cell &cell, Answer answer)
    {
        if (isSmallest(cell))
            smallest_->note(cell.number, answer);
        else
            answers_[cell.number].store(answer, std::memory_order_relaxed);
    }

    JointCells::Values JointCells::scaled(const Values &values) const
    {
        Values all{};
        for (std::size_t i = 0; i < coordinates_.size(); ++i)
            all[i] = (values[i] - coordinates_[i].lower) * scales_[i];
        return all;
    }

    bool JointCells::findIndex(const Values &scaled, Index &index) const
    {
        for (std::size_t i = 0; i < coordinates_.size(); ++i)
        {
            if (!(scaled[i] >= 0.0 && scaled[i] <= counts_[i]))
                return false;
            index[i] = std::min(static_cast<std::uint32_t>(scaled[i]), counts_[i] - 1);
        }
        return true;
    }

    JointCells::Cell JointCells::find(const Values &values) const
    {
        Index index;
        return findIndex(scaled(values), index) ? findAt(index) : Cell{0, 0, Answer::OPEN};
    }

    JointCells::Cell JointCells::findAt(const Index &index) const
    {
        Cell cell{};
        for (unsigned int level = 0; level < LEVELS; ++level)
        {
            const unsigned int shift = shiftOf(level, LEVELS);
            std::size_t number = 0;
            for (std::size_t i = 0; i < coordinates_.size(); ++i)
                number = number * (counts_[i] >> shift) + (index[i] >> shift);
            number += firsts_[level];
            cell = {level, number,
                    level < ROW_LEVELS ? answers_[number].load(std::memory_order_relaxed) : smallest_->find(number)};
            if (cell.answer != Answer::OPEN)
                break;
        }
        return cell;
    }

    std::vector<JointCells::Values> JointCells::getMiddles(unsigned int level) const
    {
        const unsigned int shift = shiftOf(level, LEVELS);
        std::vector<Values> middles(1);
        for (std::size_t i = 0; i < coordinates_.size(); ++i)
        {
            const std::uint32_t count = counts_[i] >> shift;
            const double half = 0.5 * static_cast<double>(1U << shift) / scales_[i];
            std::vector<Values> further;
            further.reserve(middles.size() * count);
            for (Values values : middles)
                for (std::uint32_t k = 0; k < count; ++k)
                {
                    values[i] = coordinates_[i].lower + (2.0 * k + 1.0) * half;
                    further.push_back(values);
                }
            middles.swap(further);
        }
        return middles;
    }

    double JointCells::moveToMiddle(const Cell &cell, Values &values) const
    {
        Index index{};
        findIndex(scaled(values), index);
        const unsigned int shift = shiftOf(cell.level, LEVELS);
        double farthest = 0.0;
        for (std::size_t i = 0; i < coordinates_.size(); ++i)
        {
            const double half = 0.5 * static_cast<double>(1U << shift) / scales_[i];
            values[i] = coordinates_[i].lower + (2.0 * (index[i] >> shift) + 1.0) * half;
            farthest += half * coordinates_[i].reach;
        }
        return farthest;
    }

    std::array<double, 2> JointCells::apartFor(const Values &values, const Values &change) const
    {
        const Values at = scaled(values);
        Index index;
        if (!findIndex(at, index))
            return {0.0, 0.0};
        Values forward{}, backward{};
        for (std::size_t i = 0; i < coordinates_.size(); ++i)
        {
            forward[i] = change[i] * scales_[i];
            backward[i] = -forward[i];
        }
        return {apartAfter(at, backward, index), apartAfter(at, forward, index)};
    }

    double JointCells::apartAfter(const Values &scaled, const Values &speed, Index index) const
    {
        double time = 0.0;
        for (int step = 0; step < MOST_STEPS && time < 1.0; ++step)
        {
            const Cell cell = findAt(index);
            if (cell.answer != Answer::APART)
                return time;
            const std::uint32_t size = 1U << shiftOf(cell.level, LEVELS);
            // Through which side the motion leaves the cell, and when
            double leaves = std::numeric_limits<double>::infinity();
            std::size_t across = 0;
            for (std::size_t i = 0; i < coordinates_.size(); ++i)
            {
                if (speed[i] == 0.0)
                    continue;
                const std::uint32_t first = index[i] & ~(size - 1);
                const double when = ((speed[i] > 0.0 ? first + size : first) - scaled[i]) / speed[i];
                if (when < leaves)
                {
                    leaves = when;
                    across = i;
                }
            }
            if (!(leaves < 1.0))
                return 1.0;
            time = std::max(time, leaves);
            for (std::size_t i = 0; i < coordinates_.size(); ++i)
            {
                const std::uint32_t first = index[i] & ~(size - 1);
                const double now = std::clamp(scaled[i] + time * speed[i], static_cast<double>(first),
                                              static_cast<double>(first + size - 1));
                index[i] = static_cast<std::uint32_t>(now);
            }
            if (speed[across] < 0.0 && (index[across] & ~(size - 1)) == 0)
                return time;
            index[across] = (index[across] & ~(size - 1)) + (speed[across] > 0.0 ? size : ~std::uint32_t(0));
            if (index[across] >= counts_[across])
                return time;
        }
        return std::min(time, 1.0);
    }
}
