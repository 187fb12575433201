#include "DynamicProblems.h"
#include "OwnDynamicRobots.h"

#include "support/Message.h"
#include "support/Quiet.h"
#include "support/Random.h"

#include "ompl_certificates/control/ControlPathSimplifier.h"
#include "ompl_certificates/control/ProvePath.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <ompl/base/goals/GoalState.h>
#include <ompl/base/goals/GoalStates.h>
#include <ompl/control/planners/rrt/RRT.h>
#include <ompl/util/RandomNumbers.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;
namespace ob = ompl::base;
namespace oc = ompl::control;

namespace
{
    class ControlPathSimplifierTest : public testing::Test
    {
        const Quiet quiet_;
    };

    const ob::State *goalOf(const TeamControlSetup &setup)
    {
        return static_cast<const ob::GoalState &>(*setup.getGoal()).getState();
    }

    /** One state, and none that differs from it by any rounding */
    class ExactGoal : public ob::Goal
    {
    public:
        ExactGoal(const ob::SpaceInformationPtr &si, const ob::State *state)
          : Goal(si), state_(si->getStateSpace(), state)
        {
        }

        bool isSatisfied(const ob::State *state) const override
        {
            return si_->equalStates(state, state_.get());
        }

    private:
        ob::ScopedState<> state_;
    };

    double distanceToGoal(TeamControlSetup &setup)
    {
        return setup.getStateSpace()->distance(setup.getSolutionPath().getStates().back(), goalOf(setup));
    }

    /** A puck alone, at rest at the start and at the goal, for which RRT plans */
    std::unique_ptr<TeamControlSetup> puckFrom(double x, double y, double goalX, double goalY)
    {
        const auto space = within({2.0, 2.0});
        auto setup = std::make_unique<TeamControlSetup>(
            teamOf({Integrator::secondOrder(RigidRobot::disc("puck", 0.1, space), within({0.5, 0.5}),
                                            within({2.0, 2.0}))}),
            boxes({}));
        ob::ScopedState<> start(setup->getStateSpace()), goal(setup->getStateSpace());
        start = std::vector<double>{x, y, 0.0, 0.0};
        goal = std::vector<double>{goalX, goalY, 0.0, 0.0};
        setup->setStartAndGoalStates(start, goal, 0.4);
        setup->setPlanner(std::make_shared<oc::RRT>(setup->getSpaceInformation()));
        return setup;
    }
}

TEST_F(ControlPathSimplifierTest, GetsATeamToItsGoalInLessTime)
{
    for (const auto mode : {CertificateMotionValidator::DISCRETE, CertificateMotionValidator::CONTINUOUS})
        for (std::uint_fast32_t seed = 1; seed <= scaled(2); ++seed)
        {
            SCOPED_TRACE("seed " + std::to_string(seed));
            ompl::RNG::setSeed(seed);
            const auto setup = swapping(Method::SHARED_PROJECTION, mode);
            ASSERT_EQ(setup->solve(60.0), ob::PlannerStatus::EXACT_SOLUTION);
            oc::PathControl &path = setup->getSolutionPath();
            const double before = path.length();
            setup->simplifySolution();
            EXPECT_TRUE(path.check());
            // Half a diagonal at full speed takes 4 s, and the box is in the way.
            EXPECT_GT(path.length(), 4.0);
            EXPECT_LT(path.length(), 0.75 * before);
            EXPECT_LT(distanceToGoal(*setup), 1e-3);
            EXPECT_TRUE(
                setup->getStateSpace()->equalStates(path.getState(0), setup->getProblemDefinition()->getStartState(0)));
            if (mode == CertificateMotionValidator::CONTINUOUS)
            {
                EXPECT_TRUE(provePath(path, setup->getTeamChecker()).unproved.empty());
            }
        }
}

TEST_F(ControlPathSimplifierTest, TellsTheLengthOfTheSimplifiedSolution)
{
    ompl::RNG::setSeed(1);
    const auto setup = puckFrom(-1.5, 0.0, 1.5, 0.0);
    ASSERT_EQ(setup->solve(60.0), ob::PlannerStatus::EXACT_SOLUTION);
    const double before = setup->getSolutionPath().length();
    setup->simplifySolution();
    EXPECT_LT(setup->getSolutionPath().length(), before);
    EXPECT_EQ(setup->getProblemDefinition()->getSolutions().front().length_, setup->getSolutionPath().length());
}

TEST_F(ControlPathSimplifierTest, FindsTheSamePathUnderAllMethods)
{
    expectSamePathUnderAllMethods([](TeamControlSetup &setup) { setup.simplifySolution(); });
}

