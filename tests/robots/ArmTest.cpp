#include "support/RandomTrees.h"

#include "ompl_certificates/robots/Arm.h"
#include "ompl_certificates/robots/CheckRobot.h"

#include <gtest/gtest.h>
#include <ompl/base/ScopedState.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/base/spaces/SE3StateSpace.h>
#include <ompl/util/Exception.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;
namespace ob = ompl::base;

namespace
{
    using Joint = KinematicTree::Joint;
    using JointType = KinematicTree::JointType;

    /** Where each link is, joint by joint, by Eigen's transforms */
    std::map<std::string, Pose> linkPoses(const KinematicTree &tree, const Pose &base,
                                          const std::map<std::string, std::vector<double>> &values)
    {
        std::map<std::string, Pose> poses{{tree.getLinks().front().name, base}};
        for (std::size_t i = 1; i < tree.getLinks().size(); ++i)
        {
            const auto &link = tree.getLinks()[i];
            const Joint &j = link.joint;
            std::vector<double> value{0, 0, 0, 0, 0, 0, 1};
            const auto given = values.find(j.mimic ? j.mimic->joint : j.name);
            if (given != values.end())
                value = given->second;
            if (j.mimic)
                value = {j.mimic->multiplier * value.front() + j.mimic->offset};
            Eigen::Affine3d pose(poses.at(tree.getLinks()[link.parent].name).matrix());
            pose = pose * Eigen::Affine3d(j.origin.matrix());
            if (j.type == JointType::REVOLUTE || j.type == JointType::CONTINUOUS)
                pose.rotate(Eigen::AngleAxisd(value[0], j.axis.normalized()));
            else if (j.type == JointType::PRISMATIC)
                pose.translate(value[0] * j.axis.normalized());
            else if (j.type == JointType::PLANAR)  // the axis is z in these tests
                pose.translate(Eigen::Vector3d(value[0], value[1], 0.0)).rotate(Eigen::AngleAxisd(value[2], j.axis));
            else if (j.type == JointType::FLOATING)
                pose.translate(Eigen::Vector3d(value[0], value[1], value[2]))
                    .rotate(Eigen::Quaterniond(value[6], value[3], value[4], value[5]));
            poses[link.name].matrix() = pose.matrix();
        }
        return poses;
    }

    /** The coordinates of \e state by the joints of the group of \e arm */
    std::map<std::string, std::vector<double>> valuesOf(const Arm &arm, const ob::State *state)
    {
        std::vector<double> reals;
        arm.getStateSpace()->copyToReals(reals, state);
        std::map<std::string, std::vector<double>> values;
        auto next = reals.begin();
        for (const std::string &name : arm.getGroup())
        {
            const JointType type = arm.getTree().getLinks()[arm.getTree().getChildOf(name)].joint.type;
            const int count = type == JointType::PLANAR ? 3 : type == JointType::FLOATING ? 7 : 1;
            values[name].assign(next, next + count);
            next += count;
        }
        EXPECT_EQ(next, reals.end());
        return values;
    }

    /** Whether the arm's links and bodies are where linkPoses() says, in random states */
    void expectPoses(const Arm &arm, const ArmOptions &options, int states = 20)
    {
        arm.getStateSpace()->setup();
        auto sampler = arm.getStateSpace()->allocStateSampler();
        ob::ScopedState<> state(arm.getStateSpace());
        for (int i = 0; i < states; ++i)
        {
            sampler->sampleUniform(state.get());
            auto values = valuesOf(arm, state.get());
            for (const auto &[name, value] : options.jointValues)
                values[name] = {value};
            const auto expected = linkPoses(arm.getTree(), options.base, values);
            for (const auto &[link, pose] : expected)
                EXPECT_LT((arm.getLinkPose(state.get(), link).matrix() - pose.matrix()).norm(), 1e-12) << link;
            std::vector<Pose> poses(arm.getBodies().size());
            arm.computePoses(state.get(), poses.data());
            for (std::size_t k = 0; k < poses.size(); ++k)
            {
                // The frames differ, the shapes must not.
                const std::string &link = arm.getLinkOfBody(k);
                const Body &own = *arm.getTree().getLinks()[arm.getTree().getLinkIndex(link)].body;
                for (std::size_t part = 0; part < own.getParts().size(); ++part)
                {
                    const Pose is = poses[k] * arm.getBodies()[k].getParts()[part].pose,
                               shall = expected.at(link) * own.getParts()[part].pose;
                    EXPECT_LT((is.matrix() - shall.matrix()).norm(), 1e-12) << link;
                }
            }
        }
    }
}

