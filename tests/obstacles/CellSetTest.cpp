#include "ompl_certificates/obstacles/CellObstacles.h"
#include "ompl_certificates/obstacles/CellSet.h"
#include "support/RandomCells.h"

#include <algorithm>
#include <deque>
#include <gtest/gtest.h>
#include <iterator>
#include <ompl/util/Exception.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;

namespace
{
    constexpr std::int32_t REACH = 20;
    constexpr double SIZE = 0.25;

    /** Where the grids begin, in space or in the plane */
    Eigen::Vector3d originOf(unsigned int dimension)
    {
        return {0.3, -0.7, dimension == 2 ? 0.0 : 0.11};
    }

    using Cells = std::set<std::array<std::int32_t, 3>>;

    /** The cells of a box; in the plane, those at height 0 */
    template <typename Visit>
    void visitCells(const CellBox &box, unsigned int dimension, const Visit &visit)
    {
        for (std::int32_t x = box.low[0]; x < box.high[0]; ++x)
            for (std::int32_t y = box.low[1]; y < box.high[1]; ++y)
                for (std::int32_t z = dimension == 2 ? 0 : box.low[2]; z < (dimension == 2 ? 1 : box.high[2]); ++z)
                    visit(std::array<std::int32_t, 3>{x, y, z});
    }

    std::vector<CellBox> boxesOf(const Cells &cells)
    {
        std::vector<CellBox> boxes;
        for (const auto &low : cells)
            boxes.push_back({low, {low[0] + 1, low[1] + 1, low[2] + 1}});
        return boxes;
    }

    CellBox randomBox(Random &random, unsigned int dimension)
    {
        CellBox box;
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
            box.low[axis] = static_cast<std::int32_t>(random.below(2 * REACH)) - REACH;
            box.high[axis] = box.low[axis] + 1 + static_cast<std::int32_t>(random.below(random.chance(0.5) ? 3 : 18));
        }
        if (dimension == 2)
            box.high[2] = box.low[2] + static_cast<std::int32_t>(random.below(3));
        return box;
    }

    /** Inserts or removes some boxes, and does the same to \e mirror */
    void disturb(Random &random, CellSet &set, Cells &mirror, unsigned int dimension)
    {
        std::vector<CellBox> boxes;
        for (unsigned int i = random.below(4); i > 0; --i)
            boxes.push_back(randomBox(random, dimension));
        const bool inserts = random.chance(0.5);
        inserts ? set.insert(boxes) : set.remove(boxes);
        for (const CellBox &box : boxes)
            visitCells(box, dimension,
                       [&](const auto &cell)
                       {
                           if (inserts)
                               mirror.insert(cell);
                           else
                               mirror.erase(cell);
                       });
        ASSERT_EQ(set.size(), mirror.size());
    }

    /** Obstacles that a set made, and those of the same cells made anew */
    struct Version
    {
        Version(ObstaclesPtr fromSet, const Cells &theCells, unsigned int dimension)
          : made(std::move(fromSet)), cells(theCells), fresh(SIZE, boxesOf(theCells), dimension, originOf(dimension))
        {
        }

        void expectEquality(Random &random) const
        {
            const auto &obstacles = dynamic_cast<const CellObstacles &>(*made);
            const unsigned int dimension = obstacles.getDimension();
            Cells found;
            for (const CellBox &box : obstacles.getBoxes())
                visitCells(box, dimension, [&](const auto &cell) { ASSERT_TRUE(found.insert(cell).second); });
            ASSERT_EQ(found, cells);
            for (int i = 0; i < 20; ++i)
            {
                const Eigen::Vector3d point =
                    originOf(dimension) + random.point(dimension, random.logUniform(0.1, 4.0) * SIZE * REACH);
                const double clearance = obstacles.clearance(point), expected = fresh.clearance(point);
                // Within cells it depends on how they are joined.
                ASSERT_EQ(std::max(clearance, 0.0), std::max(expected, 0.0));
                ASSERT_EQ(clearance < 0.0, expected < 0.0);
                ObstaclePart nearest;
                ASSERT_EQ(obstacles.findNearest(point, nearest), clearance);
                ASSERT_EQ(nearest == NO_PART, cells.empty());
                if (!cells.empty() && clearance > 0.0)
                {
                    ASSERT_NEAR(obstacles.getBounds(nearest).exteriorDistance(point), clearance, 1e-12);
                }
                const double most = clearance + random.uniform(-1.0, 1.0);
                const double limited = obstacles.clearanceUpTo(point, most);
                ASSERT_TRUE(clearance < most ? std::abs(limited - clearance) < 1e-12 : limited >= most - 1e-12);
                const Body body = bodyAmongCells(random, dimension, SIZE);
                const Pose pose = random.pose(dimension, 1.2 * SIZE * REACH);
                ObstaclePart hit = NO_PART;
                const bool collides = fresh.collides(body, pose);
                ASSERT_EQ(obstacles.collides(body, pose), collides);
                const Touching touching = obstacles.touches(body, pose, &hit);
                ASSERT_NE(touching, collides ? Touching::NO : Touching::YES);
                ASSERT_EQ(obstacles.certainlyHits(body, pose, hit), touching == Touching::YES);
            }
        }

        ObstaclesPtr made;
        Cells cells;
        CellObstacles fresh;
    };

    class CellSets : public testing::TestWithParam<unsigned int>
    {
    };
}