TEST_F(ControlPathSimplifierTest, BringsEachKindOfRobotToItsGoalWithinLimits)
{
    for (const auto &robot : allKinds())
    {
        SCOPED_TRACE(robot->getName());
        ompl::RNG::setSeed(1);
        const auto setup = crossing(robot, {{{0.0, 0.0, 0.3, 2.0}}});
        ASSERT_EQ(setup->solve(60.0), ob::PlannerStatus::EXACT_SOLUTION);
        oc::PathControl &path = setup->getSolutionPath();
        const double before = path.length();
        setup->simplifySolution();
        EXPECT_TRUE(path.check());
        EXPECT_LE(path.length(), before);
        EXPECT_LT(distanceToGoal(*setup), 1e-3);
        path.interpolate();
        for (std::size_t i = 0; i < path.getControlCount(); ++i)
            for (std::size_t c = 0; c < robot->getControlBounds().low.size(); ++c)
            {
                const double value = path.getControl(static_cast<unsigned int>(i))
                                         ->as<oc::RealVectorControlSpace::ControlType>()
                                         ->values[c];
                EXPECT_GE(value, robot->getControlBounds().low[c]);
                EXPECT_LE(value, robot->getControlBounds().high[c]);
            }
        for (const ob::State *state : path.getStates())
            EXPECT_TRUE(robot->isWithinLimits(state->as<ob::CompoundState>()->components[0]));
    }
}

/** Three meters at half a meter a second, and 0.25 s more to get under way and to stop */
TEST_F(ControlPathSimplifierTest, ComesNearTheLeastTimeWhereNothingIsInTheWay)
{
    const auto kinds = allKinds();
    for (const auto &[kind, least] : {std::pair{0, 6.0}, {1, 6.25}, {2, 6.0}, {4, 6.0}})
    {
        SCOPED_TRACE(kinds[static_cast<std::size_t>(kind)]->getName());
        ompl::RNG::setSeed(3);
        const auto setup = crossing(kinds[static_cast<std::size_t>(kind)], {});
        ASSERT_EQ(setup->solve(60.0), ob::PlannerStatus::EXACT_SOLUTION);
        setup->simplifySolution();
        EXPECT_GT(setup->getSolutionPath().length(), least - 1e-3);
        EXPECT_LT(setup->getSolutionPath().length(), 1.05 * least + 0.1);
    }
}

TEST_F(ControlPathSimplifierTest, HoldsControlsForTheDurationsOfTheSpaceInformation)
{
    for (const unsigned int least : {3U, 5U})
        for (const std::size_t kind : {0U, 1U, 2U})
            for (std::uint_fast32_t seed = 1; seed <= scaled(2); ++seed)
            {
                const auto robot = allKinds()[kind];
                SCOPED_TRACE(robot->getName() + " seed " + std::to_string(seed));
                ompl::RNG::setSeed(seed);
                const auto setup = crossing(robot, {{{0.0, 0.0, 0.3, 2.0}}});
                setup->getSpaceInformation()->setMinMaxControlDuration(least, 6);
                setup->setPlanner(std::make_shared<oc::RRT>(setup->getSpaceInformation()));
                ASSERT_EQ(setup->solve(60.0), ob::PlannerStatus::EXACT_SOLUTION);
                const double before = setup->getSolutionPath().length();
                setup->simplifySolution();
                EXPECT_LT(setup->getSolutionPath().length(), before);
                for (const double duration : setup->getSolutionPath().getControlDurations())
                {
                    EXPECT_GT(duration, 0.1 * least - 0.01);
                    EXPECT_LT(duration, 0.61);
                }
            }
}

/** It brakes in its own way, for some six hundred steps. */
TEST_F(ControlPathSimplifierTest, LetsAFastRobotWaitForASlowOne)
{
    const auto space = within({2.0, 2.0});
    const auto fast = std::make_shared<SoftBrake>(RigidRobot::disc("fast", 0.1, space));
    const auto slow = Integrator::firstOrder(RigidRobot::disc("slow", 0.1, space), within({0.03, 0.03}));
    for (std::uint_fast32_t seed = 1; seed <= scaled(3); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        ompl::RNG::setSeed(seed);
        TeamControlSetup setup(teamOf({fast, slow}), boxes({}));
        ob::ScopedState<> start(setup.getStateSpace()), goal(setup.getStateSpace());
        start = std::vector<double>{-1.0, 1.0, 0, 0, -1.0, -1.0};
        goal = std::vector<double>{1.0, 1.5, 0, 0, 1.0, -1.0};
        setup.setStartAndGoalStates(start, goal, 0.4);
        setup.setPlanner(std::make_shared<PrioritizedRRT>(setup.getSpaceInformation()));
        ASSERT_EQ(setup.solve(60.0), ob::PlannerStatus::EXACT_SOLUTION);
        const double before = setup.getSolutionPath().length();
        setup.simplifySolution(20.0);
        EXPECT_TRUE(setup.getSolutionPath().check());
        EXPECT_GT(setup.getSolutionPath().length(), 60.0);
        EXPECT_LT(setup.getSolutionPath().length(), before);
        EXPECT_LT(distanceToGoal(setup), 1e-4);
    }
}

