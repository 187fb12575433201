#include "support/RandomTrees.h"

#include "ompl_certificates/obstacles/FclObstacles.h"
#include "ompl_certificates/planning/Planners.h"
#include "ompl_certificates/planning/TeamGoalRegion.h"
#include "ompl_certificates/planning/TeamSetup.h"
#include "ompl_certificates/robots/AnyOfGoals.h"
#include "ompl_certificates/robots/LinkPoseGoal.h"
#include "ompl_certificates/robots/RigidRobot.h"
#include "ompl_certificates/robots/ZoneGoal.h"
#include "support/Message.h"
#include "support/Quiet.h"

#include <gtest/gtest.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;
namespace ob = ompl::base;

namespace
{
    /** Two arms that face each other, and a ball that goes to a point */
    class TeamGoalRegionTest : public ::testing::Test
    {
    protected:
        void SetUp() override
        {
            ompl::RNG::setSeed(1);
            const auto arm = [](const std::string &name, double x)
            {
                ArmOptions options;
                options.base = poseAt({x, 0.0, 0.0});
                return std::make_shared<Arm>(name, sevenJoints(), SEVEN, options);
            };
            ob::RealVectorBounds bounds(3);
            bounds.setLow(-2.0);
            bounds.setHigh(2.0);
            team_ = std::make_shared<TeamStateSpace>();
            team_->addRobot(arm("left", -0.5));
            team_->addRobot(arm("right", 0.5));
            team_->addRobot(RigidRobot::inR3("ball", Body::sphere(0.1), bounds));
            const PlacedBody box{Body::box(0.3, 0.3, 0.3), poseAt({0.0, 0.5, 0.4})};
            setup_ =
                std::make_shared<TeamSetup>(team_, std::make_shared<FclObstacles>(std::vector<PlacedBody>{box}, 3));
            team_->setup();
            // Both hands shall be near the middle.
            for (unsigned int i = 0; i < 2; ++i)
            {
                LinkPose pose{"link7"};
                pose.position = LinkPose::Position{Eigen::Vector3d(i == 0 ? -0.15 : 0.15, 0.0, 0.7)};
                pose.position->tolerance.setConstant(0.1);
                goals_.push_back(
                    std::make_shared<LinkPoseGoal>(std::static_pointer_cast<const Arm>(team_->getRobots()[i]), pose));
            }
            goals_.push_back(nullptr);
        }

        /** A state in which the team is free: its arms are up, or in the goal */
        ob::ScopedState<> freeState(bool inGoal)
        {
            ob::ScopedState<> state(team_);
            std::vector<double> reals(14, 0.0);
            reals.insert(reals.end(), {0.0, inGoal ? -1.5 : -1.0, 0.3});
            team_->copyFromReals(state.get(), reals);
            ompl::RNG random(1);
            do
                for (unsigned int i = 0; inGoal && i < 2; ++i)
                    EXPECT_TRUE(goals_[i]->sample(random, state.get()->as<ob::CompoundState>()->components[i]));
            while (!setup_->getStateValidityChecker()->isValid(state.get()));
            return state;
        }

        std::shared_ptr<TeamGoalRegion> makeRegion()
        {
            return std::make_shared<TeamGoalRegion>(setup_->getSpaceInformation(), freeState(true), goals_);
        }

        TeamStateSpacePtr team_;
        TeamSetupPtr setup_;
        std::vector<RobotGoalPtr> goals_;

    private:
        const Quiet quiet_;
    };
}

TEST_F(TeamGoalRegionTest, SamplesFreeStatesOfTheGoal)
{
    const auto region = makeRegion();
    ob::ScopedState<> state(team_), first(team_);
    region->sampleGoal(first.get());
    EXPECT_EQ(first, region->getState());
    int others = 0;
    for (int i = 0; i < 50; ++i)
    {
        region->sampleGoal(state.get());
        EXPECT_EQ(region->distanceGoal(state.get()), 0.0);
        EXPECT_TRUE(region->isSatisfied(state.get()));
        EXPECT_TRUE(setup_->getStateValidityChecker()->isValid(state.get()));
        others += team_->equalStates(state.get(), first.get()) ? 0 : 1;
    }
    EXPECT_GE(others, 40);
}

