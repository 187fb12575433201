#include "ompl_certificates/planning/Planners.h"

#include <array>
#include <functional>
#include <gtest/gtest.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/util/Exception.h>

using namespace ompl_certificates;
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

TEST(Planners, TakeTheirOwnParametersAndNoOthers)
{
    const auto planner = makePlanner("RRT", squareWithoutObstacles());
    setParameter(*planner, "range", "0.25");
    std::string range;
    EXPECT_TRUE(planner->params().getParam("range", range));
    EXPECT_EQ(std::stod(range), 0.25);
    EXPECT_NE(complaintOf([&] { setParameter(*planner, "gaol_bias", "0.1"); }).find("did you mean goal_bias?"),
              std::string::npos);
    EXPECT_EQ(
        complaintOf([&] { setParameter(*planner, "range", "far"); }).find("RRT refuses 'far' as its parameter 'range'"),
        0U);
}

// Some of OMPL's planners would crash, or never end.
TEST(Planners, RefuseNumbersThatAreTooSmall)
{
    const auto si = squareWithoutObstacles();
    const std::vector<std::array<std::string, 4>> cases{{"STRIDE", "degree", "0", "positive"},
                                                        {"pRRT", "thread_count", "0", "positive"},
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
        EXPECT_EQ(complaint.find(name + " refuses '" + value + "' as its parameter '" + key + "': must "), 0U)
            << complaint;
        EXPECT_NE(complaint.find(why), std::string::npos) << complaint;
    }
    EXPECT_NO_THROW(setParameter(*makePlanner("SPARStwo", si), "stretch_factor", "1.05"));
    EXPECT_NO_THROW(setParameter(*makePlanner("RRT", si), "range", "0"));
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
