#include "support/CrowdProblem.h"
#include "support/IterationLimit.h"
#include "support/Quiet.h"

#include "ompl_certificates/planning/DRRTstar.h"
#include "ompl_certificates/planning/TeamPathSimplifier.h"
#include "ompl_certificates/team/PathTimes.h"
#include "ompl_certificates/team/TeamObjective.h"
#include "ompl_certificates/team/TeamPathLength.h"

#include <gtest/gtest.h>
#include <ompl/base/goals/GoalState.h>
#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/util/RandomNumbers.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;
namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace
{
    class TeamPathSimplifierTest : public testing::Test
    {
        const Quiet quiet_;
    };

    ob::OptimizationObjectivePtr objectiveOf(const TeamSetup &setup, const std::string &name)
    {
        ob::ScopedState<> goal(setup.getStateSpace());
        goal = setup.getGoal()->as<ob::GoalState>()->getState();
        return makeObjective(name, setup.getSpaceInformation(), goal);
    }
}

TEST_F(TeamPathSimplifierTest, LowersEveryCostAndKeepsPathsValid)
{
    for (std::uint64_t seed = 1; seed <= scaled(10); ++seed)
        for (const std::string &name : objectiveNames())
        {
            SCOPED_TRACE("seed " + std::to_string(seed) + ", " + name);
            ompl::RNG::setSeed(static_cast<std::uint_fast32_t>(seed));
            const auto setup = crowd(seed, 4, 4.0, 5);
            setup->setPlanner(std::make_shared<og::RRTConnect>(setup->getSpaceInformation()));
            ASSERT_EQ(setup->solve(20.0), ob::PlannerStatus::EXACT_SOLUTION);
            const auto objective = objectiveOf(*setup, name);
            og::PathGeometric path = setup->getSolutionPath();
            const double before = path.cost(objective).value();
            TeamPathSimplifier simplifier(setup->getSpaceInformation(), objective);
            EXPECT_TRUE(simplifier.simplify(path, 300, ob::plannerNonTerminatingCondition()));
            EXPECT_LT(path.cost(objective).value(), before);
            EXPECT_TRUE(path.check());
            const auto &space = setup->getStateSpace();
            for (std::size_t i = 1; i < path.getStateCount(); ++i)
                EXPECT_GT(motionTime(*space, path.getStates()[i - 1], path.getStates()[i]), 0.0) << i;
            og::PathGeometric &old = setup->getSolutionPath();
            EXPECT_TRUE(space->equalStates(path.getState(0), old.getState(0)));
            EXPECT_TRUE(space->equalStates(path.getStates().back(), old.getStates().back()));
        }
}

TEST_F(TeamPathSimplifierTest, LeavesNoStatesThatRepeatButForRounding)
{
    for (std::uint64_t seed = 1; seed <= scaled(5); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        ompl::RNG::setSeed(static_cast<std::uint_fast32_t>(seed));
        const auto setup = crowd(seed, 4, 4.0, 5);
        setup->setPlanner(std::make_shared<og::RRTConnect>(setup->getSpaceInformation()));
        ASSERT_EQ(setup->solve(20.0), ob::PlannerStatus::EXACT_SOLUTION);
        const auto &space = setup->getStateSpace();
        og::PathGeometric &found = setup->getSolutionPath();
        og::PathGeometric path(setup->getSpaceInformation());
        ob::ScopedState<> almost(space);
        for (std::size_t i = 0; i + 1 < found.getStateCount(); ++i)
        {
            path.append(found.getStates()[i]);
            space->interpolate(found.getStates()[i], found.getStates()[i + 1], 1e-13, almost.get());
            path.append(almost.get());
        }
        path.append(found.getStates().back());
        TeamPathSimplifier simplifier(setup->getSpaceInformation(), objectiveOf(*setup, "arrival"));
        ASSERT_TRUE(simplifier.simplify(path, 20, ob::plannerNonTerminatingCondition()));
        EXPECT_TRUE(path.check());
        EXPECT_TRUE(space->equalStates(path.getState(0), found.getState(0)));
        EXPECT_TRUE(space->equalStates(path.getStates().back(), found.getStates().back()));
        for (std::size_t i = 1; i < path.getStateCount(); ++i)
            EXPECT_GT(motionTime(*space, path.getStates()[i - 1], path.getStates()[i]), 1e-10) << i;
    }
}

namespace
{
    /** Refuses motions from a state that lead away from it at once, as if there were only one way out. */
    class OneWayOut : public ob::MotionValidator
    {
    public:
        OneWayOut(const ob::SpaceInformationPtr &si, const ob::State *start)
          : MotionValidator(si), validator_(si->getMotionValidator()), start_(start)
        {
        }

