#include "DynamicProblems.h"

#include "support/IterationLimit.h"
#include "support/Message.h"
#include "support/Quiet.h"
#include "support/Random.h"

#include "ompl_certificates/control/PrioritizedRRT.h"
#include "ompl_certificates/control/ProvePath.h"

#include <cmath>
#include <gtest/gtest.h>
#include <ompl/base/PlannerData.h>
#include <ompl/base/goals/GoalStates.h>
#include <ompl/control/PlannerData.h>
#include <ompl/base/goals/GoalState.h>
#include <ompl/util/Exception.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;
namespace ob = ompl::base;
namespace oc = ompl::control;

namespace
{
    class PrioritizedRRTTest : public testing::Test
    {
        const Quiet quiet_;
    };
}

TEST_F(PrioritizedRRTTest, LetsATeamChangePlacesAndComeToRest)
{
    for (std::uint_fast32_t seed = 1; seed <= scaled(3); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        ompl::RNG::setSeed(seed);
        const auto setup = swapping(Method::SHARED_PROJECTION, CertificateMotionValidator::DISCRETE);
        ASSERT_EQ(setup->solve(60.0), ob::PlannerStatus::EXACT_SOLUTION);
        oc::PathControl &path = setup->getSolutionPath();
        EXPECT_TRUE(path.check());
        EXPECT_TRUE(setup->getProblemDefinition()->getGoal()->isSatisfied(path.getStates().back()));
        std::vector<double> end;
        setup->getStateSpace()->copyToReals(end, path.getStates().back());
        for (std::size_t robot = 0; robot < 4; ++robot)
            EXPECT_NEAR(std::hypot(end[4 * robot + 2], end[4 * robot + 3]), 0.0, 1e-9) << "velocity of " << robot;

        ob::PlannerData data(setup->getSpaceInformation());
        setup->getPlanner()->getPlannerData(data);
        EXPECT_EQ(data.numVertices(), path.getStateCount());
        EXPECT_EQ(data.numStartVertices(), 1U);
        EXPECT_EQ(data.numGoalVertices(), 1U);
        oc::PlannerData withControls(setup->getSpaceInformation());
        setup->getPlanner()->getPlannerData(withControls);
        EXPECT_EQ(withControls.numEdges(), path.getControlCount());
        withControls.decoupleFromPlanner();
        EXPECT_TRUE(static_cast<const PrioritizedRRT &>(*setup->getPlanner()).getStuckRobot().empty());
        const auto &si = *setup->getSpaceInformation();
        for (const double duration : path.getControlDurations())
            EXPECT_LE(duration, si.getMaxControlDuration() * si.getPropagationStepSize() * (1.0 + 1e-9));
    }
}

TEST_F(PrioritizedRRTTest, ProvesItsStepsInContinuousMode)
{
    ompl::RNG::setSeed(1);
    const auto setup = swapping(Method::SHARED_PROJECTION, CertificateMotionValidator::CONTINUOUS);
    ASSERT_EQ(setup->solve(60.0), ob::PlannerStatus::EXACT_SOLUTION);
    EXPECT_TRUE(provePath(setup->getSolutionPath(), setup->getTeamChecker()).unproved.empty());
}

TEST_F(PrioritizedRRTTest, FindsTheSamePathUnderAllMethods)
{
    expectSamePathUnderAllMethods([](TeamControlSetup & /*setup*/) {});
}

TEST_F(PrioritizedRRTTest, PlansForOneRobotOfEachKind)
{
    for (const auto &robot : allKinds())
    {
        SCOPED_TRACE(robot->getName());
        ompl::RNG::setSeed(1);
        const auto setup = crossing(robot, {{{0.0, 0.0, 0.3, 2.0}}});
        ASSERT_EQ(setup->solve(60.0), ob::PlannerStatus::EXACT_SOLUTION);
        EXPECT_TRUE(setup->getSolutionPath().check());
    }
}

