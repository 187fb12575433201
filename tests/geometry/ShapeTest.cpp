#include "support/Message.h"
#include "support/RandomBodies.h"
#include "support/RandomMeshes.h"

#include <atomic>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/narrowphase/collision.h>
#include <gtest/gtest.h>
#include <ompl/util/Exception.h>
#include <thread>

using namespace ompl_certificates;
using namespace ompl_certificates::test;

namespace
{
    /** A point about a shape, in the shape's own plane if it is planar */
    Eigen::Vector3d queryFor(Random &random, const Shape &shape, double half)
    {
        const Eigen::Vector3d point = random.point(shape.getDimension(), half);
        const bool upright = shape.getDimension() == 2 && shape.getKind() == Shape::Kind::CAPSULE;
        return upright ? Eigen::Vector3d(0.0, point.x(), point.y()) : point;
    }

    /** The direction in which the signed distance grows fastest */
    Eigen::Vector3d gradientAt(const Shape &shape, const Eigen::Vector3d &point, double step)
    {
        const bool planar = shape.getDimension() == 2, upright = planar && shape.getKind() == Shape::Kind::CAPSULE;
        Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
        for (Eigen::Index axis = 0; axis < 3; ++axis)
            if (!planar || axis != (upright ? 0 : 2))
            {
                const Eigen::Vector3d along = step * Eigen::Vector3d::Unit(axis);
                gradient[axis] = shape.signedDistance(point + along) - shape.signedDistance(point - along);
            }
        return gradient.normalized();
    }

    /** Whether FCL finds the shape and a ball in contact */
    bool touches(const Shape &shape, const Eigen::Vector3d &center, double radius)
    {
        const auto ball = std::make_shared<fcl::Sphered>(Shape::FCL_SCALE * radius);
        fcl::CollisionObjectd a(shape.getCollisionGeometry()), b(ball, poseAt(Shape::FCL_SCALE * center));
        fcl::CollisionRequestd request;
        fcl::CollisionResultd result;
        return fcl::collide(&a, &b, request, result) > 0;
    }
}

class RandomShape : public testing::TestWithParam<unsigned int>
{
protected:
    template <typename Test>
    void forMany(unsigned int count, const Test &test)
    {
        for (unsigned int seed = 0; seed < scaled(count); ++seed)
        {
            SCOPED_TRACE("seed " + std::to_string(seed));
            Random random(seed);
            const double size = random.logUniform(1e-3, 1e3);
            const Shape shape = randomShape(random, GetParam(), size);
            test(random, shape, size);
            if (HasFatalFailure())
                return;
        }
    }
};

TEST_P(RandomShape, HoldsItsPointsAndIsNoFartherThanTheyAre)
{
    forMany(500,
            [](Random &random, const Shape &shape, double size)
            {
                const Eigen::Vector3d query = queryFor(random, shape, size);
                const double distance = shape.signedDistance(query);
                for (int i = 0; i < 100; ++i)
                {
                    const Eigen::Vector3d point = pointOf(random, shape);
                    ASSERT_LE(shape.signedDistance(point), 1e-9 * size);
                    ASSERT_TRUE(shape.getBounds().exteriorDistance(point) < 1e-9 * size);
                    ASSERT_LE(distance, (query - point).norm() + 1e-9 * size);
                }
            });
}

TEST_P(RandomShape, HasA1LipschitzSignedDistance)
{
    forMany(500,
            [](Random &random, const Shape &shape, double size)
            {
                for (int i = 0; i < 50; ++i)
                {
                    const Eigen::Vector3d a = queryFor(random, shape, size);
                    const Eigen::Vector3d b = a + queryFor(random, shape, size * random.logUniform(1e-6, 1.0));
                    ASSERT_LE(std::abs(shape.signedDistance(a) - shape.signedDistance(b)),
                              (a - b).norm() + 1e-12 * size);
                }
            });
}

