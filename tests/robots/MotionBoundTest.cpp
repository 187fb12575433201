#include "support/RandomBodies.h"
#include "support/RandomStates.h"

#include "ompl_certificates/robots/CarWithTrailer.h"
#include "ompl_certificates/robots/Arm.h"
#include "ompl_certificates/robots/RigidRobot.h"

#include <gtest/gtest.h>
#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/base/spaces/SE3StateSpace.h>
#include <ompl/util/Exception.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;
namespace ob = ompl::base;

namespace
{
    RobotPtr randomRobot(Random &random)
    {
        const auto plane = cubeBounds(2, 3.0), space = cubeBounds(3, 3.0);
        switch (random.below(5))
        {
            case 0:
                return RigidRobot::inR2("r", randomBody(random, 2, 1.0), plane);
            case 1:
                return RigidRobot::inR3("r", randomBody(random, 3, 1.0), space);
            case 2:
                return RigidRobot::inSE2("r", randomBody(random, 2, 1.0), plane);
            case 3:
                return RigidRobot::inSE3("r", randomBody(random, 3, 1.0), space);
            default:
                return std::make_shared<CarWithTrailer>("r", randomBody(random, 2, 1.0), randomBody(random, 2, 1.0),
                                                        random.uniform(0.0, 2.0), plane);
        }
    }

    /** Positions of points of all bodies, each body's at some distance from its origin */
    std::vector<Eigen::Vector3d> probes(const Robot &robot, const ob::State *state,
                                        const std::vector<Eigen::Vector3d> &offsets)
    {
        std::vector<Pose> poses(robot.getBodies().size());
        robot.computePoses(state, poses.data());
        std::vector<Eigen::Vector3d> points;
        for (const Pose &pose : poses)
            for (const auto &offset : offsets)
                points.push_back(pose * offset);
        return points;
    }

    /** Checks that no probe moves further than the bounds allow between any two of many times. */
    void checkMotionBounds(Random &random, const Robot &robot, const ob::ScopedState<> &from,
                           const ob::ScopedState<> &to)
    {
        const auto &space = robot.getStateSpace();
        std::vector<MotionBound> bounds(robot.getBodies().size());
        robot.computeMotionBounds(from.get(), to.get(), bounds.data());
        std::vector<Eigen::Vector3d> offsets{Eigen::Vector3d::Zero()};
        for (int i = 0; i < 4; ++i)
            offsets.push_back(random.point(robot.getWorkspaceDimension(), 2.0));
        std::vector<double> times{0.0, 1.0};
        for (int i = 0; i < 15; ++i)
            times.push_back(random.chance(0.3) ? random.logUniform(1e-9, 1.0) : random.uniform(0.0, 1.0));
        std::sort(times.begin(), times.end());
        ob::ScopedState<> at(space);
        std::vector<std::vector<Eigen::Vector3d>> positions;
        for (const double t : times)
        {
            space->interpolate(from.get(), to.get(), t, at.get());
            // The checks take a motion's ends as they are.
            const ob::State *state = t == 0.0 ? from.get() : t == 1.0 ? to.get() : at.get();
            positions.push_back(probes(robot, state, offsets));
        }
        for (std::size_t a = 0; a < times.size(); ++a)
            for (std::size_t b = a + 1; b < times.size(); ++b)
                for (std::size_t i = 0; i < positions[a].size(); ++i)
                {
                    const double distance = (positions[b][i] - positions[a][i]).norm();
                    const double bound = bounds[i / offsets.size()].at(offsets[i % offsets.size()].norm());
                    ASSERT_LE(distance, bound * (times[b] - times[a]) * (1.0 + 1e-9) + 1e-11)
                        << "from " << times[a] << " to " << times[b];
                    // A jump may come at any time, and is all that the body turns by.
                    const double offset = offsets[i % offsets.size()].norm();
                    if (const auto jump = robot.getJump(i / offsets.size(), from.get(), to.get()))
                    {
                        EXPECT_LT(jump->steady.at(offset), 1e9);
                        ASSERT_LE(distance, (jump->steady.at(offset) * (times[b] - times[a]) + jump->jump.at(offset)) *
                                                    (1.0 + 1e-9) +
                                                1e-11)
                            << "from " << times[a] << " to " << times[b] << " with a jump";
                    }
                }
    }

    ob::ScopedState<> se3State(const ob::StateSpacePtr &space, const Eigen::Quaterniond &rotation)
    {
        ob::ScopedState<> state(space);
        auto *q = state->as<ob::SE3StateSpace::StateType>();
        q->setXYZ(0.0, 0.0, 0.0);
        setRotation(q->rotation(), rotation);
        return state;
    }
}

TEST(MotionBounds, HoldForAllRobotsBetweenAnyTwoTimes)
{
    for (unsigned int seed = 0; seed < scaled(2000); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const RobotPtr robot = randomRobot(random);
        const auto from = randomState(random, robot->getStateSpace());
        checkMotionBounds(random, *robot, from, randomState(random, robot->getStateSpace()));
        checkMotionBounds(random, *robot, from, randomStateNear(random, from, random.logUniform(1e-9, 1.0)));
        checkMotionBounds(random, *robot, from, from);
        if (HasFailure())
            return;
    }
}

