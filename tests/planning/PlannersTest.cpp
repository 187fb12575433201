#include "ompl_certificates/planning/Planners.h"

#include "support/DecimalCommas.h"
#include "support/ForgivenLeaks.h"

#include "ompl_certificates/obstacles/FclObstacles.h"
#include "ompl_certificates/planning/TeamSetup.h"
#include "ompl_certificates/robots/Arm.h"
#include "ompl_certificates/robots/RigidRobot.h"

#include <array>
#include <functional>
#include <gtest/gtest.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/geometric/planners/rrt/RRT.h>
#include <ompl/util/Exception.h>
#include <ompl/util/String.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;
namespace ob = ompl::base;

namespace
{
    ob::SpaceInformationPtr squareWithoutObstacles()
    {
        auto space = std::make_shared<ob::RealVectorStateSpace>(2);
        space->setBounds(0.0, 1.0);
        auto si = std::make_shared<ob::SpaceInformation>(space);
        si->setStateValidityChecker([](const ob::State * /*state*/) { return true; });
        si->setup();
        return si;
    }

    std::string complaintOf(const std::function<void()> &action)
    {
        try
        {
            action();
        }
        catch (const ompl::Exception &exception)
        {
            return exception.what();
        }
        return "none";
    }
}

TEST(Planners, AreMadeByTheNamesOfTheirClasses)
{
    const auto si = squareWithoutObstacles();
    ASSERT_GT(plannerNames().size(), 30U);
    for (const std::string &name : plannerNames())
    {
        EXPECT_NE(makePlanner(name, si), nullptr) << name;
        EXPECT_NE(plannerDescription(name), "") << name;
    }
}

TEST(Planners, ThatAreNotThereAreToldOf)
{
    const auto si = squareWithoutObstacles();
    EXPECT_EQ(complaintOf([&] { makePlanner("RRT*", si); }), "There is no planner 'RRT*'; did you mean RRTstar?");
    EXPECT_NE(complaintOf([&] { makePlanner("xyz", si); }).find("; the planners are ABITstar, "), std::string::npos);
}

namespace
{
    /** An arm of two joints that turn \e limit to either side, and a sphere */
    TeamStateSpacePtr armAndBall(double limit)
    {
        using Joint = KinematicTree::Joint;
        Joint first, second;
        first.name = "first";
        first.type = KinematicTree::JointType::REVOLUTE;
        first.lower = -limit;
        first.upper = limit;
        second = first;
        second.name = "second";
        second.origin.translation().x() = 1.0;
        KinematicTree tree("base");
        tree.addLink("base", first, "upper", Body::sphere(0.1));
        tree.addLink("upper", second, "lower", Body::sphere(0.1));
        ob::RealVectorBounds bounds(3);
        bounds.setLow(-1.0);
        bounds.setHigh(1.0);
        auto team = std::make_shared<TeamStateSpace>();
        team->addRobot(std::make_shared<Arm>("arm", tree, std::vector<std::string>{"first", "second"}));
        team->addRobot(RigidRobot::sphere("ball", 0.1, bounds));
        return team;
    }

    double rangeOf(const ob::Planner &planner)
    {
        std::string range;
        EXPECT_TRUE(planner.params().getParam("range", range));
        return ompl::stod(range);
    }
}

TEST(Planners, StepAsTheTeamSaysIfThereAreArmsAndNoOtherRangeIsGiven)
{
    const auto team = armAndBall(6.0);
    // An eighth of the arm's extent, a fifth of the ball's
    const double range = std::hypot(0.125 * std::sqrt(2.0) * M_PI, 0.2 * std::sqrt(3.0) * 2.0);
    EXPECT_NEAR(team->getPlannerRange(), range, 1e-12);
    const auto noObstacles = std::make_shared<FclObstacles>(std::vector<PlacedBody>{}, 3);
    TeamSetup setup(team, noObstacles);
    for (const char *name : {"RRT", "RRTConnect", "RRTstar", "EST", "KPIECE1"})
        EXPECT_NEAR(rangeOf(*makePlanner(name, setup.getSpaceInformation())), range, 1e-5) << name;

    // Planners that a program makes itself, too, and those that it allocates
    ob::ScopedState<> start(team), goal(team);
    start = std::vector<double>{0.0, 0.0, 0.9, 0.9, 0.9};
    goal = std::vector<double>{0.0, 0.5, -0.9, 0.9, 0.9};
    setup.setStartAndGoalStates(start, goal);
    const auto rrt = std::make_shared<ompl::geometric::RRT>(setup.getSpaceInformation());
    setup.setPlanner(rrt);
    setup.setup();
    EXPECT_DOUBLE_EQ(rrt->getRange(), range);
    const auto given = std::make_shared<ompl::geometric::RRT>(setup.getSpaceInformation());
    given->setRange(0.3);
    setup.setPlanner(given);
    setup.setup();
    EXPECT_EQ(given->getRange(), 0.3);
    TeamSetup allocating(team, noObstacles);
    allocating.setStartAndGoalStates(start, goal);
    allocating.setPlannerAllocator([](const ob::SpaceInformationPtr &si)
                                   { return std::make_shared<ompl::geometric::RRT>(si); });
    allocating.setup();
    EXPECT_NEAR(rangeOf(*allocating.getPlanner()), range, 1e-5);

    // Teams without arms leave it to OMPL.
    auto balls = std::make_shared<TeamStateSpace>();
    balls->addRobot(team->getRobots()[1]);
    TeamSetup plain(balls, noObstacles);
    EXPECT_EQ(rangeOf(*makePlanner("RRT", plain.getSpaceInformation())), 0.0);
}

