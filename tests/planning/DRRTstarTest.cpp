#include "support/CrowdProblem.h"
#include "support/IterationLimit.h"
#include "support/Quiet.h"

#include "ompl_certificates/planning/DRRTstar.h"
#include "ompl_certificates/team/TeamObjective.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <ompl/base/DiscreteMotionValidator.h>
#include <ompl/base/PlannerData.h>
#include <ompl/base/goals/GoalSampleableRegion.h>
#include <ompl/base/goals/GoalState.h>
#include <ompl/base/goals/GoalStates.h>
#include <ompl/util/RandomNumbers.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;
namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace
{
    std::shared_ptr<DRRTstar> plannerFor(TeamSetup &setup)
    {
        auto planner = std::make_shared<DRRTstar>(setup.getSpaceInformation());
        setup.setPlanner(planner);
        return planner;
    }

    /** Any solution will do */
    void stopAtFirst(TeamSetup &setup)
    {
        auto objective = std::make_shared<TeamObjective>(setup.getSpaceInformation(), TeamObjective::MAKESPAN);
        objective->setCostThreshold(objective->infiniteCost());
        setup.setOptimizationObjective(objective);
    }

    std::vector<std::vector<double>> realsAlong(og::PathGeometric &path)
    {
        std::vector<std::vector<double>> reals(path.getStateCount());
        for (unsigned int i = 0; i < path.getStateCount(); ++i)
            path.getSpaceInformation()->getStateSpace()->copyToReals(reals[i], path.getState(i));
        return reals;
    }

    /** Two discs in a room that a wall divides, without start and goal */
    TeamSetupPtr dividedRoom(const std::string &first, const std::string &second)
    {
        auto team = std::make_shared<TeamStateSpace>();
        for (const std::string &name : {first, second})
            team->addRobot(RigidRobot::disc(name, 0.2, cubeBounds(2, 3.0)));
        const std::vector<PlacedBody> wall{{Body::box(0.2, 6.0)}};
        return std::make_shared<TeamSetup>(team, std::make_shared<FclObstacles>(wall, 2));
    }

    /** Two discs in a corridor that is too narrow to pass, with a niche in its middle */
    TeamSetupPtr corridor()
    {
        auto team = std::make_shared<TeamStateSpace>();
        for (const char *name : {"left", "right"})
            team->addRobot(RigidRobot::disc(name, 0.4, cubeBounds(2, 3.0)));
        const std::vector<PlacedBody> walls{{Body::box(6.0, 2.4), planarPose(0.0, -1.7, 0.0)},
                                            {Body::box(2.4, 2.4), planarPose(-1.8, 1.7, 0.0)},
                                            {Body::box(2.4, 2.4), planarPose(1.8, 1.7, 0.0)},
                                            {Body::box(1.2, 1.4), planarPose(0.0, 2.2, 0.0)}};
        auto setup = std::make_shared<TeamSetup>(team, std::make_shared<FclObstacles>(walls, 2));
        ob::ScopedState<> start(team), goal(team);
        start = std::vector<double>{-2.0, 0.0, 2.0, 0.0};
        goal = std::vector<double>{2.0, 0.0, -2.0, 0.0};
        setup->setStartAndGoalStates(start, goal);
        return setup;
    }

    class DRRTstarTest : public testing::Test
    {
        const Quiet quiet_;
    };
}

TEST_F(DRRTstarTest, SolvesCrowdsAmongBoxes)
{
    for (std::uint64_t seed = 1; seed <= scaled(30); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        ompl::RNG::setSeed(static_cast<std::uint_fast32_t>(seed));
        const auto setup = crowd(seed, 8, 5.0, 6);
        plannerFor(*setup);
        stopAtFirst(*setup);
        ASSERT_EQ(setup->solve(20.0), ob::PlannerStatus::EXACT_SOLUTION);
        og::PathGeometric &path = setup->getSolutionPath();
        EXPECT_TRUE(path.check());
        EXPECT_TRUE(setup->getStateSpace()->equalStates(path.getStates().back(),
                                                        setup->getGoal()->as<ob::GoalState>()->getState()));
    }
}