TEST(MotionBounds, HoldWhereAnglesWrapAround)
{
    const RobotPtr robot = RigidRobot::inSE2("r", Body::box(1.0, 1.0), cubeBounds(2, 3.0));
    Random random(1);
    ob::ScopedState<ob::SE2StateSpace> from(robot->getStateSpace()), to(robot->getStateSpace());
    for (const double a : {M_PI, -M_PI, 3.1, -3.1, 0.0, 1e-9})
        for (const double b : {M_PI, -M_PI, 3.1, -3.1, 0.0, M_PI / 2})
        {
            SCOPED_TRACE(std::to_string(a) + " to " + std::to_string(b));
            from->setXY(0.0, 0.0);
            to->setXY(0.5, 0.0);
            from->setYaw(a);
            to->setYaw(b);
            checkMotionBounds(random, *robot, ob::ScopedState<>(from), ob::ScopedState<>(to));
            MotionBound bound;
            robot->computeMotionBounds(from.get(), to.get(), &bound);
            EXPECT_LE(bound.angular, M_PI) << "the longer way round";
        }
}

TEST(MotionBounds, HoldForRotationsFromNearlyNoneToHalfATurn)
{
    const RobotPtr robot = RigidRobot::inSE3("r", Body::box(1.0, 1.0, 1.0), cubeBounds(3, 3.0));
    for (unsigned int seed = 0; seed < scaled(1000); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const double angle = random.chance(0.3) ? M_PI - random.logUniform(1e-12, 1e-2) : random.logUniform(1e-12, 3.0);
        const Eigen::Quaterniond start = random.rotation();
        Eigen::Quaterniond end = start * Eigen::AngleAxisd(angle, random.direction(3));
        if (random.chance(0.5))
            end.coeffs() *= -1.0;  // the same rotation
        // OMPL takes quaternions of nearly unit length.
        end.coeffs() *= 1.0 + random.uniform(-5e-10, 5e-10);
        checkMotionBounds(random, *robot, se3State(robot->getStateSpace(), start),
                          se3State(robot->getStateSpace(), end));
        if (HasFailure())
            return;
    }
}

TEST(MotionBounds, HoldForArmsThatFlyAndNearlyKeepTheirRotation)
{
    KinematicTree tree("world");
    KinematicTree::Joint fly, elbow;
    fly.name = "fly";
    fly.type = KinematicTree::JointType::FLOATING;
    elbow.name = "elbow";
    elbow.type = KinematicTree::JointType::REVOLUTE;
    elbow.axis = Eigen::Vector3d::UnitY();
    elbow.lower = -3.0;
    elbow.upper = 3.0;
    elbow.origin = poseAt({0.5, 0.0, 1.0});
    tree.addLink("world", fly, "drone", Body::box(0.3, 0.3, 0.1));
    tree.addLink("drone", elbow, "hand", Body::box(0.1, 0.1, 0.8));
    ArmOptions options;
    options.bounds = cubeBounds(3, 5.0);
    const auto arm = std::make_shared<const Arm>("arm", tree, std::vector<std::string>{"fly", "elbow"}, options);
    unsigned int jumps = 0;
    for (unsigned int seed = 0; seed < scaled(500); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const auto from = randomState(random, arm->getStateSpace());
        auto to = random.chance(0.5) ? from : randomState(random, arm->getStateSpace());
        std::vector<double> start = from.reals(), end = to.reals();
        const Eigen::Quaterniond rotation(start[6], start[3], start[4], start[5]);
        const Eigen::Quaterniond turned =
            rotation * Eigen::AngleAxisd(random.logUniform(1e-11, 1e-3), random.direction(3));
        Eigen::Map<Eigen::Vector4d>(end.data() + 3) = turned.coeffs();
        to = end;
        checkMotionBounds(random, *arm, from, to);
        jumps += arm->getJump(1, from.get(), to.get()) ? 1 : 0;
        if (HasFailure())
            return;
    }
    EXPECT_GT(jumps, scaled(500) / 2);
}

TEST(MotionBounds, AreNotWastefulForRigidRobots)
{
    const RobotPtr robot = RigidRobot::inSE3("r", Body::box(1.0, 1.0, 1.0), cubeBounds(3, 3.0));
    const auto from = se3State(robot->getStateSpace(), Eigen::Quaterniond::Identity());
    auto to = se3State(robot->getStateSpace(), Eigen::Quaterniond(Eigen::AngleAxisd(1.0, Eigen::Vector3d::UnitZ())));
    to->as<ob::SE3StateSpace::StateType>()->setXYZ(1.0, 2.0, 2.0);
    MotionBound bound;
    robot->computeMotionBounds(from.get(), to.get(), &bound);
    EXPECT_NEAR(bound.linear, 3.0, 1e-9);
    EXPECT_NEAR(bound.angular, 1.0, 1e-5);
    EXPECT_NEAR(bound.at(2.0), 5.0, 1e-4);
}

/** OMPL takes quaternions for equal by their product, so between longer ones it jumps farther. */
TEST(MotionBounds, AreNoneWhereQuaternionsAreNotOfLengthOne)
{
    const RobotPtr robot = RigidRobot::inSE3("r", Body::box(1.0, 1.0, 1.0), cubeBounds(3, 3.0));
    const Eigen::Quaterniond start = Eigen::Quaterniond(0.5, -0.5, 0.5, 0.5);
    const Eigen::Quaterniond end = start * Eigen::Quaterniond(Eigen::AngleAxisd(6e-4, Eigen::Vector3d::UnitZ()));
    for (const double length : {1.0, 1.0 + 1e-7})
    {
        const auto from = se3State(robot->getStateSpace(), start);
        auto to = se3State(robot->getStateSpace(), end);
        auto &turn = to->as<ob::SE3StateSpace::StateType>()->rotation();
        for (double *coordinate : {&turn.x, &turn.y, &turn.z, &turn.w})
            *coordinate *= length;
        MotionBound bound;
        robot->computeMotionBounds(from.get(), to.get(), &bound);
        EXPECT_EQ(bound.angular < 1.0, length == 1.0);
    }
}
