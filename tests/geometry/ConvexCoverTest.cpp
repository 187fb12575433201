#include "geometry/ConvexCover.h"

#include "support/Random.h"
#include "support/RandomBodies.h"
#include "support/RandomMeshes.h"

#include <gtest/gtest.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;

namespace
{
    Eigen::Vector3d anyPointOf(Random &random, const Body::Part &part)
    {
        const TriangleMesh *mesh = part.shape.getMesh();
        if (!mesh)
            return part.pose * pointOf(random, part.shape);
        const auto [a, b, c] = mesh->getCorners(random.below(mesh->getTriangles().size()));
        const double u = random.uniform(0.0, 1.0), v = random.uniform(0.0, 1.0 - u);
        Eigen::Vector3d point = part.pose * (a + u * (b - a) + v * (c - a));
        if (part.shape.getDimension() == 2)
            point.z() = 0.0;
        return point;
    }

    Body anyBody(Random &random, unsigned int dimension, double size)
    {
        if (random.chance(0.3))
            return Body::mesh(ballMesh(20, size));  // more corners than a cover has
        return random.chance(0.4) ? randomMeshBody(random, dimension, size) : randomBody(random, dimension, size);
    }
}

TEST(ConvexCover, ContainsItsShape)
{
    for (unsigned int seed = 0; seed < scaled(300); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const unsigned int dimension = 2 + seed % 2;
        const Body body = anyBody(random, dimension, random.logUniform(0.01, 100.0));
        const auto &covers = body.getConvexCovers();
        ASSERT_EQ(covers.size(), body.getParts().size());
        for (std::size_t i = 0; i < covers.size(); ++i)
            for (int k = 0; k < 100; ++k)
            {
                const Eigen::Vector3d point = anyPointOf(random, body.getParts()[i]) - covers[i].getCenter();
                const Eigen::Vector3d direction = random.chance(0.5) ? random.direction(3) : point.normalized();
                ASSERT_LE(direction.dot(point - covers[i].farthest(direction)) - covers[i].getRounding(),
                          1e-12 * body.getBoundingRadius());
            }
    }
}

/** The middle of a cover is that of the box around its shape, and may be a corner that sticks out. */
TEST(ConvexCover, ContainsACornerInItsMiddle)
{
    std::vector<Eigen::Vector3d> corners{{0, 0, 0},    {1, -1, -1},    {-1, 1, -1},   {-1, -1, 1},
                                         {1, 0.8, -1}, {1, -1, -0.05}, {-1, 1, -0.05}};
    std::vector<TriangleMesh::Triangle> triangles;
    for (std::uint32_t i = 1; i < 7; ++i)
        for (std::uint32_t j = i + 1; j < 7; ++j)
            triangles.push_back({0, i, j});
    // More than a cover takes without a choice
    for (int i = 0; i < 60; ++i)
        corners.emplace_back(-1.0 + 0.01 * i, -1.0 + 0.005 * ((i * 7) % 60), -1.0 + 0.003 * ((i * 11) % 60));
    for (std::uint32_t i = 7; i + 2 < corners.size(); ++i)
        triangles.push_back({i, i + 1, i + 2});
    const Shape shape = Shape::mesh(3, std::make_shared<TriangleMesh>(corners, triangles));
    const ConvexCover cover(shape, Pose::Identity());
    Random random(1);
    for (int k = 0; k < 1000; ++k)
    {
        const Eigen::Vector3d direction = k == 0 ? Eigen::Vector3d(1.0, 1.0, 1.9).normalized() : random.direction(3);
        for (const Eigen::Vector3d &corner : corners)
            ASSERT_LE(direction.dot(corner - cover.getCenter() - cover.farthest(direction)) - cover.getRounding(), 1e-12)
                << corner.transpose() << " along " << direction.transpose();
    }
}

TEST(ConvexCover, IsTight)
{
    const ConvexCover box(Shape::box(Eigen::Vector3d(1.0, 2.0, 3.0)), Pose::Identity());
    EXPECT_NEAR(box.farthest({1.0, 0.0, 0.0}).x() + box.getRounding(), 0.5, 1e-5);
    const ConvexCover ball(Shape::ball(3, 2.0), Pose::Identity());
    EXPECT_NEAR(ball.getRounding(), 2.0, 1e-5);
    const ConvexCover cylinder(Shape::cylinder(1.0, 4.0), Pose::Identity());
    EXPECT_NEAR(cylinder.farthest({1.0, 0.0, 0.0}).x() + cylinder.getRounding(), 1.0, 0.02);
    const ConvexCover mesh(Shape::mesh(3, ballMesh(30, 1.0)), Pose::Identity());
    EXPECT_GT(mesh.getRounding(), 0.0);
    EXPECT_LT(mesh.getRounding(), 0.12);
}

