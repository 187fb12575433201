#include "ompl_certificates/team/PathTimes.h"
#include "ompl_certificates/team/TimedPath.h"
#include "support/Message.h"
#include "support/Teams.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <limits>
#include <ompl/base/SpaceInformation.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;
namespace ob = ompl::base;

namespace
{
    /** A path of two discs, the first of speed 2, that takes 1 and then 0.25 */
    class TimedPathTest : public ::testing::Test
    {
    protected:
        TimedPathTest()
        {
            const auto bounds = cubeBounds(2, HALF);
            team_->addRobot(RigidRobot::disc("fast", 0.1, bounds));
            team_->addRobot(RigidRobot::disc("slow", 0.1, bounds));
            team_->setSpeed(0, 2.0);
            si_ = std::make_shared<ob::SpaceInformation>(team_);
            si_->setStateValidityChecker([](const ob::State *) { return true; });
            si_->setup();
            for (const std::vector<double> &numbers :
                 {std::vector<double>{0, 0, 0, 3}, std::vector<double>{2, 0, 0.5, 3},
                  std::vector<double>{2, 0.5, 0.5, 3}})
                states_.push_back(numbers);
        }

        ompl::geometric::PathGeometric path() const
        {
            ompl::geometric::PathGeometric path(si_);
            ob::ScopedState<> state(team_);
            for (const std::vector<double> &numbers : states_)
            {
                state = numbers;
                path.append(state.get());
            }
            return path;
        }

        std::vector<double> at(double time) const
        {
            ob::ScopedState<> state(team_);
            TimedPath(path()).computeState(time, state.get());
            return state.reals();
        }

        const TeamStateSpacePtr team_{std::make_shared<TeamStateSpace>()};
        ob::SpaceInformationPtr si_;
        std::vector<std::vector<double>> states_;
    };
}

TEST_F(TimedPathTest, SayWhereTheTeamIs)
{
    EXPECT_EQ(TimedPath(path()).getTimes(), (std::vector<double>{0.0, 1.0, 1.25}));
    EXPECT_EQ(at(0.5), (std::vector<double>{1, 0, 0.25, 3}));
    EXPECT_EQ(at(1.125), (std::vector<double>{2, 0.25, 0.5, 3}));
    // Those of the path itself, without rounding, and before and after it
    EXPECT_EQ(at(0.0), states_[0]);
    EXPECT_EQ(at(1.0), states_[1]);
    EXPECT_EQ(at(1.25), states_[2]);
    EXPECT_EQ(at(-1.0), states_[0]);
    EXPECT_EQ(at(9.0), states_[2]);
}

TEST_F(TimedPathTest, StandStillWhereTwoStatesHaveOneTime)
{
    states_.insert(states_.begin() + 1, states_[1]);
    EXPECT_EQ(TimedPath(path()).getTimes(), (std::vector<double>{0.0, 1.0, 1.0, 1.25}));
    EXPECT_EQ(at(1.0), states_[1]);
    EXPECT_EQ(at(1.125), (std::vector<double>{2, 0.25, 0.5, 3}));
}

TEST_F(TimedPathTest, ListEachTickAndEachState)
{
    const TimedPath timed(path());
    EXPECT_EQ(timed.listTimes(0.4), (std::vector<double>{0.0, 0.4, 0.8, 1.0, 1.2, 1.25}));
    // Each multiple of 0.1 as it is written, and those of the path once
    EXPECT_EQ(timed.listTimes(0.1),
              (std::vector<double>{0.0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0, 1.1, 1.2, 1.25}));
    EXPECT_EQ(timed.listTimes(0.25), (std::vector<double>{0.0, 0.25, 0.5, 0.75, 1.0, 1.25}));
    EXPECT_EQ(timed.listTimes(7.0), timed.getTimes());
    EXPECT_EQ(TimedPath(path(), {5.0, 6.0, 6.5}).listTimes(0.5), (std::vector<double>{5.0, 5.5, 6.0, 6.5}));
    // Times of a clock are large.
    const double now = 1700000000.123456;
    const std::vector<double> late = TimedPath(path(), {now, now + 0.5, now + 1.0}).listTimes(0.001);
    EXPECT_EQ(late.size(), 1001U);
    for (std::size_t i = 0; i < late.size(); ++i)
        EXPECT_NEAR(late[i], now + 0.001 * static_cast<double>(i), 5e-7);
    EXPECT_TRUE(std::is_sorted(late.begin(), late.end()));
    // However short the step is: what divides the path evenly has a line for each. The state in the middle of the
    // path is another line where the number of parts is odd.
    for (const unsigned int parts : {3U, 300U, 3000U, 70001U})
        EXPECT_EQ(TimedPath(path(), {0.0, 0.5 / 3.0, 1.0 / 3.0}).listTimes(1.0 / 3.0 / parts).size(),
                  parts + 1 + parts % 2);
    for (const double step : {0.0, -1.0, std::numeric_limits<double>::infinity(), std::nan("")})
        EXPECT_NE(messageOf([&] { timed.listTimes(step); }), "") << step;
    EXPECT_NE(messageOf([&] { timed.listTimes(1e-9); }).find("more than 10000000"), std::string::npos);
}

TEST_F(TimedPathTest, RefuseTimesThatAreNone)
{
    EXPECT_NE(messageOf([&] { TimedPath(path(), {0.0, 1.0}); }), "");
    EXPECT_NE(messageOf([&] { TimedPath(path(), {0.0, 2.0, 1.0}); }), "");
    EXPECT_NE(messageOf([&] { TimedPath(path(), {0.0, std::nan(""), 1.0}); }), "");
    states_.clear();
    EXPECT_NE(messageOf([&] { TimedPath{path()}; }), "");
}
