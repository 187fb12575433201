#include "support/MeshObstacles.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

using namespace ompl_certificates;
using namespace ompl_certificates::test;

namespace
{
    /** Whether an inner sphere of the body contains an obstacle point, by more than the tolerance */
    bool isCertifiedColliding(const FclObstacles &obstacles, const Body &body, const Pose &pose)
    {
        const double margin = obstacles.getTolerance() + exactCheckTolerance(body.getBoundingRadius());
        return std::any_of(body.getInnerSpheres().begin(), body.getInnerSpheres().end(),
                           [&](const Ball &ball)
                           { return obstacles.clearance(pose * ball.center) + margin < ball.radius; });
    }

    /** Moves \e body to where the exact check's verdict changes, and tests what is certified there. */
    void expectTrueAround(Random &random, const FclObstacles &obstacles, const Body &body, double unit)
    {
        Pose pose = nearPose(random, obstacles, body, unit);
        const Eigen::Vector3d start = pose.translation(), along = random.direction(body.getDimension());
        const auto at = [&](double t)
        {
            pose.translation() = start + t * along;
            return obstacles.collides(body, pose);
        };
        double low = 0.0, high = 1e-3 * unit;
        const bool first = at(low);
        while (at(high) == first && high < 8.0 * unit)
            high *= 2.0;
        for (int i = 0; i < 30; ++i)
        {
            const double middle = 0.5 * (low + high);
            const bool collides = at(middle);
            ASSERT_FALSE(collides && isCertifiedFree(obstacles, body, pose)) << "unit " << unit;
            ASSERT_FALSE(!collides && isCertifiedColliding(obstacles, body, pose)) << "unit " << unit;
            (collides == first ? low : high) = middle;
        }
    }

    using Outline = std::vector<Eigen::Vector2d>;

    /** How far all of \e b lies beyond an edge of \e a. For convex polygons close to each other this is their distance,
        if one of both orders gives a positive one. */
    double gapBefore(const Outline &a, const Outline &b)
    {
        double widest = -std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < a.size(); ++i)
        {
            const Eigen::Vector2d edge = a[(i + 1) % a.size()] - a[i],
                                  normal = Eigen::Vector2d(edge.y(), -edge.x()).normalized();
            double gap = std::numeric_limits<double>::infinity();
            for (const auto &corner : b)
                gap = std::min(gap, normal.dot(corner - a[i]));
            widest = std::max(widest, gap);
        }
        return widest;
    }
}

// FCL's solver has absolute thresholds, which exceed all products of small lengths.
TEST(Tolerance, CoversWhatFclMakesOfTinyShapes)
{
    for (unsigned int seed = 0; seed < scaled(200); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const unsigned int dimension = 2 + seed % 2;
        const double unit = random.logUniform(1e-9, 1e-4);
        const FclObstacles obstacles({{randomBody(random, dimension, unit), random.pose(dimension, unit)}}, dimension);
        const Body body = randomBody(random, dimension, unit * random.logUniform(1e-4, 1.0));
        for (int i = 0; i < 20; ++i)
            ASSERT_NO_FATAL_FAILURE(expectTrueAround(random, obstacles, body, unit));
    }
}

// FCL enlarges boxes by an amount that grows with the square of their size.
TEST(Tolerance, CoversWhatFclMakesOfHugeBoxes)
{
    for (unsigned int seed = 0; seed < scaled(200); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const double unit = random.logUniform(1e7, 1e11);
        const FclObstacles obstacles({{Body::box(unit, unit, 0.5 * unit), random.pose(3, unit)}}, 3);
        const Body body = Body::box(unit, 0.3 * unit, 0.3 * unit);
        for (int i = 0; i < 20; ++i)
            ASSERT_NO_FATAL_FAILURE(expectTrueAround(random, obstacles, body, unit));
    }
}

// A disc much smaller than a triangle is checked less precisely than two triangles are.
TEST(Tolerance, CoversWhatFclMakesOfDiscsAndTriangles)
{
    for (unsigned int seed = 0; seed < scaled(150); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const FclObstacles obstacles({{meshBody(2, randomMesh(random, 10.0)), random.pose(2, 10.0)}}, 2);
        const Body body = Body::disc(random.logUniform(0.01, 1.0));
        for (int i = 0; i < 20; ++i)
            ASSERT_NO_FATAL_FAILURE(expectTrueAround(random, obstacles, body, 10.0));
    }
}

