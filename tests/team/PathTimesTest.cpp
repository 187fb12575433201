#include "ompl_certificates/team/PathTimes.h"
#include "support/Teams.h"

#include <gtest/gtest.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/base/spaces/SE2StateSpace.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;
namespace ob = ompl::base;

namespace
{
    /** A space information whose states are all valid */
    ob::SpaceInformationPtr informationOf(const ob::StateSpacePtr &space)
    {
        auto si = std::make_shared<ob::SpaceInformation>(space);
        si->setStateValidityChecker([](const ob::State *) { return true; });
        si->setup();
        return si;
    }
}

TEST(PathTimes, AMotionLastsAsLongAsTheRobotThatMovesFarthest)
{
    // Their weights, 1 and 2, do not count.
    const auto team = mixedTeam();
    ob::ScopedState<> from(team), to(team);
    from = std::vector<double>(from.reals().size(), 0.0);
    to = from;
    EXPECT_EQ(motionTime(*team, from.get(), to.get()), 0.0);
    to[0] = 3.0;
    to[1] = 4.0;
    EXPECT_DOUBLE_EQ(motionTime(*team, from.get(), to.get()), 5.0);
    to[2] = 4.5;
    EXPECT_DOUBLE_EQ(motionTime(*team, from.get(), to.get()), 5.0);
    to[2] = -6.0;
    EXPECT_DOUBLE_EQ(motionTime(*team, from.get(), to.get()), 6.0);
    // An angle counts as it does in the robot's space.
    to[4] = 1.0;
    const auto boxOf = [](const ob::ScopedState<> &state) { return state->as<ob::CompoundState>()->components[1]; };
    const double box = team->getSubspace(1)->distance(boxOf(from), boxOf(to));
    EXPECT_GT(box, 6.1);
    EXPECT_EQ(motionTime(*team, from.get(), to.get()), box);
}

TEST(PathTimes, AMotionLastsAsLongAsItsSpeedsLetIt)
{
    const auto team = mixedTeam();
    ob::ScopedState<> from(team), to(team);
    from = std::vector<double>(from.reals().size(), 0.0);
    to = from;
    to[0] = 3.0;
    to[2] = 4.0;
    team->setSpeed(0, 0.5);
    EXPECT_DOUBLE_EQ(motionTime(*team, from.get(), to.get()), 6.0);
    team->setSpeed(0, 3.0);
    team->setSpeed(1, 2.0);
    EXPECT_DOUBLE_EQ(motionTime(*team, from.get(), to.get()), 2.0);
    EXPECT_EQ(speedOf(*team, 1), 2.0);
    EXPECT_EQ(speedOf(*team->getSubspace(1), 0), 1.0);
}

TEST(PathTimes, OfStatesAddUp)
{
    const auto team = mixedTeam();
    const auto si = informationOf(team);
    ompl::geometric::PathGeometric path(si);
    EXPECT_TRUE(stateTimes(path).empty());
    Random random(1);
    std::vector<ob::ScopedState<>> states;
    for (int i = 0; i < 10; ++i)
    {
        states.push_back(randomState(random, team));
        path.append(states.back().get());
    }
    const std::vector<double> times = stateTimes(path);
    ASSERT_EQ(times.size(), states.size());
    EXPECT_EQ(times[0], 0.0);
    for (std::size_t i = 1; i < times.size(); ++i)
        EXPECT_NEAR(times[i] - times[i - 1], motionTime(*team, states[i - 1].get(), states[i].get()), 1e-9);
}

TEST(PathTimes, AnotherSpaceIsThatOfOneRobot)
{
    auto space = std::make_shared<ob::SE2StateSpace>();
    ob::RealVectorBounds bounds(2);
    bounds.setLow(-5.0);
    bounds.setHigh(5.0);
    space->setBounds(bounds);
    ob::ScopedState<> from(space), to(space);
    from = std::vector<double>{0.0, 0.0, 3.0};
    to = std::vector<double>{1.0, 2.0, -3.0};
    EXPECT_EQ(motionTime(*space, from.get(), to.get()), space->distance(from.get(), to.get()));
}