TEST_F(TeamGoalRegionTest, IsNotSatisfiedIfOneRobotIsNotThere)
{
    const auto region = makeRegion();
    const ob::ScopedState<> inGoal = freeState(true), outside = freeState(false);
    for (unsigned int i = 0; i < 3; ++i)
    {
        ob::ScopedState<> state = inGoal;
        team_->getSubspace(i)->copyState(state.get()->as<ob::CompoundState>()->components[i],
                                         outside.get()->as<ob::CompoundState>()->components[i]);
        EXPECT_FALSE(region->isSatisfied(state.get())) << i;
        EXPECT_GT(region->distanceGoal(state.get()), 0.0) << i;
    }
}

TEST_F(TeamGoalRegionTest, IsNotSatisfiedWhereADistanceIsNoNumber)
{
    class Nan : public RobotGoal
    {
    public:
        double distance(const ob::State * /*state*/) const override
        {
            return std::nan("");
        }

        bool sample(ompl::RNG & /*random*/, ob::State * /*state*/) const override
        {
            return false;
        }
    };
    auto goals = goals_;
    goals[0] = std::make_shared<Nan>();
    const ob::ScopedState<> state = freeState(true);
    EXPECT_NE(messageOf([&] { TeamGoalRegion(setup_->getSpaceInformation(), state, goals); })
                  .find("the state must be in the goal"),
              std::string::npos);
}

TEST_F(TeamGoalRegionTest, IsReachedByPlanners)
{
    for (const char *name : {"DRRTstar", "RRTConnect", "RRT", "EST", "BITstar"})
    {
        SCOPED_TRACE(name);
        setup_->clear();
        setup_->setPlanner(makePlanner(name, setup_->getSpaceInformation()));
        setup_->setStartState(freeState(false));
        setup_->setGoal(makeRegion());
        setup_->setup();
        // The first solution will do.
        setup_->getOptimizationObjective()->setCostThreshold(setup_->getOptimizationObjective()->infiniteCost());
        ASSERT_EQ(setup_->solve(20.0), ob::PlannerStatus::EXACT_SOLUTION);
        EXPECT_TRUE(setup_->getSolutionPath().check());
        EXPECT_TRUE(setup_->getGoal()->isSatisfied(setup_->getSolutionPath().getStates().back()));
        setup_->getProblemDefinition()->clearStartStates();
    }
}

/** Zones that robots share: all shall get behind a wall with a gap. */
TEST(TeamGoalRegions, HoldCrowds)
{
    const Quiet quiet;
    ob::RealVectorBounds bounds(2), zone(2);
    bounds.setLow(0.0);
    bounds.setHigh(10.0);
    zone.low = {6.5, 0.5};
    zone.high = {9.5, 9.5};
    auto team = std::make_shared<TeamStateSpace>();
    std::vector<RobotGoalPtr> goals;
    std::vector<double> start, end;
    for (unsigned int i = 0; i < 12; ++i)
    {
        team->addRobot(RigidRobot::inR2("disc_" + std::to_string(i), Body::disc(0.3), bounds));
        goals.push_back(std::make_shared<ZoneGoal>(team->getRobots().back(), zone));
        for (auto &[reals, x] : {std::pair{&start, 1.0}, {&end, 7.0}})
        {
            reals->push_back(x + i % 3);
            reals->push_back(1.0 + 2.0 * static_cast<double>(i / 3));
        }
    }
    team->setup();
    const std::vector<PlacedBody> wall{{Body::box(0.2, 4.0), planarPose(5.0, 2.0)},
                                       {Body::box(0.2, 4.0), planarPose(5.0, 8.0)}};
    TeamSetup setup(team, std::make_shared<FclObstacles>(wall, 2));
    ob::ScopedState<> from(team), to(team);
    from = start;
    to = end;
    setup.setStartState(from);
    setup.setGoal(std::make_shared<TeamGoalRegion>(setup.getSpaceInformation(), to, goals));
    ASSERT_EQ(setup.solve(5.0), ob::PlannerStatus::EXACT_SOLUTION);
    EXPECT_TRUE(setup.getSolutionPath().check());
    for (unsigned int i = 0; i < 12; ++i)
        EXPECT_EQ(
            goals[i]->distance(setup.getSolutionPath().getStates().back()->as<ob::CompoundState>()->components[i]),
            0.0);
}

