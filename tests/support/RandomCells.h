#ifndef OMPL_CERTIFICATES_TESTS_SUPPORT_RANDOM_CELLS_
#define OMPL_CERTIFICATES_TESTS_SUPPORT_RANDOM_CELLS_

#include "RandomBodies.h"
#include "RandomMeshes.h"

#include "ompl_certificates/obstacles/CellBox.h"

#include <set>

namespace ompl_certificates
{
    namespace test
    {
        /** \brief Single cells within \e half of the origin, some of them in walls; flat in the plane */
        inline std::vector<CellBox> randomCells(Random &random, unsigned int dimension, std::int32_t half)
        {
            std::set<std::array<std::int32_t, 3>> lows;
            const auto anywhere = [&] { return static_cast<std::int32_t>(random.below(2 * std::size_t(half))) - half; };
            for (unsigned int count = random.below(30); count > 0; --count)
                lows.insert({anywhere(), anywhere(), dimension == 2 ? 0 : anywhere()});
            for (unsigned int walls = random.below(4); walls > 0; --walls)
            {
                const std::size_t across = random.below(dimension);
                const std::int32_t at = anywhere();
                for (std::int32_t i = -half; i < half; ++i)
                    for (std::int32_t j = dimension == 2 ? half - 1 : -half; j < half; ++j)
                        if (random.chance(0.8))
                        {
                            std::array<std::int32_t, 3> low{i, i, dimension == 2 ? 0 : j};
                            if (dimension == 3)
                                low[(across + 1) % 3] = i, low[(across + 2) % 3] = j;
                            low[across] = at;
                            lows.insert(low);
                        }
            }
            std::vector<CellBox> cells;
            for (const auto &low : lows)
                cells.push_back({low, {low[0] + 1, low[1] + 1, dimension == 2 ? low[2] : low[2] + 1}});
            return cells;
        }

        /** \brief A body of any kind among cells of a given size, or a mesh */
        inline Body bodyAmongCells(Random &random, unsigned int dimension, double cellSize)
        {
            const double size = cellSize * random.logUniform(0.1, 8.0);
            return random.chance(0.25) ? meshBody(dimension, randomMesh(random, size))
                                       : randomBody(random, dimension, size);
        }
    }
}

#endif
