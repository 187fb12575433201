#include "support/Message.h"
#include "support/RandomBodies.h"
#include "support/RandomMeshes.h"

#include "ompl_certificates/obstacles/FclObstacles.h"

#include <fcl/geometry/shape/sphere.h>
#include <fcl/narrowphase/collision_object.h>
#include <gtest/gtest.h>
#include <limits>
#include <ompl/util/Exception.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;

namespace
{
    std::vector<PlacedBody> randomObstacles(Random &random, unsigned int dimension, double unit)
    {
        std::vector<PlacedBody> bodies;
        for (unsigned int count = 1 + random.below(12); count > 0; --count)
        {
            const Body body = randomBody(random, dimension, unit * random.logUniform(0.3, 3.0));
            bodies.push_back({body, random.pose(dimension, 3.0 * unit)});
        }
        return bodies;
    }

    Body ballOf(unsigned int dimension, double radius)
    {
        return dimension == 2 ? Body::disc(radius) : Body::sphere(radius);
    }
}

class RandomObstacles : public testing::TestWithParam<unsigned int>
{
protected:
    template <typename Test>
    void forMany(unsigned int count, const Test &test)
    {
        for (unsigned int seed = 0; seed < scaled(count); ++seed)
        {
            SCOPED_TRACE("seed " + std::to_string(seed));
            Random random(seed);
            const double unit = std::pow(10.0, random.below(8)) * 1e-3;
            const FclObstacles obstacles(randomObstacles(random, GetParam(), unit), GetParam());
            test(random, obstacles, unit);
            if (HasFatalFailure())
                return;
        }
    }
};

TEST_P(RandomObstacles, CollideWithABallAsTheirClearanceSays)
{
    forMany(150,
            [](Random &random, const FclObstacles &obstacles, double unit)
            {
                const unsigned int dimension = obstacles.getDimension();
                for (int i = 0; i < 200; ++i)
                {
                    Pose pose = poseAt(random.point(dimension, 5.0 * unit));
                    if (random.chance(0.5))
                    {
                        // Near the surface, where the ball is far smaller than the obstacles
                        const auto &near = obstacles.getBodies()[random.below(obstacles.getBodies().size())];
                        pose = poseAt(near.pose * pointOf(random, near.body) +
                                      unit * random.logUniform(1e-6, 1.0) * random.direction(dimension));
                    }
                    const double clearance = obstacles.clearance(pose.translation());
                    // Slightly smaller and slightly larger than the gap, by the two tolerances
                    const double slack =
                        obstacles.getTolerance() * (1.0 + (random.chance(0.5) ? 0.0 : random.logUniform(1e-3, 1e4)));
                    const double small = (clearance - slack) / (1.0 + EXACT_CHECK_TOLERANCE);
                    if (small > 0.0)
                    {
                        ASSERT_FALSE(obstacles.collides(ballOf(dimension, small), pose))
                            << pose.translation().transpose() << ", clearance " << clearance;
                    }
                    const double large = (clearance + slack) / (1.0 - EXACT_CHECK_TOLERANCE);
                    if (large > 0.0)
                    {
                        ASSERT_TRUE(obstacles.collides(ballOf(dimension, large), pose))
                            << pose.translation().transpose() << ", clearance " << clearance;
                    }
                }
            });
}

TEST_P(RandomObstacles, CollideWithABodyIfOneOfItsPointsIsInside)
{
    forMany(300,
            [](Random &random, const FclObstacles &obstacles, double unit)
            {
                const Body body = randomBody(random, obstacles.getDimension(), unit);
                const double margin = obstacles.getTolerance() + exactCheckTolerance(body.getBoundingRadius());
                for (int i = 0; i < 20; ++i)
                {
                    const Pose pose = random.pose(obstacles.getDimension(), 5.0 * unit);
                    const bool collides = obstacles.collides(body, pose);
                    for (int k = 0; !collides && k < 20; ++k)
                        ASSERT_GE(obstacles.clearance(pose * pointOf(random, body)), -margin);
                }
            });
}

TEST_P(RandomObstacles, CollideWithABodyOnlyIfOneOfItsFinestBallsDoes)
{
    forMany(300,
            [](Random &random, const FclObstacles &obstacles, double unit)
            {
                const Body body = randomBody(random, obstacles.getDimension(), unit);
                const double margin = obstacles.getTolerance() + exactCheckTolerance(body.getBoundingRadius());
                for (int i = 0; i < 20; ++i)
                {
                    const Pose pose = random.pose(obstacles.getDimension(), 5.0 * unit);
                    bool apart = true;
                    for (const auto &node : body.getSphereTree().getNodes())
                        if (node.childCount == 0)
                            apart = apart && obstacles.clearance(pose * node.ball.center) > node.ball.radius + margin;
                    if (apart)
                    {
                        ASSERT_FALSE(obstacles.collides(body, pose));
                    }
                }
            });
}

