#include "MapTeams.h"
#include "OctomapSetCase.h"
#include "RandomMaps.h"
#include "support/Message.h"
#include "support/Quiet.h"

#include <cmath>
#include <gtest/gtest.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;
namespace ob = ompl::base;

namespace
{
    constexpr double RESOLUTION = 0.25;

    class OctomapSets : public OctomapSetTest
    {
    };

    using Cells = std::set<std::array<std::int32_t, 3>>;

    /** The cells with an edge of so many of the obstacles' own; a box may be a part of one */
    Cells cellsOf(const Obstacles &obstacles, std::int32_t edge)
    {
        const auto divided = [edge](std::int32_t index)
        { return static_cast<std::int32_t>(std::floor(static_cast<double>(index) / edge)); };
        Cells cells;
        for (const auto &[low, high] : dynamic_cast<const CellObstacles &>(obstacles).getBoxes())
            for (std::int32_t x = low[0]; x < high[0]; x += edge)
                for (std::int32_t y = low[1]; y < high[1]; y += edge)
                    for (std::int32_t z = low[2]; z < std::max(high[2], low[2] + 1); z += edge)
                        cells.insert({divided(x), divided(y), divided(z)});
        return cells;
    }
}

TEST_P(OctomapSets, FollowTheMap)
{
    unsigned int changes = 0;
    for (unsigned int seed = 1; seed <= scaled(20); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const auto map = randomMap(random, RESOLUTION);
        OctomapSet set(*map, options());
        for (int round = 0; round < 10; ++round)
        {
            const ObstacleChange change = set.takeChange();
            const OctomapObstacles fresh(*map, options());
            ASSERT_EQ(cellsOf(*change.after, 1), cellsOf(fresh, 1 << (16U - GetParam().depth)));
            for (int i = 0; i < 20; ++i)
            {
                const Eigen::Vector3d point = random.point(fresh.getDimension(), 5.0);
                ASSERT_EQ(std::max(0.0, change.after->clearance(point)), std::max(0.0, fresh.clearance(point)));
            }
            ASSERT_EQ(change.after->getDimension(), GetParam().slice ? 2U : 3U);
            changes += change.added || change.removed;
            if (random.chance(0.7))
                scan(random, *map);
            if (random.chance(0.3))
                map->prune();
            if (random.chance(0.3))
                map->updateNode(octomap::OcTreeKey(32768, 32770, 32767), random.chance(0.5));
        }
        set.takeChange();
        const ObstacleChange none = set.takeChange();
        ASSERT_TRUE(!none.added && !none.removed);
    }
    // The first is one. Large cells hardly ever become free.
    if (GetParam().depth > 4)
    {
        EXPECT_GT(changes, scaled(20));
    }
}

