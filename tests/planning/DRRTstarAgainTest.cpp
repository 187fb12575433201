#include "planning/ProductTree.h"
#include "support/CrowdProblem.h"
#include "support/Quiet.h"

#include "ompl_certificates/planning/DRRTstar.h"
#include "ompl_certificates/team/TeamObjective.h"
#include "ompl_certificates/team/TeamPathLength.h"

#include <cmath>
#include <gtest/gtest.h>
#include <ompl/base/DiscreteMotionValidator.h>
#include <ompl/base/PlannerData.h>
#include <ompl/util/RandomNumbers.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;
namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace
{
    /** Discs that cross a room with one wall, and a planner for them */
    struct Room
    {
        explicit Room(unsigned int robots, double wallHeight = 6.0) : team(std::make_shared<TeamStateSpace>())
        {
            ompl::RNG::setSeed(1);
            for (unsigned int i = 0; i < robots; ++i)
                team->addRobot(RigidRobot::disc("disc_" + std::to_string(i), 0.2, cubeBounds(2, 10.0)));
            setup = std::make_unique<TeamSetup>(team, among({{Body::box(1.0, wallHeight)}}));
            std::vector<double> from, to;
            for (unsigned int i = 0; i < robots; ++i)
            {
                from.insert(from.end(), {-5.0, static_cast<double>(i)});
                to.insert(to.end(), {5.0, static_cast<double>(i)});
            }
            setStartAndGoal(from, to);
            planner = std::make_shared<DRRTstar>(setup->getSpaceInformation());
            setup->setPlanner(planner);
        }

        static ObstaclesPtr among(const std::vector<PlacedBody> &bodies)
        {
            return std::make_shared<FclObstacles>(bodies, 2);
        }

        void setStartAndGoal(const std::vector<double> &from, const std::vector<double> &to)
        {
            ob::ScopedState<> start(team), goal(team);
            start = from;
            goal = to;
            setup->setStartAndGoalStates(start, goal);
        }

        /** Two robots drive straight on above a wall of height 2: no path can be better. */
        void driveStraightOn()
        {
            setStartAndGoal({-5.0, 2.0, -5.0, 3.0}, {5.0, 2.0, 5.0, 3.0});
        }

        ob::PlannerSolution solution() const
        {
            ob::PlannerSolution found(nullptr);
            setup->getProblemDefinition()->getSolution(found);
            return found;
        }

        TeamStateSpacePtr team;
        std::unique_ptr<TeamSetup> setup;
        std::shared_ptr<DRRTstar> planner;
    };

    /** The length of a path, where the first robot must not go above y = 2 */
    class ForbiddenZone : public TeamPathLength
    {
    public:
        using TeamPathLength::TeamPathLength;

        ob::Cost motionCost(const ob::State *from, const ob::State *to) const override
        {
            return isForbidden(from) || isForbidden(to) ? infiniteCost() : TeamPathLength::motionCost(from, to);
        }

    private:
        bool isForbidden(const ob::State *state) const
        {
            std::vector<double> values;
            si_->getStateSpace()->copyToReals(values, state);
            return values[1] > 2.0;
        }
    };

    /** The length, and a price for where the path ends */
    class PricedGoals : public TeamPathLength
    {
    public:
        using TeamPathLength::TeamPathLength;

        ob::Cost terminalCost(const ob::State *state) const override
        {
            std::vector<double> values;
            si_->getStateSpace()->copyToReals(values, state);
            return ob::Cost(values[1] > 0.0 ? 100.0 : 0.0);
        }
    };

    /** A goal that no states can be taken of */
    class NoSampleableGoal : public ob::Goal
    {
    public:
        using Goal::Goal;

        bool isSatisfied(const ob::State * /*state*/) const override
        {
            return false;
        }
    };

    class DRRTstarAgain : public testing::Test
    {
        const Quiet quiet_;
    };
}

TEST_F(DRRTstarAgain, KeepsItsSearchWhenItIsSetUpAgain)
{
    for (const bool own : {false, true})
    {
        Room room(3);
        const auto si = room.setup->getSpaceInformation();
        if (!own)
            si->setMotionValidator(std::make_shared<ob::DiscreteMotionValidator>(si));
        ASSERT_EQ(room.setup->solve(evaluations(2000)), ob::PlannerStatus::EXACT_SOLUTION);
        const double before = room.planner->getBestCost().value();
        room.planner->setup();
        EXPECT_EQ(room.planner->getBestCost().value(), before);
        ASSERT_EQ(room.setup->solve(evaluations(2000)), ob::PlannerStatus::EXACT_SOLUTION);
        EXPECT_LE(room.planner->getBestCost().value(), before);
        EXPECT_EQ(room.solution().cost_.value(), room.planner->getBestCost().value());
        EXPECT_TRUE(room.setup->getSolutionPath().check());
    }
}