TEST(Arm, PosesAreThoseOfChainedTransforms)
{
    ompl::RNG::setSeed(11);
    for (unsigned int seed = 1; seed <= scaled(60); ++seed)
    {
        RandomTree random(seed, 2 + seed % 14);
        const Arm arm("arm", random.tree, random.group, random.options);
        expectPoses(arm, random.options);
        EXPECT_NO_THROW(checkRobot(arm, 60)) << "seed " << seed;
    }
}

TEST(Arm, SpaceIsPlainWithoutContinuousJoints)
{
    const Arm arm("arm", sevenJoints(), SEVEN);
    const auto *space = dynamic_cast<const ob::RealVectorStateSpace *>(arm.getStateSpace().get());
    ASSERT_NE(space, nullptr);
    EXPECT_EQ(space->getDimension(), 7u);
    EXPECT_EQ(space->getBounds().low, std::vector<double>(7, -2.0));
    EXPECT_EQ(space->getDimensionName(3), "joint4");
    EXPECT_EQ(space->getName(), "arm");
    EXPECT_EQ(arm.getBodies().size(), 8u);
    EXPECT_EQ(arm.getLinkOfBody(0), "base");
    EXPECT_EQ(arm.getGroup(), SEVEN);
}

TEST(Arm, ContinuousPlanarAndFloatingJointsHaveTheirSpaces)
{
    KinematicTree tree("world");
    tree.addLink("world", joint("drive", JointType::PLANAR, {0, 0, 0}), "cart", Body::box(0.6, 0.4, 0.2));
    tree.addLink("cart", joint("turn", JointType::CONTINUOUS, {0.1, 0, 0.1}), "tower", Body::box(0.1, 0.1, 0.5));
    tree.addLink("tower", joint("lift", JointType::PRISMATIC, {0, 0, 0.2}, {0, 0, 1}, 0.0, 0.4), "fork",
                 Body::box(0.4, 0.05, 0.05));
    tree.addLink("fork", joint("tilt", JointType::REVOLUTE, {0.2, 0, 0}, {0, 1, 0}), "tip", Body::sphere(0.05));
    tree.addLink("world", joint("fly", JointType::FLOATING, {0, 0, 1}), "drone", Body::box(0.3, 0.3, 0.1));
    ArmOptions options;
    options.bounds = ob::RealVectorBounds(3);
    options.bounds->setLow(-3.0);
    options.bounds->setHigh(3.0);
    ompl::RNG::setSeed(5);
    const Arm arm("mobile", tree, {"drive", "turn", "lift", "tilt", "fly"}, options);
    const auto *space = arm.getStateSpace()->as<ob::CompoundStateSpace>();
    ASSERT_EQ(space->getSubspaceCount(), 4u);
    EXPECT_TRUE(dynamic_cast<const ob::SE2StateSpace *>(space->getSubspace(0).get()));
    EXPECT_TRUE(dynamic_cast<const ob::SO2StateSpace *>(space->getSubspace(1).get()));
    EXPECT_EQ(space->getSubspace(2)->getDimension(), 2u);
    EXPECT_TRUE(dynamic_cast<const ob::SE3StateSpace *>(space->getSubspace(3).get()));
    expectPoses(arm, options, 200);
    EXPECT_NO_THROW(checkRobot(arm, scaled(3000)));
    options.bounds.reset();
    EXPECT_THROW(Arm("mobile", tree, {"drive"}, options), ompl::Exception);
}

