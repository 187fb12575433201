#include "geometry/MeshInside.h"

#include "ompl_certificates/obstacles/FclObstacles.h"
#include "support/MeshObstacles.h"

#include <gtest/gtest.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;

namespace
{
    /** The mesh without a triangle, or with one turned round */
    TriangleMeshPtr broken(const TriangleMesh &mesh, bool turned)
    {
        std::vector<TriangleMesh::Triangle> triangles = mesh.getTriangles();
        const auto middle = triangles.begin() + static_cast<std::ptrdiff_t>(triangles.size() / 2);
        if (turned)
            std::swap((*middle)[0], (*middle)[1]);
        else
            triangles.erase(middle);
        return std::make_shared<TriangleMesh>(mesh.getVertices(), std::move(triangles));
    }

    TriangleMeshPtr randomSolid(Random &random, double size)
    {
        const auto one = [&]() -> TriangleMeshPtr
        {
            if (random.chance(0.5))
                return boxMesh(size * Eigen::Vector3d(extentOf(random), extentOf(random), extentOf(random)),
                               random.point(3, 0.5 * size));
            return ballMesh(3 + random.below(6), size * random.logUniform(0.1, 0.5));
        };
        return random.chance(0.5) ? one() : joined({one(), one(), randomSoup(random, size)});
    }

    bool meet(const TriangleMeshPtr &here, const TriangleMeshPtr &there, const Pose &pose, double margin = 0.0)
    {
        return here->getInside().touches(there->getInside(), pose, margin);
    }
}

TEST(MeshInside, HasBallsThatNoTriangleReaches)
{
    std::size_t balls = 0;
    for (unsigned int seed = 0; seed < scaled(100); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const double height = random.uniform(0.2, 1.0);
        const TriangleMeshPtr mesh =
            random.chance(0.5) ? boxMesh({1.0, 0.6, height}, random.point(3, 10.0)) : ballMesh(4 + random.below(6));
        for (const Ball &ball : mesh->getInside().getBalls())
        {
            ++balls;
            EXPECT_TRUE(mesh->getBounds().contains(ball.center));
            EXPECT_GT(ball.radius, 0.0);
            EXPECT_LE(ball.radius, mesh->getTree().distance(ball.center, 100.0));
        }
        // The largest one is nearly the largest there is.
        ASSERT_FALSE(mesh->getInside().getBalls().empty());
        const double least = 0.5 * mesh->getBounds().sizes().minCoeff();
        EXPECT_GT(mesh->getInside().getBalls().front().radius, 0.7 * std::min(least, 0.3));
    }
    EXPECT_GT(balls, scaled(400));
}

/** In the hole of a frame fit larger balls than in its bars. */
TEST(MeshInside, HasBallsInTheBarsOfAFrame)
{
    // Of the largest one few candidates can be asked whether they are inside.
    for (const auto &[height, parts] : {std::pair{0.1, 1}, {0.001, 200}, {0.1, 1500}})
    {
        SCOPED_TRACE(std::to_string(height) + " high, " + std::to_string(parts) + " parts");
        // Around a square: corners of the bar's section, at each of its places
        std::vector<Eigen::Vector3d> corners;
        for (int i = 0; i < 4 * parts; ++i)
            for (const double half : {0.5, 0.4})
                for (const double z : {-0.5 * height, 0.5 * height})
                {
                    const double along = 2.0 * half * (i % parts) / parts - half;
                    const Eigen::Vector2d at[] = {{along, -half}, {half, along}, {-along, half}, {-half, -along}};
                    corners.emplace_back(at[i / parts].x(), at[i / parts].y(), z);
                }
        std::vector<TriangleMesh::Triangle> triangles;
        const auto count = static_cast<std::uint32_t>(corners.size());
        constexpr std::uint32_t ring[] = {0, 1, 3, 2};
        for (std::uint32_t at = 0; at < count; at += 4)
            for (int k = 0; k < 4; ++k)
            {
                const std::uint32_t a = at + ring[k], b = at + ring[(k + 1) % 4], c = (a + 4) % count,
                                    d = (b + 4) % count;
                triangles.insert(triangles.end(), {{a, c, b}, {b, c, d}});
            }
        const TriangleMesh frame(corners, triangles);
        ASSERT_TRUE(frame.isClosed());
        EXPECT_GE(frame.getInside().getBalls().size(), 8u);
        for (const Ball &ball : frame.getInside().getBalls())
            EXPECT_GT(ball.center.head<2>().cwiseAbs().maxCoeff(), 0.4);
    }
}

