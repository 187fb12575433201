#include "support/Chain.h"
#include "support/RandomStates.h"

#include "ompl_certificates/robots/CarWithTrailer.h"
#include "ompl_certificates/robots/RigidRobot.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/base/spaces/SE3StateSpace.h>
#include <ompl/util/Exception.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;
namespace ob = ompl::base;

TEST(RigidRobot, MovesInTheSpaceThatItIsMadeFor)
{
    const auto plane = cubeBounds(2, 3.0), space = cubeBounds(3, 3.0);
    EXPECT_TRUE(dynamic_cast<ob::RealVectorStateSpace *>(RigidRobot::disc("a", 1.0, plane)->getStateSpace().get()));
    EXPECT_TRUE(dynamic_cast<ob::RealVectorStateSpace *>(RigidRobot::sphere("a", 1.0, space)->getStateSpace().get()));
    const RobotPtr turning = RigidRobot::inSE2("b", Body::box(1.0, 1.0), plane);
    ASSERT_TRUE(dynamic_cast<ob::SE2StateSpace *>(turning->getStateSpace().get()));
    EXPECT_EQ(turning->getStateSpace()->as<ob::SE2StateSpace>()->getBounds().high[1], 3.0);
    EXPECT_EQ(turning->getStateSpace()->getName(), "b");
    EXPECT_EQ(turning->getName(), "b");
    const RobotPtr flying = RigidRobot::inSE3("c", Body::box(1.0, 1.0, 1.0), space);
    EXPECT_TRUE(dynamic_cast<ob::SE3StateSpace *>(flying->getStateSpace().get()));
    EXPECT_EQ(flying->getWorkspaceDimension(), 3U);
}

TEST(RigidRobot, StandsWhereItsStateSays)
{
    Pose pose;
    const RobotPtr disc = RigidRobot::disc("a", 1.0, cubeBounds(2, 3.0));
    ob::ScopedState<> flat(disc->getStateSpace());
    flat = std::vector<double>{1.0, -2.0};
    disc->computePoses(flat.get(), &pose);
    EXPECT_TRUE(pose.isApprox(planarPose(1.0, -2.0)));

    const RobotPtr box = RigidRobot::inSE2("b", Body::box(1.0, 1.0), cubeBounds(2, 3.0));
    ob::ScopedState<ob::SE2StateSpace> turned(box->getStateSpace());
    turned->setXY(1.0, 2.0);
    turned->setYaw(M_PI / 2);
    box->computePoses(turned.get(), &pose);
    EXPECT_TRUE((pose * Eigen::Vector3d(1.0, 0.0, 0.0)).isApprox(Eigen::Vector3d(1.0, 3.0, 0.0)));

    const RobotPtr solid = RigidRobot::inR3("c", Body::box(1.0, 1.0, 1.0), cubeBounds(3, 3.0));
    ob::ScopedState<> high(solid->getStateSpace());
    high = std::vector<double>{1.0, 2.0, 3.0};
    solid->computePoses(high.get(), &pose);
    EXPECT_TRUE(pose.isApprox(poseAt({1.0, 2.0, 3.0})));

    const RobotPtr flying = RigidRobot::inSE3("d", Body::box(1.0, 1.0, 1.0), cubeBounds(3, 3.0));
    ob::ScopedState<ob::SE3StateSpace> spun(flying->getStateSpace());
    spun->setXYZ(1.0, 2.0, 3.0);
    spun->rotation().setAxisAngle(1.0, 0.0, 0.0, M_PI / 2);
    flying->computePoses(spun.get(), &pose);
    EXPECT_TRUE((pose * Eigen::Vector3d(0.0, 1.0, 0.0)).isApprox(Eigen::Vector3d(1.0, 2.0, 4.0)));
}

TEST(RigidRobot, HasRigidPosesForQuaternionsThatAreNotQuiteUnit)
{
    const RobotPtr flying = RigidRobot::inSE3("d", Body::box(1.0, 1.0, 1.0), cubeBounds(3, 3.0));
    ob::ScopedState<ob::SE3StateSpace> state(flying->getStateSpace());
    Pose pose;
    for (unsigned int seed = 0; seed < 100; ++seed)
    {
        Random random(seed);
        randomize(random, flying->getStateSpace(), state.get());
        state->rotation().w *= 1.01;
        flying->computePoses(state.get(), &pose);
        EXPECT_NEAR((pose.linear().transpose() * pose.linear() - Eigen::Matrix3d::Identity()).norm(), 0.0, 1e-12);
    }
}

TEST(RigidRobot, RefusesBodiesAndBoundsOfAnotherDimension)
{
    const auto plane = cubeBounds(2, 3.0), space = cubeBounds(3, 3.0);
    EXPECT_THROW(RigidRobot::disc("a", 1.0, space), ompl::Exception);
    EXPECT_THROW(RigidRobot::sphere("a", 1.0, plane), ompl::Exception);
    EXPECT_THROW(RigidRobot::inR2("a", Body::sphere(1.0), plane), ompl::Exception);
    EXPECT_THROW(RigidRobot::inSE2("a", Body::sphere(1.0), plane), ompl::Exception);
    EXPECT_THROW(RigidRobot::inR3("a", Body::disc(1.0), space), ompl::Exception);
    EXPECT_THROW(RigidRobot::inSE3("a", Body::box(1.0, 1.0), space), ompl::Exception);
    EXPECT_THROW(RigidRobot::inSE3("a", Body::sphere(1.0), plane), ompl::Exception);
    EXPECT_THROW(RigidRobot::disc("", 1.0, plane), ompl::Exception);
    EXPECT_THROW(RigidRobot::disc("a", -1.0, plane), ompl::Exception);
    EXPECT_THROW(RigidRobot::inReedsShepp("a", Body::disc(1.0), 1.0, space), ompl::Exception);
    for (const double radius : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()})
        EXPECT_THROW(RigidRobot::inReedsShepp("a", Body::disc(1.0), radius, plane), ompl::Exception) << radius;
}

