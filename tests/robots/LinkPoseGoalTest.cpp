#include "support/RandomTrees.h"

#include "ompl_certificates/robots/LinkPoseGoal.h"
#include "support/Message.h"
#include "support/Quiet.h"
#include "support/Teams.h"

#include <gtest/gtest.h>
#include <ompl/base/ScopedState.h>
#include <ompl/util/Exception.h>
#include <thread>

using namespace ompl_certificates;
using namespace ompl_certificates::test;
namespace ob = ompl::base;

namespace
{
    using JointType = KinematicTree::JointType;

    std::shared_ptr<const Arm> sevenJointArm()
    {
        return std::make_shared<Arm>("arm", sevenJoints(), SEVEN);
    }

    /** Sample \e goal some times, and expect what is found to be in the goal and within the bounds.
        \return how often something was found */
    int countSamples(const LinkPoseGoal &goal, const Arm &arm, int samples, std::uint_fast32_t seed = 1)
    {
        ompl::RNG random(seed);
        ob::ScopedState<> state(arm.getStateSpace());
        int found = 0;
        for (int i = 0; i < samples; ++i)
            if (goal.sample(random, state.get()))
            {
                ++found;
                EXPECT_EQ(goal.distance(state.get()), 0.0) << "seed " << seed;
                EXPECT_TRUE(arm.getStateSpace()->satisfiesBounds(state.get())) << "seed " << seed;
            }
        return found;
    }

    /** The angle between two rotations */
    double angleBetween(const Pose &a, const Pose &b)
    {
        return Eigen::AngleAxisd(a.linear().transpose() * b.linear()).angle();
    }

    LinkPose poseOf(const Arm &arm, const ob::State *state, const std::string &link)
    {
        const Pose pose = arm.getLinkPose(state, link);
        LinkPose result{link};
        result.position = LinkPose::Position{pose.translation()};
        result.rotation = LinkPose::Rotation{pose.linear()};
        return result;
    }
}

TEST(LinkPoseGoal, IsForArmsThatHaveTheLinkAtTheSamePlaces)
{
    LinkPose pose{"link7"};
    pose.position = LinkPose::Position{Eigen::Vector3d(0.2, 0.0, 0.7)};
    const auto arm = sevenJointArm();
    const LinkPoseGoal goal(arm, pose);
    EXPECT_TRUE(goal.isFor(*arm));
    // The arm made anew, with something in its hand
    KinematicTree tree = sevenJoints();
    KinematicTree::Joint fixed;
    fixed.name = "grasp";
    tree.addLink("link7", fixed, "part", Body::sphere(0.05));
    EXPECT_TRUE(goal.isFor(Arm("loaded", tree, SEVEN)));
    ArmOptions elsewhere;
    elsewhere.base = poseAt({0.0, 0.01, 0.0});
    EXPECT_FALSE(goal.isFor(Arm("elsewhere", sevenJoints(), SEVEN, elsewhere)));
    EXPECT_FALSE(goal.isFor(Arm("shorter", sevenJoints(), {SEVEN.begin(), SEVEN.end() - 1})));
    EXPECT_FALSE(goal.isFor(*RigidRobot::sphere("ball", 0.1, cubeBounds(3, 1.0))));
    const LinkPoseGoal ofLoaded(std::make_shared<Arm>("loaded", tree, SEVEN),
                                LinkPose{"part", {0, 0, 0}, pose.position});
    EXPECT_FALSE(ofLoaded.isFor(*arm));
}

