#include "MapTeams.h"
#include "MapTrees.h"
#include "RandomMaps.h"
#include "ompl_certificates/octomap/OctomapObstacles.h"

#include <gtest/gtest.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;

class OctomapTrees : public testing::TestWithParam<std::string>
{
};

TEST_P(OctomapTrees, AreTheSameUnderAllMethods)
{
    std::size_t numbers = 0;
    for (unsigned int seed = 1; seed <= scaled(15); ++seed)
        for (const unsigned int dimension : {2U, 3U})
        {
            SCOPED_TRACE("seed " + std::to_string(seed) + ", dimension " + std::to_string(dimension));
            Random random(seed);
            OctomapOptions options;
            if (dimension == 2)
                options.slice = {-0.5, 0.5};
            const auto obstacles = std::make_shared<OctomapObstacles>(*randomMap(random, 0.2), options);
            const auto team = teamFor(dimension);
            const Checkers checkers(team, obstacles);
            const auto start = validState(random, team, checkers.reference()),
                       goal = validState(random, team, checkers.reference());
            const auto treeOf = [&](Method method)
            {
                TeamSetup setup(team, obstacles, method);
                return growTree(setup, GetParam(), seed, start, goal);
            };
            const auto expected = treeOf(Method::FCL);
            numbers += expected.size();
            for (const Method method : allMethods())
                ASSERT_EQ(treeOf(method), expected) << nameOf(method);
        }
    EXPECT_GT(numbers, scaled(15) * 40U);
}

INSTANTIATE_TEST_SUITE_P(Planner, OctomapTrees, testing::Values("RRT", "RRTConnect", "RRTstar"),
                         [](const auto &tested) { return tested.param; });
