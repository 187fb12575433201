#include "MapTeams.h"
#include "RandomMaps.h"
#include "ompl_certificates/octomap/OctomapObstacles.h"
#include "ompl_certificates/planning/Planners.h"
#include "support/Checkers.h"
#include "support/Quiet.h"

#include <gtest/gtest.h>
#include <ompl/base/PlannerData.h>
#include <ompl/base/terminationconditions/IterationTerminationCondition.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;
namespace ob = ompl::base;

namespace
{
    std::vector<double> treeOf(const TeamStateSpacePtr &team, const ObstaclesPtr &obstacles, Method method,
                               const std::string &plannerName, unsigned int seed, const ob::ScopedState<> &start,
                               const ob::ScopedState<> &goal)
    {
        const Quiet quiet;
        ompl::RNG::setSeed(seed);
        TeamSetup setup(team, obstacles, method);
        setup.setStartAndGoalStates(start, goal);
        const auto planner = makePlanner(plannerName, setup.getSpaceInformation());
        setup.setPlanner(planner);
        setup.setup();
        ob::IterationTerminationCondition condition(plannerName == "RRTstar" ? 100 : 400);
        setup.solve(ob::PlannerTerminationCondition(condition));
        ob::PlannerData data(setup.getSpaceInformation());
        planner->getPlannerData(data);
        std::vector<double> tree;
        for (unsigned int i = 0; i < data.numVertices(); ++i)
        {
            for (const double real : realsOf(*team, data.getVertex(i).getState()))
                tree.push_back(real);
            std::vector<unsigned int> edges;
            data.getEdges(i, edges);
            tree.insert(tree.end(), edges.begin(), edges.end());
        }
        return tree;
    }
}

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
            const auto freeState = [&]
            {
                auto state = randomState(random, team);
                while (!checkers.isValid(state.get()))
                    state = randomState(random, team);
                return state;
            };
            const auto start = freeState(), goal = freeState();
            const auto expected = treeOf(team, obstacles, Method::FCL, GetParam(), seed, start, goal);
            numbers += expected.size();
            for (const Method method : allMethods())
                ASSERT_EQ(treeOf(team, obstacles, method, GetParam(), seed, start, goal), expected) << nameOf(method);
        }
    EXPECT_GT(numbers, scaled(15) * 40U);
}

INSTANTIATE_TEST_SUITE_P(Planner, OctomapTrees, testing::Values("RRT", "RRTConnect", "RRTstar"),
                         [](const auto &tested) { return tested.param; });
