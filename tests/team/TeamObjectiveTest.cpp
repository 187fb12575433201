#include "support/Teams.h"

#include "ompl_certificates/team/TeamObjective.h"

#include <gtest/gtest.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/goals/GoalLazySamples.h>
#include <ompl/base/goals/GoalState.h>
#include <ompl/base/goals/GoalStates.h>
#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/util/Exception.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;
namespace ob = ompl::base;

namespace
{
    ob::ScopedState<> stateOf(const ob::StateSpacePtr &space, const std::vector<double> &reals)
    {
        ob::ScopedState<> state(space);
        state = reals;
        return state;
    }
}

TEST(TeamObjective, AddsUpWhatRobotsDoAtTheirSpeeds)
{
    const auto team = teamOfDiscs();
    const auto si = std::make_shared<ob::SpaceInformation>(team);
    // Lengths 3, 4 and 0; the last robot is at its goal already.
    const auto from = stateOf(team, {0.0, 0.0, 1.0, 0.0, 2.0, 2.0}), to = stateOf(team, {3.0, 0.0, 1.0, 4.0, 2.0, 2.0});
    const auto cost = [&](const std::string &name)
    { return makeObjective(name, si, to)->motionCost(from.get(), to.get()).value(); };
    EXPECT_DOUBLE_EQ(cost("length"), 5.0);
    EXPECT_DOUBLE_EQ(cost("sum"), 7.0);
    EXPECT_DOUBLE_EQ(cost("makespan"), 4.0);
    EXPECT_DOUBLE_EQ(cost("arrival"), 8.0);
    // A robot that stays away from its goal is on its way.
    const auto elsewhere = stateOf(team, {3.0, 0.0, 1.0, 4.0, -2.0, 2.0});
    EXPECT_DOUBLE_EQ(makeObjective("arrival", si, elsewhere)->motionCost(from.get(), to.get()).value(), 12.0);

    // These take 6, 1 and 0. Lengths stay.
    team->setSpeed(0, 0.5);
    team->setSpeed(1, 4.0);
    EXPECT_DOUBLE_EQ(cost("length"), 5.0);
    EXPECT_DOUBLE_EQ(cost("sum"), 7.0);
    EXPECT_DOUBLE_EQ(cost("makespan"), 6.0);
    EXPECT_DOUBLE_EQ(cost("arrival"), 12.0);
}

TEST(TeamObjective, TakesNoRobotApart)
{
    const auto space = std::make_shared<ob::SE2StateSpace>();
    space->setBounds(cubeBounds(2, 5.0));
    const auto si = std::make_shared<ob::SpaceInformation>(space);
    EXPECT_THROW(TeamObjective(si, TeamObjective::MAKESPAN), ompl::Exception);
    const auto two = std::make_shared<ob::CompoundStateSpace>();
    two->addSubspace(space, 1.0);
    two->addSubspace(space, 1.0);
    EXPECT_NO_THROW(TeamObjective(std::make_shared<ob::SpaceInformation>(two), TeamObjective::MAKESPAN));
}

TEST(TeamObjective, KnowsALowerBoundToTheNearestGoal)
{
    const auto team = teamOfDiscs();
    const auto si = std::make_shared<ob::SpaceInformation>(team);
    const auto from = stateOf(team, {0.0, 0.0, 0.0, 0.0, 0.0, 0.0}),
               near = stateOf(team, {1.0, 0.0, 0.0, 2.0, 0.0, 0.0}),
               far = stateOf(team, {4.0, 0.0, 0.0, 2.0, 0.0, 0.0});
    ob::GoalState one(si);
    one.setState(far.get());
    ob::GoalStates both(si);
    both.addState(far.get());
    both.addState(near.get());
    ob::GoalLazySamples growing(
        si, [](const ob::GoalLazySamples *, ob::State *) { return false; }, false);
    growing.addState(near.get());
    const std::tuple<const char *, double, double> expected[] = {
        {"sum", 6.0, 3.0}, {"makespan", 4.0, 2.0}, {"arrival", 6.0, 3.0}};
    for (const auto &[name, toOne, toBoth] : expected)
    {
        SCOPED_TRACE(name);
        const auto objective = makeObjective(name, si, far);
        EXPECT_DOUBLE_EQ(objective->costToGo(from.get(), &one).value(), toOne);
        EXPECT_DOUBLE_EQ(objective->costToGo(from.get(), &both).value(), toBoth);
        EXPECT_DOUBLE_EQ(objective->costToGo(from.get(), &growing).value(), 0.0);
        EXPECT_DOUBLE_EQ(objective->costToGo(from.get(), nullptr).value(), 0.0);
    }
}

TEST(TeamObjective, KnowsNoBoundToAGoalThatIsReachedFromAfar)
{
    const auto team = teamOfDiscs();
    const auto si = std::make_shared<ob::SpaceInformation>(team);
    const auto from = stateOf(team, {0.0, 0.0, 0.0, 0.0, 0.0, 0.0}), to = stateOf(team, {2.0, 0.0, 0.0, 0.0, 0.0, 0.0});
    ob::GoalState goal(si);
    goal.setState(to.get());
    goal.setThreshold(1.0);
    for (const char *name : {"sum", "makespan", "arrival"})
        EXPECT_LE(makeObjective(name, si, to)->costToGo(from.get(), &goal).value(), 1.0) << name;
}

TEST(TeamObjective, HeuristicsAreLowerBoundsOfDetours)
{
    const auto team = mixedTeam();
    team->setSpeed(1, 0.3);
    team->setSpeed(2, 7.0);
    const auto si = std::make_shared<ob::SpaceInformation>(team);
    const auto sampler = team->allocStateSampler();
    ob::ScopedState<> from(team), between(team), to(team);
    for (unsigned int i = 0; i < scaled(1000); ++i)
    {
        for (ob::ScopedState<> *state : {&from, &between, &to})
            sampler->sampleUniform(state->get());
        for (const std::string &name : objectiveNames())
        {
            const auto objective = makeObjective(name, si, to);
            const double detour = objective->motionCost(from.get(), between.get()).value() +
                                  objective->motionCost(between.get(), to.get()).value();
            EXPECT_LE(objective->motionCostHeuristic(from.get(), to.get()).value(), detour * (1.0 + 1e-12)) << name;
        }
    }
}

TEST(TeamObjective, RefusesWhatItCannotMeasure)
{
    const ob::StateSpacePtr team = teamOfDiscs();
    const auto si = std::make_shared<ob::SpaceInformation>(team);
    EXPECT_THROW(TeamObjective(si, TeamObjective::SUM_OF_ARRIVAL_TIMES), ompl::Exception);
    EXPECT_THROW(makeObjective("best", si, ob::ScopedState<>(team)), ompl::Exception);
    const auto plain = std::make_shared<ob::SpaceInformation>(std::make_shared<ob::RealVectorStateSpace>(2));
    EXPECT_THROW(TeamObjective(plain, TeamObjective::MAKESPAN), ompl::Exception);
}
