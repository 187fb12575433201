#include "FclOctree.h"
#include "RandomMaps.h"
#include "ompl_certificates/obstacles/CheckObstacles.h"
#include "ompl_certificates/octomap/OctomapObstacles.h"
#include "support/Message.h"
#include "support/RandomCells.h"

#include <filesystem>
#include <gtest/gtest.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;

namespace
{
    /** Whether a cell of the map's resolution is an obstacle, as the options tell, by octomap's own search */
    bool isObstacle(const octomap::OcTree &map, const OctomapOptions &options, int x, int y, int z)
    {
        const auto key = [](int i) { return static_cast<octomap::key_type>(32768 + i); };
        double low[3], high[3];
        map.getMetricMin(low[0], low[1], low[2]);
        map.getMetricMax(high[0], high[1], high[2]);
        const int size = 1 << (16 - options.depth);
        const auto first = [size](int i) { return static_cast<int>(std::floor(double(i) / size)) * size; };
        bool unknown = false;
        for (int i = first(x); i < first(x) + size; ++i)
            for (int j = first(y); j < first(y) + size; ++j)
                for (int k = first(z); k < first(z) + size; ++k)
                {
                    const octomap::OcTreeNode *node = map.search(octomap::OcTreeKey(key(i), key(j), key(k)));
                    if (node && map.isNodeOccupied(node))
                        return true;
                    const Eigen::Array3d middle = map.getResolution() * Eigen::Array3d(i + 0.5, j + 0.5, k + 0.5);
                    unknown = unknown || (!node && (middle > Eigen::Map<Eigen::Array3d>(low)).all() &&
                                          (middle < Eigen::Map<Eigen::Array3d>(high)).all());
                }
        const Eigen::Array3d middle = map.getResolution() * Eigen::Array3d(x + 0.5, y + 0.5, z + 0.5);
        return options.unknownIsOccupied && unknown && (middle > Eigen::Map<Eigen::Array3d>(low)).all() &&
               (middle < Eigen::Map<Eigen::Array3d>(high)).all();
    }

    std::string mapFile(const std::string &name)
    {
        return (std::filesystem::path(OMPL_CERTIFICATES_SHARED_DIR) / "maps" / name).string();
    }

    /** Compares verdicts with FCL's near the occupied cells of a map */
    void compareWithFcl(Random &random, const octomap::OcTree &map, const OctomapObstacles &obstacles,
                        unsigned int poses, unsigned int &hits)
    {
        const FclOctree reference(map);
        const double size = map.getResolution();
        for (unsigned int i = 0; i < poses; ++i)
        {
            const Body body = bodyAmongCells(random, 3, size);
            Pose pose = random.pose(3, 1.0);
            const Eigen::AlignedBox3d box = obstacles.getBounds(random.below(obstacles.getBoxes().size()));
            pose.translation() = box.sample() + random.point(3, body.getBoundingRadius() + size);
            if (random.chance(0.3))
                pose.translation() = box.center() + (box.sizes().maxCoeff() + body.getBoundingRadius()) *
                                                        Eigen::Vector3d::Unit(random.below(3)) * random.sign();
            const bool collides = obstacles.collides(body, pose);
            const Touching touching = obstacles.touches(body, pose);
            ASSERT_NE(touching, collides ? Touching::NO : Touching::YES);
            if (touching != Touching::UNKNOWN)
            {
                ASSERT_EQ(collides, reference.collides(body, pose))
                    << "kind " << static_cast<int>(body.getParts()[0].shape.getKind()) << "\n"
                    << pose.matrix();
            }
            hits += collides ? 1 : 0;
        }
    }
}