TEST_F(TeamGoalRegionTest, RefusesTheGoalOfAnotherArm)
{
    const ob::ScopedState<> state = freeState(true);
    std::swap(goals_[0], goals_[1]);
    const std::string message = messageOf([&] { TeamGoalRegion(setup_->getSpaceInformation(), state, goals_); });
    EXPECT_NE(message.find("is no goal of robot 'left', but of one that differs from it"), std::string::npos)
        << message;
    goals_[0] = std::make_shared<AnyOfGoals>(team_->getRobots()[1], std::vector<std::vector<double>>{},
                                             std::vector<RobotGoalPtr>{goals_[0]});
    EXPECT_THROW(TeamGoalRegion(setup_->getSpaceInformation(), state, goals_), ompl::Exception);
}

TEST_F(TeamGoalRegionTest, RefusesWhatMakesNoSense)
{
    const auto messageAbout =
        [&](const ob::SpaceInformationPtr &si, const ob::ScopedState<> &state, const std::vector<RobotGoalPtr> &goals)
    { return messageOf([&] { TeamGoalRegion(si, state, goals); }); };
    const auto &si = setup_->getSpaceInformation();
    EXPECT_NE(messageAbout(si, freeState(true), {goals_[0]}).find("3 robots, not 1"), std::string::npos);
    EXPECT_NE(messageAbout(si, freeState(false), goals_).find("the state must be in the goal"), std::string::npos);
    const auto other = std::make_shared<ob::SpaceInformation>(team_);
    other->setStateValidityChecker([](const ob::State *) { return true; });
    EXPECT_NE(messageAbout(other, freeState(true), goals_).find("TeamValidityChecker"), std::string::npos);
    const auto plain = std::make_shared<ob::SpaceInformation>(team_->getRobots()[0]->getStateSpace());
    plain->setStateValidityChecker(std::make_shared<TeamValidityChecker>(
        plain, std::make_shared<FclObstacles>(std::vector<PlacedBody>{}, 3), std::vector{team_->getRobots()[0]}));
    EXPECT_NE(messageAbout(plain, ob::ScopedState<>(plain), {goals_[0]}).find("TeamStateSpace"), std::string::npos);
}

/** Half of the discs that would fit */
TEST(TeamGoalRegions, FindRoomForCrowds)
{
    ob::RealVectorBounds bounds(2), box(2);
    bounds.setLow(0.0);
    bounds.setHigh(20.0);
    box.low = {8.0, 8.0};
    box.high = {12.0, 11.0};
    auto team = std::make_shared<TeamStateSpace>();
    std::vector<RobotGoalPtr> goals;
    std::vector<double> known;
    for (unsigned int i = 0; i < 10; ++i)
    {
        team->addRobot(RigidRobot::inR2("disc_" + std::to_string(i), Body::disc(0.5), bounds));
        goals.push_back(std::make_shared<ZoneGoal>(team->getRobots().back(), box));
        // All at one place: that is in the goal, and free for none.
        known.insert(known.end(), {10.0, 10.0});
    }
    team->setup();
    const auto si = std::make_shared<ob::SpaceInformation>(team);
    si->setStateValidityChecker(
        std::make_shared<TeamValidityChecker>(si, std::make_shared<FclObstacles>(std::vector<PlacedBody>{}, 2)));
    ob::ScopedState<> state(team);
    state = known;
    const TeamGoalRegion region(si, state, goals);
    ompl::RNG random(1);
    for (int i = 0; i < 20; ++i)
    {
        region.sampleGoal(random, state.get());
        EXPECT_TRUE(si->isValid(state.get())) << i;
    }
}
