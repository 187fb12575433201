// Meshes in the plane, where primitives are prisms

#include "support/MeshObstacles.h"

#include <cmath>
#include <gtest/gtest.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;

TEST(PlanarMeshObstacles, CountInThePlaneWithinTheZIntervalOfTheRobots)
{
    // A wall from z = 0 to 10 under a roof that is wider
    const std::vector<PlacedBody> bodies{{Body::planarMesh(boxMesh({1, 10, 10}, {0, 0, 5}))},
                                         {Body::planarMesh(boxMesh({20, 20, 1}, {0, 0, 12}))}};
    const Body robot = Body::planarMesh(boxMesh({1, 1, 2}, {0, 0, 3}));
    const FclObstacles obstacles(bodies, 2, robot.getZInterval());
    EXPECT_DOUBLE_EQ(obstacles.clearance({3, 0, 0}), 2.5);
    EXPECT_FALSE(obstacles.collides(robot, planarPose(1.1, 0.0)));
    EXPECT_TRUE(obstacles.collides(robot, planarPose(0.9, 0.0)));
    EXPECT_DOUBLE_EQ(FclObstacles(bodies, 2).clearance({3, 0, 0}), 0.0);
    // Inside the wall, away from its four sides
    EXPECT_DOUBLE_EQ(obstacles.clearance({0.1, 0, 0}), 0.4);
}

/** The ends of a wall along y that was turned there differ in x by a rounding error, and so do points between them. */
TEST(PlanarMeshObstacles, InThePlaneHaveAllOfTheirWalls)
{
    for (unsigned int seed = 0; seed < scaled(400); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const double x = random.chance(0.5) ? 1.0 : random.uniform(0.5, 1.5), y = random.uniform(0.5, 1.5);
        const double low = random.uniform(0.0, 0.8), yaw = random.chance(0.5) ? -0.5 * M_PI : M_PI;
        const Pose pose = planarPose(random.uniform(0.0, 1.0), random.uniform(0.0, 1.0), yaw);
        const FclObstacles obstacles({{Body::planarMesh(boxMesh({2.0 * x, 2.0 * y, 1.0}, {0.0, 0.0, 0.5})), pose}}, 2,
                                     {low, low + random.uniform(0.05, 0.2)});
        for (double s = -0.99; s < 1.0; s += 0.05)
            for (const double side : {-1.0, 1.0})
                for (const Eigen::Vector3d &point :
                     {Eigen::Vector3d(side * x, s * y, 0.0), Eigen::Vector3d(s * x, side * y, 0.0)})
                    ASSERT_LE(obstacles.clearance(pose * point), 1e-9) << point.transpose();
    }
}

TEST(PlanarMeshObstacles, InThePlaneAreAsFarAsUprightTriangles)
{
    // Their three corners are on one line, as seen from above, but for rounding.
    for (unsigned int seed = 0; seed < scaled(2000); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const bool isWhole = random.chance(0.5);
        const auto number = [&](double low, double high)
        { return isWhole ? std::round(random.uniform(low, high)) : random.uniform(low, high); };
        const double a = number(-8.0, 8.0), b = a + number(1.0, 5.0), c = b + number(1.0, 5.0);
        const double yaw = isWhole ? 0.25 * M_PI * std::round(random.uniform(0.0, 7.0)) : random.uniform(-M_PI, M_PI);
        const Pose pose = planarPose(number(-3.0, 3.0), number(-3.0, 3.0), yaw);
        std::vector<Eigen::Vector3d> corners{{a, 0.0, 0.0}, {b, 0.0, 2.0}, {c, 0.0, 0.0}};
        const auto wall = [&corners] {
            return Body::planarMesh(
                std::make_shared<TriangleMesh>(corners, std::vector<TriangleMesh::Triangle>{{0, 1, 2}}));
        };
        const FclObstacles placed({{wall(), pose}}, 2);
        for (Eigen::Vector3d &corner : corners)
            corner = pose * corner;
        const Body turned = wall();
        const FclObstacles obstacles({{turned, Pose::Identity()}}, 2);
        for (double x = -20.0; x <= 20.0; x += 1.0)
        {
            const Eigen::Vector3d point = pose * Eigen::Vector3d(x, 0.0, 0.0);
            const double distance = std::max({a - x, x - c, 0.0});
            ASSERT_NEAR(placed.clearance(point), distance, 1e-9) << x;
            ASSERT_NEAR(obstacles.clearance(point), distance, 1e-9) << x;
            ASSERT_NEAR(std::abs(turned.signedDistance(point)), distance, 1e-9) << x;
        }
    }
}