TEST(Planners, TakeTheirOwnParametersAndNoOthers)
{
    const auto planner = makePlanner("RRT", squareWithoutObstacles());
    setParameter(*planner, "range", "0.25");
    std::string range;
    EXPECT_TRUE(planner->params().getParam("range", range));
    EXPECT_EQ(ompl::stod(range), 0.25);
    EXPECT_NE(complaintOf([&] { setParameter(*planner, "gaol_bias", "0.1"); }).find("did you mean goal_bias?"),
              std::string::npos);
    EXPECT_EQ(
        complaintOf([&] { setParameter(*planner, "range", "far"); }).find("RRT refuses 'far' as its parameter 'range'"),
        0U);
}

TEST(Planners, TakeNumbersInAnyLocale)
{
    const DecimalCommas commas;
    const auto planner = makePlanner("RRT", squareWithoutObstacles());
    setParameter(*planner, "range", "0.250");
    EXPECT_EQ(rangeOf(*planner), 0.25);
    const auto star = makePlanner("RRTstar", squareWithoutObstacles());
    EXPECT_NE(complaintOf([&] { setParameter(*star, "rewire_factor", "-1.5"); }).find("must "), std::string::npos);

    const auto team = armAndBall(6.0);
    TeamSetup setup(team, std::make_shared<FclObstacles>(std::vector<PlacedBody>{}, 3));
    const auto given = makePlanner("RRT", setup.getSpaceInformation());
    EXPECT_NEAR(rangeOf(*given), team->getPlannerRange(), 1e-5);
    setParameter(*given, "range", "0.3");
    configureRange(*given);
    EXPECT_EQ(rangeOf(*given), 0.3);
}

// Some of OMPL's planners would crash, or never end.
TEST(Planners, RefuseNumbersThatMakeNoSense)
{
    const auto si = squareWithoutObstacles();
    const std::vector<std::array<std::string, 4>> cases{{"STRIDE", "degree", "0", "positive"},
                                                        {"pRRT", "thread_count", "0", "positive"},
                                                        {"AnytimePathShortening", "num_planners", "0", "positive"},
                                                        {"RRT", "goal_bias", "2", "at most 1"},
                                                        {"AITstar", "samples_per_batch", "0", "positive"},
                                                        {"SORRTstar", "ordering_batch_size", "0", "positive"},
                                                        {"SPARStwo", "stretch_factor", "-1", "positive"},
                                                        {"SPARStwo", "dense_delta_fraction", "-1", "negative"},
                                                        {"RRTXstatic", "epsilon", "-1e-3", "negative"},
                                                        {"RRT", "range", "-0.5", "negative"}};
    for (const auto &[name, key, value, why] : cases)
    {
        const auto planner = makePlanner(name, si);
        const std::string complaint = complaintOf([&, k = key, v = value] { setParameter(*planner, k, v); });
        EXPECT_EQ(complaint.find(planner->getName() + " refuses '" + value + "' as its parameter '" + key + "': must "),
                  0U)
            << complaint;
        EXPECT_NE(complaint.find(why), std::string::npos) << complaint;
    }
    EXPECT_NO_THROW(setParameter(*makePlanner("SPARStwo", si), "stretch_factor", "1.05"));
    EXPECT_NO_THROW(setParameter(*makePlanner("RRT", si), "range", "0"));
    // OMPL tells parameters with six digits.
    for (const char *const value : {"2.616895871065565", "1.4219548", "0.18098541408979257", "0.0000014"})
        EXPECT_NO_THROW(setParameter(*makePlanner("RRT", si), "range", value)) << value;
}

TEST(Planners, CallTheHooksAroundSolve)
{
    const auto si = squareWithoutObstacles();
    bool stopped = false, after = false;
    const auto planner = makePlanner("RRTstar", si, {[&] { return stopped = true; }, [&] { after = true; }});
    auto problem = std::make_shared<ob::ProblemDefinition>(si);
    ob::ScopedState<> start(si), goal(si);
    start = std::vector<double>{0.1, 0.1};
    goal = std::vector<double>{0.9, 0.9};
    problem->setStartAndGoalStates(start, goal);
    planner->setProblemDefinition(problem);
    planner->setup();
    // Endless, but for the hook
    planner->solve(ob::plannerNonTerminatingCondition());
    EXPECT_TRUE(stopped);
    EXPECT_TRUE(after);
}