TEST_F(DRRTstarTest, LetsSlowRobotsTakeTheirTime)
{
    for (std::uint64_t seed = 1; seed <= scaled(5); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        ompl::RNG::setSeed(static_cast<std::uint_fast32_t>(seed));
        const auto setup = crowd(seed, 4, 5.0, 0);
        auto &team = *setup->getStateSpace()->as<TeamStateSpace>();
        const std::vector<double> speeds{0.25, 3.0, 1.0, 10.0};
        const ob::State *start = setup->getProblemDefinition()->getStartState(0);
        ob::ScopedState<> goal(setup->getStateSpace());
        goal = setup->getGoal()->as<ob::GoalState>()->getState();
        double sum = 0.0, longest = 0.0;
        for (unsigned int robot = 0; robot < speeds.size(); ++robot)
        {
            team.setSpeed(robot, speeds[robot]);
            const double time = team.getSubspace(robot)->distance(start->as<ob::CompoundState>()->components[robot],
                                                                  goal->as<ob::CompoundState>()->components[robot]) /
                                speeds[robot];
            sum += time;
            longest = std::max(longest, time);
        }
        for (const auto &[name, least] : {std::make_pair("makespan", longest), std::make_pair("arrival", sum)})
        {
            const auto objective = makeObjective(name, setup->getSpaceInformation(), goal);
            setup->clear();
            setup->setOptimizationObjective(objective);
            plannerFor(*setup);
            ASSERT_EQ(setup->solve(ob::IterationTerminationCondition(3000)), ob::PlannerStatus::EXACT_SOLUTION);
            const double cost = setup->getSolutionPath().cost(objective).value();
            EXPECT_GE(cost, least * (1.0 - 1e-9)) << name;
            EXPECT_LE(cost, least * 1.5) << name;  // they get into each other's way
        }
    }
}

TEST_F(DRRTstarTest, ProvesAllMotionsInContinuousMode)
{
    for (std::uint64_t seed = 1; seed <= scaled(10); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        ompl::RNG::setSeed(static_cast<std::uint_fast32_t>(seed));
        const auto setup = crowd(seed, 6, 5.0, 6, Method::SHARED_PROJECTION, CertificateMotionValidator::CONTINUOUS);
        plannerFor(*setup);
        stopAtFirst(*setup);
        ASSERT_EQ(setup->solve(20.0), ob::PlannerStatus::EXACT_SOLUTION);
        EXPECT_TRUE(setup->getSolutionPath().check());
        EXPECT_TRUE(isFreeAtFineResolution(*setup, setup->getSolutionPath()));
    }
}

TEST_F(DRRTstarTest, HoldsAtTheResolutionOfTheTeam)
{
    // Robots' own motions have few samples, some of them on either side of a thin wall. In a step of the team all have
    // as many as the longest.
    for (std::uint64_t seed = 1; seed <= scaled(20); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        ompl::RNG::setSeed(static_cast<std::uint_fast32_t>(seed));
        auto team = std::make_shared<TeamStateSpace>();
        for (const char *name : {"a", "b", "c", "d", "e"})
        {
            team->addRobot(RigidRobot::disc(name, 0.05, cubeBounds(2, 3.0)));
            team->getSubspace(name)->setLongestValidSegmentFraction(0.08);
        }
        Random random(seed);
        std::vector<PlacedBody> walls;
        for (unsigned int i = 0; i < 12; ++i)
            walls.push_back({Body::box(0.02, 1.5), random.pose(2, 3.0)});
        TeamSetup setup(team, std::make_shared<FclObstacles>(walls, 2));
        setup.getSpaceInformation()->setup();
        const auto start = randomFreeState(setup, random, 3.0);
        setup.setStartAndGoalStates(start, randomFreeState(setup, random, 3.0));
        plannerFor(setup)->setSmoothing(false);
        stopAtFirst(setup);
        ASSERT_EQ(setup.solve(20.0), ob::PlannerStatus::EXACT_SOLUTION);
        EXPECT_TRUE(setup.getSolutionPath().check());
    }
}

TEST_F(DRRTstarTest, FindsEqualPathsUnderAllMethods)
{
    for (std::uint64_t seed = 1; seed <= scaled(5); ++seed)
    {
        std::vector<std::vector<double>> first;
        for (const Method method : allMethods())
        {
            SCOPED_TRACE("seed " + std::to_string(seed) + ", " + nameOf(method));
            ompl::RNG::setSeed(static_cast<std::uint_fast32_t>(seed));
            const auto setup = crowd(seed, 5, 4.0, 4, method);
            plannerFor(*setup);
            setup->setup();
            ASSERT_EQ(setup->solve(evaluations(3000)), ob::PlannerStatus::EXACT_SOLUTION);
            const auto path = realsAlong(setup->getSolutionPath());
            if (first.empty())
                first = path;
            EXPECT_EQ(path, first);
        }
    }
}