TEST_P(RandomShape, ReachesItsSurfaceAfterExactlyItsSignedDistance)
{
    forMany(500,
            [](Random &random, const Shape &shape, double size)
            {
                for (int i = 0; i < 20; ++i)
                {
                    const Eigen::Vector3d query = queryFor(random, shape, size);
                    const double distance = shape.signedDistance(query);
                    const Eigen::Vector3d foot = query - distance * gradientAt(shape, query, 1e-8 * size);
                    ASSERT_NEAR(shape.signedDistance(foot), 0.0, 1e-5 * size) << query.transpose();
                }
            });
}

TEST_P(RandomShape, TouchesABallForFclIfItsSignedDistanceSaysSo)
{
    forMany(500,
            [](Random &random, const Shape &shape, double size)
            {
                for (int i = 0; i < 20; ++i)
                {
                    const Eigen::Vector3d query = queryFor(random, shape, size);
                    const double distance = shape.signedDistance(query);
                    const double radius = std::abs(distance) + 0.01 * size;
                    if (std::abs(distance) > 0.01 * size)
                    {
                        ASSERT_EQ(touches(shape, query, 0.009 * size), distance < 0.0) << query.transpose();
                    }
                    ASSERT_TRUE(touches(shape, query, radius)) << query.transpose();
                    if (distance > 0.0)
                    {
                        ASSERT_FALSE(touches(shape, query, distance * (1.0 - 1e-4))) << query.transpose();
                    }
                }
            });
}

INSTANTIATE_TEST_SUITE_P(Dimension, RandomShape, testing::Values(2U, 3U));

TEST(Shape, MeasuresDistancesExactly)
{
    EXPECT_DOUBLE_EQ(Shape::ball(2, 1.0).signedDistance({3.0, 4.0, 0.0}), 4.0);
    EXPECT_DOUBLE_EQ(Shape::ball(3, 1.0).signedDistance({0.0, 0.0, 0.5}), -0.5);
    const Shape rectangle = Shape::box(Eigen::Vector2d(2.0, 4.0));
    EXPECT_DOUBLE_EQ(rectangle.signedDistance({4.0, 6.0, 0.0}), 5.0);
    EXPECT_DOUBLE_EQ(rectangle.signedDistance({0.5, 0.0, 0.0}), -0.5);
    const Shape box = Shape::box(Eigen::Vector3d(2.0, 4.0, 6.0));
    EXPECT_DOUBLE_EQ(box.signedDistance({2.0, 4.0, 5.0}), 3.0);
    EXPECT_DOUBLE_EQ(box.signedDistance({0.0, 0.0, 2.75}), -0.25);
    const Shape capsule = Shape::capsule(3, 0.5, 2.0);
    EXPECT_DOUBLE_EQ(capsule.signedDistance({0.0, 3.0, 5.0}), 4.5);
    EXPECT_DOUBLE_EQ(capsule.signedDistance({0.25, 0.0, 0.5}), -0.25);
    const Shape cylinder = Shape::cylinder(1.0, 2.0);
    EXPECT_DOUBLE_EQ(cylinder.signedDistance({4.0, 0.0, 5.0}), 5.0);
    EXPECT_DOUBLE_EQ(cylinder.signedDistance({0.0, 0.0, 0.0}), -1.0);
    EXPECT_DOUBLE_EQ(cylinder.signedDistance({0.0, 0.5, 0.75}), -0.25);
}

