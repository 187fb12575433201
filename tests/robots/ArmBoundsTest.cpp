#include "support/RandomTrees.h"

#include <gtest/gtest.h>
#include <ompl/base/ScopedState.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;
namespace ob = ompl::base;

namespace
{
    using JointType = KinematicTree::JointType;

    struct Tightness
    {
        double bodies{0.0}, pairs{0.0}, count{0.0}, pairCount{0.0};
    };

    /** No point moves farther than its motion bound, and no body turns farther, densely sampled, in the workspace and
        seen from other links. Adds up bound / truth for the points that move farthest. */
    void expectBoundsOf(const Arm &arm, const ob::State *from, const ob::State *to, Tightness &tightness)
    {
        const ob::StateSpacePtr space = arm.getStateSpace();
        ob::ScopedState<> between(space);
        constexpr int steps = 100;
        const std::size_t count = arm.getBodies().size();
        const auto &pairs = arm.getBodyPairs();
        std::vector<MotionBound> bounds(count);
        arm.computeMotionBounds(from, to, bounds.data());
        std::vector<PairMotionBound> pairBounds(pairs.size());
        arm.computePairMotionBounds(from, to, bounds.data(), pairBounds.data());
        std::vector<std::vector<Pose>> poses(steps + 1, std::vector<Pose>(count));
        for (int i = 0; i <= steps; ++i)
        {
            space->interpolate(from, to, static_cast<double>(i) / steps, between.get());
            arm.computePoses(between.get(), poses[static_cast<std::size_t>(i)].data());
        }
        // In steps, the way is what was covered; the bound holds for each of them.
        const auto compare = [&](const MotionBound &bound, double radius, auto poseAtStep, double &sum, double &n)
        {
            double truth = 0.0;
            for (int i = 0; i < steps; ++i)
            {
                const Pose a = poseAtStep(i), b = poseAtStep(i + 1);
                const double moved = (b.translation() - a.translation()).norm();
                ASSERT_LE(steps * moved, bound.linear * (1 + 1e-9) + 1e-10);
                const Eigen::AngleAxisd turned(a.linear().transpose() * b.linear());
                ASSERT_LE(steps * std::abs(turned.angle()), bound.angular * (1 + 1e-9) + 1e-10);
                for (int axis = 0; axis < 6; ++axis)
                {
                    const Eigen::Vector3d point = (axis < 3 ? radius : -radius) * Eigen::Vector3d::Unit(axis % 3);
                    const double way = steps * (b * point - a * point).norm();
                    ASSERT_LE(way, bound.at(radius) * (1 + 1e-9) + 1e-10);
                    truth = std::max(truth, way);
                }
            }
            if (truth > 1e-6)
            {
                sum += bound.at(radius) / truth;
                n += 1.0;
            }
        };
        for (std::size_t k = 0; k < count; ++k)
            compare(
                bounds[k], arm.getBodies()[k].getBoundingRadius(),
                [&](int i) { return poses[static_cast<std::size_t>(i)][k]; }, tightness.bodies, tightness.count);
        for (std::size_t p = 0; p < pairs.size(); ++p)
            for (const bool swapped : {false, true})
            {
                const std::size_t seen = swapped ? pairs[p].second : pairs[p].first,
                                  observer = swapped ? pairs[p].first : pairs[p].second;
                compare(
                    swapped ? pairBounds[p].second : pairBounds[p].first, arm.getBodies()[seen].getBoundingRadius(),
                    [&](int i)
                    {
                        const std::vector<Pose> &now = poses[static_cast<std::size_t>(i)];
                        return Pose(now[observer].inverse() * now[seen]);
                    },
                    tightness.pairs, tightness.pairCount);
            }
    }

    void expectBoundsOf(const Arm &arm, const std::vector<double> &from, const std::vector<double> &to)
    {
        ob::ScopedState<> start(arm.getStateSpace()), end(arm.getStateSpace());
        start = from;
        end = to;
        Tightness tightness;
        expectBoundsOf(arm, start.get(), end.get(), tightness);
        EXPECT_GT(tightness.count, 0.0) << "nothing moves";
    }

    /** expectBoundsOf() random motions, shortened to a \e fraction */
    Tightness expectBounds(const Arm &arm, int motions, double fraction)
    {
        const ob::StateSpacePtr space = arm.getStateSpace();
        auto sampler = space->allocStateSampler();
        ob::ScopedState<> from(space), to(space);
        Tightness tightness;
        for (int m = 0; m < motions; ++m)
        {
            sampler->sampleUniform(from.get());
            sampler->sampleUniform(to.get());
            space->interpolate(from.get(), to.get(), fraction, to.get());
            expectBoundsOf(arm, from.get(), to.get(), tightness);
        }
        return tightness;
    }
}

