#include "support/RandomClouds.h"

#include "ompl_certificates/geometry/PointCloud.h"
#include "ompl_certificates/obstacles/PointCloudObstacles.h"

#include <gtest/gtest.h>
#include <ompl/util/Exception.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;

TEST(ThinnedCloud, CoversWhatTheWholeOneDoes)
{
    for (unsigned int seed = 1; seed <= scaled(60); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const unsigned int dimension = 2 + seed % 2;
        const PointCloud cloud{randomPoints(random, dimension, random.below(2000), 4.0), random.uniform(0.0, 0.2)};
        const double cell = random.logUniform(0.01, 3.0);
        const PointCloud thin = thinned(cloud, cell);
        EXPECT_LE(thin.points.size(), cloud.points.size());
        EXPECT_GE(thin.radius, cloud.radius);
        EXPECT_LT(thin.radius, cloud.radius + cell * std::sqrt(dimension) + 1e-12);
        const PointCloudObstacles whole(cloud, dimension), less(thin, dimension);
        for (int i = 0; i < 200; ++i)
        {
            const Eigen::Vector3d point = random.point(dimension, 5.0);
            ASSERT_LE(less.clearance(point), whole.clearance(point) + whole.getTolerance()) << point.transpose();
        }
        // Each point's own ball is within a thin one.
        for (const Eigen::Vector3d &point : cloud.points)
            ASSERT_LE(less.clearance(point), -cloud.radius + whole.getTolerance()) << point.transpose();
    }
}

TEST(ThinnedCloud, HasOnePointPerCell)
{
    const PointCloud cloud{{{0.1, 0.1, 0.1}, {0.4, 0.5, 0.5}, {0.9, 0.9, 0.9}, {1.1, 0.0, 0.0}, {-0.1, 0.0, 0.0}}, 0.5};
    const PointCloud thin = thinned(cloud, 1.0);
    ASSERT_EQ(thin.points.size(), 3U);
    EXPECT_EQ(thin.points[1], cloud.points[1]);
    EXPECT_NEAR(thin.radius, 0.5 + (cloud.points[2] - cloud.points[1]).norm(), 1e-12);
    EXPECT_EQ(thinned({{{1.0, 2.0, 3.0}}, 0.25}, 0.1).radius, 0.25);
    EXPECT_TRUE(thinned({}, 1.0).points.empty());
    EXPECT_THROW(thinned(cloud, 0.0), ompl::Exception);
    EXPECT_THROW(thinned(cloud, -1.0), ompl::Exception);
    EXPECT_THROW(thinned(cloud, NAN), ompl::Exception);
    EXPECT_THROW(thinned(cloud, 1e-12), ompl::Exception);
    EXPECT_THROW(thinned({{{0.0, NAN, 0.0}}, 0.0}, 1.0), ompl::Exception);
}

TEST(SlicedCloud, KeepsWhatReachesIn)
{
    const PointCloud cloud{{{1, 2, -1.2}, {3, 4, -1.05}, {5, 6, 0}, {7, 8, 2.09}, {9, 10, 2.2}}, 0.1};
    const PointCloud slice = sliced(cloud, {-1.0, 2.0});
    ASSERT_EQ(slice.points.size(), 3U);
    EXPECT_EQ(slice.radius, 0.1);
    EXPECT_EQ(slice.points[0], Eigen::Vector3d(3, 4, 0));
    EXPECT_EQ(slice.points[1], Eigen::Vector3d(5, 6, 0));
    EXPECT_EQ(slice.points[2], Eigen::Vector3d(7, 8, 0));
    EXPECT_EQ(sliced(cloud, {}).points.size(), 5U);
    for (const Eigen::Vector3d &point : {Eigen::Vector3d(0, 0, NAN), Eigen::Vector3d(INFINITY, 0, 0)})
        EXPECT_THROW(sliced({{point}, 0.1}, {-1.0, 2.0}), ompl::Exception);
}
