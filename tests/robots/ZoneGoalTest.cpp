#include "ompl_certificates/robots/CarWithTrailer.h"
#include "ompl_certificates/robots/RigidRobot.h"
#include "ompl_certificates/robots/ZoneGoal.h"
#include "support/Message.h"
#include "support/RandomTrees.h"

#include <gtest/gtest.h>
#include <ompl/base/ScopedState.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;
namespace ob = ompl::base;

namespace
{
    ob::RealVectorBounds boxOf(const std::vector<double> &low, const std::vector<double> &high)
    {
        ob::RealVectorBounds box(static_cast<unsigned int>(low.size()));
        box.low = low;
        box.high = high;
        return box;
    }

    const ob::RealVectorBounds FLOOR = boxOf({0.0, 0.0}, {10.0, 10.0});
    const ob::RealVectorBounds HALL = boxOf({0.0, 0.0, 0.0}, {10.0, 10.0, 10.0});

    std::vector<RobotPtr> allKinds()
    {
        const Body car = Body::box(0.5, 0.25), box = Body::box(0.3, 0.2, 0.1);
        return {RigidRobot::inR2("R2", Body::disc(0.1), FLOOR), RigidRobot::inSE2("SE2", car, FLOOR),
                RigidRobot::inR3("R3", Body::sphere(0.1), HALL), RigidRobot::inSE3("SE3", box, HALL),
                std::make_shared<CarWithTrailer>("trailer", car, car, 0.5, FLOOR)};
    }
}

TEST(ZoneGoal, HoldsTheStatesWithThePositionInTheBox)
{
    for (const RobotPtr &robot : allKinds())
    {
        SCOPED_TRACE(robot->getName());
        const bool planar = robot->getWorkspaceDimension() == 2;
        const ob::RealVectorBounds box =
            planar ? boxOf({7.0, 2.0}, {8.0, 4.0}) : boxOf({7.0, 2.0, 1.0}, {8.0, 4.0, 2.0});
        const ZoneGoal zone(robot, box);
        ompl::RNG random(1);
        ob::ScopedState<> state(robot->getStateSpace());
        Eigen::AlignedBox3d seen;
        for (int i = 0; i < 200; ++i)
        {
            ASSERT_TRUE(zone.sample(random, state.get()));
            EXPECT_EQ(zone.distance(state.get()), 0.0);
            EXPECT_TRUE(robot->getStateSpace()->satisfiesBounds(state.get()));
            std::vector<Pose> poses(robot->getBodies().size());
            robot->computePoses(state.get(), poses.data());
            seen.extend(poses.front().translation());
        }
        const Eigen::Vector3d low(7.0, 2.0, planar ? 0.0 : 1.0), high(8.0, 4.0, planar ? 0.0 : 2.0);
        EXPECT_LT((seen.min() - low).norm() + (seen.max() - high).norm(), 0.2);
        EXPECT_TRUE(Eigen::AlignedBox3d(low, high).contains(seen));

        std::vector<double> reals = state.reals();
        reals[0] = 5.0;
        reals[1] = 5.5;
        state = reals;
        EXPECT_NEAR(zone.distance(state.get()), 2.5, 1e-12);
    }
}

TEST(ZoneGoal, StaysWithinTheBounds)
{
    const RobotPtr robot = RigidRobot::inR2("robot", Body::disc(0.1), FLOOR);
    ompl::RNG random(1);
    ob::ScopedState<> state(robot->getStateSpace());
    // Hardly any of it is within.
    const ZoneGoal edge(robot, boxOf({5.0, 9.99}, {6.0, 1e6}));
    for (int i = 0; i < 50; ++i)
    {
        ASSERT_TRUE(edge.sample(random, state.get()));
        EXPECT_LE(state[1], 10.0);
    }
    EXPECT_EQ(edge.describe(), "its zone from [5, 9.99] to [6, 10]");
}

TEST(ZoneGoal, IsForRobotsThatMoveInItsSpace)
{
    const auto robots = allKinds();
    for (const RobotPtr &owner : robots)
    {
        const ob::RealVectorBounds &box = owner->getWorkspaceDimension() == 2 ? FLOOR : HALL;
        for (const RobotPtr &robot : robots)
            EXPECT_EQ(ZoneGoal(owner, box).isFor(*robot), robot == owner) << owner->getName() << robot->getName();
        EXPECT_FALSE(ZoneGoal(owner, box).isFor(Arm("arm", sevenJoints(), SEVEN)));
    }
    EXPECT_TRUE(ZoneGoal(robots[0], FLOOR).isFor(*RigidRobot::disc("larger", 0.5, FLOOR)));
}

TEST(ZoneGoal, RefusesWhatMakesNoSense)
{
    const RobotPtr robot = RigidRobot::inR2("robot", Body::disc(0.1), FLOOR);
    const auto messageAbout = [](const RobotPtr &owner, const ob::RealVectorBounds &box)
    { return messageOf([&] { ZoneGoal(owner, box); }); };
    EXPECT_NE(messageAbout(robot, HALL).find("robot: goal: the box must have 2 dimensions"), std::string::npos);
    EXPECT_NE(messageAbout(robot, boxOf({0.0, 1.0}, {1.0, 0.0})).find("no lower end above"), std::string::npos);
    EXPECT_NE(messageAbout(robot, boxOf({0.0, 0.0}, {1.0, NAN})).find("must be finite"), std::string::npos);
    EXPECT_NE(messageAbout(robot, boxOf({5.0, 11.0}, {6.0, 12.0})).find("out of the bounds"), std::string::npos);
    EXPECT_NE(messageAbout(nullptr, FLOOR).find("must not be null"), std::string::npos);
    // A line is a box as well.
    EXPECT_NO_THROW(ZoneGoal(robot, boxOf({7.0, 0.0}, {7.0, 10.0})));
    const auto arm = std::make_shared<Arm>("arm", sevenJoints(), SEVEN);
    EXPECT_NE(messageAbout(arm, HALL).find("arm: goal: the state of an arm is no position"), std::string::npos);
}
