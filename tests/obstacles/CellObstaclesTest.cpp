#include "obstacles/JoinCells.h"
#include "ompl_certificates/obstacles/CellObstacles.h"
#include "ompl_certificates/obstacles/CheckObstacles.h"
#include "ompl_certificates/obstacles/FclObstacles.h"
#include "support/Message.h"
#include "support/RandomCells.h"
#include "support/RandomStates.h"

#include <gtest/gtest.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;

namespace
{
    constexpr std::int32_t HALF = 8;

    Eigen::AlignedBox3d boundsOf(const CellBox &box, double cellSize, const Eigen::Vector3d &origin)
    {
        return {origin + cellSize * Eigen::Vector3d(box.low[0], box.low[1], box.low[2]),
                origin + cellSize * Eigen::Vector3d(box.high[0], box.high[1], box.high[2])};
    }

    /** Where a grid begins: half of them at the origin, others up to some hundred cells from it */
    Eigen::Vector3d originOf(Random &random, unsigned int dimension, double cellSize)
    {
        return random.chance(0.5) ? Eigen::Vector3d::Zero().eval() : random.point(dimension, 300.0 * cellSize);
    }

    /** The same boxes of cells, for FCL */
    FclObstacles fclObstacles(const std::vector<CellBox> &boxes, double size, unsigned int dimension,
                              const Eigen::Vector3d &origin)
    {
        std::vector<PlacedBody> bodies;
        for (const CellBox &box : boxes)
        {
            const Eigen::AlignedBox3d bounds = boundsOf(box, size, origin);
            const Eigen::Vector3d sizes = bounds.sizes();
            bodies.push_back(
                {dimension == 2 ? Body::box(sizes.x(), sizes.y()) : Body::box(sizes.x(), sizes.y(), sizes.z()),
                 poseAt(bounds.center())});
        }
        return {bodies, dimension};
    }

    using CellIndices = std::set<std::array<std::int32_t, 3>>;

    /** The cells of boxes, of which each must be in one box only */
    CellIndices cellsOf(const std::vector<CellBox> &boxes)
    {
        CellIndices cells;
        for (const auto &[low, high] : boxes)
            for (std::int32_t x = low[0]; x < high[0]; ++x)
                for (std::int32_t y = low[1]; y < high[1]; ++y)
                    for (std::int32_t z = low[2]; z < std::max(high[2], low[2] + 1); ++z)
                        EXPECT_TRUE(cells.insert({x, y, z}).second);
        return cells;
    }
}

class CellObstaclesTest : public testing::TestWithParam<unsigned int>
{
};

TEST_P(CellObstaclesTest, JoinsCellsWithoutChangingThem)
{
    for (unsigned int seed = 0; seed < scaled(200); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const auto cells = randomCells(random, GetParam(), HALF);
        const CellObstacles obstacles(random.logUniform(0.01, 1.0), cells, GetParam());
        ASSERT_EQ(cellsOf(obstacles.getBoxes()), cellsOf(cells));
        ASSERT_LE(obstacles.getBoxes().size(), cells.size());
    }
    std::vector<CellBox> row;
    for (std::int32_t i = 0; i < 20; ++i)
        row.push_back({{i, 0, 0}, {i + 1, 1, 1}});
    EXPECT_EQ(joinCells(row, 16).size(), 2U);
}