        bool checkMotion(const ob::State *from, const ob::State *to) const override
        {
            const bool leaves = si_->equalStates(from, start_) && si_->distance(from, to) > 1e-6;
            return !leaves && validator_->checkMotion(from, to);
        }

        bool checkMotion(const ob::State *from, const ob::State *to,
                         std::pair<ob::State *, double> &lastValid) const override
        {
            return checkMotion(from, to) || validator_->checkMotion(from, to, lastValid);
        }

    private:
        ob::MotionValidatorPtr validator_;
        const ob::State *start_;
    };
}

TEST_F(TeamPathSimplifierTest, LeavesStatesThatRepeatWhereThePathNeedsThem)
{
    for (std::uint64_t seed = 1; seed <= 3; ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        ompl::RNG::setSeed(static_cast<std::uint_fast32_t>(seed));
        const auto setup = crowd(seed, 4, 4.0, 5);
        setup->setPlanner(std::make_shared<og::RRTConnect>(setup->getSpaceInformation()));
        ASSERT_EQ(setup->solve(20.0), ob::PlannerStatus::EXACT_SOLUTION);
        const ob::SpaceInformationPtr &si = setup->getSpaceInformation();
        const og::PathGeometric &found = setup->getSolutionPath();
        og::PathGeometric path(si, found.getState(0));
        ob::ScopedState<> almost(setup->getStateSpace()), start(setup->getStateSpace());
        start = found.getState(0);
        si->getStateSpace()->interpolate(found.getState(0), found.getState(1), 1e-13, almost.get());
        path.append(almost.get());
        for (unsigned int i = 1; i < found.getStateCount(); ++i)
            path.append(found.getState(i));
        si->setMotionValidator(std::make_shared<OneWayOut>(si, start.get()));
        ASSERT_TRUE(path.check());
        TeamPathSimplifier simplifier(si, objectiveOf(*setup, "length"));
        ASSERT_TRUE(simplifier.simplify(path, 200, ob::plannerNonTerminatingCondition()));
        EXPECT_TRUE(path.check());
        EXPECT_LT(si->distance(path.getState(0), path.getState(1)), 1e-6);
    }
}

TEST_F(TeamPathSimplifierTest, FindsTheStraightWayOfRobotsThatAreFarApart)
{
    auto team = std::make_shared<TeamStateSpace>();
    team->addRobot(RigidRobot::disc("low", 0.2, cubeBounds(2, 5.0)));
    team->addRobot(RigidRobot::disc("high", 0.2, cubeBounds(2, 5.0)));
    TeamSetup setup(team, std::make_shared<FclObstacles>(std::vector<PlacedBody>{}, 2));
    setup.getSpaceInformation()->setup();
    og::PathGeometric path(setup.getSpaceInformation());
    ob::ScopedState<> state(team);
    // One goes around a corner while the other one waits, then the other one does.
    for (const auto &reals : {std::vector<double>{-4.0, -4.0, -4.0, 1.0},
                              {-4.0, -1.0, -4.0, 1.0},
                              {4.0, -1.0, -4.0, 1.0},
                              {4.0, -1.0, -4.0, 4.0},
                              {4.0, -1.0, 4.0, 4.0}})
    {
        state = reals;
        path.append(state.get());
    }
    TeamPathSimplifier simplifier(setup.getSpaceInformation(),
                                  std::make_shared<TeamPathLength>(setup.getSpaceInformation()));
    const og::PathGeometric given = path;
    EXPECT_TRUE(simplifier.simplify(path, ob::plannerNonTerminatingCondition()));
    EXPECT_NEAR(path.length(), std::sqrt(2.0 * (64.0 + 9.0)), 0.02);
    EXPECT_FALSE(simplifier.simplify(path, 0, ob::plannerNonTerminatingCondition()));

    // OMPL's own validity checker and motion validator will do.
    const auto stock = std::make_shared<ob::SpaceInformation>(team);
    stock->setup();
    path = given;
    EXPECT_TRUE(TeamPathSimplifier(stock, std::make_shared<TeamPathLength>(stock))
                    .simplify(path, ob::plannerNonTerminatingCondition()));
    EXPECT_NEAR(path.length(), std::sqrt(2.0 * (64.0 + 9.0)), 0.02);
}

