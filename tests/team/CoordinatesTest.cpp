#include "ompl_certificates/team/Coordinates.h"
#include "ompl_certificates/robots/Arm.h"
#include "ompl_certificates/robots/RigidRobot.h"
#include "ompl_certificates/team/TeamStateSpace.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <ompl/base/ScopedState.h>
#include <ompl/base/spaces/TimeStateSpace.h>

using namespace ompl_certificates;
namespace ob = ompl::base;

namespace
{
    ob::RealVectorBounds oblong(unsigned int dimension)
    {
        ob::RealVectorBounds bounds(dimension);
        for (unsigned int axis = 0; axis < dimension; ++axis)
        {
            bounds.low[axis] = -1.0 - axis;
            bounds.high[axis] = 2.5 + axis;
        }
        return bounds;
    }

    std::string complaintOf(const Robot &robot, const std::vector<double> &numbers)
    {
        ob::ScopedState<> state(robot.getStateSpace());
        state = numbers;
        return describeOutOfBounds(robot, state.get());
    }
}

TEST(Coordinates, HaveTheBoundsOfTheirSpaces)
{
    const auto ends = [](const RobotPtr &first, const RobotPtr &second)
    {
        TeamStateSpace team;
        team.addRobot(first);
        team.addRobot(second);
        std::pair<std::vector<double>, std::vector<double>> lowAndHigh;
        for (const CoordinateBounds &one : coordinateBounds(team))
        {
            lowAndHigh.first.push_back(one.low);
            lowAndHigh.second.push_back(one.high);
        }
        EXPECT_EQ(lowAndHigh.first.size(), coordinateNames(team).size());
        return lowAndHigh;
    };
    const auto [low, high] =
        ends(RigidRobot::inSE2("cart", Body::disc(0.1), oblong(2)), RigidRobot::disc("puck", 0.1, oblong(2)));
    EXPECT_EQ(low, (std::vector<double>{-1, -2, -M_PI, -1, -2}));
    EXPECT_EQ(high, (std::vector<double>{2.5, 3.5, M_PI, 2.5, 3.5}));
    const auto [lowest, highest] = ends(RigidRobot::inSE3("drone", Body::sphere(0.1), oblong(3)),
                                        RigidRobot::inR3("ball", Body::sphere(0.1), oblong(3)));
    EXPECT_EQ(lowest, (std::vector<double>{-1, -2, -3, -1, -1, -1, -1, -1, -2, -3}));
    EXPECT_EQ(highest, (std::vector<double>{2.5, 3.5, 4.5, 1, 1, 1, 1, 2.5, 3.5, 4.5}));
    ob::TimeStateSpace time;
    time.computeLocations();
    EXPECT_TRUE(std::isinf(coordinateBounds(time).at(0).high)) << "of a kind that is not known";
}

TEST(Coordinates, TellWhichIsOutsideTheBounds)
{
    const RobotPtr cart = RigidRobot::inSE2("cart", Body::disc(0.1), oblong(2));
    EXPECT_EQ(complaintOf(*cart, {2.5, -2.0, 3.0}), "");
    EXPECT_EQ(complaintOf(*cart, {2.5, -2.125, 4.0}), "is outside the bounds: y is -2.125, not from -2 to 3.5");
    EXPECT_EQ(complaintOf(*cart, {std::nextafter(2.5f, 3.0f), 0.0, 0.0}),
              "is outside the bounds: x is 2.500000238418579, not from -1 to 2.5");
    EXPECT_EQ(complaintOf(*cart, {0.0, 0.0, 4.0}).substr(0, 33), "is outside the bounds: yaw is 4, ");
    EXPECT_EQ(complaintOf(*cart, {std::numeric_limits<double>::quiet_NaN(), 0.0, 4.0}).substr(0, 33),
              "is outside the bounds: x is nan, ");
    // No part of it is outside, but its length is not 1.
    const RobotPtr drone = RigidRobot::inSE3("drone", Body::sphere(0.1), oblong(3));
    EXPECT_EQ(complaintOf(*drone, {0, 0, 0, 0, 0, 0, 0.5}), "is outside the bounds");
}

// Names may contain dots: robot "r" with joint "s.x", and robot "r.s".
TEST(Coordinates, OfTwoRobotsMayShareANameWhicheverComesFirst)
{
    KinematicTree tree("base");
    KinematicTree::Joint joint{"s.x", KinematicTree::JointType::REVOLUTE};
    joint.lower = -1.0;
    joint.upper = 1.0;
    tree.addLink("base", joint, "link", Body::sphere(0.1));
    const Arm arm("r", tree, {"s.x"});
    const auto ball = RigidRobot::sphere("r.s", 0.1, oblong(3)), other = RigidRobot::sphere("r.t", 0.1, oblong(3));
    EXPECT_EQ(sharedCoordinate(arm, *ball), "r.s.x");
    EXPECT_EQ(sharedCoordinate(*ball, arm), "r.s.x");
    EXPECT_EQ(sharedCoordinate(arm, *other), "");
    EXPECT_EQ(sharedCoordinate(*other, arm), "");
}
