#include "support/Quiet.h"
#include "support/RandomStates.h"

#include "ompl_certificates/obstacles/FclObstacles.h"
#include "ompl_certificates/planning/DRRTstar.h"
#include "ompl_certificates/planning/TeamSetup.h"
#include "ompl_certificates/robots/RigidRobot.h"
#include "ompl_certificates/team/TeamObjective.h"

#include <cmath>
#include <gtest/gtest.h>
#include <ompl/base/goals/GoalStates.h>
#include <ompl/util/RandomNumbers.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;
namespace ob = ompl::base;

namespace
{
    /** Two discs in a room with a wall, without start and goal */
    TeamSetupPtr roomWithWall()
    {
        auto team = std::make_shared<TeamStateSpace>();
        for (const char *name : {"left", "right"})
            team->addRobot(RigidRobot::disc(name, 0.2, cubeBounds(2, 3.0)));
        const std::vector<PlacedBody> wall{{Body::box(0.2, 6.0)}};
        return std::make_shared<TeamSetup>(team, std::make_shared<FclObstacles>(wall, 2));
    }

    void setDRRTstar(TeamSetup &setup)
    {
        setup.setPlanner(std::make_shared<DRRTstar>(setup.getSpaceInformation()));
    }

    class DRRTstarOptimal : public testing::Test
    {
        const Quiet quiet_;
    };
}

TEST_F(DRRTstarOptimal, EndsWhereNoPathCanBeBetter)
{
    const auto setup = roomWithWall();
    const auto &team = setup->getStateSpace();
    const auto &si = setup->getSpaceInformation();
    const auto endsBySelf =
        [&](TeamObjective::Kind kind, const std::vector<double> &from, const std::vector<double> &to)
    {
        ompl::RNG::setSeed(1);
        ob::ScopedState<> start(team), goal(team);
        start = from;
        goal = to;
        setup->clear();
        setup->setStartAndGoalStates(start, goal);
        setup->setOptimizationObjective(std::make_shared<TeamObjective>(si, kind));
        setDRRTstar(*setup);
        constexpr unsigned int most = 50000;
        unsigned int asked = 0;
        const ob::PlannerTerminationCondition condition([&] { return ++asked > most; });
        EXPECT_EQ(setup->solve(condition), ob::PlannerStatus::EXACT_SOLUTION);
        if (asked > most)
            return false;
        const auto &path = setup->getSolutionPath();
        const auto lengths = std::make_shared<TeamObjective>(si, TeamObjective::SUM_OF_LENGTHS);
        EXPECT_NEAR(path.cost(lengths).value(), lengths->motionCost(start.get(), goal.get()).value(), 1e-9);
        return true;
    };
    for (const auto kind : {TeamObjective::SUM_OF_LENGTHS, TeamObjective::MAKESPAN})
    {
        EXPECT_TRUE(endsBySelf(kind, {-1, -1, 1, 1}, {-1, -1, 1, 1}));
        EXPECT_TRUE(endsBySelf(kind, {-1, -1, 1, 1}, {-2, 2, 2, -2}));
        // They meet in the middle.
        EXPECT_FALSE(endsBySelf(kind, {1, -1, 1, 1}, {1, 1, 1, -1}));
    }
}

TEST_F(DRRTstarOptimal, GoesOnWhereAnotherStartOrGoalIsBetter)
{
    const auto setup = roomWithWall();
    const auto &si = setup->getSpaceInformation();
    const auto stateAt = [&](double y)
    {
        ob::ScopedState<> state(si);
        state = std::vector<double>{-1, y, 1, y};
        return state;
    };
    const auto solve = [&]
    {
        unsigned int asked = 0;
        EXPECT_EQ(setup->solve(ob::PlannerTerminationCondition([&] { return ++asked > 50000; })),
                  ob::PlannerStatus::EXACT_SOLUTION);
        return setup->getSolutionPath().length() / std::sqrt(2.0);
    };
    ompl::RNG::setSeed(1);
    setDRRTstar(*setup);
    auto goals = std::make_shared<ob::GoalStates>(si);
    goals->addState(stateAt(2.5));
    goals->addState(stateAt(0.5));
    setup->addStartState(stateAt(-2));
    setup->setGoal(goals);
    setup->setOptimizationObjective(std::make_shared<TeamObjective>(si, TeamObjective::SUM_OF_LENGTHS));
    EXPECT_NEAR(solve(), 2.5, 1e-6);
    setup->addStartState(stateAt(-1));
    EXPECT_NEAR(solve(), 1.5, 1e-6);
}

/** Straight on, the path is the shortest, but whether that suffices is up to the objective. */
TEST_F(DRRTstarOptimal, CallsAPathOptimizedWhereItMeetsTheThreshold)
{
    for (const double threshold : {0.0, 5.0})
    {
        const auto setup = roomWithWall();
        ob::ScopedState<> start(setup->getStateSpace()), goal(setup->getStateSpace());
        start = std::vector<double>{-1, -1, 1, -1};
        goal = std::vector<double>{-1, 1, 1, 1};
        setup->setStartAndGoalStates(start, goal);
        const auto objective =
            std::make_shared<TeamObjective>(setup->getSpaceInformation(), TeamObjective::SUM_OF_LENGTHS);
        objective->setCostThreshold(ob::Cost(threshold));
        setup->setOptimizationObjective(objective);
        setDRRTstar(*setup);
        ASSERT_EQ(setup->solve(10.0), ob::PlannerStatus::EXACT_SOLUTION);
        EXPECT_EQ(setup->getProblemDefinition()->getSolutions().front().optimized_, threshold > 4.0);
    }
}