TEST_F(TeamPathSimplifierTest, KeepsRobotsFromWanderingWhereThatCostsNothing)
{
    const auto bounds = cubeBounds(2, 20.0);
    auto team = std::make_shared<TeamStateSpace>();
    for (const std::string name : {"mover", "parked", "idle"})
        team->addRobot(RigidRobot::disc(name, 0.4, bounds));
    TeamSetup setup(team, std::make_shared<FclObstacles>(std::vector<PlacedBody>{}, 2));
    setup.getSpaceInformation()->setup();
    const auto makespan = std::make_shared<TeamObjective>(setup.getSpaceInformation(), TeamObjective::MAKESPAN);
    const auto lengthsOf = [&](og::PathGeometric &path)
    {
        std::vector<double> lengths(3, 0.0);
        for (std::size_t i = 1; i < path.getStateCount(); ++i)
            for (unsigned int robot = 0; robot < 3; ++robot)
                lengths[robot] += team->getSubspace(robot)->distance(
                    path.getStates()[i - 1]->as<ob::CompoundState>()->components[robot],
                    path.getStates()[i]->as<ob::CompoundState>()->components[robot]);
        return lengths;
    };
    og::PathGeometric path(setup.getSpaceInformation());
    ob::ScopedState<> start(team), state(team), goal(team);
    start = std::vector<double>{-9, 0, 0, 5, 0, -5};
    state = std::vector<double>{0, 0, 3, 8, 4, -8};
    goal = std::vector<double>{9, 0, 0, 5, 1, -5};
    for (const auto *each : {&start, &state, &goal})
        path.append(each->get());
    TeamPathSimplifier simplifier(setup.getSpaceInformation(), makespan);
    EXPECT_TRUE(simplifier.simplify(path, 100, ob::plannerNonTerminatingCondition()));
    EXPECT_EQ(path.cost(makespan).value(), 18.0);
    EXPECT_EQ(lengthsOf(path), (std::vector<double>{18.0, 0.0, 1.0}));

    // The planner keeps the shorter one of two paths of one cost. The mover has to pass the parked one here.
    ompl::RNG::setSeed(1);
    start = std::vector<double>{-9, 5, 0, 5, 0, -5};
    goal = std::vector<double>{9, 5, 0, 5, 1, -5};
    setup.setStartAndGoalStates(start, goal);
    setup.setOptimizationObjective(makespan);
    setup.setPlanner(std::make_shared<DRRTstar>(setup.getSpaceInformation()));
    ASSERT_EQ(setup.solve(ob::IterationTerminationCondition(20000)), ob::PlannerStatus::EXACT_SOLUTION);
    const std::vector<double> lengths = lengthsOf(setup.getSolutionPath());
    EXPECT_LT(lengths[1], 4.0);
    EXPECT_LT(lengths[2], 1.2);
}

TEST_F(TeamPathSimplifierTest, LetsEachRobotGoAtItsOwnSpeed)
{
    auto team = std::make_shared<TeamStateSpace>();
    team->addRobot(RigidRobot::disc("slow", 0.2, cubeBounds(2, 5.0)));
    team->addRobot(RigidRobot::disc("fast", 0.2, cubeBounds(2, 5.0)));
    team->setSpeed(0, 0.5);
    team->setSpeed(1, 4.0);
    TeamSetup setup(team, std::make_shared<FclObstacles>(std::vector<PlacedBody>{}, 2));
    setup.getSpaceInformation()->setup();
    og::PathGeometric path(setup.getSpaceInformation());
    ob::ScopedState<> start(team), goal(team);
    start = std::vector<double>{-4.0, -4.0, -4.0, 4.0};
    goal = std::vector<double>{4.0, -4.0, 4.0, 4.0};
    path.append(start.get());
    path.append(goal.get());
    // Side by side both take 8 / 0.5. The fast one can be there after 8 / 4.
    const auto objective = makeObjective("arrival", setup.getSpaceInformation(), goal);
    EXPECT_DOUBLE_EQ(path.cost(objective).value(), 32.0);
    EXPECT_TRUE(TeamPathSimplifier(setup.getSpaceInformation(), objective)
                    .simplify(path, ob::plannerNonTerminatingCondition()));
    EXPECT_NEAR(path.cost(objective).value(), 18.0, 1e-6);
}

TEST_F(TeamPathSimplifierTest, LeavesPathsAloneThatItCannotShorten)
{
    const auto setup = crowd(1, 2, 4.0, 0);
    setup->getSpaceInformation()->setup();
    TeamPathSimplifier simplifier(setup->getSpaceInformation(), objectiveOf(*setup, "length"));
    og::PathGeometric path(setup->getSpaceInformation());
    EXPECT_FALSE(simplifier.simplify(path, ob::plannerNonTerminatingCondition()));
    path.append(setup->getProblemDefinition()->getStartState(0));
    EXPECT_FALSE(simplifier.simplify(path, 100, ob::plannerNonTerminatingCondition()));
    EXPECT_EQ(path.getStateCount(), 1U);

    const auto noTeam = std::make_shared<ob::SpaceInformation>(std::make_shared<ob::SE2StateSpace>());
    EXPECT_THROW(TeamPathSimplifier(noTeam, objectiveOf(*setup, "length")), ompl::Exception);
}