TEST_F(ControlPathSimplifierTest, ReachesGoalsAtTheBounds)
{
    ompl::RNG::setSeed(1);
    const auto setup = puckFrom(-1.0, 0.0, 2.0, 0.0);
    ASSERT_EQ(setup->solve(60.0), ob::PlannerStatus::EXACT_SOLUTION);
    setup->simplifySolution();
    EXPECT_TRUE(setup->getSolutionPath().check());
    EXPECT_LT(distanceToGoal(*setup), 1e-4);
}

TEST_F(ControlPathSimplifierTest, LeavesASolutionThatLaterOnesMustBeat)
{
    ompl::RNG::setSeed(1);
    const auto setup = puckFrom(-1.5, -1.0, 1.5, 1.0);
    ASSERT_EQ(setup->solve(60.0), ob::PlannerStatus::EXACT_SOLUTION);
    oc::PathControl &path = setup->getSolutionPath();
    const double found = path.length();
    setup->simplifySolution();
    const double simplified = path.length();
    ASSERT_LT(simplified, found);
    for (int i = 0; i < 20; ++i)
    {
        // Its next tree finds another path, mostly longer than the simplified one.
        setup->getPlanner()->clear();
        ASSERT_EQ(setup->solve(60.0), ob::PlannerStatus::EXACT_SOLUTION);
        EXPECT_LE(setup->getSolutionPath().length(), simplified);
    }
    EXPECT_EQ(path.length(), simplified) << "who holds the path keeps it";
}

/** A quaternion and its opposite are one goal. */
TEST_F(ControlPathSimplifierTest, TurnsARobotInSpace)
{
    const auto space = within({2.0, 2.0, 2.0});
    const auto spinner = std::make_shared<Spinner>(RigidRobot::inSE3("spinner", Body::box(0.3, 0.2, 0.1), space));
    for (const double sign : {1.0, -1.0})
    {
        ompl::RNG::setSeed(1);
        TeamControlSetup setup(teamOf({spinner}), std::make_shared<FclObstacles>(std::vector<PlacedBody>{}, 3));
        ob::ScopedState<> start(setup.getStateSpace()), goal(setup.getStateSpace());
        start = std::vector<double>{-1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0};
        const double s = sign * std::sin(0.75), c = sign * std::cos(0.75);
        goal = std::vector<double>{1.0, 0.5, 0.0, 0.6 * s, 0.0, 0.8 * s, c};
        setup.setStartAndGoalStates(start, goal, 0.5);
        setup.setPlanner(std::make_shared<oc::RRT>(setup.getSpaceInformation()));
        ASSERT_EQ(setup.solve(60.0), ob::PlannerStatus::EXACT_SOLUTION);
        setup.simplifySolution();
        EXPECT_TRUE(setup.getSolutionPath().check());
        EXPECT_LT(distanceToGoal(setup), 1e-3);
        EXPECT_LT(setup.getSolutionPath().length(), 4.5);
    }
}

TEST_F(ControlPathSimplifierTest, TakesDurationsThatAreWholeStepsAlone)
{
    ompl::RNG::setSeed(1);
    const auto setup = crossing(allKinds()[0], {});
    setup->setup();
    ob::ScopedState<> state(setup->getStateSpace());
    state = std::vector<double>{-1.5, 0.0};
    oc::Control *control = setup->getSpaceInformation()->allocControl();
    auto *values = control->as<oc::RealVectorControlSpace::ControlType>()->values;
    values[0] = 0.25;
    values[1] = 0.0;
    for (const double last : {0.0, 0.2, 0.14})
    {
        oc::PathControl path(setup->getSpaceInformation());
        path.append(state.get(), control, 0.0);
        path.append(state.get(), control, 1.0);
        setup->getSpaceInformation()->propagate(state.get(), control, 10, state.get());
        path.append(state.get(), control, last);
        path.append(state.get());
        state[0] = -1.5;
        ControlPathSimplifier simplifier(setup->getSpaceInformation());
        const auto simplify = [&] { simplifier.simplify(path, ob::plannerNonTerminatingCondition()); };
        if (last == 0.14)
            EXPECT_EQ(messageOf(simplify),
                      "ControlPathSimplifier: needs controls that are held for whole steps of 0.100000 s");
        else
        {
            simplify();
            EXPECT_LE(path.length(), 0.5 * (1.0 + last) + 0.11);
        }
    }
    setup->getSpaceInformation()->freeControl(control);
}

