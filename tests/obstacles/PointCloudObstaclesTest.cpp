#include "support/RandomBodies.h"
#include "support/RandomClouds.h"
#include "support/RandomMeshes.h"
#include "support/RandomStates.h"

#include "ompl_certificates/obstacles/CheckObstacles.h"
#include "ompl_certificates/obstacles/PointCloudObstacles.h"

#include <algorithm>
#include <array>
#include <gtest/gtest.h>
#include <ompl/util/Console.h>
#include <ompl/util/Exception.h>
#include <ompl/util/RandomNumbers.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;

namespace
{
    constexpr double INF = std::numeric_limits<double>::infinity();

    /** Balls in a row, asked one by one */
    struct Balls
    {
        std::vector<Eigen::Vector3d> points;
        std::vector<double> radii;

        double radius(std::size_t i) const
        {
            return radii.size() == 1 ? radii[0] : radii[i];
        }

        double clearance(const Eigen::Vector3d &point) const
        {
            double least = INF;
            for (std::size_t i = 0; i < points.size(); ++i)
                least = std::min(least, (points[i] - point).norm() - radius(i));
            return least;
        }

        /** The least distance of a body to a ball; where a solid and a ball overlap, some negative number */
        double distance(const Body &body, const Pose &pose) const
        {
            double least = INF;
            for (const Body::Part &part : body.getParts())
            {
                const Pose toPart = (pose * part.pose).inverse();
                for (std::size_t i = 0; i < points.size(); ++i)
                    least = std::min(least, part.shape.signedDistance(toPart * points[i]) - radius(i));
            }
            return least;
        }
    };

    Body anyBody(Random &random, unsigned int dimension, double size)
    {
        return random.chance(0.3) ? randomMeshBody(random, dimension, size) : randomBody(random, dimension, size);
    }

    /** All that is asked of a body at a pose must agree. */
    void expectAgreement(const PointCloudObstacles &cloud, const Body &body, const Pose &pose, bool expected)
    {
        ASSERT_EQ(cloud.collides(body, pose), expected) << pose.matrix();
        ObstaclePart hit = NO_PART;
        ASSERT_EQ(cloud.touches(body, pose, &hit), expected ? Touching::YES : Touching::NO);
        ASSERT_TRUE(!expected || cloud.certainlyHits(body, pose, hit));
        for (ObstaclePart part = 0; part < cloud.size() && !expected; ++part)
            ASSERT_FALSE(cloud.certainlyHits(body, pose, part));
        ASSERT_FALSE(cloud.certainlyHits(body, pose, NO_PART));
    }

    /** Adds a few balls that are very far away, as sensors see them. They must not change what is told of others. */
    void addFarBalls(Random &random, unsigned int dimension, Balls &balls)
    {
        const bool haveRadii = balls.radii.size() == balls.points.size();
        for (unsigned int i = random.below(4); i > 0; --i)
        {
            balls.points.push_back(random.logUniform(1e2, 1e13) * random.direction(dimension));
            if (haveRadii)
                balls.radii.push_back(0.1);
        }
    }

    /** Gives some balls many copies, some of them with another radius; then sets all in another order */
    void repeatSome(Random &random, Balls &balls)
    {
        const bool haveRadii = balls.radii.size() == balls.points.size();
        for (unsigned int i = random.below(5); i > 0; --i)
        {
            const std::size_t which = random.below(balls.points.size());
            for (unsigned int copies = random.below(random.chance(0.5) ? 4 : 200); copies > 0; --copies)
            {
                Eigen::Vector3d copy = balls.points[which];
                if (random.chance(0.5))
                    copy = (copy.array() == 0.0).select(-copy, copy);
                balls.points.push_back(copy);
                if (haveRadii)
                    balls.radii.push_back(random.chance(0.5) ? balls.radii[which] : random.uniform(0.0, 0.3));
            }
        }
        for (std::size_t i = balls.points.size() - 1; i > 0; --i)
        {
            const std::size_t other = random.below(i + 1);
            std::swap(balls.points[i], balls.points[other]);
            if (haveRadii)
                std::swap(balls.radii[i], balls.radii[other]);
        }
    }

