#include "support/RandomTrees.h"
#include "support/Teams.h"

#include <gtest/gtest.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;

namespace
{
    RobotPtr car(const std::string &name, double hitch, double half = HALF, bool selfCollision = false)
    {
        return std::make_shared<CarWithTrailer>(name, Body::box(0.4, 0.2), Body::box(0.3, 0.2), hitch,
                                                cubeBounds(2, half), selfCollision);
    }
}

TEST(LikeRobots, HaveEqualBodiesAndSpaces)
{
    const auto bounds = cubeBounds(2, HALF);
    const RobotPtr disc = RigidRobot::disc("disc", 0.3, bounds);
    EXPECT_TRUE(disc->isLike(*disc));
    EXPECT_TRUE(disc->isLike(*RigidRobot::disc("other", 0.3, bounds)));
    EXPECT_FALSE(disc->isLike(*RigidRobot::disc("larger", 0.4, bounds)));
    EXPECT_FALSE(disc->isLike(*RigidRobot::disc("elsewhere", 0.3, cubeBounds(2, 2.0 * HALF))));
    for (const unsigned int axis : {0U, 1U})
    {
        auto lower = bounds, higher = bounds;
        lower.low[axis] -= 1.0;
        higher.high[axis] += 1.0;
        EXPECT_FALSE(disc->isLike(*RigidRobot::disc("lower", 0.3, lower)));
        EXPECT_FALSE(disc->isLike(*RigidRobot::disc("higher", 0.3, higher)));
    }
    EXPECT_FALSE(disc->isLike(*RigidRobot::inSE2("turning", Body::disc(0.3), bounds)));
    const RobotPtr box = RigidRobot::inSE2("box", Body::box(0.5, 0.2), bounds);
    EXPECT_TRUE(box->isLike(*RigidRobot::inSE2("other", Body::box(0.5, 0.2), bounds)));
    EXPECT_FALSE(box->isLike(*RigidRobot::inSE2("upright", Body::box(0.2, 0.5), bounds)));
    EXPECT_FALSE(box->isLike(*disc));

    const Body body = Body::box(0.5, 0.2);
    const RobotPtr driver = RigidRobot::inReedsShepp("driver", body, 1.0, bounds);
    EXPECT_TRUE(driver->isLike(*RigidRobot::inReedsShepp("other", body, 1.0, bounds)));
    EXPECT_FALSE(driver->isLike(*RigidRobot::inReedsShepp("wider", body, 2.0, bounds)));
    EXPECT_FALSE(driver->isLike(*box));

    EXPECT_TRUE(car("car", 0.5)->isLike(*car("other", 0.5)));
    EXPECT_FALSE(car("car", 0.5)->isLike(*car("longer", 0.6)));
    EXPECT_FALSE(car("car", 0.5)->isLike(*car("elsewhere", 0.5, 2.0 * HALF)));
    EXPECT_FALSE(car("car", 0.5)->isLike(*car("careful", 0.5, HALF, true)));
    EXPECT_TRUE(car("careful", 0.5, HALF, true)->isLike(*car("another", 0.5, HALF, true)));
    EXPECT_FALSE(car("car", 0.5)->isLike(*box));
    EXPECT_FALSE(box->isLike(*car("car", 0.5)));
}

TEST(LikeRobots, AreNotSoIfTheirWeightsDiffer)
{
    const auto bounds = cubeBounds(2, HALF);
    const RobotPtr a = RigidRobot::inSE2("a", Body::box(0.5, 0.2), bounds);
    const RobotPtr b = RigidRobot::inSE2("b", Body::box(0.5, 0.2), bounds);
    ASSERT_TRUE(a->isLike(*b));
    b->getStateSpace()->as<ompl::base::CompoundStateSpace>()->setSubspaceWeight(1, 3.0);
    EXPECT_FALSE(a->isLike(*b));
}

TEST(LikeRobots, HaveJointsThatFollowAlike)
{
    const auto follower = [](double multiplier, double offset)
    {
        KinematicTree tree("base", Body::sphere(0.1));
        tree.addLink("base", joint("leader", KinematicTree::JointType::REVOLUTE, {0, 0, 0}), "link");
        auto follows = joint("follower", KinematicTree::JointType::REVOLUTE, {0.3, 0, 0});
        follows.mimic = KinematicTree::Mimic{"leader", multiplier, offset};
        tree.addLink("link", follows, "tip", Body::sphere(0.1));
        return tree;
    };
    const auto armOf = [](const KinematicTree &tree)
    { return std::make_shared<Arm>("arm", tree, std::vector<std::string>{"leader"}, ArmOptions{}); };
    const KinematicTree tree = follower(1.0, 0.0);
    EXPECT_TRUE(tree == follower(1.0, 0.0));
    EXPECT_TRUE(armOf(tree)->isLike(*armOf(follower(1.0, 0.0))));
    for (const KinematicTree &other : {follower(2.0, 0.0), follower(1.0, 0.5)})
    {
        EXPECT_FALSE(tree == other);
        EXPECT_FALSE(armOf(tree)->isLike(*armOf(other)));
    }
}