// Whoever shows progress, or plans while a robot waits, calls solve() again and again, each time for an instant.
TEST_F(DRRTstarAgain, FindsInManyShortCallsWhatOneLongCallFinds)
{
    for (const std::uint64_t slice : {100U, 300U})
    {
        // All have to pass one of two narrow gaps.
        Room whole(6, 18.6), parts(6, 18.6);
        constexpr std::uint64_t all = 6000;
        ASSERT_EQ(whole.setup->solve(evaluations(all)), ob::PlannerStatus::EXACT_SOLUTION);
        ob::PlannerStatus status = ob::PlannerStatus::TIMEOUT;
        std::uint64_t spent = 0;
        // What calls cost on their own comes on top.
        for (; spent < 3 * all && status != ob::PlannerStatus::EXACT_SOLUTION; spent += slice)
            status = parts.setup->solve(evaluations(slice));
        ASSERT_EQ(status, ob::PlannerStatus::EXACT_SOLUTION) << slice;
        EXPECT_TRUE(parts.setup->getSolutionPath().check()) << slice;
    }
}

// With more robots a whole round takes longer than a call.
TEST_F(DRRTstarAgain, GoesOnInShortCallsAfterTheFirstSolution)
{
    Room room(10, 6.0);
    const auto vertices = [&]
    { return std::stoul(room.planner->getPlannerProgressProperties().at("roadmap vertices INTEGER")()); };
    for (int i = 0; i < 300 && !room.setup->haveExactSolutionPath(); ++i)
        room.setup->solve(evaluations(100));
    ASSERT_TRUE(room.setup->haveExactSolutionPath());
    const double cost = room.planner->getBestCost().value();
    std::size_t before = 0;
    for (int part = 0; part < 2; ++part)
    {
        for (int i = 0; i < 300 * (part + 1); ++i)
            room.setup->solve(evaluations(100));
        EXPECT_GT(vertices(), before);
        before = vertices();
    }
    EXPECT_LT(room.planner->getBestCost().value(), cost);
}

// A start is taken before it shows that the goal is of no use.
TEST_F(DRRTstarAgain, TakesStartsThatCameWithAGoalOfNoUse)
{
    Room room(4, 18.6);
    const auto problem = room.setup->getProblemDefinition();
    const ob::GoalPtr goal = problem->getGoal();
    room.setup->solve(evaluations(200));
    ob::ScopedState<> start(room.team);
    start = std::vector<double>{-5.0, -1.0, -5.0, -2.0, -5.0, -3.0, -5.0, -4.0};
    problem->addStartState(start);
    problem->setGoal(std::make_shared<NoSampleableGoal>(room.setup->getSpaceInformation()));
    EXPECT_EQ(room.setup->solve(evaluations(200)), ob::PlannerStatus::UNRECOGNIZED_GOAL_TYPE);
    problem->setGoal(goal);
    EXPECT_EQ(room.setup->solve(evaluations(6000)), ob::PlannerStatus::EXACT_SOLUTION);
    EXPECT_TRUE(room.setup->getSolutionPath().check());
}

// Also a call that ends early, or has nothing more to try, tells which robot is stuck.
TEST_F(DRRTstarAgain, NamesTheStuckRobotInEachCall)
{
    Room room(2, 30.0);
    room.planner->setMaxRoadmapSize(100);
    for (int call = 0; call < 3; ++call)
    {
        EXPECT_EQ(room.setup->solve(evaluations(call == 1 ? 5 : 20000)), ob::PlannerStatus::TIMEOUT);
        EXPECT_EQ(room.planner->getStuckRobot(), "disc_0") << call;
    }
}

/** The wall divides the room; then another checker knows of none. */
TEST_F(DRRTstarAgain, TakesTheCheckerThatIsThere)
{
    for (const bool clears : {true, false})
        for (const bool setsUp : {true, false})
        {
            SCOPED_TRACE(std::to_string(clears) + std::to_string(setsUp));
            Room room(5, 30.0);
            const auto si = room.setup->getSpaceInformation();
            ASSERT_EQ(room.setup->solve(evaluations(500)), ob::PlannerStatus::TIMEOUT);
            if (clears)
                room.setup->clear();
            const auto open = std::make_shared<TeamValidityChecker>(si, Room::among({}));
            room.setup->setStateValidityChecker(open);
            si->setMotionValidator(std::make_shared<CertificateMotionValidator>(open));
            if (setsUp)
                room.planner->setup();
            ASSERT_EQ(room.setup->solve(evaluations(2000)), ob::PlannerStatus::EXACT_SOLUTION);
            EXPECT_TRUE(room.setup->getSolutionPath().check());
        }
}

