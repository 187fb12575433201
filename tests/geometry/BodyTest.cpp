#include "support/RandomBodies.h"

#include <gtest/gtest.h>
#include <limits>
#include <ompl/util/Exception.h>
#include <thread>

using namespace ompl_certificates;
using namespace ompl_certificates::test;

// Eigen aligns by how a program is compiled, and the library may be compiled otherwise.
static_assert(alignof(Pose) == alignof(double), "poses must lie alike in all programs");
static_assert(alignof(Body::Part) <= alignof(std::max_align_t), "parts must lie alike in all programs");

TEST(Body, RefusesSizesThatAreNotPositiveAndFinite)
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(Body::disc(-0.1), ompl::Exception);
    EXPECT_THROW(Body::sphere(nan), ompl::Exception);
    EXPECT_THROW(Body::box(1.0, 0.0), ompl::Exception);
    EXPECT_THROW(Body::box(1.0, 1.0, -1.0), ompl::Exception);
    EXPECT_THROW(Body::planarCapsule(0.0, 1.0), ompl::Exception);
    EXPECT_THROW(Body::capsule(1.0, nan), ompl::Exception);
    EXPECT_THROW(Body::cylinder(-1.0, 1.0), ompl::Exception);
    EXPECT_THROW(Body::convexPolygon({{0, 0}, {1, 1}}), ompl::Exception);
    EXPECT_THROW(Body::convexPolytope({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}), ompl::Exception);
}

TEST(Body, IsJoinedOfBodiesAtTheirPoses)
{
    const Shape box = Shape::box(Eigen::Vector2d(1.0, 2.0)), disc = Shape::ball(2, 0.5);
    const Pose one = planarPose(1.0, 0.0), other = planarPose(0.0, 3.0), pose = planarPose(2.0, -1.0, 0.5);
    EXPECT_EQ(Body::join({{Body({{box, one}, {disc, other}}), pose}, {Body::disc(0.5)}}),
              Body({{box, pose * one}, {disc, pose * other}, {disc, Pose::Identity()}}));
    EXPECT_THROW(Body::join({}), ompl::Exception);
    EXPECT_THROW(Body::join({{Body::disc(1.0)}, {Body::sphere(1.0)}}), ompl::Exception);
}

TEST(Body, RefusesAConcaveOutlineAndNamesThePoint)
{
    const auto complaintOf = [](const auto &points, const auto &make) -> std::string
    {
        try
        {
            make(points);
        }
        catch (const ompl::Exception &exception)
        {
            return exception.what();
        }
        return "";
    };
    const std::vector<Eigen::Vector2d> angle{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
    EXPECT_NE(complaintOf(angle, [](const auto &points) { return Body::convexPolygon(points); })
                  .find("Point 3 of 6 (counted from 0), (1.000000, 1.000000), lies inside the convex hull"),
              std::string::npos);
    std::vector<Eigen::Vector3d> dented;
    for (const double z : {0.0, 1.0})
        for (const auto &point : angle)
            dented.emplace_back(point.x(), point.y(), z);
    // The dent's own edge ends on two faces of the hull.
    EXPECT_NO_THROW(Body::convexPolytope(dented));
    dented.emplace_back(1.0, 1.0, 0.5);
    EXPECT_NE(complaintOf(dented, [](const auto &points) { return Body::convexPolytope(points); })
                  .find("Point 12 of 13 (counted from 0), (1.000000, 1.000000, 0.500000), lies inside"),
              std::string::npos);

    // Whoever wants the hull asks for it by name.
    EXPECT_EQ(Body::convexHull(angle).getParts().front().shape.getHull()->vertices.size(), 5U);
    EXPECT_EQ(Body::convexHull(dented).getParts().front().shape.getHull()->vertices.size(), 10U);
}

TEST(Body, TakesCornersInAnyOrderPointsOnEdgesAndRepeatedOnes)
{
    for (const double far : {0.0, 1e6})
    {
        std::vector<Eigen::Vector2d> points{{2, 2}, {0, 0}, {2, 0}, {0, 2}, {1, 0}, {0, 0}, {1.5, 2}, {2, 0.5}};
        // Written down with seven digits
        points.emplace_back(1.0, 1e-7);
        std::vector<Eigen::Vector3d> prism;
        for (auto &point : points)
        {
            point.x() += far;
            for (const double z : {-1.0, 0.0, 1.0})
                prism.emplace_back(point.x(), point.y(), z);
        }
        EXPECT_EQ(Body::convexPolygon(points).getParts().front().shape.getHull()->vertices.size(), 4U);
        // All points in the middle of the prism's sides, none inside
        EXPECT_EQ(Body::convexPolytope(prism).getParts().front().shape.getHull()->vertices.size(), 8U);
    }
}

TEST(Body, RefusesNoPartsMixedPartsAndPosesThatAreNotFinite)
{
    const Shape disc = Shape::ball(2, 1.0), sphere = Shape::ball(3, 1.0);
    EXPECT_THROW(Body(std::vector<Body::Part>{}), ompl::Exception);
    EXPECT_THROW(Body({{disc, Pose::Identity()}, {sphere, Pose::Identity()}}), ompl::Exception);
    EXPECT_THROW(Body({{disc, planarPose(std::numeric_limits<double>::infinity(), 0.0)}}), ompl::Exception);
}

TEST(Body, TakesRoundedRotationsForTrueOnes)
{
    Pose rounded = Pose::Identity();
    rounded.linear() << 0.866, -0.5, 0.0, 0.5, 0.866, 0.0, 0.0, 0.0, 1.0;
    const Pose pose =
        Body({{Shape::polytope(3, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}), rounded}}).getParts()[0].pose;
    EXPECT_LT((pose.linear().transpose() * pose.linear() - Eigen::Matrix3d::Identity()).norm(), 1e-15);
    EXPECT_LT((pose.linear() - rounded.linear()).norm(), 1e-3);
    const Pose exact = planarPose(1.0, 2.0, 0.3);
    EXPECT_EQ(Body({{Body::disc(1.0).getParts()[0].shape, exact}}).getParts()[0].pose.matrix(), exact.matrix());
    Pose larger = Pose::Identity(), mirror = Pose::Identity();
    larger.linear() *= 1.01;
    mirror.linear()(0, 0) = -1.0;
    for (const Pose &bad : {larger, mirror})
        EXPECT_THROW(Body({{Body::sphere(1.0).getParts()[0].shape, bad}}), ompl::Exception);
}