TEST_F(PrioritizedRRTTest, EndsWithoutAPathWhereThereIsNone)
{
    const auto space = within({2.0, 2.0});
    TeamControlSetup setup(teamOf({Integrator::firstOrder(RigidRobot::disc("disc", 0.2, space), within({0.5, 0.5}))}),
                           boxes({{{0.0, 0.0, 0.2, 4.0}}}));
    ob::ScopedState<> start(setup.getStateSpace()), goal(setup.getStateSpace());
    start = std::vector<double>{-1.0, 0.0};
    goal = std::vector<double>{1.0, 0.0};
    setup.setStartAndGoalStates(start, goal, 0.1);
    auto planner = std::make_shared<PrioritizedRRT>(setup.getSpaceInformation());
    planner->setIterations(200);
    setup.setPlanner(planner);
    ob::IterationTerminationCondition limit(1000);
    EXPECT_EQ(setup.solve(limit), ob::PlannerStatus::TIMEOUT);
    EXPECT_FALSE(setup.haveSolutionPath());
    EXPECT_EQ(planner->getStuckRobot(), "disc");

    start = std::vector<double>{0.0, 0.0};
    setup.setStartAndGoalStates(start, goal, 0.1);
    EXPECT_EQ(setup.solve(1.0), ob::PlannerStatus::INVALID_START);
    EXPECT_EQ(planner->getStuckRobot(), "") << "no robot was tried";
    setup.setStartAndGoalStates(goal, start, 0.1);
    EXPECT_EQ(setup.solve(1.0), ob::PlannerStatus::INVALID_GOAL);
}

TEST_F(PrioritizedRRTTest, KeepsNothingOfItsPathAfterClear)
{
    const auto setup = crossing(allKinds()[0], {});
    ASSERT_EQ(setup->solve(60.0), ob::PlannerStatus::EXACT_SOLUTION);
    setup->getPlanner()->clear();
    ob::PlannerData data(setup->getSpaceInformation());
    setup->getPlanner()->getPlannerData(data);
    EXPECT_EQ(data.numVertices(), 0U);
}

TEST_F(PrioritizedRRTTest, TriesAnotherGoalWithEachOrder)
{
    const auto space = within({2.0, 2.0});
    TeamControlSetup setup(teamOf({Integrator::firstOrder(RigidRobot::disc("disc", 0.2, space), within({0.5, 0.5}))}),
                           boxes({{{0.0, 0.0, 0.2, 4.0}}}));
    ob::ScopedState<> state(setup.getStateSpace());
    state = std::vector<double>{-1.0, 0.0};
    setup.setStartState(state);
    const auto goals = std::make_shared<ob::GoalStates>(setup.getSpaceInformation());
    for (const double x : {1.0, -1.5})
    {
        state = std::vector<double>{x, 1.0};
        goals->addState(state);
    }
    goals->setThreshold(0.1);
    setup.setGoal(goals);
    auto planner = std::make_shared<PrioritizedRRT>(setup.getSpaceInformation());
    planner->setIterations(200);
    setup.setPlanner(planner);
    EXPECT_EQ(setup.solve(60.0), ob::PlannerStatus::EXACT_SOLUTION);
}

TEST_F(PrioritizedRRTTest, RefusesWhatItCannotUse)
{
    const auto setup = swapping(Method::STANDARD, CertificateMotionValidator::DISCRETE);
    PrioritizedRRT planner(setup->getSpaceInformation());
    EXPECT_EQ(messageOf([&] { planner.setGoalBias(1.5); }),
              "PrioritizedRRT: goal_bias must be from 0 to 1, not 1.500000");
    EXPECT_EQ(messageOf([&] { planner.setIterations(0); }), "PrioritizedRRT: iterations must be positive, not 0");
    EXPECT_TRUE(planner.params().setParam("goal_bias", "0.3"));
    EXPECT_EQ(planner.getGoalBias(), 0.3);

    const auto foreign = swapping(Method::STANDARD, CertificateMotionValidator::DISCRETE);
    foreign->setStateValidityChecker([](const ob::State *) { return true; });
    EXPECT_EQ(messageOf([&] { foreign->setup(); }),
              "PrioritizedRRT: needs a LimitedValidityChecker or a TeamValidityChecker");
    const auto other = swapping(Method::STANDARD, CertificateMotionValidator::DISCRETE);
    other->setStatePropagator([](const ob::State *, const oc::Control *, double, ob::State *) {});
    EXPECT_EQ(messageOf([&] { other->setup(); }), "PrioritizedRRT: needs a TeamPropagator");
}

