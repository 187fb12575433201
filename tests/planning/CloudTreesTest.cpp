#include "ompl_certificates/obstacles/FclObstacles.h"
#include "ompl_certificates/obstacles/MixedObstacles.h"
#include "ompl_certificates/obstacles/PointCloudObstacles.h"
#include "ompl_certificates/planning/Planners.h"
#include "support/Checkers.h"
#include "support/ErrorsOnly.h"
#include "support/IterationLimit.h"
#include "support/Quiet.h"
#include "support/RandomClouds.h"

#include <gtest/gtest.h>
#include <ompl/base/PlannerData.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;
namespace ob = ompl::base;

namespace
{
    /** All states of a planner's tree, one after the other, each with the number of its edges */
    std::vector<double> treeOf(const TeamStateSpacePtr &team, const ObstaclesPtr &obstacles, Method method,
                               const std::string &plannerName, const ob::ScopedState<> &start,
                               const ob::ScopedState<> &goal)
    {
        {
            const Quiet quiet;
            ompl::RNG::setSeed(1);
        }
        TeamSetup setup(team, obstacles, method);
        setup.setStartAndGoalStates(start, goal);
        setup.getSpaceInformation()->setStateValidityCheckingResolution(0.005);
        const auto planner = makePlanner(plannerName, setup.getSpaceInformation());
        setup.setPlanner(planner);
        setup.setup();
        ob::IterationTerminationCondition condition(400);
        setup.solve(ob::PlannerTerminationCondition(condition));
        ob::PlannerData data(setup.getSpaceInformation());
        planner->getPlannerData(data);
        std::vector<double> numbers;
        for (unsigned int i = 0; i < data.numVertices(); ++i)
        {
            const auto reals = realsOf(*team, data.getVertex(i).getState());
            numbers.insert(numbers.end(), reals.begin(), reals.end());
            std::vector<unsigned int> edges;
            numbers.push_back(data.getEdges(i, edges));
        }
        return numbers;
    }
}

class CloudTrees : public ErrorsOnly<std::string>
{
};

TEST_P(CloudTrees, AreTheSameUnderAllMethods)
{
    std::size_t numbers = 0;
    for (unsigned int seed = 1; seed <= scaled(2); ++seed)
        for (unsigned int kind = 0; kind < TEAMS; ++kind)
        {
            SCOPED_TRACE("seed " + std::to_string(seed) + ", team " + std::to_string(kind));
            Random random(seed);
            const auto team = anyTeam(kind);
            const unsigned int dimension = team->getWorkspaceDimension();
            // A few lumps, so that there is a way
            std::vector<Eigen::Vector3d> points;
            for (int lump = 0; lump < 20; ++lump)
                for (const auto &point : randomPoints(random, dimension, 60, 0.3, random.point(dimension, HALF)))
                    points.push_back(point);
            ObstaclesPtr obstacles = std::make_shared<PointCloudObstacles>(PointCloud{points, 0.03}, dimension);
            if (kind < FIRST_OF_MESHES && seed % 2 == 0)
                obstacles = std::make_shared<MixedObstacles>(
                    std::vector<ObstaclesPtr>{obstacles, anyObstacles(random, kind, 3)});
            const Checkers checkers(team, obstacles);
            auto start = randomState(random, team), goal = randomState(random, team);
            for (auto *state : {&start, &goal})
                for (int i = 0; i < 100000 && !checkers.isValid(state->get()); ++i)
                    *state = randomState(random, team);
            const auto expected = treeOf(team, obstacles, Method::FCL, GetParam(), start, goal);
            numbers += expected.size();
            for (const Method method : allMethods())
                ASSERT_TRUE(treeOf(team, obstacles, method, GetParam(), start, goal) == expected) << nameOf(method);
        }
    EXPECT_GT(numbers, 500U);
}

INSTANTIATE_TEST_SUITE_P(Planner, CloudTrees, testing::Values("RRT", "RRTConnect"),
                         [](const auto &tested) { return tested.param; });