// RRTConnect's plan would come back to where it began, and RRTstar would find none.
TEST(Planners, StayWhereTheStartIsTheGoal)
{
    const auto si = squareWithoutObstacles();
    for (const std::string &name : plannerNames())
    {
        if (name == "DRRTstar")
            continue;  // It is for teams alone.
        SCOPED_TRACE(name);
        bool after = false;
        const auto planner = makePlanner(name, si, {{}, [&] { after = true; }});
        auto problem = std::make_shared<ob::ProblemDefinition>(si);
        const auto objective = std::make_shared<ob::PathLengthOptimizationObjective>(si);
        problem->setOptimizationObjective(objective);
        ob::ScopedState<> start(si);
        start = std::vector<double>{0.1, 0.1};
        problem->setStartAndGoalStates(start, start);
        planner->setProblemDefinition(problem);
        planner->setup();
        EXPECT_EQ(planner->solve(ob::plannerNonTerminatingCondition()), ob::PlannerStatus::EXACT_SOLUTION);
        ASSERT_TRUE(problem->getSolutionPath());
        EXPECT_EQ(problem->getSolutionPath()->length(), 0.0);
        EXPECT_FALSE(problem->hasApproximateSolution());
        EXPECT_TRUE(after);
    }
}

// Where the start is invalid, the goal there is no plan.
TEST(Planners, DoNotStayWhereTheStartIsInvalid)
{
    const auto si = squareWithoutObstacles();
    si->setStateValidityChecker([](const ob::State *) { return false; });
    si->setup();
    const auto planner = makePlanner("RRTConnect", si);
    auto problem = std::make_shared<ob::ProblemDefinition>(si);
    ob::ScopedState<> start(si);
    start = std::vector<double>{0.1, 0.1};
    problem->setStartAndGoalStates(start, start);
    planner->setProblemDefinition(problem);
    planner->setup();
    EXPECT_EQ(planner->solve(0.1), ob::PlannerStatus::INVALID_START);
    EXPECT_FALSE(problem->hasSolution());
}

// OMPL's own FMT crashes without a valid goal, and LazyLBTRRT once it has a valid start again.
TEST(Planners, EndTidilyWithoutAValidStartOrGoal)
{
    const auto si = squareWithoutObstacles();
    si->setStateValidityChecker([](const ob::State *state)
                                { return (*state->as<ob::RealVectorStateSpace::StateType>())[0] < 0.5; });
    si->setup();
    for (const std::string name : {"FMT", "LazyLBTRRT"})
    {
        SCOPED_TRACE(name);
        const ForgivenLeaks forgiven(name == "LazyLBTRRT");
        const auto planner = makePlanner(name, si);
        const auto solve = [&](double from, double to)
        {
            auto problem = std::make_shared<ob::ProblemDefinition>(si);
            ob::ScopedState<> start(si), goal(si);
            start = std::vector<double>{from, 0.1};
            goal = std::vector<double>{to, 0.9};
            problem->setStartAndGoalStates(start, goal);
            planner->clear();
            planner->setProblemDefinition(problem);
            planner->setup();
            return planner->solve(0.3);
        };
        EXPECT_EQ(solve(0.1, 0.9), ob::PlannerStatus::INVALID_GOAL);
        EXPECT_EQ(solve(0.9, 0.1), ob::PlannerStatus::INVALID_START);
        EXPECT_EQ(solve(0.1, 0.4), ob::PlannerStatus::EXACT_SOLUTION);
    }
}

// OMPL's own goes on sampling for ever.
TEST(Planners, AITstarEndsWithTheStraightWay)
{
    const auto si = squareWithoutObstacles();
    for (const double x : {0.9, 0.1})
    {
        const auto planner = makePlanner("AITstar", si);
        auto problem = std::make_shared<ob::ProblemDefinition>(si);
        const auto objective = std::make_shared<ob::PathLengthOptimizationObjective>(si);
        problem->setOptimizationObjective(objective);
        ob::ScopedState<> start(si), goal(si);
        start = std::vector<double>{0.1, 0.1};
        goal = std::vector<double>{x, 0.1};
        problem->setStartAndGoalStates(start, goal);
        planner->setProblemDefinition(problem);
        planner->setup();
        EXPECT_EQ(planner->solve(0.2), ob::PlannerStatus::EXACT_SOLUTION);
        EXPECT_NEAR(problem->getSolutionPath()->length(), x - 0.1, 1e-9);
        EXPECT_EQ(objective->getCostThreshold().value(), 0.0);
    }
}