namespace
{
    /** The length of paths, and how many motions were measured */
    class CountingLength : public TeamPathLength
    {
    public:
        using TeamPathLength::TeamPathLength;

        ob::Cost motionCost(const ob::State *from, const ob::State *to) const override
        {
            ++count;
            return TeamPathLength::motionCost(from, to);
        }

        mutable std::size_t count{0};
    };
}

/** With a pace of its own each robot has corners at times of its own, so the team's path has thousands of motions. */
TEST_F(TeamPathSimplifierTest, EndsWithItsConditionHoweverManyRobotsThereAre)
{
    constexpr unsigned int robots = 20, states = 20;
    const auto team = std::make_shared<TeamStateSpace>();
    for (unsigned int i = 0; i < robots; ++i)
    {
        ob::RealVectorBounds lane(2);
        lane.setLow(0, 0.0);
        lane.setHigh(0, 30.0);
        lane.setLow(1, i);
        lane.setHigh(1, i + 0.4);
        team->addRobot(RigidRobot::inR2("robot" + std::to_string(i), Body::disc(0.1), lane));
    }
    TeamSetup setup(team, std::make_shared<FclObstacles>(std::vector<PlacedBody>(), 2));
    setup.getSpaceInformation()->setup();
    og::PathGeometric path(setup.getSpaceInformation());
    const auto sampler = team->allocStateSampler();
    ob::ScopedState<> state(team);
    for (unsigned int i = 0; i < states; ++i)
    {
        sampler->sampleUniform(state.get());
        path.append(state.get());
    }
    const auto objective = std::make_shared<CountingLength>(setup.getSpaceInformation());
    TeamPathSimplifier simplifier(setup.getSpaceInformation(), objective);
    og::PathGeometric same = path;
    EXPECT_FALSE(simplifier.simplify(same, 100, ob::plannerAlwaysTerminatingCondition()));
    EXPECT_EQ(objective->count, 0U);
    EXPECT_EQ(same.getStateCount(), path.getStateCount());
    // Wherever it comes in between, few motions are measured after it, and the path is a valid one.
    for (const std::size_t most : {1U, 10U, 300U, 1000U, 3000U})
    {
        og::PathGeometric changed = path;
        objective->count = 0;
        simplifier.simplify(changed, 100, ob::PlannerTerminationCondition([&] { return objective->count >= most; }));
        EXPECT_LE(objective->count, most + 256 / robots + 1);
        EXPECT_TRUE(changed.check());
        EXPECT_LE(changed.cost(objective).value(), path.cost(objective).value());
    }
}

TEST_F(TeamPathSimplifierTest, IsPartOfATeamSetupsSimplifier)
{
    for (const std::string &name : objectiveNames())
    {
        SCOPED_TRACE(name);
        ompl::RNG::setSeed(2);
        const auto setup = crowd(2, 3, 4.0, 4);
        const auto objective = objectiveOf(*setup, name);
        setup->setOptimizationObjective(objective);
        setup->setPlanner(std::make_shared<og::RRTConnect>(setup->getSpaceInformation()));
        ASSERT_EQ(setup->solve(20.0), ob::PlannerStatus::EXACT_SOLUTION);
        const double before = setup->getSolutionPath().cost(objective).value();
        setup->simplifySolution(5.0);
        EXPECT_LT(setup->getSolutionPath().cost(objective).value(), before);
        EXPECT_TRUE(setup->getSolutionPath().check());
    }
}

TEST(TeamSetup, ChoosesAPlannerForTheNumberOfRobots)
{
    const auto team = crowd(1, 3, 4.0, 2);
    team->setup();
    EXPECT_EQ(team->getPlanner()->getName(), "DRRTstar");
    const auto one = crowd(1, 1, 4.0, 2);
    one->setup();
    EXPECT_EQ(one->getPlanner()->getName(), "RRTConnect");
    const auto chosen = crowd(1, 3, 4.0, 2);
    chosen->setPlanner(std::make_shared<og::RRTConnect>(chosen->getSpaceInformation()));
    chosen->setup();
    EXPECT_EQ(chosen->getPlanner()->getName(), "RRTConnect");
}
