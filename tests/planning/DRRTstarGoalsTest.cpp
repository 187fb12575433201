#include "support/CrowdProblem.h"
#include "support/Quiet.h"

#include "ompl_certificates/planning/DRRTstar.h"
#include "ompl_certificates/team/TeamObjective.h"
#include "ompl_certificates/team/TeamPathLength.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <ompl/base/goals/GoalSampleableRegion.h>
#include <ompl/base/goals/GoalStates.h>
#include <ompl/util/RandomNumbers.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;
namespace ob = ompl::base;

namespace
{
    constexpr double HEIGHT = 0.8;

    /** Each robot's goal is a rectangle in its lane. */
    class Rectangles : public ob::GoalSampleableRegion
    {
    public:
        Rectangles(const ob::SpaceInformationPtr &si, double left, double right)
          : GoalSampleableRegion(si), left_(left), right_(right)
        {
            setThreshold(1e-9);
        }

        double distanceGoal(const ob::State *state) const override
        {
            std::vector<double> reals;
            si_->getStateSpace()->copyToReals(reals, state);
            double distance = 0.0;
            for (std::size_t i = 0; i < reals.size(); i += 2)
                distance = std::max({distance, left_ - reals[i], reals[i] - right_,
                                     std::abs(reals[i + 1] - lane(i / 2)) - 0.5 * HEIGHT});
            return distance;
        }

        void sampleGoal(ob::State *state) const override
        {
            std::vector<double> reals(si_->getStateSpace()->getDimension());
            for (std::size_t i = 0; i < reals.size(); i += 2)
            {
                reals[i] = random_.uniformReal(left_, right_);
                reals[i + 1] = lane(i / 2) + random_.uniformReal(-0.5, 0.5) * HEIGHT;
            }
            si_->getStateSpace()->copyFromReals(state, reals);
        }

        unsigned int maxSampleCount() const override
        {
            return 1000000;
        }

        static double lane(std::size_t robot)
        {
            return 1.0 + 2.0 * static_cast<double>(robot);
        }

    private:
        const double left_, right_;
        mutable ompl::RNG random_;
    };

    class DRRTstarGoals : public testing::Test
    {
    protected:
        /** Discs at the left end of lanes, with obstacles */
        void setUpLanes(unsigned int robots, const std::vector<PlacedBody> &obstacles)
        {
            auto team = std::make_shared<TeamStateSpace>();
            ob::RealVectorBounds bounds(2);
            bounds.setLow(0.0);
            bounds.setHigh(20.0);
            std::vector<double> reals;
            for (unsigned int robot = 0; robot < robots; ++robot)
            {
                team->addRobot(RigidRobot::disc("disc" + std::to_string(robot), 0.3, bounds));
                reals.insert(reals.end(), {1.0, Rectangles::lane(robot)});
            }
            setup_ = std::make_shared<TeamSetup>(team, std::make_shared<FclObstacles>(obstacles, 2));
            ob::ScopedState<> start(team);
            start = reals;
            setup_->setStartState(start);
            setup_->setPlanner(std::make_shared<DRRTstar>(setup_->getSpaceInformation()));
        }

        void stopAt(double cost)
        {
            auto objective = std::make_shared<TeamPathLength>(setup_->getSpaceInformation());
            objective->setCostThreshold(ob::Cost(cost));
            setup_->setOptimizationObjective(objective);
        }

        void SetUp() override
        {
            ompl::RNG::setSeed(1);
        }

        TeamSetupPtr setup_;

    private:
        const Quiet quiet_;
    };

    /** Which no robot crosses */
    const PlacedBody WALL{Body::box(0.2, 22.0), planarPose(17.0, 10.0, 0.0)};
}

/** Half of each robot's goals are behind a wall, so of a team's goals one in 256 can be reached. */
TEST_F(DRRTstarGoals, AreMixedOfThoseThatRobotsReach)
{
    setUpLanes(8, {WALL});
    setup_->setGoal(std::make_shared<Rectangles>(setup_->getSpaceInformation(), 14.0, 20.0));
    stopAt(std::numeric_limits<double>::infinity());
    ASSERT_EQ(setup_->solve(20.0), ob::PlannerStatus::EXACT_SOLUTION);
    EXPECT_TRUE(setup_->getSolutionPath().check());
    EXPECT_TRUE(setup_->getGoal()->isSatisfied(setup_->getSolutionPath().getStates().back()));
}

