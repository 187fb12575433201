#include "support/RandomMeshes.h"

#include "geometry/TriangleTree.h"

#include <gtest/gtest.h>
#include <limits>

using namespace ompl_certificates;
using namespace ompl_certificates::test;

namespace
{
    constexpr double INF = std::numeric_limits<double>::infinity();

    /** Slow and simple: the nearest point on a grid over the triangle, refined around it */
    double bruteDistance(const Eigen::Vector3d &point, const TriangleTree::Corners &corners)
    {
        const auto &[a, b, c] = corners;
        Eigen::Vector2d middle(0.5, 0.5);
        double nearest = INF;
        for (double width = 0.5; width > 1e-7; width *= 0.5)
        {
            Eigen::Vector2d best = middle;
            for (int i = -4; i <= 4; ++i)
                for (int k = -4; k <= 4; ++k)
                {
                    const double u = std::clamp(middle.x() + i * width / 2.0, 0.0, 1.0);
                    const double v = std::clamp(middle.y() + k * width / 2.0, 0.0, 1.0 - u);
                    const double distance = (a + u * (b - a) + v * (c - a) - point).norm();
                    if (distance < nearest)
                    {
                        nearest = distance;
                        best = {u, v};
                    }
                }
            middle = best;
        }
        return nearest;
    }

    TriangleTree::Corners randomCorners(Random &random, double size)
    {
        const Eigen::Vector3d at = random.point(3, size);
        const double extent = size * random.logUniform(1e-3, 1.0);
        TriangleTree::Corners corners{at + random.point(3, extent), at + random.point(3, extent),
                                      at + random.point(3, extent)};
        if (random.chance(0.1))
            corners[2] = corners[1];
        if (random.chance(0.1))
            corners[1] = 0.5 * (corners[0] + corners[2]);
        if (random.chance(0.1))
            corners[0].z() = corners[1].z() = corners[2].z() = 0.0;
        return corners;
    }
}

TEST(TriangleTree, FindsTheDistanceOfOneTriangle)
{
    for (unsigned int seed = 0; seed < scaled(300); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        TriangleTree tree;
        const auto corners = randomCorners(random, 1.0);
        tree.add(corners, 7);
        tree.build();
        for (int i = 0; i < 5; ++i)
        {
            Eigen::Vector3d point = random.point(3, 2.0);
            if (random.chance(0.2))
                point.z() = 0.0;
            std::uint32_t nearest;
            EXPECT_NEAR(tree.distance(point, INF, &nearest), bruteDistance(point, corners), 2e-6);
            EXPECT_EQ(nearest, 0U);
            EXPECT_EQ(tree.getName(nearest), 7U);
        }
    }
}

TEST(TriangleTree, FindsTheNearestOfMany)
{
    for (unsigned int seed = 0; seed < scaled(200); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const double unit = std::pow(10.0, random.below(10)) * 1e-4;
        const Eigen::Vector3d offset = random.chance(0.3) ? random.point(3, 1000.0 * unit) : Eigen::Vector3d::Zero();
        TriangleTree tree;
        std::vector<TriangleTree> single;
        const unsigned int count = 1 + random.below(random.chance(0.3) ? 2000 : 30);
        for (unsigned int i = 0; i < count; ++i)
        {
            auto corners = randomCorners(random, unit);
            for (auto &corner : corners)
                corner += offset;
            tree.add(corners, i);
            if (random.chance(0.2))  // the same again
                tree.add({corners[2], corners[0], corners[1]}, i + count);
            single.emplace_back();
            single.back().add(corners, i);
            single.back().build();
        }
        tree.build();
        EXPECT_EQ(tree.size(), count);
        for (int i = 0; i < 30; ++i)
        {
            const Eigen::Vector3d point =
                offset + random.point(3, unit * random.logUniform(0.1, random.chance(0.1) ? 1e25 : 10.0));
            double expected = INF;
            for (const auto &other : single)
                expected = std::min(expected, other.distance(point, INF));
            std::uint32_t nearest;
            EXPECT_EQ(tree.distance(point, INF, &nearest), expected);
            ASSERT_LT(nearest, count);
            EXPECT_EQ(single[tree.getName(nearest)].distance(point, INF), expected);
            const double limit = expected * random.uniform(0.5, 1.5);
            EXPECT_EQ(tree.distance(point, limit, &nearest), std::min(limit, expected));
            EXPECT_EQ(nearest == TriangleTree::NONE, limit <= expected);
        }
    }
}

TEST(TriangleTree, OfNoneIsInfinitelyFar)
{
    TriangleTree tree;
    tree.build();
    EXPECT_EQ(tree.size(), 0U);
    EXPECT_EQ(tree.distance({1, 2, 3}, INF), INF);
    EXPECT_TRUE(tree.getBounds().isEmpty());
}