TEST(OctomapObstacles, AreTheCellsThatTheOptionsTell)
{
    for (unsigned int seed = 0; seed < scaled(60); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const auto map = randomMap(random, random.logUniform(0.01, 1.0));
        OctomapOptions options;
        options.depth = random.chance(0.5) ? 16 : 13 + random.below(4);
        options.unknownIsOccupied = random.chance(0.5);
        const OctomapObstacles obstacles(*map, options);
        ASSERT_EQ(obstacles.getDimension(), 3U);
        for (int i = 0; i < 300; ++i)
        {
            const auto cell = [&] { return static_cast<int>(random.below(40)) - 20; };
            const int x = cell(), y = cell(), z = cell();
            const Eigen::Vector3d middle = map->getResolution() * Eigen::Vector3d(x + 0.5, y + 0.5, z + 0.5);
            ASSERT_EQ(obstacles.clearance(middle) < 0.0, isObstacle(*map, options, x, y, z))
                << x << " " << y << " " << z << ", depth " << options.depth;
        }
    }
}

TEST(OctomapObstacles, AreSlicedBetweenTwoHeights)
{
    for (unsigned int seed = 0; seed < scaled(60); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const double size = random.logUniform(0.01, 1.0);
        const auto map = randomMap(random, size);
        OctomapOptions options;
        options.unknownIsOccupied = random.chance(0.3);
        // Cells from the first to the one before the last are cut; the ends are on their borders, or within them.
        const int first = static_cast<int>(random.below(24)) - 16, last = first + 1 + static_cast<int>(random.below(8));
        options.slice = {size * (first + (random.chance(0.5) ? 0.5 : 0.0)),
                         size * (last - (random.chance(0.5) ? 0.5 : 0.0) + (last == first + 1 ? 0.25 : 0.0))};
        const int beyond = last == first + 1 && options.slice->high > size * last ? last + 1 : last;
        const OctomapObstacles obstacles(*map, options);
        ASSERT_EQ(obstacles.getDimension(), 2U);
        for (int i = 0; i < 100; ++i)
        {
            const int x = static_cast<int>(random.below(40)) - 20, y = static_cast<int>(random.below(40)) - 20;
            bool expected = false;
            for (int z = first; z < beyond; ++z)
                expected = expected || isObstacle(*map, options, x, y, z);
            ASSERT_EQ(obstacles.clearance({size * (x + 0.5), size * (y + 0.5), 0.0}) < 0.0, expected)
                << x << " " << y << ", z from " << first << " to " << beyond;
        }
    }
}

TEST(OctomapObstacles, AreSlicedWhereTheMapIsPlaced)
{
    octomap::OcTree map(0.1);
    map.updateNode(octomap::point3d(0.05F, 0.05F, 0.05F), true);
    OctomapOptions options;
    options.origin = {0.0, 0.0, -1.0};
    options.slice = {-1.0, -0.9};
    EXPECT_EQ(OctomapObstacles(map, options).getBoxes().size(), 1U);
    for (const ZInterval &beside : {ZInterval{-1.5, -1.4}, ZInterval{-0.5, -0.4}, ZInterval{0.0, 0.1}})
    {
        options.slice = beside;
        EXPECT_TRUE(OctomapObstacles(map, options).getBoxes().empty()) << "from z = " << beside.low;
    }
}

TEST(OctomapObstacles, CollideAsFclSaysOfItsOcTree)
{
    unsigned int hits = 0, poses = 0;
    for (unsigned int seed = 0; seed < scaled(40); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const auto map = randomMap(random, random.logUniform(0.01, 1.0));
        const OctomapObstacles obstacles(*map);
        if (obstacles.getBoxes().empty())
            continue;
        ASSERT_NO_FATAL_FAILURE(compareWithFcl(random, *map, obstacles, 60, hits));
        poses += 60;
    }
    EXPECT_GT(hits, poses / 5);
    EXPECT_LT(hits, 4 * poses / 5);
}

TEST(OctomapObstacles, FulfilTheContract)
{
    for (unsigned int seed = 0; seed < scaled(10); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const double size = random.logUniform(0.01, 1.0);
        const auto map = randomMap(random, size);
        OctomapOptions options;
        options.unknownIsOccupied = random.chance(0.5);
        if (random.chance(0.5))
            options.slice = {-4.0 * size, 6.0 * size};
        const OctomapObstacles obstacles(*map, options);
        ompl::base::RealVectorBounds bounds(obstacles.getDimension());
        bounds.setLow(-18.0 * size);
        bounds.setHigh(18.0 * size);
        EXPECT_NO_THROW(
            checkObstacles(obstacles, {bodyAmongCells(random, obstacles.getDimension(), size)}, bounds, 100));
    }
}