TEST_P(CellSets, MakeTheObstaclesOfTheirCells)
{
    for (unsigned int seed = 1; seed <= scaled(20); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        CellSet set(SIZE, GetParam(), originOf(GetParam()));
        Cells mirror;
        std::deque<Version> versions;
        versions.emplace_back(set.takeChange().after, mirror, GetParam());
        for (int round = 0; round < 12; ++round)
        {
            for (unsigned int i = random.below(4); i > 0; --i)
                ASSERT_NO_FATAL_FAILURE(disturb(random, set, mirror, GetParam()));
            const ObstacleChange change = set.takeChange();
            const bool isSame = versions.back().cells == mirror;
            versions.emplace_back(change.after, mirror, GetParam());
            ASSERT_NO_FATAL_FAILURE(versions.back().expectEquality(random));
            ASSERT_EQ(!change.added && !change.removed, isSame);
            // Whoever saves certificates of a changed map can load them for a new one of the same cells.
            std::vector<CellBox> cells;
            for (const auto &[x, y, z] : mirror)
                cells.push_back({{x, y, z}, {x + 1, y + 1, z + 1}});
            ASSERT_EQ(change.after->getFingerprint(),
                      CellObstacles(SIZE, cells, GetParam(), originOf(GetParam())).getFingerprint());
        }
        // What was made before has not changed.
        for (const Version &version : versions)
            ASSERT_NO_FATAL_FAILURE(version.expectEquality(random));
    }
}

TEST_P(CellSets, RemoveBoxesFromPlanes)
{
    constexpr unsigned int WIDTH = 300;
    unsigned int removed = 0;
    for (unsigned int seed = 1; seed <= scaled(60); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const std::size_t across = seed % GetParam();
        const auto anywhere = [&] { return static_cast<std::int32_t>(random.below(WIDTH)) - std::int32_t(WIDTH / 2); };
        const std::int32_t plane = anywhere();
        CellSet set(SIZE, GetParam(), originOf(GetParam()));
        Cells mirror;
        for (int round = 0; round < 30; ++round)
        {
            // Single cells of a plane, and some beside it
            for (unsigned int i = random.below(20); i > 0; --i)
            {
                std::array<std::int32_t, 3> low{anywhere(), anywhere(), GetParam() == 2 ? 0 : anywhere()};
                if (random.chance(0.9))
                    low[across] = plane;
                set.insert({{low, {low[0] + 1, low[1] + 1, low[2] + 1}}});
                mirror.insert(low);
            }
            // A box that is short along some axes and long along others
            CellBox box;
            for (std::size_t axis = 0; axis < 3; ++axis)
            {
                box.low[axis] = axis == across && random.chance(0.7) ? plane : anywhere();
                box.high[axis] =
                    box.low[axis] + 1 + static_cast<std::int32_t>(random.below(random.chance(0.5) ? 20 : WIDTH));
            }
            set.remove({box});
            for (auto cell = mirror.begin(); cell != mirror.end();)
            {
                bool isWithin = true;
                for (std::size_t axis = 0; axis < GetParam(); ++axis)
                    isWithin = isWithin && box.low[axis] <= (*cell)[axis] && (*cell)[axis] < box.high[axis];
                removed += isWithin;
                cell = isWithin ? mirror.erase(cell) : std::next(cell);
            }
            ASSERT_EQ(set.size(), mirror.size());
            if (random.chance(0.5))
                continue;
            const ObstaclesPtr after = set.takeChange().after;
            Cells found;
            for (const CellBox &joined : dynamic_cast<const CellObstacles &>(*after).getBoxes())
                visitCells(joined, GetParam(), [&](const auto &cell) { ASSERT_TRUE(found.insert(cell).second); });
            ASSERT_EQ(found, mirror);
        }
    }
    EXPECT_GT(removed, 60 * scaled(60));
}

