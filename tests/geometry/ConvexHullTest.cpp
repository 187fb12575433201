#include "support/Message.h"
#include "support/RandomBodies.h"

#include "ompl_certificates/geometry/ConvexHull.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <limits>
#include <ompl/util/Exception.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;

namespace
{
    using Points = std::vector<Eigen::Vector3d>;

    /** How far \e point is beyond the points along the directions that can hold a face. These are the normals of all
        pairs of points in the plane, of all triples in space. Positive if and only if the point lies outside the
        hull. */
    double farthestBeyond(const Points &points, unsigned int dimension, const Eigen::Vector3d &point)
    {
        double farthest = -std::numeric_limits<double>::infinity();
        const auto consider = [&](const Eigen::Vector3d &normal)
        {
            if (normal.norm() < 1e-9)
                return;
            for (const double sign : {1.0, -1.0})
            {
                double support = -std::numeric_limits<double>::infinity();
                for (const auto &p : points)
                    support = std::max(support, sign * normal.normalized().dot(p));
                farthest = std::max(farthest, sign * normal.normalized().dot(point) - support);
            }
        };
        for (std::size_t i = 0; i < points.size(); ++i)
            for (std::size_t j = i + 1; j < points.size(); ++j)
            {
                const Eigen::Vector3d edge = points[j] - points[i];
                if (dimension == 2)
                    consider({edge.y(), -edge.x(), 0.0});
                else
                    for (std::size_t k = j + 1; k < points.size(); ++k)
                        consider(edge.cross(points[k] - points[i]));
            }
        return farthest;
    }

    Points boxCorners()
    {
        Points corners;
        for (const double x : {-1.0, 1.0})
            for (const double y : {-2.0, 2.0})
                for (const double z : {-3.0, 3.0})
                    corners.emplace_back(x, y, z);
        return corners;
    }
}

class RandomHull : public testing::TestWithParam<unsigned int>
{
};