TEST(Arm, PlannersStepAnEighthOfHalfATurnForEachJoint)
{
    // Limits of +-2 are wider than half a turn.
    EXPECT_NEAR(Arm("arm", sevenJoints(), SEVEN).getPlannerRange(), 0.125 * M_PI * std::sqrt(7.0), 1e-12);

    KinematicTree tree("world");
    tree.addLink("world", joint("lift", JointType::PRISMATIC, {0, 0, 0}, {0, 0, 1}, 0.0, 4.0), "a", Body::sphere(0.1));
    tree.addLink("a", joint("narrow", JointType::REVOLUTE, {1, 0, 0}, {0, 0, 1}, 0.0, 3.0), "b", Body::sphere(0.1));
    tree.addLink("b", joint("turn", JointType::CONTINUOUS, {1, 0, 0}), "c", Body::sphere(0.1));
    tree.addLink("c", joint("wide", JointType::REVOLUTE, {1, 0, 0}, {0, 0, 1}, -9.0, 9.0), "d", Body::sphere(0.1));
    const Arm plain("plain", tree, {"lift", "narrow"});
    EXPECT_DOUBLE_EQ(plain.getPlannerRange(), 0.125 * 5.0);
    EXPECT_DOUBLE_EQ(plain.Robot::getPlannerRange(), 0.2 * 5.0);
    // As the space does it, its three components add up.
    const Arm mixed("mixed", tree, {"lift", "narrow", "turn", "wide"});
    EXPECT_DOUBLE_EQ(mixed.getPlannerRange(), 0.125 * (5.0 + M_PI + M_PI));
    EXPECT_DOUBLE_EQ(mixed.Robot::getPlannerRange(), 0.2 * (5.0 + M_PI + 18.0));
}

TEST(Arm, OtherJointsKeepTheirValuesWithinLimits)
{
    KinematicTree tree = sevenJoints();
    tree.addLink("link7", joint("finger", JointType::PRISMATIC, {0, 0, 0.1}, {0, 1, 0}, 0.02, 0.08), "left",
                 Body::box(0.01, 0.02, 0.05));
    Joint other = joint("other", JointType::PRISMATIC, {0, 0, 0.1}, {0, -1, 0}, 0.0, 0.08);
    other.mimic = KinematicTree::Mimic{"finger", 1.0, 0.0};
    tree.addLink("link7", other, "right", Body::box(0.01, 0.02, 0.05));
    const auto yOf = [&](const ArmOptions &options, const std::string &link)
    {
        const Arm arm("arm", tree, SEVEN, options);
        ob::ScopedState<> state(arm.getStateSpace());
        state = std::vector<double>(7, 0.0);
        return arm.getLinkPose(state.get(), link).translation().y();
    };
    ArmOptions options;
    EXPECT_DOUBLE_EQ(yOf(options, "left"), 0.02);
    EXPECT_DOUBLE_EQ(yOf(options, "right"), -0.02);
    options.jointValues["finger"] = 0.05;
    EXPECT_DOUBLE_EQ(yOf(options, "left"), 0.05);
    EXPECT_DOUBLE_EQ(yOf(options, "right"), -0.05);
}

TEST(Arm, LinksThatTheGroupDoesNotMoveStandStill)
{
    const Arm arm("arm", sevenJoints(), {"joint4", "joint5"});
    ob::ScopedState<> from(arm.getStateSpace()), to(arm.getStateSpace());
    from = std::vector<double>{-1.0, 0.5};
    to = std::vector<double>{1.0, -1.5};
    std::vector<MotionBound> bounds(arm.getBodies().size());
    arm.computeMotionBounds(from.get(), to.get(), bounds.data());
    std::vector<Pose> a(bounds.size()), b(bounds.size());
    arm.computePoses(from.get(), a.data());
    arm.computePoses(to.get(), b.data());
    for (std::size_t i = 0; i < bounds.size(); ++i)
    {
        EXPECT_EQ(i < 4, bounds[i].linear == 0.0 && bounds[i].angular == 0.0) << i;
        EXPECT_EQ(i < 4, a[i].matrix() == b[i].matrix()) << i;
    }
}