TEST_P(CellSets, TellWhichClearancesMayChange)
{
    unsigned int unconcerned = 0, changed = 0, within = 0;
    for (unsigned int seed = 1; seed <= scaled(30); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        CellSet set(SIZE, GetParam(), originOf(GetParam()));
        Cells mirror;
        for (int i = 0; i < 10; ++i)
            ASSERT_NO_FATAL_FAILURE(disturb(random, set, mirror, GetParam()));
        ObstaclesPtr before = set.takeChange().after;
        for (int round = 0; round < 8; ++round)
        {
            ASSERT_NO_FATAL_FAILURE(disturb(random, set, mirror, GetParam()));
            const ObstacleChange change = set.takeChange();
            const CellObstacles fresh(SIZE, boxesOf(mirror), GetParam(), originOf(GetParam()));
            for (int i = 0; i < 200; ++i)
            {
                Eigen::Vector3d point = originOf(GetParam()) + random.point(GetParam(), 1.2 * SIZE * REACH);
                if (const auto inside = dynamic_cast<const CellObstacles &>(*before).getBoxes();
                    !inside.empty() && i % 2 == 0)
                {
                    const auto &[low, high] = inside[random.below(inside.size())];
                    for (std::size_t axis = 0; axis < GetParam(); ++axis)
                        point[Eigen::Index(axis)] =
                            originOf(GetParam())[Eigen::Index(axis)] + SIZE * random.uniform(low[axis], high[axis]);
                }
                const double old = before->clearance(point), now = change.clearance(point, old);
                ASSERT_EQ(now, change.after->clearance(point));
                changed += old != now;
                within += old < 0.0 && now < 0.0 && old != now;
                // In a ball around the certificate's
                const Eigen::Vector3d center = point + random.point(GetParam(), 1.0);
                if (!change.concerns(center, (point - center).norm() + std::abs(old)))
                {
                    ++unconcerned;
                    ASSERT_EQ(now, old);
                }
                // All points nearer than the depth are in a cell.
                if (now < 0.0)
                {
                    ASSERT_LE(fresh.clearance(point - now * random.uniform(0.0, 1.0) * random.direction(GetParam())),
                              1e-9);
                }
            }
            before = change.after;
        }
    }
    EXPECT_GT(unconcerned, 30 * scaled(30));
    EXPECT_GT(changed, 30 * scaled(30));
    EXPECT_GT(within, scaled(30));
}

INSTANTIATE_TEST_SUITE_P(Dimension, CellSets, testing::Values(2U, 3U));

TEST(CellSet, ForgetsCellsThatComeAndGoBetweenChanges)
{
    CellSet set(SIZE);
    const CellBox here{{0, 0, 0}, {4, 4, 4}}, part{{1, 1, 1}, {2, 2, 40}};
    set.insert({here});
    set.takeChange();
    set.insert({part});
    set.remove({part});
    set.insert({here});
    const ObstacleChange change = set.takeChange();
    EXPECT_EQ(change.added, nullptr);
    EXPECT_EQ(change.removed, nullptr);
    EXPECT_EQ(change.after, set.takeChange().after);
    const auto boxes = dynamic_cast<const CellObstacles &>(*change.after).getBoxes();
    EXPECT_EQ(boxes, std::vector<CellBox>{here});
    set.remove({here});
    EXPECT_EQ(set.size(), 0U);
    EXPECT_EQ(set.takeChange().after->clearance({0.0, 0.0, 0.0}), std::numeric_limits<double>::infinity());
}

TEST(CellSet, RefusesWhatMakesNoSense)
{
    EXPECT_THROW(CellSet(SIZE, 4), ompl::Exception);
    EXPECT_THROW(CellSet(0.0), ompl::Exception);
    EXPECT_THROW(CellSet(SIZE, 3, {0.0, NAN, 0.0}), ompl::Exception);
    EXPECT_THROW(CellSet{std::numeric_limits<double>::infinity()}, ompl::Exception);
    CellSet set(SIZE);
    const CellBox good{{0, 0, 0}, {1, 1, 1}}, empty{{0, 0, 0}, {1, 0, 1}},
        far{{CellBox::FARTHEST, 0, 0}, {CellBox::FARTHEST + 1, 1, 1}};
    EXPECT_THROW(set.insert({good, empty}), ompl::Exception);
    EXPECT_THROW(set.insert({good, far}), ompl::Exception);
    // More than the memory of most machines
    EXPECT_THROW(set.insert({good, {{-1024, -1024, -1024}, {1024, 1024, 1024}}}), ompl::Exception);
    std::vector<CellBox> slabs;
    for (std::int32_t i = -64; i < 64; ++i)
        slabs.push_back({{-1024, -1024, 16 * i}, {1024, 1024, 16 * i + 16}});
    EXPECT_THROW(set.insert(slabs), ompl::Exception);
    EXPECT_EQ(set.size(), 0U);
    // The rods of a cube share blocks: they reach into some 4000.
    std::vector<CellBox> rods;
    for (std::int32_t y = 0; y < 256; ++y)
        for (std::int32_t z = 0; z < 256; ++z)
            rods.push_back({{0, y, z}, {256, y + 1, z + 1}});
    CellSet cube(SIZE);
    cube.insert(rods);
    EXPECT_EQ(cube.size(), std::size_t(1) << 24U);
    set.insert({good});
    EXPECT_THROW(set.remove({good, empty}), ompl::Exception);
    EXPECT_EQ(set.size(), 1U);
    // The farthest cells
    set.insert({{{CellBox::FARTHEST - 1, 0, -CellBox::FARTHEST}, {CellBox::FARTHEST, 1, -CellBox::FARTHEST + 1}}});
    EXPECT_EQ(set.size(), 2U);
}