    /** Centers and radii in an order that does not depend on that of the balls */
    std::vector<std::array<double, 4>> sortedBalls(const std::vector<Ball> &balls)
    {
        std::vector<std::array<double, 4>> sorted;
        for (const auto &[center, radius] : balls)
            sorted.push_back({center.x(), center.y(), center.z(), radius});
        std::sort(sorted.begin(), sorted.end());
        return sorted;
    }

    std::size_t anyCount(Random &random)
    {
        const std::size_t few[] = {0, 1, 2, 7, 8, 9, 16, 17, 32, 33, 65, 129};
        return random.chance(0.6) ? few[random.below(std::size(few))] : random.integer(100, 2000);
    }
}

TEST(PointCloudObstacles, KnowTheClearanceExactly)
{
    for (unsigned int seed = 1; seed <= scaled(150); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const unsigned int dimension = 2 + seed % 2;
        // Some clouds are far from the origin, as those with coordinates of a map are.
        const Eigen::Vector3d center = random.chance(0.3) ? random.point(dimension, 1e6) : Eigen::Vector3d::Zero();
        const std::size_t count = anyCount(random);
        Balls balls{randomPoints(random, dimension, count, 5.0, center), randomRadii(random, count, 0.5)};
        if (count > 0 && random.chance(0.3))
            addFarBalls(random, dimension, balls);
        const PointCloudObstacles cloud(balls.points, balls.radii, dimension);
        ASSERT_EQ(cloud.size(), balls.points.size());
        for (int i = 0; i < 100; ++i)
        {
            Eigen::Vector3d point = center + random.point(dimension, random.logUniform(0.1, 100.0));
            if (count > 0 && random.chance(0.3))
                point = balls.points[random.below(count)] + random.point(dimension, random.logUniform(1e-9, 1.0));
            if (random.chance(0.02))
                point *= 1e20;
            const double clearance = cloud.clearance(point);
            // The same arithmetic gives the same number.
            ASSERT_EQ(clearance, balls.clearance(point)) << point.transpose();
            ObstaclePart part;
            ASSERT_EQ(cloud.findNearest(point, part), clearance);
            ASSERT_EQ(part == NO_PART, count == 0);
            if (count > 0)
            {
                ASSERT_EQ((cloud.getBall(part).center - point).norm() - cloud.getBall(part).radius, clearance);
            }
            const Eigen::Vector3d other = point + random.logUniform(1e-6, 10.0) * random.direction(dimension);
            if (count > 0 && point.norm() < 1e9)
            {
                ASSERT_LE(std::abs(cloud.clearance(other) - clearance),
                          (other - point).norm() + 2.0 * cloud.getTolerance());
            }
        }
    }
}

TEST(PointCloudObstacles, GiveTheVerdictOfAllPoints)
{
    unsigned int grazing = 0, colliding = 0, asked = 0;
    for (unsigned int seed = 1; seed <= scaled(150); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const unsigned int dimension = 2 + seed % 2;
        const std::size_t count = 1 + anyCount(random) / 4;
        Balls balls{randomPoints(random, dimension, count, 3.0), randomRadii(random, count, 0.3)};
        if (random.chance(0.3))
            addFarBalls(random, dimension, balls);
        const PointCloudObstacles cloud(balls.points, balls.radii, dimension);
        const Body body = anyBody(random, dimension, random.logUniform(0.1, 3.0));
        for (int i = 0; i < 4; ++i)
        {
            // From anywhere to where it just touches
            Pose pose = random.pose(dimension, 4.0);
            if (random.chance(0.7))
                pose.translation() =
                    balls.points[random.below(count)] + random.point(dimension, 0.5 * body.getBoundingRadius());
            const Eigen::Vector3d start = pose.translation(), along = random.direction(dimension);
            const auto distanceAt = [&](double t)
            {
                pose.translation() = start + t * along;
                return balls.distance(body, pose);
            };
            const bool first = distanceAt(0.0) <= 0.0;
            double low = 0.0, high = 8.0;
            if ((distanceAt(high) <= 0.0) != first)
                while (high - low > 1e-13)
                {
                    const double middle = 0.5 * (low + high);
                    ((distanceAt(middle) <= 0.0) == first ? low : high) = middle;
                    if (middle == low && middle == high)
                        break;
                }
            for (const double beside : {0.0, 1e-10, -1e-10, 1e-7, -1e-7, 1e-3, -1e-3, -low})
            {
                const double distance = distanceAt(low + beside);
                // Only rounding may matter, of triangles for one.
                const bool unsure = std::abs(distance) < 1e-13;
                ASSERT_NO_FATAL_FAILURE(
                    expectAgreement(cloud, body, pose, unsure ? cloud.collides(body, pose) : distance <= 0.0))
                    << distance;
                grazing += !unsure && std::abs(distance) < 2e-7;
                colliding += distance <= 0.0;
                ++asked;
            }
        }
    }
    EXPECT_GT(grazing, asked / 8);
    EXPECT_GT(colliding, asked / 8);
    EXPECT_LT(colliding, asked / 8 * 7);
}