TEST(MeshInside, IsEmptyWhereAMeshIsNotClosed)
{
    for (const TriangleMeshPtr &mesh : {boxMesh({1.0, 2.0, 3.0}), ballMesh(6)})
    {
        EXPECT_FALSE(mesh->getInside().getBalls().empty());
        EXPECT_TRUE(broken(*mesh, false)->getInside().getBalls().empty());
        EXPECT_TRUE(broken(*mesh, true)->getInside().getBalls().empty());
        // Another piece that is open makes no difference.
        EXPECT_FALSE(joined({mesh, broken(*boxMesh({1.0, 1.0, 1.0}), false)})->getInside().getBalls().empty());
    }
}

TEST(MeshInside, OfTwoBoxesThatShareAnEdgeIsThatOfAMeshThatIsNotClosed)
{
    const TriangleMeshPtr box = boxMesh({1, 1, 1});
    EXPECT_TRUE(joined({box, boxMesh({1, 1, 1}, {2, 2, 0})})->isClosed());
    EXPECT_FALSE(joined({box, boxMesh({1, 1, 1}, {1, 1, 0})})->isClosed()) << "four triangles at an edge";
}

TEST(MeshInside, SaysNothingWhereOneMeshContainsTheOther)
{
    const TriangleMeshPtr large = boxMesh({4.0, 4.0, 4.0}), small = boxMesh({1.0, 1.0, 1.0});
    EXPECT_FALSE(meet(large, small, Pose::Identity()));
    EXPECT_FALSE(meet(small, large, Pose::Identity()));
    EXPECT_FALSE(meet(large, small, poseAt({0.0, 0.0, 1.4})));
    EXPECT_TRUE(meet(large, small, poseAt({0.0, 0.0, 1.8})));
    EXPECT_TRUE(meet(small, large, poseAt({0.0, 0.0, 1.8})));
    EXPECT_FALSE(meet(small, large, poseAt({0.0, 0.0, 1.8}), 0.5));
    EXPECT_FALSE(meet(large, small, poseAt({0.0, 0.0, 2.6})));
    EXPECT_FALSE(meet(large, small, poseAt({0.0, std::nan(""), 1.8})));
}

// The mesh may be shifted and turned as far as the margin allows.
TEST(MeshInside, MeetsOnlyWhatFclSaysTouches)
{
    unsigned int meeting = 0, touching = 0;
    for (unsigned int seed = 0; seed < scaled(300); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const double size = random.logUniform(1e-3, 1e3);
        const TriangleMeshPtr here = randomSolid(random, size), there = randomSolid(random, size);
        const Body body = Body::mesh(there);
        const FclObstacles fcl({{Body::mesh(here)}}, 3);
        for (int i = 0; i < 30; ++i)
        {
            const Pose pose = random.pose(3, 0.7 * size);
            const double margin = random.chance(0.5) ? 0.0 : size * random.logUniform(1e-3, 0.3);
            touching += fcl.collides(body, pose) ? 1 : 0;
            if (!meet(here, there, pose, margin))
                continue;
            ++meeting;
            for (int k = 0; k < 4; ++k)
                ASSERT_TRUE(fcl.collides(body, poseAt(margin * random.uniform(0.0, 1.0) * random.direction(3)) * pose))
                    << "margin " << margin << " at\n"
                    << pose.matrix();
        }
    }
    EXPECT_GT(meeting, scaled(500));
    EXPECT_GT(touching, meeting);
}