TEST(OctomapObstacles, OfNothingAreNone)
{
    octomap::OcTree map(0.1);
    OctomapOptions options;
    options.unknownIsOccupied = true;
    EXPECT_TRUE(OctomapObstacles(map, options).getBoxes().empty());
    EXPECT_FALSE(OctomapObstacles(map).collides(Body::sphere(1.0), Pose::Identity()));
}

TEST(OctomapObstacles, RefuseOptionsThatMakeNoSense)
{
    const octomap::OcTree map(0.1);
    for (const unsigned int depth : {0U, 17U})
        EXPECT_NE(messageOf(
                      [&] {
                          OctomapObstacles(map, {depth, false, {}});
                      })
                      .find(std::to_string(depth)),
                  std::string::npos);
    EXPECT_NE(messageOf([&] { OctomapObstacles(map, {16, false, ZInterval{1.0, 1.0}}); }), "");
    EXPECT_NE(messageOf([&] { OctomapObstacles(map, {16, false, ZInterval{std::nan(""), 1.0}}); }), "");
    EXPECT_NE(messageOf([&] { OctomapObstacles(map, {16, false, {}, {0.0, std::nan(""), 0.0}}); }), "");
}

// A corridor and a building of the University of Freiburg, where they are at hand
class RealMap : public testing::TestWithParam<std::string>
{
protected:
    void SetUp() override
    {
        if (!std::filesystem::exists(mapFile(GetParam())))
            GTEST_SKIP() << mapFile(GetParam()) << " is not there";
    }
};

TEST_P(RealMap, CollidesAsFclSaysOfItsOcTree)
{
    Random random(1);
    octomap::OcTree map(0.1);
    ASSERT_TRUE(map.readBinary(mapFile(GetParam())));
    const OctomapObstacles obstacles(mapFile(GetParam()));
    unsigned int hits = 0, poses = scaled(1000);
    ASSERT_NO_FATAL_FAILURE(compareWithFcl(random, map, obstacles, poses, hits));
    EXPECT_GT(hits, poses / 5);
    EXPECT_LT(hits, 4 * poses / 5);
}

TEST_P(RealMap, HasTheClearancesOfItsCells)
{
    Random random(2);
    octomap::OcTree map(0.1);
    ASSERT_TRUE(map.readBinary(mapFile(GetParam())));
    std::vector<Eigen::AlignedBox3d> cells;
    for (auto leaf = map.begin_leafs(); leaf != map.end_leafs(); ++leaf)
        if (map.isNodeOccupied(*leaf))
        {
            const Eigen::Vector3d middle(leaf.getX(), leaf.getY(), leaf.getZ()),
                half = Eigen::Vector3d::Constant(0.5 * leaf.getSize());
            cells.emplace_back(middle - half, middle + half);
        }
    const OctomapObstacles obstacles(mapFile(GetParam()));
    for (unsigned int i = 0; i < scaled(100); ++i)
    {
        const Eigen::Vector3d point(random.uniform(-10.0, 34.0), random.uniform(-10.0, 9.0), random.uniform(-1.0, 3.0));
        double nearest = std::numeric_limits<double>::infinity();
        for (const auto &cell : cells)
            nearest = std::min(nearest, cell.squaredExteriorDistance(point));
        ASSERT_NEAR(std::max(0.0, obstacles.clearance(point)), std::sqrt(nearest), 1e-10) << point.transpose();
    }
}

INSTANTIATE_TEST_SUITE_P(Maps, RealMap, testing::Values("fr_079.bt", "geb079.bt"),
                         [](const auto &tested) { return tested.param.substr(0, tested.param.find('.')); });
