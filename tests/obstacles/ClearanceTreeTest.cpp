#include "support/RandomBodies.h"

#include "obstacles/ClearanceTree.h"

#include <gtest/gtest.h>
#include <limits>

using namespace ompl_certificates;
using namespace ompl_certificates::test;

namespace
{
    struct Placed
    {
        Shape shape;
        Pose pose;
    };

    std::vector<Placed> randomShapes(Random &random, unsigned int dimension)
    {
        std::vector<Placed> shapes;
        for (unsigned int count = random.below(40); count > 0; --count)
        {
            const double size = random.logUniform(0.1, 8.0);
            const Body::Part part = placed(randomShape(random, dimension, size), random.pose(dimension, 4.0));
            shapes.push_back({part.shape, part.pose});
        }
        return shapes;
    }
}

class RandomClearanceTree : public testing::TestWithParam<unsigned int>
{
};

TEST_P(RandomClearanceTree, FindsTheSmallestSignedDistance)
{
    for (unsigned int seed = 0; seed < scaled(300); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const auto shapes = randomShapes(random, GetParam());
        ClearanceTree tree;
        for (const auto &[shape, pose] : shapes)
            tree.add(shape, pose);
        tree.build();
        ASSERT_EQ(tree.size(), shapes.size());
        for (int i = 0; i < 50; ++i)
        {
            const Eigen::Vector3d point = random.point(GetParam(), 6.0);
            double nearest = std::numeric_limits<double>::infinity();
            for (const auto &[shape, pose] : shapes)
                nearest = std::min(nearest, shape.signedDistance(pose.inverse() * point));
            if (shapes.empty())
            {
                ASSERT_EQ(tree.signedDistance(point), nearest);
            }
            else
            {
                ASSERT_NEAR(tree.signedDistance(point), nearest, 1e-12) << point.transpose();
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Dimension, RandomClearanceTree, testing::Values(2U, 3U));

TEST(ClearanceTree, FindsDepthsOfFlatShapesBesideCapsules)
{
    // A capsule sticks out of the plane; that must not hide how deep a point is in a rectangle.
    ClearanceTree tree;
    const auto capsule = Body::planarCapsule(0.1, 1.0).getParts().front();
    tree.add(Shape::box(Eigen::Vector2d(2.0, 2.0)), planarPose(-1.0, 0.0));
    tree.add(Shape::box(Eigen::Vector2d(4.0, 4.0)), planarPose(0.0, 0.0));
    for (const double x : {0.0, 1.0, -1.0, 0.5})
        tree.add(capsule.shape, planarPose(x, 0.0) * capsule.pose);
    tree.build();
    EXPECT_NEAR(tree.signedDistance({0.0, 0.0, 0.0}), -2.0, 1e-12);
    EXPECT_NEAR(tree.signedDistance({-1.0, 0.0, 0.0}), -1.0, 1e-12);
}