TEST(LinkPoseGoal, FindsThePosesOfRandomStates)
{
    const auto arm = sevenJointArm();
    ompl::RNG::setSeed(1);
    auto sampler = arm->getStateSpace()->allocStateSampler();
    ob::ScopedState<> state(arm->getStateSpace()), found(arm->getStateSpace());
    ompl::RNG random(1);
    int misses = 0;
    for (int i = 0; i < 200; ++i)
    {
        sampler->sampleUniform(state.get());
        const LinkPoseGoal goal(arm, poseOf(*arm, state.get(), "link7"));
        EXPECT_EQ(goal.distance(state.get()), 0.0);
        if (!goal.sample(random, found.get()))
        {
            ++misses;
            continue;
        }
        EXPECT_EQ(goal.distance(found.get()), 0.0);
        EXPECT_TRUE(arm->getStateSpace()->satisfiesBounds(found.get()));
        const Pose wanted = arm->getLinkPose(state.get(), "link7"), is = arm->getLinkPose(found.get(), "link7");
        EXPECT_LT((wanted.translation() - is.translation()).norm(), std::sqrt(3.0) * 1e-3);
        EXPECT_LT(angleBetween(wanted, is), std::sqrt(3.0) * 1e-2 + 1e-4);
    }
    EXPECT_LE(misses, 4);
}

/** A search that began elsewhere would find another posture of the arm. */
TEST(LinkPoseGoal, IsReachedAlongALineWithoutJumps)
{
    const auto arm = sevenJointArm();
    const ob::StateSpacePtr &space = arm->getStateSpace();
    Random random(1);
    ob::ScopedState<> state(space), before(space);
    int lines = 0;
    for (int i = 0; i < 100; ++i)
    {
        std::vector<double> values(SEVEN.size());
        for (double &value : values)
            value = random.uniform(0.3, 1.5) * random.sign();
        state = values;
        LinkPose pose = poseOf(*arm, state.get(), "link7");
        EXPECT_TRUE(LinkPoseGoal(arm, pose).reach(state.get()));
        EXPECT_EQ(state.reals(), values) << "A state of the goal stays as it is.";
        const Eigen::Vector3d step = 0.005 * random.direction(3);
        for (int steps = 1; steps <= 20; ++steps)
        {
            pose.position->point += step;
            const LinkPoseGoal goal(arm, pose);
            before = state;
            if (!goal.reach(state.get()))
                break;
            EXPECT_EQ(goal.distance(state.get()), 0.0);
            EXPECT_TRUE(space->satisfiesBounds(state.get()));
            EXPECT_LT(space->distance(before.get(), state.get()), 0.5) << "line " << i << ", step " << steps;
            lines += steps == 20 ? 1 : 0;
        }
    }
    // Others leave the reach of the posture.
    EXPECT_GE(lines, 70);
    LinkPose far = poseOf(*arm, state.get(), "link7");
    far.position->point.x() += 100.0;
    EXPECT_FALSE(LinkPoseGoal(arm, far).reach(state.get()));
}

/** The others must do what a joint at its limit cannot. */
TEST(LinkPoseGoal, FindsPosesWithJointsAtTheirLimits)
{
    std::vector<double> values(7);
    KinematicTree tree("base");
    std::string parent = "base";
    for (std::size_t i = 0; i < SEVEN.size(); ++i)
    {
        const Eigen::Vector3d axis = i % 2 == 0 ? Eigen::Vector3d::UnitZ() : Eigen::Vector3d::UnitY();
        const std::string link = "link" + std::to_string(i + 1);
        tree.addLink(parent, joint(SEVEN[i], JointType::REVOLUTE, {0.1, 0.0, 0.3}, axis, -1.0, 1.0), link,
                     Body::sphere(0.05));
        parent = link;
    }
    const auto arm = std::make_shared<Arm>("arm", tree, SEVEN);
    Random random(1);
    ob::ScopedState<> state(arm->getStateSpace());
    int found = 0;
    for (int i = 0; i < 100; ++i)
    {
        for (std::size_t k = 0; k < values.size(); ++k)
            values[k] = k < 5 ? random.sign() : random.uniform(-1.0, 1.0);
        state = values;
        found += countSamples(LinkPoseGoal(arm, poseOf(*arm, state.get(), "link7")), *arm, 1);
    }
    EXPECT_GE(found, 99);
}