TEST(RigidRobot, RefusesBoundsThatCannotBeSampled)
{
    const double infinite = std::numeric_limits<double>::infinity();
    for (const auto &[low, high] :
         {std::pair{2.0, 1.0}, {0.0, infinite}, {-infinite, 0.0}, {std::nan(""), 1.0}, {0.0, std::nan("")}})
    {
        ompl::base::RealVectorBounds bounds = cubeBounds(2, 3.0);
        bounds.low[1] = low;
        bounds.high[1] = high;
        EXPECT_THROW(RigidRobot::inSE2("a", Body::box(1.0, 1.0), bounds), ompl::Exception) << low << " " << high;
        EXPECT_THROW(CarWithTrailer("a", Body::box(1.0, 1.0), Body::box(1.0, 1.0), 2.0, bounds), ompl::Exception);
        bounds.low[1] = bounds.high[1] = 1.0;
        EXPECT_NO_THROW(RigidRobot::inSE2("a", Body::box(1.0, 1.0), bounds)) << "one line";
    }
}

TEST(RigidRobot, HasANameOfOneLine)
{
    EXPECT_THROW(RigidRobot::disc("a\nb", 1.0, cubeBounds(2, 3.0)), ompl::Exception);
    EXPECT_THROW(RigidRobot::disc("a\r", 1.0, cubeBounds(2, 3.0)), ompl::Exception);
    EXPECT_NO_THROW(RigidRobot::disc("a \"b\", c", 1.0, cubeBounds(2, 3.0)));
}

TEST(CarWithTrailer, PullsItsTrailerBehindTheHinge)
{
    const CarWithTrailer robot("t", Body::box(1.0, 0.5), Body::box(0.8, 0.5), 2.0, cubeBounds(2, 3.0));
    ob::ScopedState<ob::CompoundStateSpace> state(robot.getStateSpace());
    auto *car = state->as<ob::SE2StateSpace::StateType>(0);
    car->setXY(1.0, 1.0);
    car->setYaw(0.5);
    state->as<ob::SO2StateSpace::StateType>(1)->value = M_PI / 2;
    Pose poses[2];
    robot.computePoses(state.get(), poses);
    EXPECT_TRUE(poses[0].isApprox(planarPose(1.0, 1.0, 0.5)));
    EXPECT_TRUE(poses[1].isApprox(planarPose(1.0, -1.0, M_PI / 2)));
    EXPECT_EQ(robot.getBodies().size(), 2U);
    // The hinge, in the trailer's frame, is the origin of the car's.
    EXPECT_TRUE((poses[1] * Eigen::Vector3d(2.0, 0.0, 0.0)).isApprox(poses[0].translation()));
}

TEST(CarWithTrailer, RefusesWhatIsNotPlanarAndBadHitches)
{
    const Body box = Body::box(1.0, 1.0), solid = Body::box(1.0, 1.0, 1.0);
    const auto plane = cubeBounds(2, 3.0);
    const double infinity = std::numeric_limits<double>::infinity();
    EXPECT_THROW(CarWithTrailer("t", solid, solid, 1.0, plane), ompl::Exception);
    EXPECT_THROW(CarWithTrailer("t", box, solid, 1.0, plane), ompl::Exception);
    EXPECT_THROW(CarWithTrailer("t", box, box, -1.0, plane), ompl::Exception);
    EXPECT_THROW(CarWithTrailer("t", box, box, infinity, plane), ompl::Exception);
    EXPECT_THROW(CarWithTrailer("t", box, box, 1.0, cubeBounds(3, 1.0)), ompl::Exception);
    EXPECT_NO_THROW(CarWithTrailer("t", box, box, 0.0, plane));
}

TEST(BodyPairs, NameTwoBodiesOfTheRobot)
{
    const Chain::Link link{Body::disc(0.1), planarPose(1.0, 0.0), Eigen::Vector3d::UnitZ(), 0.0};
    const auto make = [&](const std::vector<BodyPair> &pairs) { return Chain("arm", {link, link, link}, pairs); };
    EXPECT_TRUE(make({}).getBodyPairs().empty());
    EXPECT_EQ(make({{0, 2}, {2, 1}}).getBodyPairs(), (std::vector<BodyPair>{{0, 2}, {2, 1}}));
    EXPECT_THROW(make({{0, 2}, {1, 1}}), ompl::Exception);
    EXPECT_THROW(make({{0, 3}}), ompl::Exception);
    EXPECT_THROW(make({{3, 0}}), ompl::Exception);
    EXPECT_TRUE(RigidRobot::disc("a", 1.0, cubeBounds(2, 3.0))->getBodyPairs().empty());
}