TEST_P(OctomapSets, LeaveVerdictsOfFreshCheckers)
{
    const Quiet quiet;
    const auto team = teamFor(GetParam().slice ? 2 : 3);
    for (unsigned int seed = 1; seed <= scaled(3); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const auto map = randomMap(random, RESOLUTION);
        OctomapSet set(*map, options());
        Checkers changed(team, set.takeChange().after);
        std::vector<ob::ScopedState<>> states;
        for (unsigned int i = 0; i < 150; ++i)
            states.push_back(randomState(random, team));
        for (const auto &setup : changed.setups)
            setup->getTeamChecker()->setAdaptive(false);
        for (int round = 0; round < 6; ++round)
        {
            const ObstacleChange change = set.takeChange();
            TeamSetup fresh(team, std::make_shared<OctomapObstacles>(*map, options()), Method::STANDARD);
            fresh.getSpaceInformation()->setup();
            for (const auto &setup : changed.setups)
            {
                const auto checker = setup->getTeamChecker();
                checker->changeObstacles(change);
                for (const Certificate &certificate : checker->getCertificates())
                    ASSERT_EQ(certificate.clearance, change.after->clearance(certificate.point));
                for (std::size_t i = 0; i + 1 < states.size(); ++i)
                {
                    ASSERT_EQ(checker->isValid(states[i].get()), fresh.getTeamChecker()->isValid(states[i].get()));
                    ASSERT_EQ(setup->getSpaceInformation()->checkMotion(states[i].get(), states[i + 1].get()),
                              fresh.getSpaceInformation()->checkMotion(states[i].get(), states[i + 1].get()));
                }
            }
            scan(random, *map);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Options, OctomapSets,
                         testing::Values(OctomapSetCase{"whole", 16, {}}, OctomapSetCase{"coarse", 14, {}},
                                         OctomapSetCase{"veryCoarse", 11, {}},
                                         OctomapSetCase{"slice", 16, ZInterval{-0.6, 0.9}},
                                         OctomapSetCase{"coarseSlice", 15, ZInterval{0.0, 0.5}},
                                         OctomapSetCase{"veryCoarseSlice", 4, ZInterval{0.1, 0.5}}),
                         [](const auto &instance) { return std::string(instance.param.name); });

TEST_P(OctomapSets, RereadWhatTheMapDoesNotNote)
{
    octomap::OcTree map(RESOLUTION);
    // Two cells far from each other, of which the second was seen twice
    map.updateNode(octomap::point3d(0.1F, 0.1F, 0.1F), true);
    for (int times = 0; times < 2; ++times)
        map.updateNode(octomap::point3d(3000.0F, 0.1F, 0.1F), true);
    OctomapSet set(map, options());
    const auto edge = 1 << (16U - GetParam().depth);
    const auto now = [&] { return cellsOf(OctomapObstacles(map, options()), edge); };
    EXPECT_EQ(cellsOf(*set.takeChange().after, 1), now());
    EXPECT_EQ(now().size(), 2U);
    map.setOccupancyThres(0.8);
    set.reread();
    const ObstacleChange less = set.takeChange();
    EXPECT_EQ(cellsOf(*less.after, 1), now());
    EXPECT_EQ(now().size(), 1U);
    EXPECT_TRUE(less.removed && !less.added);

    set.reread();
    const ObstacleChange same = set.takeChange();
    EXPECT_FALSE(same.added || same.removed);
    map.clear();
    set.reread();
    EXPECT_TRUE(cellsOf(*set.takeChange().after, 1).empty());
}

TEST(OctomapSet, HasTheOriginOfItsOptions)
{
    Random random(3);
    for (const bool sliced : {false, true})
    {
        const auto map = randomMap(random, RESOLUTION);
        OctomapOptions options;
        options.origin = {10.0, -20.0, 30.0};
        if (sliced)
            options.slice = ZInterval{29.5, 31.0};
        const OctomapObstacles expected(*map, options);
        OctomapSet set(*map, options);
        const ObstaclesPtr obstacles = set.takeChange().after;
        for (int i = 0; i < 200; ++i)
        {
            Eigen::Vector3d point = options.origin + random.point(3, 5.0);
            point.z() = sliced ? 0.0 : point.z();
            // Within cells it is a distance to the surface of a box, and the set joins others.
            const double distance = expected.clearance(point);
            EXPECT_NEAR(std::max(0.0, obstacles->clearance(point)), std::max(0.0, distance), 1e-9);
        }
    }
}

TEST(OctomapSet, RefusesWhatMakesNoSense)
{
    octomap::OcTree map(RESOLUTION);
    OctomapOptions options;
    options.unknownIsOccupied = true;
    EXPECT_THROW(OctomapSet(map, options), ompl::Exception);
    options.unknownIsOccupied = false;
    options.depth = 17;
    EXPECT_THROW(OctomapSet(map, options), ompl::Exception);
    options.depth = 16;
    options.slice = ZInterval{1.0, 1.0};
    EXPECT_THROW(OctomapSet(map, options), ompl::Exception);
    EXPECT_FALSE(map.isChangeDetectionEnabled());
    options.slice.reset();
    EXPECT_EQ(OctomapSet(map, options).takeChange().after->clearance({0.0, 0.0, 0.0}),
              std::numeric_limits<double>::infinity());
    EXPECT_FALSE(map.isChangeDetectionEnabled()) << "once no set is left";
    const OctomapSet set(map, options);
    EXPECT_TRUE(map.isChangeDetectionEnabled());
    EXPECT_NE(messageOf([&] { const OctomapSet second(map, options); }).find("another OctomapSet"), std::string::npos);
    EXPECT_TRUE(map.isChangeDetectionEnabled()) << "for the first set";
}