/** Only the second validator sees the wall, which is thinner than the steps of the first. */
TEST_F(DRRTstarAgain, TakesTheMotionValidatorThatIsThere)
{
    Room room(2, 8.0);
    room.team->setLongestValidSegmentFraction(0.3);
    ASSERT_EQ(room.setup->solve(evaluations(2000)), ob::PlannerStatus::EXACT_SOLUTION);
    room.setup->getSpaceInformation()->setMotionValidator(std::make_shared<CertificateMotionValidator>(
        room.setup->getTeamChecker(), CertificateMotionValidator::CONTINUOUS));
    ASSERT_FALSE(room.setup->getSolutionPath().check());
    room.setup->getProblemDefinition()->clearSolutionPaths();
    ASSERT_EQ(room.setup->solve(evaluations(2000)), ob::PlannerStatus::EXACT_SOLUTION);
    EXPECT_TRUE(room.setup->getSolutionPath().check());
}

TEST_F(DRRTstarAgain, TakesTheObjectiveThatIsThere)
{
    Room room(2);
    const auto si = room.setup->getSpaceInformation();
    ASSERT_EQ(room.setup->solve(evaluations(1000)), ob::PlannerStatus::EXACT_SOLUTION);
    for (const bool clears : {true, false})
    {
        if (clears)
            room.setup->clear();
        const auto objective =
            std::make_shared<TeamObjective>(si, clears ? TeamObjective::MAKESPAN : TeamObjective::SUM_OF_LENGTHS);
        room.setup->setOptimizationObjective(objective);
        room.setup->getProblemDefinition()->clearSolutionPaths();
        ASSERT_EQ(room.setup->solve(evaluations(1000)), ob::PlannerStatus::EXACT_SOLUTION);
        EXPECT_EQ(room.solution().opt_, objective);
        EXPECT_NEAR(room.solution().cost_.value(), room.setup->getSolutionPath().cost(objective).value(), 1e-9);
    }
}

/** A problem that has another start, given to the planner without clear(), with an objective of its own or with that
    of the first */
TEST_F(DRRTstarAgain, BeginsAnewWithAnotherProblem)
{
    for (const bool sharesObjective : {false, true})
    {
        Room room(2);
        const auto si = room.setup->getSpaceInformation();
        ASSERT_EQ(room.setup->solve(evaluations(1000)), ob::PlannerStatus::EXACT_SOLUTION);
        const double before = room.planner->getBestCost().value();
        room.planner->setProblemDefinition(room.setup->getProblemDefinition());
        EXPECT_EQ(room.planner->getBestCost().value(), before);
        const auto problem = std::make_shared<ob::ProblemDefinition>(si);
        ob::ScopedState<> start(room.team), goal(room.team);
        start = std::vector<double>{5.0, 5.0, 5.0, 7.0};
        goal = std::vector<double>{5.0, -5.0, 5.0, -7.0};
        problem->setStartAndGoalStates(start, goal);
        if (sharesObjective)
            problem->setOptimizationObjective(room.setup->getProblemDefinition()->getOptimizationObjective());
        room.planner->setProblemDefinition(problem);
        ASSERT_EQ(room.planner->solve(evaluations(1000)), ob::PlannerStatus::EXACT_SOLUTION);
        const auto path = std::static_pointer_cast<og::PathGeometric>(problem->getSolutionPath());
        EXPECT_TRUE(si->equalStates(path->getState(0), start.get()));
        EXPECT_TRUE(si->equalStates(path->getStates().back(), goal.get()));
    }
}

TEST_F(DRRTstarAgain, SearchesAgainAfterClearWhereItsPathWasOptimal)
{
    Room room(2, 2.0);
    room.driveStraightOn();
    ASSERT_EQ(room.setup->solve(evaluations(2000)), ob::PlannerStatus::EXACT_SOLUTION);
    room.setup->getProblemDefinition()->clearSolutionPaths();
    room.planner->clear();
    EXPECT_EQ(room.setup->solve(evaluations(2000)), ob::PlannerStatus::EXACT_SOLUTION);
}