TEST_P(RandomObstacles, HaveA1LipschitzClearance)
{
    forMany(200,
            [](Random &random, const FclObstacles &obstacles, double unit)
            {
                for (int i = 0; i < 100; ++i)
                {
                    const Eigen::Vector3d a = random.point(obstacles.getDimension(), 5.0 * unit);
                    const Eigen::Vector3d b =
                        a + random.point(obstacles.getDimension(), unit * random.logUniform(1e-6, 5.0));
                    ASSERT_LE(std::abs(obstacles.clearance(a) - obstacles.clearance(b)), (a - b).norm() + 1e-12 * unit);
                }
            });
}

INSTANTIATE_TEST_SUITE_P(Dimension, RandomObstacles, testing::Values(2U, 3U));

TEST(FclObstacles, OfNoneAreInfinitelyFar)
{
    const FclObstacles none(std::vector<PlacedBody>{}, 2);
    EXPECT_EQ(none.clearance({1.0, 2.0, 0.0}), std::numeric_limits<double>::infinity());
    EXPECT_FALSE(none.collides(Body::disc(1e9), Pose::Identity()));
    EXPECT_TRUE(none.provesCollisions());
}

TEST(FclObstacles, RefuseAnotherDimensionAndPosesThatAreNotFinite)
{
    EXPECT_THROW(FclObstacles(std::vector<PlacedBody>{}, 1), ompl::Exception);
    EXPECT_THROW(FclObstacles(std::vector<PlacedBody>{}, 4), ompl::Exception);
    EXPECT_THROW(FclObstacles({{Body::sphere(1.0)}}, 2), ompl::Exception);
    EXPECT_THROW(FclObstacles({{Body::disc(1.0)}}, 3), ompl::Exception);
    EXPECT_THROW(FclObstacles({{Body::disc(1.0), planarPose(std::nan(""), 0.0)}}, 2), ompl::Exception);
    // Of several they say which one.
    const std::vector<PlacedBody> bodies{{Body::disc(1.0)}, {Body::sphere(1.0)}};
    EXPECT_EQ(messageOf([&] { FclObstacles(bodies, 2); }).rfind("obstacle 1: An obstacle has 3", 0), 0U);
    const auto ball = std::make_shared<fcl::CollisionObjectd>(std::make_shared<fcl::Sphered>(1.0));
    EXPECT_EQ(messageOf(
                  [&] {
                      FclObstacles(std::vector{ball, ball, std::shared_ptr<fcl::CollisionObjectd>()});
                  }),
              "obstacle 2: A collision object must not be null");
}

/** A cube is turned, and its rotation written with three decimals: all checks must mean the same cube. */
TEST(FclObstacles, TakeRoundedRotationsForTrueOnes)
{
    Random random(1);
    Pose pose = Pose::Identity();
    pose.linear() = random.rotation().toRotationMatrix();
    for (double &number : pose.linear().reshaped())
        number = std::round(1e3 * number) / 1e3;
    Pose nearest = pose;
    nearest.linear() = Eigen::Quaterniond(pose.linear()).normalized().toRotationMatrix();
    ASSERT_GT((nearest.linear() - pose.linear()).norm(), 1e-5);
    const Body box = Body::box(2.0, 2.0, 2.0), ball = Body::sphere(0.5);
    const FclObstacles rounded({{box, pose}}, 3), exact({{box, nearest}}, 3);
    for (int i = 0; i < 2000; ++i)
    {
        const Pose place = poseAt(random.direction(3) * random.uniform(1.4, 2.4));
        ASSERT_NEAR(rounded.clearance(place.translation()), exact.clearance(place.translation()), 1e-12);
        ASSERT_EQ(rounded.collides(ball, place), exact.collides(ball, place)) << i;
    }
    pose.linear() *= 1.01;
    EXPECT_THROW(FclObstacles({{Body::sphere(1.0), pose}}, 3), ompl::Exception);
}

TEST(FclObstacles, RefuseWhatLeavesThePlane)
{
    const auto make = [](const Body &body, const Pose &pose) { FclObstacles({{body, pose}}, 2); };
    Pose lifted = planarPose(1.0, 2.0, 0.5), tilted = lifted;
    lifted.translation().z() = 0.5;
    tilted.linear() = Eigen::AngleAxisd(0.1, Eigen::Vector3d::UnitY()).toRotationMatrix();
    const Body mesh = Body::planarMesh(test::boxMesh({1.0, 1.0, 1.0}));
    for (const Body &body : {Body::disc(1.0), Body::box(1.0, 2.0), Body::planarCapsule(0.1, 1.0)})
    {
        EXPECT_NO_THROW(make(body, planarPose(1.0, 2.0, 0.5)));
        EXPECT_THROW(make(body, lifted), ompl::Exception);
        if (!body.isBall())
        {
            EXPECT_THROW(make(body, tilted), ompl::Exception);
        }
    }
    EXPECT_NO_THROW(make(mesh, lifted));
    EXPECT_THROW(make(mesh, tilted), ompl::Exception);
}