TEST(PointCloudObstacles, MayHaveManyEqualPoints)
{
    unsigned int colliding = 0;
    for (unsigned int seed = 1; seed <= scaled(150); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const unsigned int dimension = 2 + seed % 2;
        const std::size_t count = random.chance(0.3) ? 1 : 1 + anyCount(random) / 8;
        Balls balls{randomPoints(random, dimension, count, 3.0), randomRadii(random, count, 0.3)};
        if (random.chance(0.5))
            balls.points.front().setZero();
        ASSERT_NO_FATAL_FAILURE(repeatSome(random, balls));
        const PointCloudObstacles cloud(balls.points, balls.radii, dimension);
        std::vector<Ball> given;
        for (std::size_t i = 0; i < balls.points.size(); ++i)
            given.push_back({balls.points[i], balls.radius(i)});
        ASSERT_EQ(cloud.size(), given.size());
        ASSERT_EQ(sortedBalls(cloud.getBalls()), sortedBalls(given));
        for (int i = 0; i < 30; ++i)
        {
            Eigen::Vector3d point = random.point(dimension, random.logUniform(0.1, 100.0));
            if (random.chance(0.5))
                point = balls.points[random.below(given.size())] + random.point(dimension, random.logUniform(1e-9, 1));
            if (random.chance(0.05))
                point *= 1e20;
            const double clearance = balls.clearance(point);
            ASSERT_EQ(cloud.clearance(point), clearance) << point.transpose();
            ObstaclePart part;
            ASSERT_EQ(cloud.findNearest(point, part), clearance);
            ASSERT_EQ((cloud.getBall(part).center - point).norm() - cloud.getBall(part).radius, clearance);
        }
        for (int i = 0; i < 10; ++i)
        {
            const Body body = anyBody(random, dimension, random.logUniform(0.1, 3.0));
            Pose pose = random.pose(dimension, 4.0);
            if (random.chance(0.7))
                pose.translation() =
                    balls.points[random.below(given.size())] + random.point(dimension, body.getBoundingRadius());
            const double distance = balls.distance(body, pose);
            if (std::abs(distance) > 1e-12)
            {
                ASSERT_NO_FATAL_FAILURE(expectAgreement(cloud, body, pose, distance <= 0.0)) << distance;
            }
            colliding += distance <= 0.0;
        }
    }
    EXPECT_GT(colliding, scaled(150));
    EXPECT_LT(colliding, 9 * scaled(150));
}

TEST(PointCloudObstacles, MeetAMeshAtItsSurface)
{
    const PointCloudObstacles cloud(PointCloud{{Eigen::Vector3d::Zero()}, 0.1}, 3);
    const Body hollow = Body::mesh(boxMesh({2.0, 2.0, 2.0}));
    EXPECT_FALSE(cloud.collides(hollow, Pose::Identity()));
    EXPECT_TRUE(cloud.collides(hollow, poseAt({0.95, 0.0, 0.0})));
    EXPECT_TRUE(cloud.collides(hollow, poseAt({1.05, 0.0, 0.0})));
    EXPECT_FALSE(cloud.collides(hollow, poseAt({1.15, 0.0, 0.0})));
    EXPECT_TRUE(cloud.collides(Body::box(2.0, 2.0, 2.0), Pose::Identity()));
    // A planar mesh is what is seen of it from above, at any z.
    const PointCloudObstacles planar(PointCloud{{Eigen::Vector3d::Zero()}, 0.1}, 2);
    const Body raisedBox = Body::planarMesh(raised(boxMesh({2.0, 2.0, 2.0}), 50.0));
    EXPECT_TRUE(planar.collides(raisedBox, Pose::Identity()));
    EXPECT_TRUE(planar.collides(raisedBox, poseAt({1.05, 0.0, 0.0})));
    EXPECT_FALSE(planar.collides(raisedBox, poseAt({1.15, 0.0, 0.0})));
}

