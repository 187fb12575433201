#include "support/MeshObstacles.h"

#include <gtest/gtest.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;

namespace
{
    /** Whether a core ball of the body holds an obstacle point, by more than the tolerance */
    bool isCertifiedColliding(const FclObstacles &obstacles, const Body &body, const Pose &pose)
    {
        const double margin = obstacles.getTolerance() + exactCheckTolerance(body.getReach());
        return std::any_of(body.getCore().begin(), body.getCore().end(),
                           [&](const Ball &ball)
                           { return obstacles.clearance(pose * ball.center) + margin < ball.radius; });
    }

    /** Moves \e body up to where the exact check changes its mind, and tries what is certified there. */
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
}

// FCL's solver has absolute thresholds, which are above all that is made of small lengths.
TEST(Tolerance, CoversWhatFclMakesOfTinyShapes)
{
    for (unsigned int seed = 0; seed < scaled(200); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const unsigned int dimension = 2 + seed % 2;
        const double unit = random.logUniform(1e-9, 1e-4);
        const FclObstacles obstacles(dimension, {{randomBody(random, dimension, unit), random.pose(dimension, unit)}});
        const Body body = randomBody(random, dimension, unit * random.logUniform(1e-4, 1.0));
        for (int i = 0; i < 20; ++i)
            ASSERT_NO_FATAL_FAILURE(expectTrueAround(random, obstacles, body, unit));
    }
}

// FCL enlarges boxes by what grows with the square of their size.
TEST(Tolerance, CoversWhatFclMakesOfHugeBoxes)
{
    for (unsigned int seed = 0; seed < scaled(200); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const double unit = random.logUniform(1e7, 1e11);
        const FclObstacles obstacles(3, {{Body::box(unit, unit, 0.5 * unit), random.pose(3, unit)}});
        const Body body = Body::box(unit, 0.3 * unit, 0.3 * unit);
        for (int i = 0; i < 20; ++i)
            ASSERT_NO_FATAL_FAILURE(expectTrueAround(random, obstacles, body, unit));
    }
}

// A disc that is small beside a triangle is checked less precisely than two triangles are.
TEST(Tolerance, CoversWhatFclMakesOfDiscsAndTriangles)
{
    for (unsigned int seed = 0; seed < scaled(150); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const FclObstacles obstacles(2, {{meshBody(2, randomMesh(random, 10.0)), random.pose(2, 10.0)}});
        const Body body = Body::disc(random.logUniform(0.01, 1.0));
        for (int i = 0; i < 20; ++i)
            ASSERT_NO_FATAL_FAILURE(expectTrueAround(random, obstacles, body, 10.0));
    }
}