// FCL's solver finds prisms touching that are of equal height, exactly level, and a hundredth of their size apart.
TEST(Tolerance, CoversWhatFclMakesOfLevelPrisms)
{
    unsigned int compared = 0;
    for (unsigned int seed = 0; seed < scaled(400); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const unsigned int dimension = 2 + seed % 2;
        // Corners on a circle: all of them belong to the outline, in order.
        Outline outline;
        std::vector<Eigen::Vector3d> corners;
        for (double angle = random.uniform(0.1, 1.0); angle < 6.2; angle += random.uniform(0.3, 2.0))
        {
            outline.emplace_back(std::cos(angle), 0.5 * std::sin(angle));
            for (const double z : {-1.0, 1.0})
                corners.emplace_back(outline.back().x(), outline.back().y(), z);
        }
        if (outline.size() < 3)
            continue;
        const Body body = dimension == 2 ? Body::convexPolygon(outline) : Body::convexPolytope(corners);
        const FclObstacles obstacles({{body, Pose::Identity()}}, dimension);
        for (int i = 0; i < 20; ++i)
        {
            const Eigen::Vector3d along = random.direction(2);
            Pose pose = planarPose(0.0, 0.0, random.uniform(-4.0, 4.0));
            const auto gapAt = [&](double distance)
            {
                pose.translation() = distance * along;
                Outline moved;
                for (const auto &corner : outline)
                    moved.emplace_back((pose * Eigen::Vector3d(corner.x(), corner.y(), 0.0)).head<2>());
                return std::max(gapBefore(outline, moved), gapBefore(moved, outline));
            };
            double touching = 0.0, apart = 3.0;
            while (apart - touching > 1e-9)
                (gapAt(0.5 * (touching + apart)) > 0.0 ? apart : touching) = 0.5 * (touching + apart);
            for (const double change : {-1e-2, -1e-3, -1e-4, 1e-4, 1e-3, 1e-2})
            {
                const double gap = gapAt(apart + change);
                if (std::abs(gap) < 2.0 * exactCheckTolerance(2.0))
                    continue;
                ++compared;
                ASSERT_EQ(obstacles.collides(body, pose), gap < 0.0) << "gap " << gap;
            }
        }
    }
    EXPECT_GT(compared, scaled(400) * 20);
}

// Too small a tolerance shows itself in few worlds alone, so its terms are looked at one by one.
TEST(Tolerance, GrowsWithTheDistanceFromTheOriginWithMeshesAndWithTheirHeight)
{
    const auto ballAt = [](double x) { return FclObstacles({{Body::sphere(0.1), poseAt({x, 0, 0})}}, 3); };
    EXPECT_NEAR(ballAt(1e6).getTolerance() - ballAt(0.0).getTolerance(), 1e-8, 1e-9);
    const auto cube = [](double height) { return boxMesh({100.0, 100.0, height}); };
    EXPECT_GT(FclObstacles({{Body::mesh(cube(100.0))}}, 3).getTolerance() - ballAt(0.0).getTolerance(), 8e-5);
    // In the plane, a disc beside a mesh is checked as a prism of the mesh's height.
    const auto besideADisc = [&](double height)
    {
        const Body mesh = Body::planarMesh(cube(height));
        return FclObstacles({{mesh}, {Body::disc(0.01), planarPose(300.0, 0.0)}}, 2).getTolerance();
    };
    EXPECT_GE(besideADisc(100.0) - besideADisc(1.0), exactCheckTolerance(100.0) - exactCheckTolerance(1.0));
}

// Else nothing would be certified near a house of 10 m that is given in a map's coordinates, and continuous mode would
// refuse to pass it.
TEST(Tolerance, DoesNotGrowWithAMapsCoordinates)
{
    const Eigen::Vector3d middle(5e5, 5.4e6, 300.0);
    const auto bodiesAt = [](const Eigen::Vector3d &at)
    {
        std::vector<Eigen::Vector2d> outline;
        std::vector<Eigen::Vector3d> corners;
        for (const Eigen::Vector2d &corner : {Eigen::Vector2d(0, 0), Eigen::Vector2d(8, 0), Eigen::Vector2d(2, 6)})
        {
            outline.emplace_back(at.head<2>() + corner);
            for (const double z : {0.0, 4.0})
                corners.emplace_back(outline.back().x(), outline.back().y(), at.z() + z);
        }
        const TriangleMeshPtr box = boxMesh({8.0, 6.0, 4.0});
        std::vector<Eigen::Vector3d> vertices = box->getVertices();
        for (Eigen::Vector3d &vertex : vertices)
            vertex += at;
        const auto mesh = std::make_shared<TriangleMesh>(vertices, box->getTriangles());
        // A planar mesh keeps its z.
        for (Eigen::Vector3d &vertex : vertices)
            vertex.z() -= at.z();
        const auto level = std::make_shared<TriangleMesh>(vertices, box->getTriangles());
        return std::vector<Body>{Body::convexPolygon(outline),  Body::convexHull(outline), Body::planarMesh(level),
                                 Body::convexPolytope(corners), Body::convexHull(corners), Body::mesh(mesh)};
    };
    const std::vector<Body> near = bodiesAt(Eigen::Vector3d::Zero()), far = bodiesAt(middle);
    Random random(17);
    for (std::size_t i = 0; i < near.size(); ++i)
    {
        const unsigned int dimension = near[i].getDimension();
        const FclObstacles here({{near[i]}}, dimension), there({{far[i]}}, dimension);
        // Three times, since a shape at its corner is as large as its diagonal, and more for the map's rounding
        EXPECT_LE(there.getTolerance(), 3.0 * here.getTolerance() + 1e-13 * middle.norm()) << i;
        const Body robot = dimension == 2 ? Body::disc(1.0) : Body::sphere(1.0);
        for (int state = 0; state < 200; ++state)
        {
            const Eigen::Vector3d point = random.point(dimension, 12.0);
            const Eigen::Vector3d same = point + (dimension == 2 ? Eigen::Vector3d(middle.x(), middle.y(), 0) : middle);
            const double clearance = here.clearance(point);
            EXPECT_NEAR(there.clearance(same), clearance, 1e-8) << i;
            EXPECT_NEAR(far[i].signedDistance(same), near[i].signedDistance(point), 1e-8) << i;
            if (std::abs(std::abs(clearance) - 1.0) > 1e-3)
            {
                EXPECT_EQ(there.collides(robot, poseAt(same)), here.collides(robot, poseAt(point))) << i;
            }
        }
    }
}