TEST(Body, RefusesPlanarPartsThatLeaveThePlane)
{
    Pose lifted = Pose::Identity(), tilted = Pose::Identity();
    lifted.translation().z() = 0.1;
    tilted.linear() = Eigen::AngleAxisd(0.1, Eigen::Vector3d::UnitX()).toRotationMatrix();
    const Body::Part part = Body::box(1.0, 2.0).getParts().front();
    EXPECT_NO_THROW(Body({{part.shape, planarPose(1.0, 2.0, 3.0)}}));
    EXPECT_THROW(Body({{part.shape, lifted}}), ompl::Exception);
    EXPECT_THROW(Body({{part.shape, tilted}}), ompl::Exception);
}

TEST(Body, KnowsItsDimensionAndWhetherItIsABall)
{
    EXPECT_EQ(Body::disc(1.0).getDimension(), 2U);
    EXPECT_EQ(Body::box(1.0, 1.0, 1.0).getDimension(), 3U);
    EXPECT_TRUE(Body::disc(0.0).isBall());
    EXPECT_TRUE(Body::sphere(1.0).isBall());
    EXPECT_FALSE(Body::planarCapsule(1.0, 1.0).isBall());
    const Body::Part disc{Shape::ball(2, 1.0), Pose::Identity()};
    EXPECT_FALSE(Body({disc, disc}).isBall());
}

TEST(Body, LaysAPlanarCapsuleAlongX)
{
    const Body body = Body::planarCapsule(0.5, 4.0);
    EXPECT_NEAR(body.signedDistance({2.5, 0.0, 0.0}), 0.0, 1e-15);
    EXPECT_NEAR(body.signedDistance({0.0, 2.5, 0.0}), 2.0, 1e-15);
    EXPECT_NEAR(body.getBoundingRadius(), 2.5, 1e-12);
}

TEST(Body, EqualsABodyOfTheSamePartsInTheSameOrder)
{
    const Body::Part disc{Shape::ball(2, 1.0), planarPose(1.0, 0.0)};
    const Body::Part box{Shape::box(Eigen::Vector2d(1.0, 2.0)), planarPose(0.0, 0.0, 0.5)};
    EXPECT_TRUE(Body({disc, box}) == Body({disc, box}));
    EXPECT_FALSE(Body({disc, box}) == Body({box, disc}));
    EXPECT_FALSE(Body({disc, box}) == Body({disc}));
    EXPECT_FALSE(Body({disc}) == Body({disc, box}));
    EXPECT_FALSE(Body({disc}) == Body({{disc.shape, planarPose(1.0, 1e-9)}}));
    EXPECT_TRUE(Body::box(1.0, 2.0) == Body::box(1.0, 2.0));
    EXPECT_FALSE(Body::box(1.0, 2.0) == Body::box(2.0, 1.0));
    const Body body = Body::disc(1.0), copy = body;
    EXPECT_TRUE(body == copy);
}

TEST(Body, BoundingRadiusIsThatOfTheFarthestPoint)
{
    for (unsigned int seed = 0; seed < scaled(300); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const unsigned int dimension = 2 + random.below(2);
        const Body body = randomBody(random, dimension, 1.0);
        for (int i = 0; i < 200; ++i)
            ASSERT_LE(pointOf(random, body).norm(), body.getBoundingRadius() * (1.0 + 1e-12));
    }
    EXPECT_DOUBLE_EQ(Body::box(6.0, 8.0).getBoundingRadius(), 5.0);
    EXPECT_DOUBLE_EQ(Body::cylinder(3.0, 8.0).getBoundingRadius(), 5.0);
    EXPECT_DOUBLE_EQ(Body::disc(0.0).getBoundingRadius(), 0.0);
}

TEST(Body, MakesItsBallsOnceForAllThreads)
{
    for (int round = 0; round < 20; ++round)
    {
        const Body body = Body::box(1.0, 2.0, 3.0);
        const SphereTree *trees[4];
        std::vector<std::thread> threads;
        for (auto &tree : trees)
            threads.emplace_back([&tree, copy = body] { tree = &copy.getSphereTree(); });
        for (auto &thread : threads)
            thread.join();
        for (const SphereTree *tree : trees)
            EXPECT_EQ(tree, &body.getSphereTree());
    }
}