TEST_P(CellObstaclesTest, KnowsTheDistanceToTheNearestCell)
{
    for (unsigned int seed = 0; seed < scaled(200); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const double size = random.logUniform(0.01, 1.0);
        const auto cells = randomCells(random, GetParam(), HALF);
        const Eigen::Vector3d origin = originOf(random, GetParam(), size);
        const CellObstacles obstacles(size, cells, GetParam(), origin);
        EXPECT_EQ(obstacles.getOrigin(), origin);
        for (int i = 0; i < 100; ++i)
        {
            const Eigen::Vector3d point = origin + random.point(GetParam(), size * HALF *
                                                                                (random.chance(0.1)    ? 1e3
                                                                                 : random.chance(0.01) ? 1e25
                                                                                                       : 1.2));
            double nearest = std::numeric_limits<double>::infinity();
            for (const CellBox &cell : cells)
                nearest = std::min(nearest, boundsOf(cell, size, origin).exteriorDistance(point));
            ObstaclePart part;
            const double clearance = obstacles.findNearest(point, part);
            ASSERT_EQ(clearance, obstacles.clearance(point));
            if (cells.empty())
            {
                ASSERT_TRUE(std::isinf(clearance) && part == NO_PART);
                continue;
            }
            ASSERT_NEAR(std::max(clearance, 0.0), nearest, 1e-12 * (size * HALF + origin.norm() + point.norm()))
                << point.transpose();
            ASSERT_NEAR(obstacles.getBounds(part).exteriorDistance(point), nearest,
                        1e-12 * (size * HALF + origin.norm() + point.norm()));
            ASSERT_LE(-clearance, 0.5 * size * 16);
        }
    }
}

TEST_P(CellObstaclesTest, KnowTheGapToABoxAlongTheirAxes)
{
    for (unsigned int seed = 0; seed < scaled(300); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const double size = random.logUniform(0.01, 1.0), extent = size * HALF;
        const auto cells = randomCells(random, GetParam(), HALF);
        const Eigen::Vector3d origin = originOf(random, GetParam(), size);
        const CellObstacles obstacles(size, cells, GetParam(), origin);
        for (int i = 0; i < 20; ++i)
        {
            const Eigen::Vector3d sizes(random.uniform(0.1, 1.0) * extent, random.uniform(0.1, 1.0) * extent,
                                        random.uniform(0.1, 1.0) * extent);
            const bool flat = GetParam() == 2;
            const Body body = flat ? Body::box(sizes.x(), sizes.y()) : Body::box(sizes.x(), sizes.y(), sizes.z());
            const Eigen::Vector3d center = origin + random.point(GetParam(), 3.0 * extent);
            double nearest = std::numeric_limits<double>::infinity();
            for (const CellBox &cell : cells)
            {
                const Eigen::AlignedBox3d bounds = boundsOf(cell, size, origin);
                const Eigen::Vector3d apart = (bounds.center() - center).cwiseAbs() - 0.5 * (bounds.sizes() + sizes);
                nearest = std::min(nearest, flat ? apart.head<2>().maxCoeff() : apart.maxCoeff());
            }
            const double needed = random.uniform(0.0, 0.5) * extent, wanted = random.uniform(0.6, 3.0) * extent;
            const double gap = obstacles.gap(body, poseAt(center), needed, wanted);
            if (nearest > needed + 1e-4 * extent)
            {
                ASSERT_NEAR(gap, std::min(nearest, wanted), 1e-4 * extent);
            }
            else
            {
                ASSERT_LE(gap, needed + 2e-4 * extent);
            }
        }
    }
}