/** A path that is shorter, but ends beside the goal, is no plan any more. */
TEST_F(ControlPathSimplifierTest, KeepsAPathThatNoOtherReplacesAtItsGoal)
{
    for (const std::size_t kind : {1U, 2U, 4U})
    {
        ompl::RNG::setSeed(1);
        const auto setup = crossing(allKinds()[kind], {});
        ASSERT_EQ(setup->solve(60.0), ob::PlannerStatus::EXACT_SOLUTION);
        oc::PathControl &path = setup->getSolutionPath();
        const auto goal = std::make_shared<ExactGoal>(setup->getSpaceInformation(), path.getStates().back());
        ControlPathSimplifier(setup->getSpaceInformation(), goal).simplify(path, ob::plannerNonTerminatingCondition());
        EXPECT_TRUE(goal->isSatisfied(path.getStates().back())) << allKinds()[kind]->getName();
    }
}

TEST_F(ControlPathSimplifierTest, EndsAtTheNearestOfSeveralGoals)
{
    ompl::RNG::setSeed(1);
    const auto setup = crossing(allKinds()[0], {});
    const auto goals = std::make_shared<ob::GoalStates>(setup->getSpaceInformation());
    ob::ScopedState<> state(setup->getStateSpace());
    for (const double y : {-1.0, 1.0, 0.0})
    {
        state = std::vector<double>{1.5, y};
        goals->addState(state);
    }
    goals->setThreshold(0.3);
    setup->setGoal(goals);
    ASSERT_EQ(setup->solve(60.0), ob::PlannerStatus::EXACT_SOLUTION);
    setup->simplifySolution();
    EXPECT_LT(goals->distanceGoal(setup->getSolutionPath().getStates().back()), 1e-3);

    // Not at the first, but at the one where the path ended
    oc::PathControl path = setup->getSolutionPath();
    const auto ends = std::make_shared<ob::GoalStates>(setup->getSpaceInformation());
    state = std::vector<double>{0.0, 0.0};
    ends->addState(state);
    ob::ScopedState<> end(setup->getStateSpace(), path.getStates().back());
    end[0] -= 0.05;
    ends->addState(end);
    ControlPathSimplifier(setup->getSpaceInformation(), ends).simplify(path, ob::plannerNonTerminatingCondition());
    EXPECT_LT(end.distance(path.getStates().back()), 1e-3);
}

TEST_F(ControlPathSimplifierTest, KeepsTheEndOfAPathToOtherGoals)
{
    ompl::RNG::setSeed(1);
    const auto setup = crossing(allKinds()[2], {});
    setup->setPlanner(std::make_shared<oc::RRT>(setup->getSpaceInformation()));
    ASSERT_EQ(setup->solve(60.0), ob::PlannerStatus::EXACT_SOLUTION);
    oc::PathControl path = setup->getSolutionPath();
    ob::ScopedState<> end(setup->getStateSpace(), path.getStates().back());
    const double before = path.length();
    ControlPathSimplifier simplifier(setup->getSpaceInformation());
    EXPECT_TRUE(simplifier.simplify(path, ob::plannerNonTerminatingCondition()));
    EXPECT_LT(path.length(), before);
    EXPECT_LT(end.distance(path.getStates().back()), 1e-3);

    // No time, no change.
    oc::PathControl same = setup->getSolutionPath();
    EXPECT_FALSE(simplifier.simplify(same, ob::PlannerTerminationCondition([] { return true; })));
    EXPECT_EQ(numbersOf(same), numbersOf(setup->getSolutionPath()));
}