TEST(LinkPoseGoal, TellsWhatIsBeyondTheTolerances)
{
    const auto arm = sevenJointArm();
    ob::ScopedState<> state(arm->getStateSpace());
    state = std::vector<double>{0.3, -0.4, 0.5, 0.6, -0.7, 0.8, 0.9};
    LinkPose pose = poseOf(*arm, state.get(), "link7");
    const Eigen::Matrix3d rotation = pose.rotation->rotation;
    pose.position->point += Eigen::Vector3d(0.0, 0.3, 0.0);
    pose.position->tolerance = Eigen::Vector3d(0.1, 0.1, 0.1);
    EXPECT_NEAR(LinkPoseGoal(arm, pose).distance(state.get()), 0.2, 1e-12);
    // The tolerance along the axis that is y turned by a quarter
    pose.position->axes = Eigen::AngleAxisd(0.5 * M_PI, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    pose.position->tolerance = Eigen::Vector3d(0.3 + 1e-12, 0.001, 0.001);
    EXPECT_EQ(LinkPoseGoal(arm, pose).distance(state.get()), 0.0);
    pose.position->tolerance = Eigen::Vector3d(0.001, 0.3 + 1e-12, 0.001);
    EXPECT_NEAR(LinkPoseGoal(arm, pose).distance(state.get()), 0.299, 1e-12);
    // The link is turned by 0.4 about the z axis of the goal.
    pose.position.reset();
    pose.rotation->rotation = rotation * Eigen::AngleAxisd(-0.4, Eigen::Vector3d::UnitZ());
    pose.rotation->tolerance = Eigen::Vector3d(0.1, 0.1, 0.1);
    EXPECT_NEAR(LinkPoseGoal(arm, pose).distance(state.get()), 0.3, 1e-12);
    pose.rotation->tolerance.z() = 0.4 + 1e-9;
    EXPECT_EQ(LinkPoseGoal(arm, pose).distance(state.get()), 0.0);
    // The point of the link, not its origin
    LinkPose point{"link7"};
    point.point = Eigen::Vector3d(0.1, 0.2, 0.3);
    point.position = LinkPose::Position{arm->getLinkPose(state.get(), "link7") * point.point};
    EXPECT_EQ(LinkPoseGoal(arm, point).distance(state.get()), 0.0);
}

/** Any turn about one axis is allowed, also those that Euler angles write in two ways. */
TEST(LinkPoseGoal, IsNotReachedBeyondTheLimitsOfAJoint)
{
    KinematicTree tree("base");
    tree.addLink("base", joint("turn", JointType::REVOLUTE, {0, 0, 0}, Eigen::Vector3d::UnitZ(), -1.0, 1.0), "link",
                 Body::sphere(0.1));
    const auto arm = std::make_shared<const Arm>("arm", tree, std::vector<std::string>{"turn"}, ArmOptions{});
    ob::ScopedState<> state(arm->getStateSpace());
    for (const double angle : {0.9, 1.2})
    {
        LinkPose pose{"link"};
        pose.rotation = LinkPose::Rotation{planarPose(0.0, 0.0, angle).linear()};
        // The state has the pose already.
        state[0] = angle;
        EXPECT_EQ(LinkPoseGoal(arm, pose).reach(state.get()), angle < 1.0) << angle;
    }
}

TEST(LinkPoseGoal, LeavesTurnsFree)
{
    const auto arm = sevenJointArm();
    ob::ScopedState<> state(arm->getStateSpace());
    state = std::vector<double>{0.3, -0.4, 0.5, 0.6, -0.7, 0.8, 0.9};
    for (int axis = 0; axis < 3; ++axis)
        for (const double angle : {-3.0, -2.0, -0.5 * M_PI, -1.0, 0.0, 1.0, 0.5 * M_PI, 2.0, 3.0})
        {
            LinkPose pose = poseOf(*arm, state.get(), "link7");
            const Eigen::Matrix3d turn = Eigen::AngleAxisd(angle, Eigen::Vector3d::Unit(axis)).toRotationMatrix();
            pose.rotation->rotation = pose.rotation->rotation * turn;
            pose.rotation->tolerance[axis] = M_PI;
            EXPECT_EQ(LinkPoseGoal(arm, pose).distance(state.get()), 0.0) << axis << " " << angle;
            // Tilts are told from the free turn.
            const Eigen::Vector3d across = Eigen::Vector3d::Unit((axis + 1) % 3);
            for (const Eigen::Vector3d &tilt : {across, Eigen::Vector3d(turn.transpose() * across)})
            {
                LinkPose tilted = pose;
                tilted.rotation->rotation *= Eigen::AngleAxisd(0.1, tilt).toRotationMatrix();
                EXPECT_NEAR(LinkPoseGoal(arm, tilted).distance(state.get()), 0.09, 0.04) << axis << " " << angle;
            }
            pose.rotation->tolerance[axis] = std::abs(angle) + 1e-9;
            EXPECT_EQ(LinkPoseGoal(arm, pose).distance(state.get()), 0.0) << axis << " " << angle;
            if (angle == 0.0)
                continue;
            pose.rotation->tolerance[axis] = 0.5 * std::abs(angle);
            EXPECT_GT(LinkPoseGoal(arm, pose).distance(state.get()), 0.4) << axis << " " << angle;
        }
}

TEST(LinkPoseGoal, SpreadsOverTheTolerances)
{
    const auto arm = sevenJointArm();
    ob::ScopedState<> state(arm->getStateSpace());
    state = std::vector<double>{0.3, -0.4, 0.5, 0.6, -0.7, 0.8, 0.9};
    LinkPose pose = poseOf(*arm, state.get(), "link7");
    pose.position->tolerance.setConstant(0.05);
    pose.rotation->tolerance = Eigen::Vector3d(0.01, 0.01, 4.0);
    const LinkPoseGoal goal(arm, pose);
    ompl::RNG random(3);
    Eigen::AlignedBox3d points;
    double largest = 0.0;
    for (int i = 0; i < 100; ++i)
        if (goal.sample(random, state.get()))
        {
            const Pose link = arm->getLinkPose(state.get(), "link7");
            points.extend(link.translation() - pose.position->point);
            Pose wanted = Pose::Identity();
            wanted.linear() = pose.rotation->rotation;
            largest = std::max(largest, angleBetween(wanted, link));
        }
    EXPECT_GT(points.sizes().minCoeff(), 0.05);
    EXPECT_LE(points.sizes().maxCoeff(), 0.1 + 1e-12);
    EXPECT_GT(largest, 2.0);
}

/** Arms with all kinds of joints, mimics too */
TEST(LinkPoseGoal, FindsPosesOfAnyTree)
{
    const Quiet quiet;
    int goals = 0, found = 0;
    for (std::uint_fast32_t seed = 1; seed <= 40; ++seed)
    {
        ompl::RNG::setSeed(seed);
        const auto arm = RandomTree(static_cast<unsigned int>(seed), 8).make("arm");
        auto sampler = arm->getStateSpace()->allocStateSampler();
        ob::ScopedState<> state(arm->getStateSpace());
        sampler->sampleUniform(state.get());
        for (const auto &link : arm->getTree().getLinks())
            if (arm->moves(link.name))
            {
                ++goals;
                found += countSamples(LinkPoseGoal(arm, poseOf(*arm, state.get(), link.name)), *arm, 1, seed);
            }
    }
    EXPECT_GT(goals, 50);
    EXPECT_GT(found, 0.95 * goals) << "of " << goals;
}

TEST(LinkPoseGoal, GivesUpBeyondTheReach)
{
    const auto arm = sevenJointArm();
    LinkPose pose{"link7"};
    pose.position = LinkPose::Position{Eigen::Vector3d(3.0, 0.0, 0.0)};
    const LinkPoseGoal goal(arm, pose);
    EXPECT_EQ(countSamples(goal, *arm, 3), 0);
    ob::ScopedState<> state(arm->getStateSpace());
    state = std::vector<double>(7, 0.0);
    EXPECT_GT(goal.distance(state.get()), 1.0);
}

TEST(LinkPoseGoal, RefusesWhatMakesNoSense)
{
    const auto arm = sevenJointArm();
    LinkPose good{"link7"};
    good.position = LinkPose::Position{Eigen::Vector3d::Zero()};
    good.rotation = LinkPose::Rotation{Eigen::Matrix3d::Identity()};
    EXPECT_NO_THROW(LinkPoseGoal(arm, good));
    const auto expectRefusal = [&](const std::function<void(LinkPose &)> &spoil, const std::string &part)
    {
        LinkPose bad = good;
        spoil(bad);
        const std::string message = messageOf([&] { LinkPoseGoal(arm, bad); });
        EXPECT_NE(message.find("arm"), std::string::npos) << message;
        EXPECT_NE(message.find(part), std::string::npos) << message << " without " << part;
    };
    expectRefusal([](LinkPose &pose) { pose.link = "leg"; }, "'leg': there is no such link");
    expectRefusal([](LinkPose &pose) { pose.link = "base"; }, "'base': the arm does not move this link");
    expectRefusal(
        [](LinkPose &pose)
        {
            pose.position.reset();
            pose.rotation.reset();
        },
        "must have a position, a rotation or both");
    expectRefusal([](LinkPose &pose) { pose.position->point.x() = NAN; }, "finite");
    expectRefusal([](LinkPose &pose) { pose.point.x() = HUGE_VAL; }, "finite");
    expectRefusal([](LinkPose &pose) { pose.position->tolerance.x() = 0.0; }, "position tolerance");
    expectRefusal([](LinkPose &pose) { pose.rotation->tolerance.x() = NAN; }, "rotation tolerance");
    expectRefusal([](LinkPose &pose) { pose.rotation->rotation *= 2.0; }, "rotation");
    expectRefusal([](LinkPose &pose) { pose.position->axes.col(0) *= -1.0; }, "axes");
    EXPECT_NE(messageOf([&] { LinkPoseGoal(nullptr, good); }).find("must not be null"), std::string::npos);
}

TEST(LinkPoseGoal, RefusesPosesOutOfThePlaneOfAPlanarArm)
{
    KinematicTree tree("base");
    tree.addLink("base", joint("joint1", JointType::CONTINUOUS, {0.0, 0.0, 0.0}), "link", Body::disc(0.1));
    const auto arm = std::make_shared<Arm>("arm", tree, std::vector<std::string>{"joint1"});
    LinkPose good{"link"};
    good.position = LinkPose::Position{Eigen::Vector3d::Zero()};
    good.rotation = LinkPose::Rotation{planarPose(0.0, 0.0, 0.7).linear()};
    EXPECT_NO_THROW(LinkPoseGoal(arm, good));
    LinkPose bad = good;
    bad.position->point.z() = 1.0;
    EXPECT_NE(messageOf([&] { LinkPoseGoal(arm, bad); }).find("z = 0"), std::string::npos);
    bad = good;
    bad.rotation->rotation *= Eigen::AngleAxisd(0.1, Eigen::Vector3d::UnitX()).toRotationMatrix();
    EXPECT_NE(messageOf([&] { LinkPoseGoal(arm, bad); }).find("turns about z alone"), std::string::npos);
}

/** A robot's goal is made while others sample one: run with the thread sanitizer. */
TEST(LinkPoseGoal, IsMadeWhileOthersAreSampled)
{
    const auto arm = sevenJointArm();
    LinkPose pose{"link7"};
    pose.position = LinkPose::Position{Eigen::Vector3d(0.2, 0.0, 0.6)};
    const LinkPoseGoal goal(arm, pose);
    std::thread maker(
        [&]
        {
            for (int i = 0; i < 2000; ++i)
                LinkPoseGoal(arm, pose);
        });
    EXPECT_EQ(countSamples(goal, *arm, 50), 50);
    maker.join();
}