TEST(PointCloudObstacles, KeepTheContract)
{
    ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
    ompl::RNG::setSeed(7);
    for (unsigned int seed = 1; seed <= scaled(12); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const unsigned int dimension = 2 + seed % 2;
        const PointCloudObstacles cloud(randomPoints(random, dimension, 500, 4.0), randomRadii(random, 500, 0.3),
                                        dimension);
        checkObstacles(cloud,
                       {randomBody(random, dimension, 1.0), randomBody(random, dimension, 3.0),
                        randomMeshBody(random, dimension, 1.0)},
                       cubeBounds(dimension, 5.0), 200);
    }
}

TEST(PointCloudObstacles, HaveAFingerprint)
{
    Random random(1);
    const auto points = randomPoints(random, 3, 100, 1.0);
    const auto reversed = std::vector<Eigen::Vector3d>(points.rbegin(), points.rend());
    const auto printOf = [](const std::vector<Eigen::Vector3d> &some, double radius) {
        return PointCloudObstacles(PointCloud{some, radius}, 3).getFingerprint();
    };
    EXPECT_NE(printOf(points, 0.1), 0U);
    EXPECT_EQ(printOf(points, 0.1), printOf(reversed, 0.1));
    EXPECT_NE(printOf(points, 0.1), printOf(points, 0.2));
    auto moved = points;
    moved[50].x() += 1e-9;
    EXPECT_NE(printOf(points, 0.1), printOf(moved, 0.1));
}

TEST(PointCloudObstacles, RefuseWhatIsNoCloud)
{
    const Eigen::Vector3d here(1.0, 2.0, 0.0), nan(0.0, NAN, 0.0), far(0.0, 0.0, INF);
    const auto make = [](const std::vector<Eigen::Vector3d> &points, const std::vector<double> &radii,
                         unsigned int dimension) { PointCloudObstacles(points, radii, dimension); };
    EXPECT_NO_THROW(make({here, here}, {0.0}, 2));
    EXPECT_NO_THROW(make({}, {0.0}, 2));
    EXPECT_NO_THROW(make({}, {}, 3));
    EXPECT_THROW(make({here}, {0.1}, 4), ompl::Exception);
    EXPECT_THROW(make({here, nan}, {0.1}, 3), ompl::Exception);
    EXPECT_THROW(make({here, far}, {0.1}, 3), ompl::Exception);
    EXPECT_THROW(make({{0.0, 0.0, 1e-9}}, {0.1}, 2), ompl::Exception);
    EXPECT_THROW(make({here, here}, {0.1, 0.1, 0.1}, 3), ompl::Exception);
    EXPECT_THROW(make({here, here}, {}, 3), ompl::Exception);
    for (const double radius : {-0.1, double(NAN), INF})
    {
        EXPECT_THROW(make({here}, {radius}, 3), ompl::Exception);
        EXPECT_THROW(make({here, here}, {0.1, radius}, 3), ompl::Exception);
    }
}

TEST(PointCloudObstacles, EndWhereverABodyIs)
{
    Random random(1);
    std::vector<Eigen::Vector3d> points;
    for (int i = 0; i < 1000; ++i)
        points.emplace_back(random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0));
    const PointCloudObstacles obstacles(PointCloud{points, 0.01}, 3);
    for (const double far : {1e19, 1e40, 1e45, 1e300})
        for (const Body &body : {Body::sphere(0.3), Body::box(0.3, 0.2, 0.1)})
            EXPECT_FALSE(obstacles.collides(body, poseAt({far, 0.0, -far}))) << far;
}
