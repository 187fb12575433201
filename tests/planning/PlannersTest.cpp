#include "ompl_certificates/planning/Planners.h"

#include <functional>
#include <gtest/gtest.h>
#include <ompl/base/SpaceInformation.h>
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