TEST_P(CellObstaclesTest, DecidesAsFclDoesOfEachCell)
{
    unsigned int hits = 0, poses = 0, unknown = 0;
    for (unsigned int seed = 0; seed < scaled(300); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const double size = random.logUniform(0.01, 1.0);
        const auto cells = randomCells(random, GetParam(), HALF);
        const Eigen::Vector3d origin = originOf(random, GetParam(), size);
        const CellObstacles obstacles(size, cells, GetParam(), origin);
        const FclObstacles reference = fclObstacles(cells, size, GetParam(), origin),
                           joined = fclObstacles(obstacles.getBoxes(), size, GetParam(), origin);
        const Body body = bodyAmongCells(random, GetParam(), size);
        for (int i = 0; i < 30; ++i)
        {
            Pose pose = random.pose(GetParam(), size * HALF);
            pose.translation() += origin;
            // Now and then the body just touches a cell, in a level pose, or is a few tolerances away.
            if (!cells.empty() && random.chance(0.5))
            {
                const Eigen::AlignedBox3d bounds = boundsOf(cells[random.below(cells.size())], size, origin);
                const Eigen::AlignedBox3d own =
                    body.getParts()[0].shape.getBounds().transformed(pose * body.getParts()[0].pose);
                const Eigen::Index axis = random.below(GetParam());
                pose.translation() += bounds.center() - own.center();
                pose.translation()[axis] += random.sign() * 0.5 * (bounds.sizes()[axis] + own.sizes()[axis]) +
                                            random.sign() * random.logUniform(1e-7, 1e-3) * size;
                if (GetParam() == 2)
                    pose.translation().z() = 0.0;
            }
            const bool collides = obstacles.collides(body, pose);
            ObstaclePart hit = NO_PART;
            const Touching touching = obstacles.touches(body, pose, &hit);
            ASSERT_NE(touching, collides ? Touching::NO : Touching::YES);
            if (touching == Touching::YES)
            {
                ASSERT_NE(hit, NO_PART);
                ASSERT_TRUE(obstacles.certainlyHits(body, pose, hit));
            }
            // Where a shape just touches, what FCL says depends on how the cells are joined.
            const FclObstacles &fcl = touching == Touching::UNKNOWN ? joined : reference;
            ASSERT_EQ(collides, fcl.collides(body, pose)) << pose.matrix();
            ++poses;
            hits += collides ? 1 : 0;
            unknown += touching == Touching::UNKNOWN ? 1 : 0;
        }
    }
    EXPECT_GT(hits, poses / 5);
    EXPECT_LT(hits, 4 * poses / 5);
    EXPECT_LT(unknown, poses / 10);
}

TEST_P(CellObstaclesTest, FulfilsTheContract)
{
    for (unsigned int seed = 0; seed < scaled(30); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const double size = random.logUniform(0.01, 1.0);
        const Eigen::Vector3d origin = originOf(random, GetParam(), size);
        const CellObstacles obstacles(size, randomCells(random, GetParam(), HALF), GetParam(), origin);
        std::vector<Body> bodies;
        for (int i = 0; i < 4; ++i)
            bodies.push_back(bodyAmongCells(random, GetParam(), size));
        ompl::base::RealVectorBounds bounds = cubeBounds(GetParam(), 1.5 * size * HALF);
        for (unsigned int axis = 0; axis < GetParam(); ++axis)
        {
            bounds.low[axis] += origin[axis];
            bounds.high[axis] += origin[axis];
        }
        EXPECT_NO_THROW(checkObstacles(obstacles, bodies, bounds, 50));
    }
}

INSTANTIATE_TEST_SUITE_P(Dimension, CellObstaclesTest, testing::Values(2U, 3U));

TEST(CellObstacles, FillTheWholeRangeOfIndices)
{
    const std::int32_t most = CellBox::FARTHEST;
    const CellObstacles obstacles(0.5, {{{-most, -most, -most}, {1 - most, 1 - most, 1 - most}},
                                        {{most - 1, most - 1, most - 1}, {most, most, most}}});
    EXPECT_EQ(obstacles.getBoxes().size(), 2U);
    for (const double sign : {-1.0, 1.0})
    {
        const Eigen::Vector3d corner = sign * 0.5 * most * Eigen::Vector3d::Ones();
        EXPECT_DOUBLE_EQ(obstacles.clearance(corner + sign * Eigen::Vector3d(2.0, 0.0, 0.0)), 2.0);
        EXPECT_TRUE(obstacles.collides(Body::sphere(1.0), poseAt(corner + sign * Eigen::Vector3d(0.9, 0.0, 0.0))));
        EXPECT_FALSE(obstacles.collides(Body::sphere(1.0), poseAt(corner + sign * Eigen::Vector3d(1.1, 0.0, 0.0))));
    }
    EXPECT_NEAR(obstacles.clearance({0.5 * most - 0.25, 0.5 * most - 0.2, 0.5 * most - 0.25}), -0.2, 1e-11);
}

