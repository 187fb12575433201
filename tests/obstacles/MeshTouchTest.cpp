#include "support/MeshObstacles.h"

#include <gtest/gtest.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;

namespace
{
    Touching opposite(bool collides)
    {
        return collides ? Touching::NO : Touching::YES;
    }
}

class MeshTouch : public testing::TestWithParam<unsigned int>
{
};

TEST_P(MeshTouch, NeverSaysWhatTheExactCheckDenies)
{
    unsigned int unknown = 0, yes = 0, no = 0;
    for (unsigned int seed = 0; seed < scaled(400); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const double unit = std::pow(10.0, random.below(8)) * 1e-3;
        const bool mixed = random.chance(0.3);
        const FclObstacles obstacles(randomMeshObstacles(random, GetParam(), unit, mixed ? 0.4 : 0.0), GetParam());
        const double size = unit * random.logUniform(0.01, 3.0);
        const Body body = mixed && random.chance(0.3) ? randomBody(random, GetParam(), size)
                                                      : meshBody(GetParam(), randomMesh(random, size));
        for (int i = 0; i < 250; ++i)
        {
            const Pose pose = nearPose(random, obstacles, body, std::max(size, 0.1 * unit));
            const bool collides = obstacles.collides(body, pose);
            ObstaclePart hit = NO_PART;
            const Touching answer = obstacles.touches(body, pose, &hit);
            ASSERT_NE(answer, opposite(collides)) << pose.matrix();
            if (answer == Touching::YES)
            {
                ASSERT_NE(hit, NO_PART);
                ASSERT_TRUE(obstacles.certainlyHits(body, pose, hit));
            }
            ObstaclePart nearest;
            ASSERT_EQ(obstacles.findNearest(pose.translation(), nearest), obstacles.clearance(pose.translation()));
            if (!collides)
            {
                ASSERT_FALSE(obstacles.certainlyHits(body, pose, nearest));
                ASSERT_FALSE(obstacles.certainlyHits(body, pose, random.below(50)));
            }
            ASSERT_FALSE(obstacles.certainlyHits(body, pose, NO_PART));
            unknown += !mixed && answer == Touching::UNKNOWN;
            yes += answer == Touching::YES;
            no += answer == Touching::NO;
        }
    }
    // Two thirds of these poses were made to just touch.
    EXPECT_GT(yes, scaled(400) * 250 / 10);
    EXPECT_GT(no, scaled(400) * 250 / 10);
    EXPECT_LT(unknown, scaled(400) * 250 / 5);
}

INSTANTIATE_TEST_SUITE_P(Dimension, MeshTouch, testing::Values(2U, 3U));

/** Walls and floors: each triangle is larger than all of the body, whose own are small. */
TEST(MeshTouch, NeverSaysOfLongTrianglesWhatTheExactCheckDenies)
{
    unsigned int yes = 0, no = 0;
    for (unsigned int seed = 0; seed < scaled(60); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        std::vector<Eigen::Vector3d> corners;
        std::vector<std::array<std::uint32_t, 3>> triangles;
        for (std::uint32_t i = 0; i < 3 + random.below(60); ++i)
        {
            const Eigen::Vector3d middle = random.point(3, 3.0), along = random.point(3, 4.0);
            for (const Eigen::Vector3d &corner :
                 {Eigen::Vector3d(middle - along), Eigen::Vector3d(middle + along),
                  Eigen::Vector3d(middle + random.logUniform(1e-3, 4.0) * random.direction(3))})
                corners.push_back(corner);
            triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
        }
        const Body walls = Body::mesh(std::make_shared<TriangleMesh>(corners, triangles)),
                   ball = Body::mesh(ballMesh(16, 0.4));
        // Either may be the obstacle.
        for (const auto &[fixed, body] : {std::make_pair(walls, ball), std::make_pair(ball, walls)})
        {
            const FclObstacles obstacles({{fixed}}, 3);
            for (int i = 0; i < 60; ++i)
            {
                const Pose pose = random.pose(3, 4.0);
                const Touching answer = obstacles.touches(body, pose);
                ASSERT_NE(answer, opposite(obstacles.collides(body, pose))) << pose.matrix();
                yes += answer == Touching::YES;
                no += answer == Touching::NO;
            }
        }
    }
    EXPECT_GT(yes, scaled(60) * 10);
    EXPECT_GT(no, scaled(60) * 10);
}

TEST(MeshTouch, KnowsAlmostAllRandomPoses)
{
    const FclObstacles obstacles({{Body::mesh(ballMesh(20, 5.0))}, {Body::mesh(boxMesh({3, 3, 3})), poseAt({8, 0, 0})}},
                                 3);
    const Body body = Body::mesh(boxMesh({2, 1, 1}));
    unsigned int unknown = 0, colliding = 0;
    for (unsigned int seed = 0; seed < 1000; ++seed)
    {
        Random random(seed);
        const Pose pose = random.pose(3, 8.0);
        const Touching answer = obstacles.touches(body, pose);
        unknown += answer == Touching::UNKNOWN;
        colliding += answer == Touching::YES;
        EXPECT_NE(answer, opposite(obstacles.collides(body, pose)));
    }
    EXPECT_LT(unknown, 5U);
    EXPECT_GT(colliding, 50U);
}

TEST(MeshTouch, HitsATriangleWithASolidBody)
{
    const FclObstacles obstacles({{Body::mesh(boxMesh({10, 10, 10}))}}, 3);
    ObstaclePart part;
    EXPECT_DOUBLE_EQ(obstacles.findNearest({4, 1, 0.5}, part), 1.0);
    ASSERT_NE(part, NO_PART);
    EXPECT_TRUE(obstacles.certainlyHits(Body::sphere(1.5), poseAt({4, 1, 0.5}), part));
    EXPECT_FALSE(obstacles.certainlyHits(Body::sphere(0.9), poseAt({4, 1, 0.5}), part));
    EXPECT_TRUE(obstacles.certainlyHits(Body::box(4, 1, 1), poseAt({4, 1, 0.5}), part));
    ObstaclePart hit = NO_PART;
    EXPECT_EQ(obstacles.touches(Body::sphere(1.5), poseAt({4, 1, 0.5}), &hit), Touching::YES);
    EXPECT_TRUE(obstacles.certainlyHits(Body::sphere(1.5), poseAt({4, 1, 0.5}), hit));
    EXPECT_EQ(obstacles.touches(Body::sphere(0.9), poseAt({4, 1, 0.5})), Touching::NO);
    const FclObstacles primitives({{Body::box(1.0, 1.0, 1.0)}}, 3);
    EXPECT_DOUBLE_EQ(primitives.findNearest({4, 0, 0}, part), 3.5);
    EXPECT_EQ(part, NO_PART);
}