TEST(Arm, TreesAndGroupsThatMakeNoSenseAreRefused)
{
    KinematicTree tree("base", Body::sphere(0.1));
    const auto add = [&](const Joint &j, const std::string &name) { tree.addLink("base", j, name, Body::sphere(0.1)); };
    const double nan = std::nan("");
    EXPECT_THROW(KinematicTree(""), ompl::Exception);
    EXPECT_THROW(tree.addLink("nowhere", joint("j", JointType::FIXED, {0, 0, 0}), "l"), ompl::Exception);
    EXPECT_THROW(add(joint("j", JointType::FIXED, {0, 0, 0}), "base"), ompl::Exception);
    EXPECT_THROW(add(joint("", JointType::FIXED, {0, 0, 0}), "l"), ompl::Exception);
    EXPECT_THROW(add(joint("j", JointType::FIXED, {0, 0, nan}), "l"), ompl::Exception);
    EXPECT_THROW(add(joint("j", JointType::REVOLUTE, {0, 0, 0}, {0, 0, 0}), "l"), ompl::Exception);
    EXPECT_THROW(add(joint("j", JointType::REVOLUTE, {0, 0, 0}, {0, nan, 0}), "l"), ompl::Exception);
    EXPECT_THROW(add(joint("j", JointType::REVOLUTE, {0, 0, 0}, {0, 0, 1}, 1.0, -1.0), "l"), ompl::Exception);
    EXPECT_THROW(add(joint("j", JointType::PRISMATIC, {0, 0, 0}, {0, 0, 1}, nan, 1.0), "l"), ompl::Exception);
    add(joint("fixed", JointType::FIXED, {0, 0, 0}), "a");
    add(joint("free", JointType::REVOLUTE, {0, 0, 0}), "b");
    add(joint("stuck", JointType::REVOLUTE, {0, 0, 0}, {0, 0, 1}, 1.0, 1.0), "c");
    EXPECT_THROW(add(joint("free", JointType::FIXED, {0, 0, 0}), "d"), ompl::Exception);
    EXPECT_NO_THROW(Arm("arm", tree, {"free"}));
    EXPECT_THROW(Arm("arm", tree, {}), ompl::Exception);
    EXPECT_THROW(Arm("arm", tree, {"fixed"}), ompl::Exception);
    EXPECT_THROW(Arm("arm", tree, {"stuck"}), ompl::Exception);
    EXPECT_THROW(Arm("arm", tree, {"unknown"}), ompl::Exception);
    EXPECT_THROW(Arm("arm", tree, {"free", "free"}), ompl::Exception);
    ArmOptions options;
    options.jointValues["free"] = nan;
    EXPECT_THROW(Arm("arm", tree, {"free"}, options), ompl::Exception);
    options.jointValues = {{"unknown", 1.0}};
    EXPECT_THROW(Arm("arm", tree, {"free"}, options), ompl::Exception);
    options.jointValues.clear();
    options.linkPairs = {{"base", "unknown"}};
    EXPECT_THROW(Arm("arm", tree, {"free"}, options), ompl::Exception);
    options.linkPairs = {{"base", "base"}};
    EXPECT_THROW(Arm("arm", tree, {"free"}, options), ompl::Exception);
    options.linkPairs.clear();
    options.base.translation().x() = nan;
    EXPECT_THROW(Arm("arm", tree, {"free"}, options), ompl::Exception);

    const auto mimicking = [&](const std::string &source, double multiplier, JointType type,
                               const std::vector<std::string> &group = {"free", "spin"})
    {
        KinematicTree copy = tree;
        copy.addLink("base", joint("spin", JointType::CONTINUOUS, {0, 0, 0}), "spinning");
        Joint j = joint("follower", type, {0, 0, 0});
        j.mimic = KinematicTree::Mimic{source, multiplier, 0.0};
        copy.addLink("base", j, "following");
        Joint second = joint("second", JointType::REVOLUTE, {0, 0, 0});
        second.mimic = KinematicTree::Mimic{"free", 0.5, 0.0};
        copy.addLink("base", second, "second");
        const Arm arm("arm", copy, group);
    };
    EXPECT_NO_THROW(mimicking("free", 0.7, JointType::PRISMATIC));
    EXPECT_NO_THROW(mimicking("spin", -2.0, JointType::CONTINUOUS));
    EXPECT_THROW(mimicking("spin", 0.5, JointType::CONTINUOUS), ompl::Exception);
    EXPECT_THROW(mimicking("spin", 1.0, JointType::PRISMATIC), ompl::Exception);
    EXPECT_NO_THROW(mimicking("spin", 0.5, JointType::CONTINUOUS, {"free"})) << "it stands still";
    EXPECT_NO_THROW(mimicking("spin", 1.0, JointType::PRISMATIC, {"free"}));
    EXPECT_THROW(mimicking("second", 1.0, JointType::REVOLUTE), ompl::Exception);
    EXPECT_THROW(mimicking("follower", 1.0, JointType::REVOLUTE), ompl::Exception);
    EXPECT_THROW(mimicking("unknown", 1.0, JointType::REVOLUTE), ompl::Exception);
    EXPECT_THROW(mimicking("free", nan, JointType::REVOLUTE), ompl::Exception);
}