TEST(Arm, NoPointMovesFartherThanItsBound)
{
    ompl::RNG::setSeed(21);
    for (unsigned int seed = 1; seed <= scaled(40); ++seed)
    {
        RandomTree random(seed, 2 + seed % 10);
        const Arm arm("arm", random.tree, random.group, allPairs(random.tree, random.options));
        for (const double fraction : {1.0, 0.2, 0.01})
            expectBounds(arm, 5, fraction);
        if (HasFatalFailure())
            FAIL() << "seed " << seed;
    }
}

/** Axes that meet in a point: no point's way tells how far the last link turns. */
TEST(Arm, NoWristTurnsFartherThanItsBound)
{
    KinematicTree tree("base");
    const Eigen::Vector3d center = Eigen::Vector3d::Zero();
    tree.addLink("base", joint("a", JointType::REVOLUTE, center, Eigen::Vector3d::UnitZ()), "one");
    tree.addLink("one", joint("b", JointType::REVOLUTE, center, Eigen::Vector3d::UnitY()), "two");
    tree.addLink("two", joint("c", JointType::REVOLUTE, center, Eigen::Vector3d::UnitZ()), "hand",
                 Body::box(1.0, 0.1, 0.1));
    expectBoundsOf(Arm("arm", tree, {"a", "b", "c"}, {}), {-1.5, -1.5, 1.5}, {1.5, 1.5, -1.5});
}

/** Users may check states beyond the limits, where links reach farther than within. */
TEST(Arm, NoPointMovesFartherThanItsBoundBeyondTheLimitsEither)
{
    const Eigen::Vector3d center = Eigen::Vector3d::Zero();
    KinematicTree turning("base");
    turning.addLink("base", joint("turn", JointType::REVOLUTE, center), "one");
    KinematicTree sliding = turning, planar = turning;
    sliding.addLink("one", joint("slide", JointType::PRISMATIC, center, Eigen::Vector3d::UnitX(), 0.0, 1.0), "two",
                    Body::sphere(0.1));
    expectBoundsOf(Arm("sliding", sliding, {"turn", "slide"}, {}), {-0.5, 5.0}, {0.5, 5.0});

    planar.addLink("one", joint("plane", JointType::PLANAR, center), "two", Body::sphere(0.1));
    ArmOptions options;
    options.bounds = ob::RealVectorBounds(2);
    options.bounds->setLow(-1.0);
    options.bounds->setHigh(1.0);
    expectBoundsOf(Arm("planar", planar, {"turn", "plane"}, options), {-0.5, 5.0, 0.0, 0.0}, {0.5, 5.0, 0.0, 0.0});
}

/** Such points lie on a circle that is tilted against the other axis, of which some points are tried alone. */
TEST(Arm, NoPointMovesFartherThanItsBoundWhereItReachesFarthest)
{
    Random random(1);
    const Eigen::Vector3d z = Eigen::Vector3d::UnitZ();
    for (unsigned int i = 0; i < scaled(20); ++i)
    {
        KinematicTree tree("base");
        tree.addLink("base", joint("turn", JointType::REVOLUTE, {0.0, 0.0, 0.0}, z), "one");
        tree.addLink("one", joint("tilted", JointType::REVOLUTE, random.point(3, 0.3), random.direction(3), -4.0, 4.0),
                     "two", Body({{Shape::ball(3, 0.01), poseAt(random.direction(3))}}));
        const Arm arm("arm", tree, {"turn", "tilted"}, {});
        ob::ScopedState<> state(arm.getStateSpace());
        double most = 0.0, farthest = 0.0;
        for (double angle = -M_PI; angle < M_PI; angle += 1e-3)
        {
            Pose pose;
            state = std::vector<double>{0.0, angle};
            arm.computePoses(state.get(), &pose);
            if (const double distance = pose.translation().head<2>().norm(); distance > most)
            {
                most = distance;
                farthest = angle;
            }
        }
        // So short that a chord is as long as its arc
        expectBoundsOf(arm, {0.0, farthest}, {0.01, farthest});
    }
}

TEST(Arm, BoundsAreTight)
{
    ompl::RNG::setSeed(22);
    const KinematicTree tree = sevenJoints();
    const Arm arm("arm", tree, SEVEN, allPairs(tree));
    for (const double fraction : {1.0, 0.2, 0.02})
    {
        const Tightness tightness = expectBounds(arm, 100, fraction);
        const double bodies = tightness.bodies / tightness.count, pairs = tightness.pairs / tightness.pairCount;
        std::cout << "motions of " << fraction << " of random ones: bound / truth " << bodies << ", of pairs " << pairs
                  << "\n";
        RecordProperty("bodies_" + std::to_string(fraction), std::to_string(bodies));
        RecordProperty("pairs_" + std::to_string(fraction), std::to_string(pairs));
        EXPECT_LT(bodies, fraction == 1.0 ? 3.0 : fraction == 0.2 ? 2.2 : 1.7);
        EXPECT_LT(pairs, fraction == 1.0 ? 2.5 : fraction == 0.2 ? 2.0 : 1.7);
    }
}