TEST(FclObstacles, CountAPointRobotAsABody)
{
    const FclObstacles obstacles(
        {{Body::convexPolygon({{0, 0}, {2, 0}, {2, 2}, {0, 2}})}, {Body::disc(0.5), planarPose(5, 0)}}, 2);
    EXPECT_TRUE(obstacles.collides(Body::disc(0.0), planarPose(1.0, 1.0)));
    EXPECT_TRUE(obstacles.collides(Body::disc(0.0), planarPose(1.0, 0.001)));
    EXPECT_FALSE(obstacles.collides(Body::disc(0.0), planarPose(1.0, -0.001)));
    EXPECT_TRUE(obstacles.collides(Body::disc(0.0), planarPose(5.0, 0.4)));
    EXPECT_FALSE(obstacles.collides(Body::disc(0.0), planarPose(5.0, 0.6)));
}

TEST(FclObstacles, TakeDiscsHoweverTheyAreTurned)
{
    Pose turned = poseAt({0.0, 0.0, 0.0});
    turned.rotate(Eigen::AngleAxisd(0.5 * M_PI, Eigen::Vector3d::UnitX()));
    const FclObstacles obstacles({{Body::disc(1.0), turned}}, 2);
    const Body part({{Shape::ball(2, 0.1), turned}});
    for (const double y : {0.0, 0.5, 0.9, 1.05})
    {
        SCOPED_TRACE(y);
        const Pose pose = planarPose(0.0, y);
        EXPECT_TRUE(obstacles.collides(part, pose));
        EXPECT_EQ(obstacles.touches(part, pose), Touching::YES);
        EXPECT_LT(obstacles.gap(part, pose, 0.0, 1.0), 1e-3);
    }
    EXPECT_FALSE(obstacles.collides(part, planarPose(0.0, 1.2)));
    EXPECT_TRUE(part.getBounds().contains(Eigen::Vector3d(0.0, 0.09, 0.0)));
}

/** FCL's solver does not end for these two, unless it is told that they have some width. Then this test never ends. */
TEST(FclObstacles, WithoutWidthAreCheckedInFiniteTime)
{
    Pose ofCylinder, ofCapsule;
    ofCylinder.matrix().topRows<3>() << 0.0, 0.0, -1.0, -0x1.03e68fa193c18p+6, 0.0, -1.0, 0.0, -0x1.9b58a9de5ced1p+0,
        -1.0, 0.0, 0.0, 0x1.2236620b37a69p+7;
    ofCapsule.matrix().topRows<3>() << 0x1.9031ae983fd6p-5, -0x1.ff96e5721f122p-2, 0x1.bad150502105fp-1,
        -0x1.03e68fa193c18p+6, 0x1.7d965a88ac4a7p-1, 0x1.307de634d4b92p-1, 0x1.34ac7888d9c55p-2, -0x1.9b58aa2bf4ap+0,
        -0x1.547471ad5d1b7p-1, 0x1.427ca653b0f78p-1, 0x1.9b0802601f794p-2, 0x1.2236620b37a69p+7;
    const Body capsule = Body::capsule(4.8966798817474458e-15, 0.10103199806124907);
    const FclObstacles obstacles({{capsule, ofCapsule}}, 3);
    EXPECT_FALSE(obstacles.collides(Body::cylinder(7.2936120514323799e-14, 6.7977885072217717e-14), ofCylinder));
}

/** So many boxes that not all of them are compared. */
TEST(FclObstacles, HaveNoGapBeyondTheirDistanceHoweverManyAreNear)
{
    const Body cube = Body::box(0.2, 0.2, 0.2);
    for (unsigned int seed = 0; seed < scaled(200); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        std::vector<PlacedBody> bodies;
        for (int i = 0; i < 60; ++i)
            bodies.push_back({Body::box(0.05, 0.05, 0.05), poseAt(random.uniform(0.5, 1.0) * random.direction(3))});
        const FclObstacles obstacles(bodies, 3);
        double low = 0.0, high = 2.0;
        while (high - low > 1e-9)
        {
            const double middle = 0.5 * (low + high);
            (obstacles.staysFree(cube, Pose::Identity(), middle) ? low : high) = middle;
        }
        EXPECT_LE(obstacles.gap(cube, Pose::Identity(), 0.001, 2.0), low + 1e-6);
    }
}
