#include "pictures/CellOutline.h"
#include "support/RandomCells.h"

#include <gtest/gtest.h>

namespace ompl_certificates
{
    using namespace test;

    namespace
    {
        bool isIn(const std::vector<Eigen::AlignedBox3d> &rectangles, const Eigen::Vector3d &point)
        {
            return std::any_of(rectangles.begin(), rectangles.end(),
                               [&](const auto &rectangle) { return rectangle.contains(point); });
        }
    }

    TEST(CellOutline, CoversWhatIsSeenAndNoMore)
    {
        constexpr std::int32_t half = 8;
        for (unsigned int seed = 0; seed < scaled(100); ++seed)
        {
            SCOPED_TRACE("seed " + std::to_string(seed));
            Random random(seed);
            const unsigned int dimension = 2 + random.below(2);
            const int up = dimension == 2 ? 1 : 1 + static_cast<int>(random.below(2));
            const double size = random.logUniform(0.01, 1.0);
            const auto cells = randomCells(random, dimension, half);
            const auto outlines = cellOutlines(CellObstacles(size, cells, dimension), up, 0.9 * size, 4);
            if (cells.empty())
            {
                EXPECT_TRUE(outlines.empty());
                continue;
            }
            ASSERT_EQ(outlines.size(), dimension == 2 ? 1U : 4U);
            const auto coarse = cellOutlines(CellObstacles(size, cells, dimension), up, 2.5 * size, 4);
            for (std::int32_t x = -half; x < half; ++x)
                for (std::int32_t y = -half; y < half; ++y)
                {
                    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
                    middle[0] = size * (x + 0.5);
                    middle[up] = size * (y + 0.5);
                    const bool expected = std::any_of(cells.begin(), cells.end(),
                                                      [&](const CellBox &cell)
                                                      { return cell.low[0] == x && cell.low[std::size_t(up)] == y; });
                    ASSERT_EQ(isIn(outlines.front(), middle), expected) << x << " " << y;
                    ASSERT_TRUE(!expected || isIn(coarse.front(), middle)) << x << " " << y;
                    for (std::size_t level = 1; level < outlines.size(); ++level)
                        ASSERT_TRUE(isIn(outlines[level - 1], middle) || !isIn(outlines[level], middle));
                }
        }
    }
}