TEST(Shape, RefusesSizesThatAreNotPositiveAndFinite)
{
    const double infinity = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
    for (const double bad : {0.0, -1.0, infinity, nan})
    {
        EXPECT_THROW(Shape::box(Eigen::Vector2d(1.0, bad)), ompl::Exception);
        EXPECT_THROW(Shape::box(Eigen::Vector2d(bad, 1.0)), ompl::Exception);
        EXPECT_THROW(Shape::box(Eigen::Vector3d(1.0, bad, 1.0)), ompl::Exception);
        EXPECT_THROW(Shape::box(Eigen::Vector3d(1.0, 1.0, bad)), ompl::Exception);
        EXPECT_THROW(Shape::capsule(2, bad, 1.0), ompl::Exception);
        EXPECT_THROW(Shape::capsule(3, 1.0, bad), ompl::Exception);
        EXPECT_THROW(Shape::cylinder(bad, 1.0), ompl::Exception);
        EXPECT_THROW(Shape::cylinder(1.0, bad), ompl::Exception);
    }
    for (const double bad : {-1.0, infinity, nan})
        EXPECT_THROW(Shape::ball(2, bad), ompl::Exception);
    EXPECT_NO_THROW(Shape::ball(3, 0.0));
    EXPECT_THROW(Shape::ball(1, 1.0), ompl::Exception);
    EXPECT_THROW(Shape::capsule(4, 1.0, 1.0), ompl::Exception);
    EXPECT_NE(messageOf([] { Shape::box(Eigen::Vector2d(1e30, 1.0)); }).find("A box of 1e+30 by 1 is too thin"),
              std::string::npos);
    // As thin as a polytope must not be; it is named as what it is.
    EXPECT_NO_THROW(Shape::box(Eigen::Vector3d(1.0, 1.0, 1e-6)));
    EXPECT_NE(
        messageOf([] { Shape::box(Eigen::Vector3d(1.0, 1.0, 4e-7)); }).find("A box must be thicker than 3e-07 of"),
        std::string::npos);
}

TEST(Shape, EqualsOnlyItsLike)
{
    const Shape box = Shape::box(Eigen::Vector2d(1.0, 2.0));
    EXPECT_TRUE(box == Shape::box(Eigen::Vector2d(1.0, 2.0)));
    EXPECT_FALSE(box == Shape::box(Eigen::Vector2d(1.0, 2.5)));
    EXPECT_FALSE(Shape::ball(2, 1.0) == Shape::ball(3, 1.0));
    EXPECT_FALSE(Shape::capsule(3, 1.0, 2.0) == Shape::cylinder(1.0, 2.0));
    const std::vector<Eigen::Vector3d> corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
        others{{0, 0, 0}, {1, 0, 0}, {0, 2, 0}};
    EXPECT_TRUE(Shape::polytope(2, corners) == Shape::polytope(2, corners));
    EXPECT_FALSE(Shape::polytope(2, corners) == Shape::polytope(2, others));
    // Of equal vertices, but one has a hole.
    const TriangleMeshPtr closed = boxMesh({1, 1, 1});
    std::vector<TriangleMesh::Triangle> triangles = closed->getTriangles();
    triangles.pop_back();
    const auto open = std::make_shared<TriangleMesh>(closed->getVertices(), triangles);
    EXPECT_TRUE(Shape::mesh(3, closed) == Shape::mesh(3, boxMesh({1, 1, 1})));
    EXPECT_FALSE(Shape::mesh(3, closed) == Shape::mesh(3, open));
}

TEST(ShapeThreads, MakeOneGeometryForFclAndAllItsCopies)
{
    for (unsigned int round = 1; round <= scaled(20); ++round)
    {
        SCOPED_TRACE("round " + std::to_string(round));
        // So many triangles that the threads meet while FCL's tree is made
        const Shape shape = Shape::mesh(3, ballMesh(20)), copy = shape;
        const Shape *const asked[]{&shape, &copy, &shape};
        const void *seen[3];
        std::atomic<int> waiting{3};
        std::vector<std::thread> threads;
        for (std::size_t i = 0; i < 3; ++i)
            threads.emplace_back(
                [&, i]
                {
                    for (--waiting; waiting > 0;)
                        std::this_thread::yield();
                    seen[i] = asked[i]->getCollisionGeometry().get();
                });
        for (auto &thread : threads)
            thread.join();
        for (const void *each : seen)
            EXPECT_EQ(each, shape.getCollisionGeometry().get());
    }
}