TEST(ConvexGap, IsALowerBoundOfTheDistance)
{
    for (unsigned int seed = 0; seed < scaled(2000); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const unsigned int dimension = 2 + seed % 2;
        const double size = random.logUniform(0.01, 100.0);
        const Body first = anyBody(random, dimension, size), second = anyBody(random, dimension, size);
        const Pose pose = random.pose(dimension, 2.0 * size);
        const double needed = random.chance(0.5) ? 0.0 : random.uniform(0.0, 0.5 * size);
        const double wanted = random.chance(0.5) ? 100.0 * size : needed;
        Eigen::Vector3d direction = random.chance(0.5) ? Eigen::Vector3d::Zero() : random.direction(dimension);
        const double gap = convexGap(first, second, pose, needed, wanted, direction);
        for (int k = 0; gap > needed && k < 200; ++k)
        {
            const auto &one = first.getParts()[random.below(first.getParts().size())];
            const auto &other = second.getParts()[random.below(second.getParts().size())];
            ASSERT_LE(gap, (anyPointOf(random, one) - pose * anyPointOf(random, other)).norm());
        }
    }
}

TEST(ConvexGap, FindsMostOfTheDistance)
{
    for (unsigned int seed = 0; seed < scaled(2000); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const Body box =
            Body::box(random.logUniform(0.1, 1.0), random.logUniform(0.1, 1.0), random.logUniform(0.1, 1.0));
        const Body ball = Body::sphere(random.uniform(0.1, 1.0));
        const Pose pose = random.pose(3, 3.0);
        const double distance = box.signedDistance(pose.translation()) - ball.getBoundingRadius();
        Eigen::Vector3d direction = random.chance(0.5) ? Eigen::Vector3d::Zero() : random.direction(3);
        const double gap = convexGap(box, ball, pose, 0.0, 100.0, direction);
        if (distance > 1e-3)
        {
            ASSERT_GT(gap, 0.85 * (distance + ball.getBoundingRadius()) - ball.getBoundingRadius() - 1e-4);
            // From that direction the bound is found at once, and again.
            ASSERT_GE(convexGap(box, ball, pose, 0.0, gap - 1e-6, direction), gap - 1e-6);
        }
    }
}

TEST(ConvexGap, OfBallsIsTheirs)
{
    for (unsigned int seed = 0; seed < scaled(500); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const auto balls = [&random]
        {
            std::vector<Body::Part> parts;
            for (std::size_t count = 1 + random.below(6); count > 0; --count)
                parts.push_back({Shape::ball(3, random.uniform(0.1, 0.5)), poseAt(random.point(3, 1.0))});
            return Body(parts);
        };
        const Body first = balls(), second = balls();
        const Pose pose = random.pose(3, 3.0);
        double least = std::numeric_limits<double>::infinity();
        for (const Body::Part &one : first.getParts())
            for (const Body::Part &other : second.getParts())
                least = std::min(least, (one.pose.translation() - pose * other.pose.translation()).norm() -
                                            (one.shape.getRadius() + other.shape.getRadius()));
        Eigen::Vector3d direction = Eigen::Vector3d::Zero();
        const double gap = convexGap(first, second, pose, 0.0, 100.0, direction);
        if (least > 1e-6)
        {
            ASSERT_NEAR(gap, least, 1e-5);
        }
        else
        {
            ASSERT_LT(gap, 1e-5);
        }
    }
}

TEST(ConvexGap, OfPosesThatAreNotFiniteProvesNothing)
{
    const Body box = Body::box(1.0, 1.0, 1.0);
    Pose pose = Pose::Identity();
    Eigen::Vector3d direction = Eigen::Vector3d::Zero();
    pose.translation().x() = std::numeric_limits<double>::quiet_NaN();
    EXPECT_LT(convexGap(box, box, pose, 0.0, 1.0, direction), 0.0);
    pose.translation().x() = std::numeric_limits<double>::infinity();
    EXPECT_LT(convexGap(box, box, pose, 0.0, 1.0, direction), 0.0);
    // Squares of these are infinite.
    const Body two = Body(std::vector<Body::Part>{{Shape::ball(3, 1.0), poseAt({0.0, 0.0, 1.0})},
                                                  {Shape::ball(3, 1.0), Pose::Identity()}});
    pose.translation().x() = 1e200;
    for (const Body &body : {box, two})
        EXPECT_LT(convexGap(body, body, pose, 0.0, 1.0, direction), 0.0);
    pose = Pose::Identity();
    pose.linear()(0, 0) = std::numeric_limits<double>::quiet_NaN();
    EXPECT_LT(convexGap(box, box, pose, 0.0, 1.0, direction), 0.0);
}