TEST(PlanarMeshObstacles, InThePlaneAreCheckedAgainstPrismsThatAreHighEnough)
{
    // A wall about x = 0 from z = 100 to 110, and robots that are primitives: discs, boxes, capsules, polygons, points
    const FclObstacles wall({{Body::planarMesh(boxMesh({2, 20, 10}, {0, 0, 105}))}}, 2);
    const std::vector<Body> robots{Body::disc(1.0), Body::box(2.0, 0.5), Body::planarCapsule(0.25, 1.5),
                                   Body::convexPolygon({{-1, -1}, {1, 0}, {-1, 1}})};
    for (const Body &robot : robots)
    {
        EXPECT_TRUE(wall.collides(robot, planarPose(1.99, 0.0)));
        EXPECT_FALSE(wall.collides(robot, planarPose(2.01, 0.0)));
    }
    EXPECT_TRUE(wall.collides(robots[2], planarPose(1.24, 0.0, M_PI / 2)));
    EXPECT_FALSE(wall.collides(robots[2], planarPose(1.26, 0.0, M_PI / 2)));
    EXPECT_TRUE(wall.collides(Body::disc(0.0), planarPose(0.9, 0.0)));
    EXPECT_FALSE(wall.collides(Body::disc(0.0), planarPose(1.1, 0.0)));
    // The wall has a roof, seen from above.
    EXPECT_TRUE(wall.collides(Body::disc(0.1), planarPose(0.0, 0.0)));
    // Turned around: primitives as obstacles of a mesh far above the plane
    const Body mesh = Body::planarMesh(boxMesh({2, 2, 10}, {0, 0, 105}));
    for (const Body &obstacle : robots)
    {
        const FclObstacles obstacles({{obstacle}}, 2);
        EXPECT_TRUE(obstacles.collides(mesh, planarPose(1.99, 0.0)));
        EXPECT_FALSE(obstacles.collides(mesh, planarPose(2.01, 0.0)));
        // A higher mesh later
        EXPECT_TRUE(obstacles.collides(Body::planarMesh(boxMesh({2, 2, 1000})), planarPose(1.99, 0.0)));
    }
    // Robots below the wall
    const FclObstacles above({{Body::planarMesh(boxMesh({2, 20, 10}, {0, 0, 105}))}}, 2, {0.0, 1.0});
    EXPECT_FALSE(above.collides(Body::disc(1.0), planarPose(0.0, 0.0)));
    EXPECT_TRUE(std::isinf(above.clearance({0.0, 0.0, 0.0})));
}

/** FCL's solver never ends for some cylinders without width. Then this test never ends either. */
TEST(PlanarMeshObstacles, InThePlaneAreCheckedAgainstPointsAndSegmentsInFiniteTime)
{
    const Body bodies[] = {Body::disc(0.0), Body::box(1e-11, 1e-11), Body::box(1.0, 1e-11),
                           Body::planarCapsule(1e-11, 1.0)};
    for (unsigned int seed = 0; seed < scaled(300); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const Body mesh = meshBody(2, randomMesh(random, 10.0));
        const FclObstacles obstacles({{mesh}}, 2);
        for (int i = 0; i < 100; ++i)
        {
            const Eigen::Vector3d at = surfacePointOf(random, mesh);
            const Pose pose = planarPose(at.x(), at.y(), random.uniform(-3.0, 3.0));
            for (const Body &body : bodies)
                ASSERT_FALSE(obstacles.collides(body, pose) && isCertifiedFree(obstacles, body, pose));
        }
    }
}

/** FCL's constructors of a collision object compute the geometry's box again, while other threads read it. */
/** Who makes a body for each check makes more shapes than are kept. */
TEST(PlanarMeshObstacles, InThePlaneAreCheckedAgainstAnyNumberOfShapes)
{
    const auto mesh = std::make_shared<TriangleMesh>(std::vector<Eigen::Vector3d>{{0, 0, 0}, {1, 0, 1}, {0, 1, 0}},
                                                     std::vector<TriangleMesh::Triangle>{{0, 1, 2}});
    const FclObstacles obstacles({{Body::planarMesh(mesh)}}, 2);
    for (int i = 0; i < 1500; ++i)
    {
        const double radius = 0.9001 + 0.0002 * i;
        const Body disc = Body::disc(radius);
        for (int k = 0; k < 2; ++k)
            ASSERT_EQ(obstacles.collides(disc, planarPose(-1.0, 0.3)), radius > 1.0) << radius;
    }
}