TEST_F(PrioritizedRRTTest, BrakesBringEachKindToRest)
{
    std::mt19937 random(1);
    for (const auto &robot : allKinds())
    {
        SCOPED_TRACE(robot->getName());
        const auto &space = robot->getStateSpace();
        ob::ScopedState<> state(space), next(space);
        std::vector<double> control(robot->getControlNames().size());
        for (std::uint64_t trial = 0; trial < scaled(20); ++trial)
        {
            state.random();
            for (int step = 0; step < 30; ++step)
            {
                robot->computeBrake(state.get(), 0.1, control.data());
                for (std::size_t i = 0; i < control.size(); ++i)
                {
                    EXPECT_GE(control[i], robot->getControlBounds().low[i]);
                    EXPECT_LE(control[i], robot->getControlBounds().high[i]);
                }
                robot->propagate(state.get(), control.data(), 0.1, next.get());
                std::swap(state, next);
            }
            EXPECT_LE(space->distance(state.get(), next.get()), 1e-12);
        }
    }
}

TEST_F(PrioritizedRRTTest, RobotStepsAreProvedAmongThoseAskedForAlone)
{
    const auto setup = swapping(Method::SHARED_PROJECTION, CertificateMotionValidator::CONTINUOUS);
    setup->setup();
    const auto &si = setup->getSpaceInformation();
    const auto &propagator = static_cast<const TeamPropagator &>(*si->getStatePropagator());
    const TeamValidityChecker &checker = *setup->getTeamChecker();
    ob::ScopedState<> state(setup->getStateSpace()), result(setup->getStateSpace());
    // The first and the second robot head for each other, the third one for the box, the fourth one stands.
    state = std::vector<double>{-1.0, 1.0, 0.4, 0, -0.67, 1.0, -0.4, 0, 0, -0.37, 0, 0.4, 1.5, 1.5, 0, 0};
    oc::Control *control = si->allocControl();
    std::fill_n(control->as<oc::RealVectorControlSpace::ControlType>()->values, 8, 0.0);
    const auto isFree = [&](unsigned int robot, const std::vector<unsigned int> &others)
    { return propagator.isRobotStepFree(checker, state.get(), control, 0.1, robot, others); };
    EXPECT_TRUE(isFree(0, {}));
    EXPECT_TRUE(isFree(0, {2, 3}));
    EXPECT_FALSE(isFree(0, {1}));
    EXPECT_FALSE(isFree(1, {3, 0}));
    EXPECT_FALSE(isFree(2, {}));
    EXPECT_TRUE(isFree(3, {0, 1, 2}));
    EXPECT_THROW(isFree(4, {}), ompl::Exception);
    EXPECT_THROW(isFree(0, {4}), ompl::Exception);
    EXPECT_THROW(isFree(0, {0}), ompl::Exception);
    EXPECT_FALSE(propagator.isStepFree(checker, state.get(), control, 0.1, result.get()));
    si->freeControl(control);
}

TEST_F(PrioritizedRRTTest, KeepsItsGoalWhereTheNextOneIsRefused)
{
    // The goal of a is in the way of b, which must go first. Another goal, in a wall, is no reason to give it up.
    ompl::RNG::setSeed(1);
    ob::RealVectorBounds bounds(2);
    bounds.setLow(0.0);
    bounds.setHigh(10.0);
    const auto disc = [&](const std::string &name) {
        return Integrator::firstOrder(RigidRobot::disc(name, 0.4, bounds), within({1.0, 1.0}));
    };
    TeamControlSetup setup(teamOf({disc("a"), disc("b")}), boxes({{5.0, 2.2, 2.0, 4.4}, {5.0, 7.8, 2.0, 4.4}}));
    ob::ScopedState<> start(setup.getStateSpace()), good(setup.getStateSpace()), refused(setup.getStateSpace());
    start = std::vector<double>{2, 8, 2, 2};
    good = std::vector<double>{5, 5, 8, 2};
    refused = std::vector<double>{5, 2, 8, 2};
    setup.addStartState(start);
    const auto goals = std::make_shared<ob::GoalStates>(setup.getSpaceInformation());
    goals->addState(good);
    goals->addState(refused);
    goals->setThreshold(0.6);
    setup.setGoal(goals);
    auto planner = std::make_shared<PrioritizedRRT>(setup.getSpaceInformation());
    planner->setIterations(2000);
    setup.setPlanner(planner);
    EXPECT_EQ(setup.solve(60.0), ob::PlannerStatus::EXACT_SOLUTION);
}