/** So far from the origin the search's own numbers are coarse. */
TEST(CellObstacles, HaveNoGapBeyondTheirDistanceFarAway)
{
    Random random(1);
    const CellObstacles cells(0.05, {{{30000, 30000, 30000}, {30001, 30001, 30001}}}, 3);
    const Eigen::Vector3d middle = Eigen::Vector3d::Constant(0.05 * 30000.5);
    const Body body = Body::box(0.2, 0.1, 0.1);
    unsigned int apart = 0;
    for (int i = 0; i < 3000; ++i)
    {
        Pose pose = random.pose(3, 0.5);
        pose.translation() += middle;
        const double gap = cells.gap(body, pose, 1e-6, 1.0);
        if (gap <= 0.0)
            continue;
        double free = 0.0, hit = 1.5;
        while (hit - free > 1e-9)
            (cells.staysFree(body, pose, 0.5 * (free + hit)) ? free : hit) = 0.5 * (free + hit);
        ASSERT_LE(gap, hit) << pose.matrix();
        ++apart;
    }
    EXPECT_GT(apart, 1000U);
}

/** Of two parts, since one alone is looked up otherwise. */
TEST(CellObstacles, InThePlaneMeetMeshesAtAnyHeight)
{
    const CellObstacles obstacles(0.1, {{{0, 0, 0}, {3, 3, 0}}}, 2);
    const auto triangle = std::make_shared<TriangleMesh>(
        std::vector<Eigen::Vector3d>{{-0.2, -0.2, 0.0}, {0.2, -0.2, 0.0}, {0.0, 0.2, 0.0}},
        std::vector<TriangleMesh::Triangle>{{0, 1, 2}});
    const Body body({{Body::planarMesh(triangle).getParts()[0].shape, poseAt({0.0, 0.0, 5.0})},
                     {Shape::ball(2, 0.05), poseAt({3.0, 3.0, 0.0})}});
    EXPECT_TRUE(obstacles.collides(body, planarPose(0.15, 0.15)));
    EXPECT_FALSE(obstacles.staysFree(body, planarPose(0.15, 0.15), 0.1));
    EXPECT_FALSE(obstacles.collides(body, planarPose(0.15, 1.15)));
    EXPECT_TRUE(obstacles.staysFree(body, planarPose(0.15, 1.15), 0.1));
}

/** Parts of a body that touch none of many cells near it are tried one by one. */
TEST(CellObstacles, TouchADumbbellBeyondManyBetweenItsBalls)
{
    const Body dumbbell(
        {{Shape::ball(3, 0.1), poseAt({-1.0, 0.0, 0.0})}, {Shape::ball(3, 0.1), poseAt({1.0, 0.0, 0.0})}});
    std::vector<CellBox> between;
    for (std::int32_t i = -40; i < 40; i += 4)
        between.push_back({{i, 0, 0}, {i + 1, 1, 1}});
    const CellObstacles clear(0.02, between);
    EXPECT_FALSE(clear.collides(dumbbell, Pose::Identity()));
    EXPECT_TRUE(clear.staysFree(dumbbell, Pose::Identity(), 0.05));
    for (const std::int32_t inBall : {-50, 50})
    {
        std::vector<CellBox> cells = between;
        cells.push_back({{inBall, 0, 0}, {inBall + 1, 1, 1}});
        const CellObstacles obstacles(0.02, cells);
        EXPECT_TRUE(obstacles.collides(dumbbell, Pose::Identity()));
        EXPECT_EQ(obstacles.touches(dumbbell, Pose::Identity()), Touching::YES);
        EXPECT_FALSE(obstacles.staysFree(dumbbell, Pose::Identity(), 0.05));
    }
}