TEST(Arm, PlanarArmsStayInThePlane)
{
    KinematicTree tree("base", Body::disc(0.2));
    std::string parent = "base";
    for (const std::string name : {"upper", "lower", "hand"})
    {
        tree.addLink(parent,
                     joint(name + "_joint", JointType::REVOLUTE, {parent == "base" ? 0.0 : 1.0, 0, 0},
                           {0, 0, name == "lower" ? -1.0 : 1.0}, -3.0, 3.0),
                     name, Body({{Shape::box(Eigen::Vector2d(1.0, 0.1)), poseAt({0.5, 0, 0})}}));
        parent = name;
    }
    ompl::RNG::setSeed(3);
    const Arm arm("planar", tree, {"upper_joint", "lower_joint", "hand_joint"});
    EXPECT_EQ(arm.getWorkspaceDimension(), 2u);
    expectPoses(arm, {});
    EXPECT_NO_THROW(checkRobot(arm, 1000));
    tree.addLink("hand", joint("up", JointType::REVOLUTE, {1, 0, 0}, {0, 1, 0}), "finger", Body::disc(0.1));
    EXPECT_THROW(Arm("tilted", tree, {"upper_joint", "up"}), ompl::Exception);
    EXPECT_NO_THROW(Arm("level", tree, {"upper_joint"}));
}

TEST(Arm, IsLikeOneOnTheSameBase)
{
    const KinematicTree tree = sevenJoints();
    const Arm arm("arm", tree, SEVEN);
    EXPECT_TRUE(arm.isLike(arm));
    EXPECT_TRUE(arm.isLike(Arm("other", sevenJoints(), SEVEN)));
    ArmOptions elsewhere;
    elsewhere.base.translation().x() = 1.0;
    EXPECT_FALSE(arm.isLike(Arm("elsewhere", tree, SEVEN, elsewhere)));
    EXPECT_TRUE(Arm("there", tree, SEVEN, elsewhere).isLike(Arm("elsewhere", tree, SEVEN, elsewhere)));
    EXPECT_FALSE(arm.isLike(Arm("fewer", tree, {"joint1", "joint2"})));
    EXPECT_FALSE(
        arm.isLike(Arm("turned", tree, {"joint2", "joint1", "joint3", "joint4", "joint5", "joint6", "joint7"})));
    ArmOptions pairs;
    pairs.linkPairs = {{"base", "link7"}};
    EXPECT_FALSE(arm.isLike(Arm("checked", tree, SEVEN, pairs)));
    EXPECT_TRUE(Arm("checked", tree, SEVEN, pairs).isLike(Arm("too", tree, SEVEN, pairs)));
    KinematicTree longer = sevenJoints();
    longer.addLink("link7", joint("tool", JointType::FIXED, {0, 0, 0.1}), "tool", Body::sphere(0.1));
    EXPECT_FALSE(arm.isLike(Arm("longer", longer, SEVEN)));
    ArmOptions bent;
    bent.jointValues["joint2"] = 0.3;
    EXPECT_FALSE(Arm("straight", tree, {"joint1"}).isLike(Arm("bent", tree, {"joint1"}, bent)));
    EXPECT_FALSE(arm.isLike(*RandomTree(3, 5).make("random")));
}