TEST_F(DRRTstarTest, LetsRobotsMakeWayWherePrioritiesFail)
{
    ompl::RNG::setSeed(1);
    const auto setup = corridor();
    plannerFor(*setup);
    stopAtFirst(*setup);
    ASSERT_EQ(setup->solve(30.0), ob::PlannerStatus::EXACT_SOLUTION);
    EXPECT_TRUE(setup->getSolutionPath().check());
}

TEST_F(DRRTstarTest, UsesEveryStartAndGoal)
{
    ompl::RNG::setSeed(1);
    // One robot is walled in at the first start, and cannot leave towards the first goal.
    const auto setup = dividedRoom("a", "b");
    ob::ScopedState<> start(setup->getStateSpace()), goal(setup->getStateSpace());
    start = std::vector<double>{-2.0, 1.0, 2.0, 1.0};
    setup->addStartState(start);
    start = std::vector<double>{2.0, -1.0, 2.0, 1.0};
    setup->addStartState(start);
    auto goals = std::make_shared<ob::GoalStates>(setup->getSpaceInformation());
    goal = std::vector<double>{-2.0, -2.0, -2.0, 2.0};
    goals->addState(goal);
    goal = std::vector<double>{2.0, -2.0, 2.0, 2.0};
    goals->addState(goal);
    setup->setGoal(goals);
    plannerFor(*setup);
    stopAtFirst(*setup);
    ASSERT_EQ(setup->solve(10.0), ob::PlannerStatus::EXACT_SOLUTION);
    EXPECT_TRUE(setup->getStateSpace()->equalStates(setup->getSolutionPath().getState(0), start.get()) ||
                setup->getStateSpace()->equalStates(setup->getSolutionPath().getStates().back(), goal.get()));
    ob::PlannerData data(setup->getSpaceInformation());
    setup->getPlannerData(data);
    EXPECT_EQ(data.numStartVertices(), 2U);
    EXPECT_EQ(data.numGoalVertices(), 1U);
    EXPECT_GE(data.numEdges(), 1U);
}

/** In the roadmap that they share, the start of one robot lies beside the goal of another, as near as numbers are. */
TEST_F(DRRTstarTest, SwapsRobotsOnACircle)
{
    for (const double center : {0.0, 4.0, 10.0})
    {
        SCOPED_TRACE(center);
        constexpr unsigned int robots = 16;
        ob::RealVectorBounds bounds(2);
        bounds.setLow(center - 4.0);
        bounds.setHigh(center + 16.0);
        auto team = std::make_shared<TeamStateSpace>();
        for (unsigned int i = 0; i < robots; ++i)
            team->addRobot(RigidRobot::disc("robot" + std::to_string(i), 0.3, bounds));
        team->setLongestValidSegmentFraction(0.01);
        TeamSetup setup(team, std::make_shared<FclObstacles>(std::vector<PlacedBody>{}, 2));
        std::vector<double> starts, goals;
        for (unsigned int i = 0; i < robots; ++i)
        {
            const double angle = 2.0 * M_PI * i / robots;
            for (auto *reals : {&starts, &goals})
            {
                const double turned = reals == &starts ? angle : angle + M_PI;
                reals->push_back(center + 4.0 * std::cos(turned));
                reals->push_back(center + 4.0 * std::sin(turned));
            }
        }
        ob::ScopedState<> start(team), goal(team);
        start = starts;
        goal = goals;
        setup.setStartAndGoalStates(start, goal);
        plannerFor(setup);
        stopAtFirst(setup);
        EXPECT_EQ(setup.solve(30.0), ob::PlannerStatus::EXACT_SOLUTION);
        EXPECT_TRUE(setup.getSolutionPath().check());
    }
}

TEST_F(DRRTstarTest, KeepsItsOwnCopyOfAPathThatIsSimplified)
{
    const auto setup = crowd(1, 2, 3.0, 1);
    const auto planner = plannerFor(*setup);
    stopAtFirst(*setup);
    ASSERT_EQ(setup->solve(10.0), ob::PlannerStatus::EXACT_SOLUTION);
    ob::PlannerData data(setup->getSpaceInformation());
    planner->getPlannerData(data);
    ASSERT_GT(data.numVertices(), 1U);
    const auto &states = setup->getSolutionPath().getStates();
    for (unsigned int i = 0; i < data.numVertices(); ++i)
        EXPECT_EQ(std::count(states.begin(), states.end(), data.getVertex(i).getState()), 0);
}