/** The first state but one of a path is in the tree, and becomes a start: the shorter way begins there. */
TEST_F(DRRTstarAgain, BeginsWhereItWasBefore)
{
    Room room(1, 8.0);
    room.planner->setSmoothing(false);
    ASSERT_EQ(room.setup->solve(evaluations(1000)), ob::PlannerStatus::EXACT_SOLUTION);
    const og::PathGeometric path = room.setup->getSolutionPath();
    ASSERT_GE(path.getStateCount(), 3U);
    const ob::ScopedState<> start(room.team, path.getState(static_cast<unsigned int>(path.getStateCount()) - 2));
    room.setup->getProblemDefinition()->addStartState(start);
    ASSERT_EQ(room.setup->solve(evaluations(1000)), ob::PlannerStatus::EXACT_SOLUTION);
    EXPECT_TRUE(room.team->equalStates(room.setup->getSolutionPath().getState(0), start.get()));
    EXPECT_LT(room.setup->getSolutionPath().length(), path.length());
    ob::PlannerData data(room.setup->getSpaceInformation());
    room.planner->getPlannerData(data);
    EXPECT_EQ(data.numStartVertices(), 2U);
}

TEST_F(DRRTstarAgain, PlansWhereSomeWaysCostWithoutEnd)
{
    for (std::uint64_t seed = 1; seed <= scaled(10); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Room room(5);
        ompl::RNG::setSeed(static_cast<std::uint_fast32_t>(seed));
        room.setup->setOptimizationObjective(std::make_shared<ForbiddenZone>(room.setup->getSpaceInformation()));
        ASSERT_EQ(room.setup->solve(evaluations(1000)), ob::PlannerStatus::EXACT_SOLUTION);
        EXPECT_TRUE(room.setup->getSolutionPath().check());
    }
}

/** The tree knows a short way to a dear goal, and a longer one to another. */
TEST_F(DRRTstarAgain, CountsWhatItCostsToEndAtAGoal)
{
    Room room(1, 2.0);
    room.setup->setup();
    const ob::SpaceInformationPtr si = room.setup->getSpaceInformation();
    const auto &validator = dynamic_cast<const CertificateMotionValidator &>(*si->getMotionValidator());
    TeamRoadmaps roadmaps(validator, true, 1);
    ProductTree tree(si, std::make_shared<PricedGoals>(si), roadmaps);
    ob::ScopedState<> start(room.team), dear(room.team), cheap(room.team);
    start = std::vector<double>{5.0, 4.0};
    dear = std::vector<double>{5.0, 2.0};
    cheap = std::vector<double>{5.0, -4.0};
    const auto from = roadmaps.add(start.get()), near = roadmaps.add(dear.get()), far = roadmaps.add(cheap.get());
    tree.setGoals(
        {{near, {roadmaps.getRoadmap(0).distancesTo(near[0])}}, {far, {roadmaps.getRoadmap(0).distancesTo(far[0])}}});
    tree.insert({from, near});
    EXPECT_EQ(tree.getCost().value(), 102.0);
    tree.insert({from, far});
    EXPECT_EQ(tree.getCost().value(), 8.0);
    EXPECT_EQ(tree.getPath().back(), far);
}

/** Two robots that RRTConnect plans for together, without the tree */
TEST_F(DRRTstarAgain, TellsOfAPathFromStartToGoalInItsData)
{
    Room room(2, 2.0);
    room.driveStraightOn();
    auto objective = std::make_shared<TeamPathLength>(room.setup->getSpaceInformation());
    objective->setCostThreshold(objective->infiniteCost());
    room.setup->setOptimizationObjective(objective);
    ASSERT_EQ(room.setup->solve(evaluations(3000)), ob::PlannerStatus::EXACT_SOLUTION);
    ob::PlannerData data(room.setup->getSpaceInformation());
    room.planner->getPlannerData(data);
    ASSERT_EQ(data.numStartVertices(), 1U);
    ASSERT_GE(data.numGoalVertices(), 1U);
    std::vector<unsigned int> open{data.getStartIndex(0)}, next;
    std::vector<bool> seen(data.numVertices());
    while (!open.empty())
    {
        const unsigned int vertex = open.back();
        open.pop_back();
        seen[vertex] = true;
        data.getEdges(vertex, next);
        for (const unsigned int to : next)
            if (!seen[to])
                open.push_back(to);
    }
    EXPECT_TRUE(seen[data.getGoalIndex(0)]);
}

TEST_F(DRRTstarAgain, RefusesRoadmapsOfNothing)
{
    Room room(1);
    EXPECT_THROW(room.planner->setRoadmapSize(0), ompl::Exception);
    EXPECT_THROW(room.planner->setMaxRoadmapSize(0), ompl::Exception);
    EXPECT_GT(room.planner->getRoadmapSize(), 0U);
}