TEST_F(DRRTstarGoals, GetBetterAsMoreAreSampled)
{
    setUpLanes(4, {});
    setup_->setGoal(std::make_shared<Rectangles>(setup_->getSpaceInformation(), 14.0, 20.0));
    // The shortest paths end at the regions' near sides. Ten goals of the team, taken whole, give some 31.
    const double least = std::sqrt(4.0) * 13.0;
    stopAt(1.03 * least);
    ASSERT_EQ(setup_->solve(20.0), ob::PlannerStatus::EXACT_SOLUTION);
    EXPECT_LT(setup_->getSolutionPath().cost(setup_->getOptimizationObjective()).value(), 1.03 * least);
}

/** All but the last of a list are behind the wall, and longer than what one round takes. */
TEST_F(DRRTstarGoals, OfAListAreAllTaken)
{
    setUpLanes(5, {WALL});
    auto goals = std::make_shared<ob::GoalStates>(setup_->getSpaceInformation());
    ob::ScopedState<> goal(setup_->getStateSpace());
    std::vector<double> reals;
    for (int i = 0; i < 26; ++i)
    {
        reals.clear();
        for (unsigned int robot = 0; robot < 5; ++robot)
            reals.insert(reals.end(), {i < 25 ? 17.5 + 0.08 * i : 10.0, Rectangles::lane(robot)});
        goal = reals;
        goals->addState(goal);
    }
    setup_->setGoal(goals);
    stopAt(std::numeric_limits<double>::infinity());
    ASSERT_EQ(setup_->solve(20.0), ob::PlannerStatus::EXACT_SOLUTION);
    EXPECT_TRUE(setup_->getStateSpace()->equalStates(setup_->getSolutionPath().getStates().back(), goal.get()));
}

/** The parts of two goals in a list are no goal. */
TEST_F(DRRTstarGoals, OfAListAreNotMixed)
{
    setUpLanes(2, {WALL});
    auto goals = std::make_shared<ob::GoalStates>(setup_->getSpaceInformation());
    ob::ScopedState<> goal(setup_->getStateSpace());
    for (const double x : {10.0, 18.0})
    {
        goal = std::vector<double>{x, 1.0, 28.0 - x, 3.0};
        goals->addState(goal);
    }
    setup_->setGoal(goals);
    stopAt(std::numeric_limits<double>::infinity());
    EXPECT_EQ(setup_->solve(0.5), ob::PlannerStatus::TIMEOUT);
    EXPECT_EQ(setup_->getPlanner()->as<DRRTstar>()->getStuckRobot(), "");
}

/** Each robot has a way from one of the starts, and none from the other. */
TEST_F(DRRTstarGoals, NamesNoRobotAsStuckThatArrivesFromAnotherStart)
{
    setUpLanes(2, {{Body::box(1.0, 60.0), planarPose(10.0, 0.0)}});
    ob::ScopedState<> state(setup_->getStateSpace());
    setup_->clearStartStates();
    for (const std::vector<double> &start : {std::vector<double>{1, 1, 18, 7}, {18, 1, 1, 7}})
    {
        state = start;
        setup_->addStartState(state);
    }
    state = std::vector<double>{16, 1, 16, 7};
    setup_->setGoalState(state);
    stopAt(std::numeric_limits<double>::infinity());
    EXPECT_NE(setup_->solve(0.5), ob::PlannerStatus::EXACT_SOLUTION);
    const auto &planner = *setup_->getPlanner()->as<DRRTstar>();
    EXPECT_EQ(planner.getStuckRobot(), "");

    setup_->clear();
    state = std::vector<double>{1, 1, 18, 7};
    setup_->setStartState(state);
    EXPECT_NE(setup_->solve(0.5), ob::PlannerStatus::EXACT_SOLUTION);
    EXPECT_EQ(planner.getStuckRobot(), "disc0");
    setup_->clear();
    EXPECT_EQ(planner.getStuckRobot(), "");
}