TEST_F(DRRTstarTest, ReturnsNoWorsePathAfterOneThatWasSimplified)
{
    for (unsigned int seed = 1; seed <= 10; ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const auto setup = crowd(seed, 4, 3.0, 4);
        plannerFor(*setup);
        for (int i = 0; i < 100 && !setup->haveExactSolutionPath(); ++i)
            setup->solve(0.1);
        ASSERT_TRUE(setup->haveExactSolutionPath());
        setup->simplifySolution(0.2);
        const auto objective = setup->getProblemDefinition()->getOptimizationObjective();
        const double simplified = setup->getSolutionPath().cost(objective).value();
        ob::PlannerSolution solution(nullptr);
        ASSERT_TRUE(setup->getProblemDefinition()->getSolution(solution));
        EXPECT_DOUBLE_EQ(solution.cost_.value(), simplified);
        setup->solve(0.1);
        EXPECT_LE(setup->getSolutionPath().cost(objective).value(), simplified * (1.0 + 1e-9));
    }
}

TEST_F(DRRTstarTest, GetsBetterWithTimeAndStartsAgainAfterClear)
{
    ompl::RNG::setSeed(1);
    const auto setup = crowd(3, 4, 4.0, 4);
    const auto planner = plannerFor(*setup);
    std::vector<double> costs;
    setup->setup();
    setup->getProblemDefinition()->setIntermediateSolutionCallback(
        [&](const ob::Planner *, const std::vector<const ob::State *> &states, ob::Cost cost)
        {
            EXPECT_GE(states.size(), 2U);
            costs.push_back(cost.value());
        });
    EXPECT_TRUE(std::isinf(planner->getBestCost().value()));
    ASSERT_EQ(setup->solve(evaluations(500)), ob::PlannerStatus::EXACT_SOLUTION);
    const double first = planner->getBestCost().value();
    EXPECT_DOUBLE_EQ(setup->getSolutionPath().length(), first);
    ASSERT_EQ(setup->solve(evaluations(5000)), ob::PlannerStatus::EXACT_SOLUTION);
    EXPECT_LE(planner->getBestCost().value(), first);
    EXPECT_DOUBLE_EQ(setup->getSolutionPath().length(), planner->getBestCost().value());
    EXPECT_TRUE(setup->getSolutionPath().check());
    ASSERT_GE(costs.size(), 2U);
    EXPECT_TRUE(std::is_sorted(costs.rbegin(), costs.rend()));
    EXPECT_EQ(planner->getPlannerProgressProperties().count("best cost REAL"), 1U);

    setup->clear();
    EXPECT_TRUE(std::isinf(planner->getBestCost().value()));
    ob::PlannerData data(setup->getSpaceInformation());
    planner->getPlannerData(data);
    EXPECT_EQ(data.numVertices(), 0U);
    EXPECT_EQ(setup->solve(evaluations(0)), ob::PlannerStatus::TIMEOUT);
    EXPECT_EQ(setup->solve(evaluations(2000)), ob::PlannerStatus::EXACT_SOLUTION);
}

TEST_F(DRRTstarTest, PlansForOneRobotAndForAnyMotionValidator)
{
    ompl::RNG::setSeed(1);
    const auto setup = crowd(5, 1, 4.0, 6);
    const auto planner = plannerFor(*setup);
    setup->getSpaceInformation()->setMotionValidator(
        std::make_shared<ob::DiscreteMotionValidator>(setup->getSpaceInformation()));
    planner->setSmoothing(false);
    ASSERT_EQ(setup->solve(evaluations(3000)), ob::PlannerStatus::EXACT_SOLUTION);
    EXPECT_TRUE(setup->getSolutionPath().check());
}

TEST_F(DRRTstarTest, IsSetUpAgainOnceThereIsAProblem)
{
    ompl::RNG::setSeed(1);
    const auto setup = crowd(2, 3, 4.0, 2);
    DRRTstar planner(setup->getSpaceInformation());
    planner.setup();
    EXPECT_FALSE(planner.isSetup());
    planner.setProblemDefinition(setup->getProblemDefinition());
    EXPECT_EQ(planner.ob::Planner::solve(0.3), ob::PlannerStatus::EXACT_SOLUTION);
}
