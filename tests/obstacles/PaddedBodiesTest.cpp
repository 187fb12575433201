#include "support/MeshObstacles.h"
#include "support/RandomCells.h"
#include "support/RandomClouds.h"
#include "support/RandomStates.h"

#include "geometry/WithinDistance.h"

#include "ompl_certificates/obstacles/CellObstacles.h"
#include "ompl_certificates/obstacles/CheckObstacles.h"
#include "ompl_certificates/obstacles/MixedObstacles.h"
#include "ompl_certificates/obstacles/PointCloudObstacles.h"

#include <gtest/gtest.h>
#include <numeric>

using namespace ompl_certificates;
using namespace ompl_certificates::test;

namespace
{
    /** A body with a padding, up to its size */
    Body randomPaddedBody(Random &random, unsigned int dimension, double size)
    {
        const Body body =
            random.chance(0.4) ? randomMeshBody(random, dimension, size) : randomBody(random, dimension, size);
        return body.padded(size * random.logUniform(1e-3, 1.0));
    }
}

class PaddedBodies : public testing::TestWithParam<unsigned int>
{
};

/** All answers, as certificates rely on them: clearances, gaps, hits, and what stays free */
TEST_P(PaddedBodies, FulfilTheContractOfObstacles)
{
    const unsigned int dimension = GetParam();
    for (unsigned int seed = 0; seed < scaled(20); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const auto padded = [&] { return randomPaddedBody(random, dimension, random.logUniform(0.1, 2.0)); };
        const std::vector<Body> bodies{padded(), padded(), padded()};
        const ompl::base::RealVectorBounds bounds = cubeBounds(dimension, 4.0);
        ZInterval heights;
        std::vector<PlacedBody> solids, meshes;
        for (int i = 0; i < 5; ++i)
        {
            solids.push_back({randomBody(random, dimension, random.logUniform(0.2, 2.0)), random.pose(dimension, 3.0)});
            meshes.push_back(
                {randomMeshBody(random, dimension, random.logUniform(0.2, 2.0)), random.pose(dimension, 3.0)});
        }
        const auto primitives = std::make_shared<FclObstacles>(solids, dimension, heights),
                   surfaces = std::make_shared<FclObstacles>(meshes, dimension, heights);
        const auto cloud = std::make_shared<PointCloudObstacles>(randomPoints(random, dimension, 200, 4.0),
                                                                 std::vector<double>{0.05}, dimension);
        const auto cells = std::make_shared<CellObstacles>(0.3, randomCells(random, dimension, 8), dimension);
        const auto mixed = std::make_shared<MixedObstacles>(std::vector<ObstaclesPtr>{surfaces, cloud, cells});
        for (const ObstaclesPtr &obstacles :
             std::initializer_list<ObstaclesPtr>{primitives, surfaces, cloud, cells, mixed})
        {
            ASSERT_TRUE(obstacles->knowsPadding());
            ASSERT_NO_THROW(checkObstacles(*obstacles, bodies, bounds, 40));
        }
    }
}

/** The verdict is that of all pairs of shapes, asked one by one. */
TEST_P(PaddedBodies, TouchWhatIsWithinTheirPadding)
{
    const unsigned int dimension = GetParam();
    unsigned int hits = 0, tried = 0;
    for (unsigned int seed = 0; seed < scaled(60); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const FclObstacles obstacles(randomMeshObstacles(random, dimension, 1.0, 0.5), dimension);
        const Body body = randomPaddedBody(random, dimension, random.logUniform(0.1, 2.0));
        for (int i = 0; i < 50; ++i)
        {
            Pose pose = nearPose(random, obstacles, body, 1.0);
            pose.translation() += random.point(dimension, 2.0 * body.getPadding());
            bool within = false;
            for (const PlacedBody &obstacle : obstacles.getBodies())
                within = within || areWithin(obstacle.body, body, obstacle.pose.inverse() * pose, body.getPadding());
            ASSERT_EQ(obstacles.collides(body, pose), within) << pose.matrix();
            ASSERT_TRUE(within || !obstacles.collides(body.withoutPadding(), pose)) << pose.matrix();
            hits += within;
            ++tried;
        }
    }
    EXPECT_GT(hits, tried / 20);
    EXPECT_LT(hits, tried - tried / 20);
}

INSTANTIATE_TEST_SUITE_P(Dimension, PaddedBodies, testing::Values(2U, 3U));

