#include "planning/TimedPaths.h"
#include "support/Teams.h"

#include "ompl_certificates/planning/TeamSetup.h"
#include "ompl_certificates/team/TimedPath.h"

#include <gtest/gtest.h>
#include <ompl/base/spaces/SE3StateSpace.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;
namespace ob = ompl::base;

/** OMPL calls orientations equal that differ by less than 9e-5 radians. */
TEST(TimedPaths, KeepSmallTurns)
{
    auto team = std::make_shared<TeamStateSpace>();
    team->addRobot(RigidRobot::inSE3("body", Body::box(1.0, 1.0, 1.0), cubeBounds(3, 5.0)));
    team->addRobot(RigidRobot::sphere("ball", 0.1, cubeBounds(3, 5.0)));
    const TeamSetup setup(team, std::make_shared<FclObstacles>(std::vector<PlacedBody>{}, 3));
    setup.getSpaceInformation()->setup();
    ompl::geometric::PathGeometric path(setup.getSpaceInformation());
    ob::ScopedState<> state(team);
    for (int i = 0; i < 4; ++i)
    {
        // The body turns a little in the middle of the path; the ball moves all the time.
        const double half = i < 2 ? 0.0 : 2e-5;
        state = std::vector<double>{0.0, 0.0, 0.0, 0.0, 0.0, std::sin(half), std::cos(half), 0.1 * i, 2.0, 0.0};
        path.append(state.get());
    }
    const TimedPaths paths(setup.getTeamChecker()->getTeam(), path);
    ASSERT_EQ(paths.getKnots(0).size(), 4U);
    const auto turnAt = [&](std::size_t knot)
    { return paths.getKnots(0)[knot].state->as<ob::SE3StateSpace::StateType>()->rotation().z; };
    EXPECT_EQ(turnAt(1), 0.0);
    EXPECT_EQ(turnAt(2), std::sin(2e-5));
}

/** OMPL's interpolation ends at pi there, and its distance ends the program. */
TEST(TimedPaths, HaveNoAngleOfPi)
{
    auto team = std::make_shared<TeamStateSpace>();
    team->addRobot(RigidRobot::inSE2("box", Body::box(1.0, 1.0), cubeBounds(2, 5.0)));
    team->addRobot(RigidRobot::disc("disc", 0.1, cubeBounds(2, 5.0)));
    const TeamSetup setup(team, std::make_shared<FclObstacles>(std::vector<PlacedBody>{}, 2));
    setup.getSpaceInformation()->setup();
    ob::ScopedState<> from(team), to(team), state(team);
    from = std::vector<double>{0.0, 0.0, 1.5210040888234959, 3.0, 3.0};
    to = std::vector<double>{0.0, 0.0, -M_PI, 3.0, 3.0};
    const double nearlyAll = 0.99999999999999978;
    team->interpolate(from.get(), to.get(), nearlyAll, state.get());
    EXPECT_TRUE(team->satisfiesBounds(state.get())) << state;

    ompl::geometric::PathGeometric path(setup.getSpaceInformation());
    path.append(from.get());
    path.append(to.get());
    const TimedPaths paths(setup.getTeamChecker()->getTeam(), path);
    const double time = nearlyAll * paths.getDuration();
    EXPECT_TRUE(team->getSubspace(0)->satisfiesBounds(paths.at(0, time).state.get()));
    paths.copyTo(time, state.get());
    EXPECT_TRUE(team->satisfiesBounds(state.get())) << state;
    TimedPath(path).computeState(time, state.get());
    EXPECT_TRUE(team->satisfiesBounds(state.get())) << state;
}