TEST(CellObstacles, InThePlaneAreAllOfALongBoxAboveOrBelowAShortOne)
{
    const CellBox longer{{0, 0, 0}, {10, 1, 1}}, shorter{{2, 0, 2}, {3, 1, 3}};
    for (const auto &cells : {std::vector<CellBox>{longer, shorter}, std::vector<CellBox>{shorter, longer}})
    {
        const CellObstacles obstacles(1.0, cells, 2);
        EXPECT_LT(obstacles.clearance({8.5, 0.5, 0.0}), 0.0);
        EXPECT_GT(obstacles.clearance({10.5, 0.5, 0.0}), 0.0);
    }
}

TEST(CellObstacles, AreKnownByTheirCells)
{
    const std::vector<CellBox> one{{{0, 0, 0}, {2, 1, 1}}}, two{{{1, 0, 0}, {2, 1, 1}}, {{0, 0, 0}, {1, 1, 1}}},
        other{{{0, 0, 0}, {1, 1, 1}}};
    EXPECT_EQ(CellObstacles(0.1, one).getFingerprint(), CellObstacles(0.1, two).getFingerprint());
    EXPECT_NE(CellObstacles(0.1, one).getFingerprint(), CellObstacles(0.1, other).getFingerprint());
    EXPECT_NE(CellObstacles(0.1, one).getFingerprint(), CellObstacles(0.2, one).getFingerprint());
    EXPECT_NE(CellObstacles(0.1, one).getFingerprint(), CellObstacles(0.1, one, 2).getFingerprint());
    EXPECT_NE(CellObstacles(0.1, one).getFingerprint(), CellObstacles(0.1, one, 3, {0.0, 0.1, 0.0}).getFingerprint());
    EXPECT_EQ(CellObstacles(0.1, one, 2).getFingerprint(),
              CellObstacles(0.1, one, 2, {0.0, 0.0, 0.1}).getFingerprint());
    EXPECT_NE(CellObstacles(0.1, {}).getFingerprint(), 0U);
}

TEST(CellObstacles, RefuseWhatMakesNoSense)
{
    const std::int32_t most = CellBox::FARTHEST;
    EXPECT_NE(messageOf([] { CellObstacles(0.0, {}); }), "");
    EXPECT_NE(messageOf([] { CellObstacles(std::numeric_limits<double>::quiet_NaN(), {}); }), "");
    EXPECT_NE(messageOf([] { CellObstacles(1.0, {}, 4); }), "");
    EXPECT_NE(messageOf([] { CellObstacles(1.0, {}, 3, {0.0, 0.0, INFINITY}); }), "");
    EXPECT_NE(messageOf([] { CellObstacles(1.0, {{{0, 0, 0}, {1, 1, 0}}}); }), "");
    EXPECT_NE(messageOf([=] { CellObstacles(1.0, {{{0, 0, 0}, {1, 1, most + 1}}}); }), "");
    EXPECT_NE(messageOf([=] { CellObstacles(1.0, {{{-most - 1, 0, 0}, {1, 1, 1}}}); }), "");
    const CellObstacles none(1.0, {});
    ObstaclePart part = 0;
    none.findNearest({0.0, 0.0, 0.0}, part);
    EXPECT_NE(messageOf([&] { none.getBounds(part); }).find("There is no cell"), std::string::npos);
}

TEST(CellObstacles, KnowTheirDepthWhateverTheLimit)
{
    const CellObstacles one(1.0, {{{0, 0, 0}, {1, 1, 1}}});
    for (const double limit : {1.0, 1e-12, 1e-24, 1e-300})
    {
        EXPECT_DOUBLE_EQ(one.clearanceUpTo({0.5, 0.5, 0.5}, limit), -0.5) << limit;
        EXPECT_EQ(one.clearanceUpTo({0.5, 0.5, 3.0}, limit), limit);
    }
}
