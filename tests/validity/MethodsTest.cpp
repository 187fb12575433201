#include "support/ExpensiveObstacles.h"
#include "support/Checkers.h"

#include <gtest/gtest.h>
#include <ompl/util/Console.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;
namespace ob = ompl::base;

namespace
{
    /** Two equal discs, far from each other, beside one obstacle each */
    class Methods : public testing::Test
    {
    protected:
        void SetUp() override
        {
            ompl::msg::setLogLevel(ompl::msg::LOG_ERROR);
            team_ = std::make_shared<TeamStateSpace>();
            team_->addRobot(RigidRobot::disc("a", 0.1, cubeBounds(2, HALF)));
            team_->addRobot(RigidRobot::disc("b", 0.1, cubeBounds(2, HALF)));
            obstacles_ =
                std::make_shared<ExpensiveObstacles>(std::vector<PlacedBody>{{Body::disc(1.0), planarPose(-3.0, 3.0)},
                                                                             {Body::disc(1.0), planarPose(3.0, 3.0)}},
                                                     2);
        }

        /** The number of robots checked exactly, at a state without references */
        unsigned int exactAt(const TeamSetup &setup, const std::vector<double> &reals)
        {
            ob::ScopedState<> state(team_);
            state = reals;
            team_->clearReferences(state.get());
            setup.getStatistics().reset();
            EXPECT_TRUE(setup.getTeamChecker()->isValid(state.get()));
            return static_cast<unsigned int>(setup.getStatistics().getCounts().asked);
        }

        TeamStateSpacePtr team_;
        ObstaclesPtr obstacles_;
        const std::vector<double> apart_{-3.0, 0.0, 3.0, 0.0}, swapped_{3.0, 0.01, -3.0, 0.01},
            moved_{-3.0, 0.01, 3.0, 0.01};
    };
}

TEST_F(Methods, StandardChecksEveryRobotEveryTime)
{
    const TeamSetup setup(team_, obstacles_, Method::STANDARD);
    EXPECT_EQ(exactAt(setup, apart_), 2U);
    EXPECT_EQ(exactAt(setup, apart_), 2U);
}

TEST_F(Methods, BasicNeedsAReferenceToATeamCertificate)
{
    const TeamSetup setup(team_, obstacles_, Method::BASIC);
    setup.getTeamChecker()->setAdaptive(false);
    EXPECT_EQ(exactAt(setup, apart_), 2U);
    EXPECT_EQ(exactAt(setup, moved_), 2U);
    ob::ScopedState<> near(team_), state(team_);
    near = apart_;
    ASSERT_TRUE(setup.getTeamChecker()->isValid(near.get()));
    setup.getStatistics().reset();
    team_->interpolate(near.get(), (state = moved_).get(), 1.0, state.get());
    EXPECT_TRUE(setup.getTeamChecker()->isValid(state.get()));
    EXPECT_EQ(setup.getStatistics().getCounts().asked, 0U);
    EXPECT_EQ(setup.getStatistics().getCounts().certifiedFree, 2U);
}

TEST_F(Methods, PartialUsesARobotsOwnCertificatesOnly)
{
    const TeamSetup setup(team_, obstacles_, Method::PARTIAL);
    setup.getTeamChecker()->setAdaptive(false);
    EXPECT_EQ(exactAt(setup, apart_), 2U);
    EXPECT_EQ(exactAt(setup, moved_), 0U);
    EXPECT_EQ(exactAt(setup, swapped_), 2U);
    EXPECT_EQ(exactAt(setup, swapped_), 0U);
}

TEST_F(Methods, SharedProjectionUsesAnyRobotsCertificates)
{
    const TeamSetup setup(team_, obstacles_, Method::SHARED_PROJECTION);
    setup.getTeamChecker()->setAdaptive(false);
    EXPECT_EQ(exactAt(setup, apart_), 2U);
    EXPECT_EQ(exactAt(setup, moved_), 0U);
    EXPECT_EQ(exactAt(setup, swapped_), 0U);
}

TEST_F(Methods, MoveFromStateToStateByReference)
{
    // checkMotion() gets the near state and the new one, which has no references yet.
    for (const Method method : {Method::BASIC, Method::PARTIAL, Method::SHARED_PROJECTION})
    {
        const TeamSetup setup(team_, obstacles_, method);
        setup.getTeamChecker()->setAdaptive(false);
        setup.getSpaceInformation()->setup();
        ob::ScopedState<> near(team_), fresh(team_);
        near = apart_;
        fresh = moved_;
        ASSERT_TRUE(setup.getTeamChecker()->isValid(near.get()));
        setup.getStatistics().reset();
        EXPECT_TRUE(setup.getSpaceInformation()->checkMotion(near.get(), fresh.get()));
        EXPECT_EQ(setup.getStatistics().getCounts().asked, 0U) << nameOf(method);
        for (unsigned int robot = 0; robot < 2; ++robot)
            EXPECT_NE(fresh->as<TeamStateSpace::StateType>()->getReference(robot), NO_CERTIFICATE) << nameOf(method);
    }
}

TEST_F(Methods, RememberCollisionsIfTheyAreShared)
{
    const TeamSetup setup(team_, obstacles_, Method::SHARED_PROJECTION);
    setup.getTeamChecker()->setAdaptive(false);
    ob::ScopedState<> state(team_);
    state = std::vector<double>{-3.0, 3.0, 3.0, 0.0};
    EXPECT_FALSE(setup.getTeamChecker()->isValid(state.get()));
    state = std::vector<double>{3.0, 0.0, -3.1, 3.0};
    EXPECT_FALSE(setup.getTeamChecker()->isValid(state.get()));
    EXPECT_EQ(setup.getStatistics().getCounts().certifiedColliding, 1U);
}
