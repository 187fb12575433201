#include "ompl_certificates/geometry/Ball.h"
#include "support/Random.h"

#include <gtest/gtest.h>
#include <limits>

using namespace ompl_certificates;
using namespace ompl_certificates::test;

TEST(Ball, IsApartFromThoseThatItDoesNotTouch)
{
    Random random(1);
    for (unsigned int i = 0; i < scaled(10000); ++i)
    {
        const double first = random.logUniform(1e-3, 1e3), second = random.logUniform(1e-3, 1e3);
        const Eigen::Vector3d center = random.point(3, 10.0), direction = random.direction(3).normalized();
        const auto isApartAt = [&](double distance)
        {
            const Ball other{center + distance * direction, second};
            return areApart(Ball{center, first}, other);
        };
        ASSERT_FALSE(isApartAt(0.0));
        ASSERT_FALSE(isApartAt(0.999 * (first + second)));
        ASSERT_FALSE(isApartAt(first + second));
        ASSERT_TRUE(isApartAt(1.001 * (first + second)));
    }
}

TEST(Ball, IsApartFromNoneThatIsEverywhere)
{
    const Ball everywhere{Eigen::Vector3d::Zero(), std::numeric_limits<double>::infinity()};
    EXPECT_FALSE(areApart(everywhere, Ball{{1e6, 0.0, 0.0}, 1.0}));
    EXPECT_FALSE(areApart(everywhere, everywhere));
}

/** \brief The radius of the smallest ball around few points: it is the largest of those around up to four of them that are
    the smallest around these. */
static double smallestRadius(const std::vector<Eigen::Vector3d> &points)
{
    double largest = 0.0;
    const auto consider = [&](const std::vector<Eigen::Vector3d> &corners)
    {
        // The circumcenter in the corners' own plane or line, in barycentric coordinates: none of these is negative if no
        // smaller ball has all corners.
        const auto count = static_cast<Eigen::Index>(corners.size());
        Eigen::MatrixXd system = Eigen::MatrixXd::Ones(count, count);
        Eigen::VectorXd right = Eigen::VectorXd::Ones(count);
        for (Eigen::Index i = 1; i < count; ++i)
        {
            const Eigen::Vector3d edge = corners[static_cast<std::size_t>(i)] - corners[0];
            for (Eigen::Index j = 0; j < count; ++j)
                system(i, j) = 2.0 * edge.dot(corners[static_cast<std::size_t>(j)] - corners[0]);
            right[i] = edge.squaredNorm();
        }
        const Eigen::FullPivLU<Eigen::MatrixXd> solver(system);
        if (!solver.isInvertible())
            return;
        const Eigen::VectorXd weights = solver.solve(right);
        if (weights.minCoeff() < -1e-9)
            return;
        Eigen::Vector3d center = Eigen::Vector3d::Zero();
        for (Eigen::Index i = 0; i < count; ++i)
            center += weights[i] * (corners[static_cast<std::size_t>(i)] - corners[0]);
        largest = std::max(largest, center.norm());
    };
    for (const auto &a : points)
        for (const auto &b : points)
        {
            consider({a, b});
            for (const auto &c : points)
            {
                consider({a, b, c});
                for (const auto &d : points)
                    consider({a, b, c, d});
            }
        }
    return largest;
}

TEST(EnclosingBall, IsNearlyTheSmallest)
{
    for (unsigned int seed = 0; seed < scaled(200); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        // Flat and long ones too, points that coincide, corners of boxes; near the origin and far from it
        const double farAway = seed % 3 == 0 ? 1e6 : 1.0;
        const Eigen::Vector3d shift = random.point(3, farAway);
        Eigen::Vector3d sizes = random.point(seed % 5 == 0 ? 2 : 3, 2.0);
        std::vector<Eigen::Vector3d> points;
        for (unsigned int i = 0; i < 1 + seed % 8; ++i)
            if (i > 0 && random.chance(0.2))
                points.push_back(points.back());
            else
                points.emplace_back(shift + sizes.cwiseProduct(random.chance(0.5)
                                                                   ? random.direction(3)
                                                                   : random.direction(3).cwiseSign().eval()));
        const Ball ball = enclosingBall(points, 0.25);
        for (const auto &point : points)
            EXPECT_LE((point - ball.center).norm() + 0.25, ball.radius + 1e-12);
        const double smallest = smallestRadius(points);
        EXPECT_GE(ball.radius, 0.25 + smallest - 1e-9);
        EXPECT_LE(ball.radius, 0.25 + 1.001 * smallest + 1e-9);
    }
}

TEST(EnclosingBall, OfManyPointsIsNearlyTheSmallest)
{
    for (unsigned int seed = 0; seed < scaled(200); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        // Points of a ball's surface that are not all on one side of it: no smaller ball contains them.
        const Eigen::Vector3d center = random.point(3, 5.0);
        std::vector<Eigen::Vector3d> points;
        for (int i = 0; i < 100; ++i)
        {
            const Eigen::Vector3d direction = random.direction(3);
            points.push_back(center + direction);
            points.push_back(center - direction);
            points.push_back(center + random.uniform(0.0, 1.0) * random.direction(3));
        }
        const Ball ball = enclosingBall(points, 0.25);
        EXPECT_GE(ball.radius, 1.25 - 1e-12);
        EXPECT_LE(ball.radius, 1.2511);
        for (const auto &point : points)
            EXPECT_LE((point - ball.center).norm() + 0.25, ball.radius + 1e-12);
    }
}

TEST(EnclosingBall, OfWhatIsSymmetricIsExact)
{
    std::vector<Eigen::Vector3d> corners;
    for (unsigned int i = 0; i < 8; ++i)
        corners.emplace_back(i & 1U ? 0.3 : -0.3, i & 2U ? 0.7 : -0.7, i & 4U ? 0.1 : -0.1);
    const Ball ball = enclosingBall(corners, 0.0);
    EXPECT_EQ(ball.center, Eigen::Vector3d::Zero());
    EXPECT_EQ(ball.radius, Eigen::Vector3d(0.3, 0.7, 0.1).norm());
}