/** A robot that is at its goal from the start, in the way of nobody, stays there. */
TEST_F(ControlPathSimplifierTest, LetsARobotStandAtItsGoal)
{
    ompl::RNG::setSeed(1);
    const auto space = within({2.0, 2.0});
    std::vector<std::shared_ptr<const DynamicRobot>> robots;
    for (const char *name : {"mover", "watcher"})
        robots.push_back(
            Integrator::secondOrder(RigidRobot::disc(name, 0.15, space), within({0.5, 0.5}), within({2, 2})));
    TeamControlSetup setup(teamOf(robots), boxes({}));
    ob::ScopedState<> start(setup.getStateSpace()), goal(setup.getStateSpace());
    start = std::vector<double>{-1.0, 0, 0, 0, 0, 1.0, 0, 0};
    goal = std::vector<double>{1.0, 0, 0, 0, 0, 1.0, 0, 0};
    setup.setStartAndGoalStates(start, goal, 0.4);
    setup.setPlanner(std::make_shared<PrioritizedRRT>(setup.getSpaceInformation()));
    ASSERT_EQ(setup.solve(60.0), ob::PlannerStatus::EXACT_SOLUTION);
    setup.simplifySolution();
    EXPECT_TRUE(setup.getSolutionPath().check());
    EXPECT_LT(distanceToGoal(setup), 1e-3);
    EXPECT_LT(setup.getSolutionPath().length(), 4.6);
}

/** Each would be there soonest straight through the other one. */
TEST_F(ControlPathSimplifierTest, LetsRobotsGiveWay)
{
    const auto space = within({2.0, 2.0});
    std::vector<std::shared_ptr<const DynamicRobot>> robots;
    for (const char *name : {"left", "right"})
        robots.push_back(Integrator::firstOrder(RigidRobot::disc(name, 0.3, space), within({0.5, 0.5})));
    for (std::uint_fast32_t seed = 1; seed <= scaled(3); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        ompl::RNG::setSeed(seed);
        TeamControlSetup setup(teamOf(robots), boxes({}));
        ob::ScopedState<> start(setup.getStateSpace()), goal(setup.getStateSpace());
        start = std::vector<double>{-1.5, 0.0, 1.5, 0.0};
        goal = std::vector<double>{1.5, 0.0, -1.5, 0.0};
        setup.setStartAndGoalStates(start, goal, 0.4);
        setup.setPlanner(std::make_shared<PrioritizedRRT>(setup.getSpaceInformation()));
        ASSERT_EQ(setup.solve(60.0), ob::PlannerStatus::EXACT_SOLUTION);
        const double before = setup.getSolutionPath().length();
        setup.simplifySolution();
        EXPECT_TRUE(setup.getSolutionPath().check());
        EXPECT_LT(setup.getSolutionPath().length(), before);
        EXPECT_LT(setup.getSolutionPath().length(), 7.0);
    }
}

TEST_F(ControlPathSimplifierTest, RefusesWhatItCannotUse)
{
    const auto setup = swapping(Method::STANDARD, CertificateMotionValidator::DISCRETE);
    setup->setStateValidityChecker([](const ob::State *) { return true; });
    EXPECT_EQ(messageOf([&] { ControlPathSimplifier simplifier(setup->getSpaceInformation()); }),
              "ControlPathSimplifier: needs a LimitedValidityChecker or a TeamValidityChecker");
    setup->setStatePropagator([](const ob::State *, const oc::Control *, double, ob::State *) {});
    EXPECT_EQ(messageOf([&] { ControlPathSimplifier simplifier(setup->getSpaceInformation()); }),
              "ControlPathSimplifier: needs a TeamPropagator");
    EXPECT_EQ(messageOf([&] { ControlPathSimplifier simplifier(nullptr); }),
              "ControlPathSimplifier: needs space information");

    // A robot that holds something, as its checker alone knows
    const auto space = within({2.0, 2.0});
    TeamControlSetup holding(teamOf({Integrator::firstOrder(RigidRobot::disc("disc", 0.1, space), within({1, 1}))}),
                             boxes({}));
    const auto &si = holding.getSpaceInformation();
    EXPECT_EQ(messageOf([&] { ControlPathSimplifier simplifier(si); }),
              "ControlPathSimplifier: needs space information that is set up");
    si->setup();
    EXPECT_EQ(messageOf([&] { ControlPathSimplifier simplifier(si); }), "");
    si->setStateValidityChecker(std::make_shared<TeamValidityChecker>(
        si, boxes({}), std::vector<RobotPtr>{RigidRobot::disc("disc", 0.3, space)}));
    EXPECT_EQ(messageOf([&] { ControlPathSimplifier simplifier(si); }),
              "ControlPathSimplifier: needs a validity checker for the robots of its space");
}