TEST(PaddedBodies, KeepTheirDistanceWithRoundCorners)
{
    const FclObstacles boxes({{Body::box(2.0, 2.0)}}, 2);
    const PointCloudObstacles points({Eigen::Vector3d::Zero()}, {0.1}, 2);
    const CellObstacles cells(2.0, {{{0, 0, 0}, {1, 1, 1}}}, 2);
    const Body disc = Body::disc(0.5).padded(0.25), box = Body::box(1.0, 1.0).padded(0.25);
    // Before a face, and before a corner, where a larger box would touch long before
    const double corner = 1.0 + 0.5 + 0.25 / std::sqrt(2.0);
    for (const Body &body : {disc, box})
    {
        EXPECT_FALSE(boxes.collides(body, planarPose(1.751, 0.0)));
        EXPECT_TRUE(boxes.collides(body, planarPose(1.749, 0.0)));
        EXPECT_FALSE(points.collides(body, planarPose(0.851, 0.0)));
        EXPECT_TRUE(points.collides(body, planarPose(0.849, 0.0)));
        EXPECT_FALSE(cells.collides(body, planarPose(2.751, 1.0)));
        EXPECT_TRUE(cells.collides(body, planarPose(2.749, 1.0)));
    }
    EXPECT_FALSE(boxes.collides(box, planarPose(corner + 0.001, corner + 0.001)));
    EXPECT_TRUE(boxes.collides(box, planarPose(corner - 0.001, corner - 0.001)));
    EXPECT_FALSE(cells.collides(box, planarPose(1.0 + corner + 0.001, 1.0 + corner + 0.001)));
    EXPECT_TRUE(cells.collides(box, planarPose(1.0 + corner - 0.001, 1.0 + corner - 0.001)));
}

/** What lies beside a planar mesh, but farther up or down than its padding, is not near. */
TEST(PaddedBodies, OfPlanarMeshesKeepTheDistanceInSpace)
{
    const Body body = Body::planarMesh(boxMesh({1.0, 1.0, 1.0})).padded(0.5);
    EXPECT_EQ(body.getZInterval().low, -1.0);
    EXPECT_EQ(body.getZInterval().high, 1.0);
    const auto collides = [&](double height)
    {
        const FclObstacles slab({{Body::planarMesh(boxMesh({1.0, 1.0, 1.0}, {0.0, 0.0, height}))}}, 2,
                                body.getZInterval());
        return slab.collides(body, planarPose(0.2, 0.0));
    };
    EXPECT_TRUE(collides(1.4));
    EXPECT_FALSE(collides(1.6));
}

/** What a certificate or a remembered hit says of a body is never more than what the check says of it. */
TEST(PaddedBodies, HitForCertainOnlyWhatTheyTouch)
{
    const TriangleMeshPtr mesh = boxMesh({1.0, 1.0, 1.0});
    const std::vector<ObstaclesPtr> all{
        std::make_shared<FclObstacles>(std::vector<PlacedBody>{{Body::box(1.0, 1.0, 1.0)}}, 3),
        std::make_shared<FclObstacles>(std::vector<PlacedBody>{{Body::mesh(mesh)}}, 3),
        std::make_shared<CellObstacles>(1.0, std::vector<CellBox>{{{0, 0, 0}, {1, 1, 1}}}, 3,
                                        Eigen::Vector3d(-0.5, -0.5, -0.5)),
        std::make_shared<PointCloudObstacles>(std::vector<Eigen::Vector3d>{Eigen::Vector3d::Zero()},
                                              std::vector<double>{0.5}, 3)};
    for (std::size_t i = 0; i < all.size(); ++i)
        for (const Body &body : {Body::box(1.0, 1.0, 1.0).padded(0.25), Body::mesh(mesh).padded(0.25)})
        {
            SCOPED_TRACE("obstacles " + std::to_string(i));
            const Obstacles &obstacles = *all[i];
            // Random poses hardly ever come so near to the padding.
            const Pose apart = poseAt({1.25 + 0.5 * obstacles.getTolerance() + 1e-9, 0.0, 0.0}),
                       within = poseAt({1.2, 0.0, 0.0});
            ASSERT_FALSE(obstacles.collides(body, apart));
            ASSERT_TRUE(obstacles.collides(body, within));
            unsigned int hits = 0;
            for (ObstaclePart part = 0; part < mesh->getTriangles().size(); ++part)
            {
                EXPECT_FALSE(obstacles.certainlyHits(body, apart, part)) << part;
                hits += obstacles.certainlyHits(body, within, part);
            }
            EXPECT_GT(hits, 0U);
        }
}

/** In the plane only what of a triangle is within the robots' z-interval counts. */
TEST(PaddedBodies, HitNoTriangleAboveTheRobots)
{
    // It rises toward the disc, which is beside it at z = 0.
    const auto ramp = std::make_shared<TriangleMesh>(
        std::vector<Eigen::Vector3d>{{10.0, -5.0, -2.0}, {10.0, 5.0, -2.0}, {0.0, 0.0, 1.0}},
        std::vector<TriangleMesh::Triangle>{{0, 1, 2}});
    const FclObstacles obstacles({{Body::planarMesh(ramp)}}, 2, {-2.0, -1.0});
    const Body disc = Body::disc(0.1).padded(0.3);
    EXPECT_TRUE(obstacles.collides(disc, planarPose(7.0, 0.0)));
    EXPECT_FALSE(obstacles.collides(disc, planarPose(3.0, 0.0)));
    EXPECT_FALSE(obstacles.certainlyHits(disc, planarPose(3.0, 0.0), 0));
}

TEST(PaddedBodies, AreNoObstacles)
{
    EXPECT_THROW(FclObstacles({{Body::disc(1.0).padded(0.1)}}, 2), ompl::Exception);
    EXPECT_NO_THROW(FclObstacles({{Body::disc(1.0).padded(0.1).withoutPadding()}}, 2));
}