TEST_P(RandomHull, ContainsAPointWhereItsSignedDistanceIsNegative)
{
    const unsigned int dimension = GetParam();
    for (unsigned int seed = 0; seed < scaled(400); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const Points points = hullPoints(random, dimension, 1.0);
        ConvexHull hull;
        try
        {
            hull = convexHull(points, dimension);
        }
        catch (const ompl::Exception &)
        {
            continue;  // flat
        }
        for (const auto &point : points)
            EXPECT_LE(hull.signedDistance(point), 1e-9);
        for (int i = 0; i < 20; ++i)
        {
            const Eigen::Vector3d query = random.point(dimension, 1.0);
            const double beyond = farthestBeyond(points, dimension, query);
            const double distance = hull.signedDistance(query);
            if (beyond <= 0.0)
                EXPECT_NEAR(distance, beyond, 1e-9);
            else
                EXPECT_GE(distance, beyond - 1e-9);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Dimension, RandomHull, testing::Values(2U, 3U));

TEST(RandomHulls, AreSeldomRefused)
{
    unsigned int refused = 0;
    for (unsigned int seed = 0; seed < 200; ++seed)
    {
        Random random(seed);
        Points points;
        for (int i = 0; i < 12; ++i)
            points.push_back(random.direction(3));
        try
        {
            EXPECT_EQ(convexHull(points, 3).vertices.size(), 12U);
        }
        catch (const ompl::Exception &)
        {
            ++refused;
        }
    }
    EXPECT_EQ(refused, 0U);
}

TEST(ConvexHull, OfABoxHasItsSixFaces)
{
    const ConvexHull hull = convexHull(boxCorners(), 3);
    EXPECT_EQ(hull.vertices.size(), 8U);
    ASSERT_EQ(hull.faces.size(), 6U);
    for (const auto &face : hull.faces)
    {
        ASSERT_EQ(face.vertices.size(), 4U);
        for (std::size_t i = 0; i < 4; ++i)
        {
            const Eigen::Vector3d &a = hull.vertices[face.vertices[i]];
            const Eigen::Vector3d &b = hull.vertices[face.vertices[(i + 1) % 4]];
            const Eigen::Vector3d &c = hull.vertices[face.vertices[(i + 2) % 4]];
            EXPECT_NEAR(face.normal.dot(a), face.offset, 1e-12);
            EXPECT_GT((b - a).cross(c - b).dot(face.normal), 0.0) << "not counter-clockwise";
        }
    }
}

TEST(ConvexHull, IgnoresPointsInsideOnFacesOnEdgesAndDuplicates)
{
    Points points = boxCorners();
    for (const auto &corner : boxCorners())
    {
        points.push_back(corner);
        points.push_back(0.3 * corner);
        points.emplace_back(corner.x(), 0.2 * corner.y(), 0.1 * corner.z());
        points.emplace_back(corner.x(), corner.y(), 0.4 * corner.z());
    }
    const ConvexHull hull = convexHull(points, 3);
    EXPECT_EQ(hull.vertices.size(), 8U);
    EXPECT_EQ(hull.faces.size(), 6U);
}

TEST(ConvexHull, IsClosedForNearlyCoplanarPoints)
{
    for (unsigned int seed = 0; seed < scaled(300); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        // Corners and points of the faces of a box, moved by about the tolerance of the hull
        const double noise = random.logUniform(1e-12, 1e-7);
        Points points = boxCorners();
        for (int i = 0; i < 6; ++i)
        {
            Eigen::Vector3d onFace(random.uniform(-1, 1), random.uniform(-2, 2), random.uniform(-3, 3));
            const auto axis = static_cast<Eigen::Index>(random.below(3));
            onFace[axis] = random.sign() * static_cast<double>(axis + 1);
            points.push_back(onFace);
        }
        for (auto &point : points)
            point += random.point(3, noise);
        const ConvexHull hull = convexHull(points, 3);
        for (int i = 0; i < 100; ++i)
        {
            const Eigen::Vector3d query = random.point(3, 5.0);
            const Eigen::Vector3d q = query.cwiseAbs() - Eigen::Vector3d(1.0, 2.0, 3.0);
            const double exact = q.maxCoeff() <= 0.0 ? q.maxCoeff() : q.cwiseMax(0.0).norm();
            ASSERT_NEAR(hull.signedDistance(query), exact, 4.0 * noise + 1e-9) << query.transpose();
        }
    }
}

TEST(ConvexHull, IsRightOrRefusedForThinPointsAndFarFromTheOrigin)
{
    for (unsigned int seed = 0; seed < scaled(300); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const bool isFar = seed % 2 == 0;
        const Eigen::Vector3d center = random.direction(3) * (isFar ? 1e8 : 0.0);
        const double thickness = isFar ? 1.0 : random.logUniform(1e-10, 1e-5);
        const double rounding = isFar ? 1e-6 : 1e-9;
        const Eigen::Quaterniond turn = random.rotation();
        Points points, there;
        for (int i = 0; i < 12; ++i)
        {
            points.push_back(turn * random.point(3, 1.0).cwiseProduct(Eigen::Vector3d(1.0, 1.0, thickness)));
            there.push_back(points.back() + center);
        }
        ConvexHull hull;
        try
        {
            hull = convexHull(there, 3);
        }
        catch (const ompl::Exception &)
        {
            EXPECT_FALSE(isFar);
            continue;
        }
        EXPECT_GT(thickness, 1e-7) << "thinner ones could lack a face";
        for (int i = 0; i < 20; ++i)
        {
            const Eigen::Vector3d query = random.point(3, 4.0);
            double nearest = std::numeric_limits<double>::infinity();
            for (const auto &point : points)
                nearest = std::min(nearest, (point - query).norm());
            const double distance = hull.signedDistance(query + center);
            EXPECT_LE(distance, nearest + rounding);
            EXPECT_GE(distance, farthestBeyond(points, 3, query) - rounding);
        }
    }
}

/** The blunt tip of a wedge may be one sliver of a triangle. Without its face the hull would go on beyond the tip. */
TEST(ConvexHull, EndsAtTheTipOfAThinWedge)
{
    unsigned int hulls = 0;
    for (unsigned int seed = 1; seed <= scaled(2000); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const double thickness = random.logUniform(1e-6, 1e-3), tip = thickness * random.logUniform(1e-4, 0.9),
                     width = random.logUniform(0.03, 1.0);
        std::vector<Eigen::Vector3d> points;
        for (const double y : {-0.5, 0.5})
            for (const double z : {-0.5, 0.5})
                points.emplace_back(0.0, width * y, thickness * z);
        points.emplace_back(1.0, -0.5 * width, 0.0);
        points.emplace_back(1.0, 0.5 * width, 0.5 * tip);
        points.emplace_back(1.0, 0.5 * width, -0.5 * tip);
        const Pose pose = random.pose(3, random.chance(0.5) ? 10.0 : 0.0);
        for (Eigen::Vector3d &point : points)
            point = pose * point;
        for (std::size_t i = points.size() - 1; i > 0; --i)
            std::swap(points[i], points[random.below(i + 1)]);
        ConvexHull hull;
        if (!messageOf([&] { hull = convexHull(points, 3); }).empty())
            continue;
        ++hulls;
        for (int i = 0; i < 20; ++i)
        {
            const double beyond = random.logUniform(10.0 * thickness, 1.0);
            const double distance =
                hull.signedDistance(pose * Eigen::Vector3d(1.0 + beyond, width * random.uniform(-0.4, 0.4), 0.0));
            ASSERT_NEAR(distance, beyond, 0.1 * beyond) << "thickness " << thickness << ", tip " << tip;
        }
    }
    EXPECT_GT(hulls, scaled(1500));
}

/** Fingerprints of obstacles, by which certificate files know theirs, are made of the vertices in their order. */
TEST(ConvexHull, KeepsTheOrderOfItsVertices)
{
    // The fifth is on an edge: it is the rounding of a normal that makes a corner of it.
    const Points points{{2, 1, 3}, {2, 0, 0}, {2, 3, 0}, {0, 3, 3}, {0, 2, 2}, {0, 0, 0}, {2, 1, 1}, {0, 3, 1}};
    const ConvexHull hull = convexHull(points, 3);
    std::vector<std::size_t> order;
    for (const auto &vertex : hull.vertices)
        order.push_back(static_cast<std::size_t>(std::find(points.begin(), points.end(), vertex) - points.begin()));
    EXPECT_EQ(order, (std::vector<std::size_t>{1, 2, 0, 5, 3, 4, 7}));
}

TEST(ConvexHull, GoesAroundAPolygonCounterClockwise)
{
    const ConvexHull hull = convexHull({{0, 0, 5}, {2, 0, 0}, {1, 0, 0}, {2, 1, -3}, {0, 1, 0}, {1, 0.5, 0}}, 2);
    ASSERT_EQ(hull.vertices.size(), 4U);
    ASSERT_EQ(hull.faces.size(), 4U);
    for (std::size_t i = 0; i < 4; ++i)
    {
        const Eigen::Vector3d a = hull.vertices[(i + 1) % 4] - hull.vertices[i];
        const Eigen::Vector3d b = hull.vertices[(i + 2) % 4] - hull.vertices[(i + 1) % 4];
        EXPECT_GT(a.cross(b).z(), 0.0);
        EXPECT_EQ(hull.vertices[i].z(), 0.0);
    }
    EXPECT_DOUBLE_EQ(hull.signedDistance({3.0, 2.0, 0.0}), std::sqrt(2.0));
    EXPECT_DOUBLE_EQ(hull.signedDistance({1.0, 0.25, 0.0}), -0.25);
}

TEST(ConvexHull, KeepsTheCornersOfEdgesThatAreVerticalUpToRounding)
{
    // By x such points are in any order. A corner must not be taken for one between two others.
    for (const Points &points : {Points{{-1.0 - 4e-16, 0.3, 0}, {-1.0, -1.0, 0}, {-1.0 + 4e-16, 1.0, 0}, {1, 0, 0}},
                                 Points{{1.0 + 4e-16, 0.3, 0}, {1.0, -1.0, 0}, {1.0 - 4e-16, 1.0, 0}, {-1, 0, 0}}})
    {
        const ConvexHull hull = convexHull(points, 2);
        EXPECT_EQ(hull.vertices.size(), 3U) << "the point on the edge is none";
        for (const auto &point : points)
            EXPECT_LE(hull.signedDistance(point), 1e-9);
    }
    // Prisms seen from above: their corners come twice.
    for (unsigned int seed = 0; seed < scaled(2000); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        Points points;
        for (const auto &corner : boxCorners())
            for (const double along : {1.0, random.uniform(-1.0, 1.0)})
                points.emplace_back(corner.x() + random.uniform(-1e-15, 1e-15),
                                    along * corner.y() + random.uniform(-1e-15, 1e-15), corner.z());
        for (const unsigned int dimension : {2U, 3U})
        {
            const ConvexHull hull = convexHull(points, dimension);
            if (dimension == 2)
            {
                EXPECT_EQ(hull.vertices.size(), 4U);
            }
            for (const auto &point : points)
                EXPECT_LE(hull.signedDistance(dimension == 2 ? Eigen::Vector3d(point.x(), point.y(), 0.0) : point),
                          1e-9);
        }
    }
}

TEST(ConvexHull, RefusesWhatSpansNothing)
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(convexHull({}, 2), ompl::Exception);
    EXPECT_THROW(convexHull({{0, 0, 0}, {1, 0, 0}}, 2), ompl::Exception);
    EXPECT_THROW(convexHull({{0, 0, 0}, {1, 1, 0}, {2, 2, 0}, {3, 3, 0}}, 2), ompl::Exception);
    EXPECT_THROW(convexHull({{1, 1, 0}, {1, 1, 0}, {1, 1, 0}}, 2), ompl::Exception);
    EXPECT_THROW(convexHull({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, 3), ompl::Exception);
    EXPECT_THROW(convexHull({{0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}, {2, 3, 1}}, 3), ompl::Exception);
    EXPECT_THROW(convexHull({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}}, 3), ompl::Exception);
    EXPECT_THROW(convexHull({{0, 0, 0}, {1, 0, 0}, {0, nan, 0}}, 2), ompl::Exception);
    EXPECT_THROW(convexHull({{0, 0, 0}, {1, 0, 0}, {0, std::numeric_limits<double>::infinity(), 0}}, 2),
                 ompl::Exception);
    EXPECT_THROW(convexHull(Points(MAX_HULL_POINTS + 1, Eigen::Vector3d::Ones()), 2), ompl::Exception);
}
