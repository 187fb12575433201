#include "support/RandomBodies.h"
#include "support/RandomMeshes.h"

#include "geometry/WithinDistance.h"

#include <fcl/narrowphase/distance.h>
#include <gtest/gtest.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;

namespace
{
    /** The distance of two bodies by FCL, shape by shape. It is 0 or less where they overlap. */
    double fclDistance(const Body &a, const Body &b, const Pose &pose)
    {
        double least = std::numeric_limits<double>::infinity();
        for (const Body::Part &one : a.getParts())
            for (const Body::Part &other : b.getParts())
            {
                const auto at = [](const Pose &place)
                {
                    fcl::Transform3d scaled(place);
                    scaled.translation() *= Shape::FCL_SCALE;
                    return scaled;
                };
                fcl::DistanceRequestd request(true);
                request.gjk_solver_type = fcl::GST_INDEP;
                fcl::DistanceResultd result;
                least = std::min(least, fcl::distance(one.shape.getCollisionGeometry().get(), at(one.pose),
                                                      other.shape.getCollisionGeometry().get(), at(pose * other.pose),
                                                      request, result));
            }
        return least / Shape::FCL_SCALE;
    }

    /** The point of a body that is nearest to a point of another one, found by sampling: an upper bound of their
        distance */
    double sampledDistance(Random &random, const Body &a, const Body &b, const Pose &pose, int samples)
    {
        double least = std::numeric_limits<double>::infinity();
        for (int i = 0; i < samples; ++i)
        {
            const Eigen::Vector3d point = pose * pointOf(random, b);
            least = std::min(least, a.signedDistance(point));
        }
        return least;
    }
}

/** Solid shapes against each other: signed distances of single points are exact, so the distance of the two is at most
    that of any point of one. A plane between them is a proof of the opposite: half spaces are large boxes. */
TEST(WithinDistance, FindsAllThatIsSampledToBeNear)
{
    for (const unsigned int dimension : {2U, 3U})
        for (unsigned int seed = 0; seed < scaled(3000); ++seed)
        {
            SCOPED_TRACE("seed " + std::to_string(seed) + " in " + std::to_string(dimension) + " dimensions");
            Random random(seed);
            const double unit = random.logUniform(1e-3, 1e3);
            const Body a = randomBody(random, dimension, unit * random.logUniform(0.1, 1.0)),
                       b = randomBody(random, dimension, unit * random.logUniform(0.1, 1.0));
            const Pose pose = random.pose(dimension, unit);
            const double sampled = sampledDistance(random, a, b, pose, 200);
            const double distance = std::max(0.0, sampled) + unit * random.logUniform(1e-8, 0.1);
            ASSERT_TRUE(areWithin(a, b, pose, distance)) << sampled << " " << distance;
            ASSERT_TRUE(areWithin(b, a, pose.inverse(), distance));
        }
}

TEST(WithinDistance, IsThatOfFclInSpace)
{
    unsigned int near = 0, far = 0;
    for (unsigned int seed = 0; seed < scaled(4000); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const auto body = [&]
        {
            return random.chance(0.3) ? meshBody(3, randomMesh(random, random.logUniform(0.1, 1.0)))
                                      : randomSimpleBody(random, 3, random.logUniform(0.1, 1.0));
        };
        const Body a = body(), b = body();
        const Pose pose = random.pose(3, 1.0);
        const double distance = fclDistance(a, b, pose);
        if (!(distance > 1e-3))
            continue;
        // Its solver is mostly precise to a millionth, but not always to a thousandth.
        ASSERT_TRUE(areWithin(a, b, pose, distance * 1.003 + 1e-5)) << distance;
        ASSERT_FALSE(areWithin(a, b, pose, distance * 0.997 - 1e-5)) << distance;
        const double asked = random.uniform(0.1, 2.0) * distance;
        if (std::abs(asked - distance) < 1e-2 * distance)
            continue;
        ASSERT_EQ(areWithin(a, b, pose, asked), asked > distance);
        ++(asked > distance ? near : far);
    }
    EXPECT_GT(near, scaled(4000) / 10);
    EXPECT_GT(far, scaled(4000) / 10);
}

/** Boxes whose faces are parallel, or whose corners or edges face each other: the simplices of the search have no
    volume. */
TEST(WithinDistance, IsExactForBoxesAlongTheAxes)
{
    for (unsigned int seed = 0; seed < scaled(4000); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const Eigen::Vector3d half(extent(random, 1.0), extent(random, 1.0), extent(random, 1.0)),
            other(extent(random, 1.0), extent(random, 1.0), extent(random, 1.0));
        Eigen::Vector3d gap = random.point(3, 1.0), center;
        for (int i = 0; i < 3; ++i)
        {
            if (random.chance(0.3))
                gap[i] = 0.0;
            const double sign = random.sign();
            center[i] = sign * (half[i] + other[i] + std::max(0.0, gap[i])) * (gap[i] < 0.0 ? random.uniform(0, 1) : 1);
        }
        const double distance = gap.cwiseMax(0.0).norm();
        if (distance < 1e-6)
            continue;
        const Body solid = Body::box(2 * half.x(), 2 * half.y(), 2 * half.z()),
                   box = Body::box(2 * other.x(), 2 * other.y(), 2 * other.z()), mesh = Body::mesh(boxMesh(2 * other)),
                   hollow = Body::mesh(boxMesh(2 * half));
        for (const auto &[a, b] : {std::pair{solid, box}, {solid, mesh}, {hollow, box}, {hollow, mesh}})
        {
            ASSERT_TRUE(areWithin(a, b, poseAt(center), distance * (1.0 + 1e-9) + 1e-9));
            ASSERT_FALSE(areWithin(a, b, poseAt(center), distance * (1.0 - 1e-9) - 1e-9));
        }
    }
}

/** Large faces that are near each other, and slivers, turned anyhow: there the search has simplices that are flat, but
    for rounding. */
TEST(WithinDistance, IsExactForLargeFacesAndSlivers)
{
    for (unsigned int seed = 0; seed < scaled(4000); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const double gap = random.logUniform(1e-5, 1e-1), slim = random.logUniform(1e-6, 1.0);
        const Eigen::Vector3d size(10.0, 10.0 * slim, random.logUniform(1e-3, 1.0));
        // Side by side along z, shifted by less than their sizes, and all of it turned
        const Eigen::Matrix3d turn = random.rotation().toRotationMatrix();
        const auto turned = [&](const TriangleMeshPtr &mesh)
        {
            std::vector<Eigen::Vector3d> corners = mesh->getVertices();
            for (Eigen::Vector3d &corner : corners)
                corner = turn * corner;
            return corners;
        };
        const TriangleMeshPtr box = boxMesh(size);
        const auto mesh = std::make_shared<TriangleMesh>(turned(box), box->getTriangles());
        const Body hull = Body::convexHull(mesh->getVertices()), surface = Body::mesh(mesh);
        const Pose apart =
            poseAt(turn * Eigen::Vector3d(random.uniform(-9.0, 9.0), slim * random.uniform(-9.0, 9.0), size.z() + gap));
        for (const auto &[a, b] : {std::pair{hull, hull}, {hull, surface}, {surface, hull}, {surface, surface}})
        {
            ASSERT_TRUE(areWithin(a, b, apart, gap * (1.0 + 1e-6) + 1e-9)) << gap << " " << slim;
            ASSERT_FALSE(areWithin(a, b, apart, gap * (1.0 - 1e-6) - 1e-9)) << gap << " " << slim;
        }
    }
}

/** Cylinders, whose surface the search only nears step by step */
TEST(WithinDistance, IsPreciseForRoundShapes)
{
    const Body cylinder = Body::cylinder(1.0, 2.0);
    for (const double distance : {1e-6, 1e-3, 0.1, 10.0})
        for (const double turn : {0.0, 1e-9, 1e-3, 0.3, 1.0, M_PI_2})
        {
            // Side by side, turned about the line between them
            Pose pose = poseAt({2.0 + distance, 0.0, 0.0});
            pose.linear() = Eigen::AngleAxisd(turn, Eigen::Vector3d::UnitX()).toRotationMatrix();
            EXPECT_TRUE(areWithin(cylinder, cylinder, pose, distance + 1e-8)) << distance << " " << turn;
            EXPECT_FALSE(areWithin(cylinder, cylinder, pose, distance - 1e-8)) << distance << " " << turn;
            // Rim to rim, on top of each other
            const Pose above = poseAt({2.0 + 0.6 * distance, 0.0, 2.0 + 0.8 * distance});
            EXPECT_TRUE(areWithin(cylinder, cylinder, above, distance + 1e-8)) << distance;
            EXPECT_FALSE(areWithin(cylinder, cylinder, above, distance - 1e-8)) << distance;
        }
}

/** In the plane a mesh is seen from above by primitives, and as it is by meshes. */
TEST(WithinDistance, SeesPlanarMeshesFromAboveUnlessBothAreMeshes)
{
    const Body mesh = Body::planarMesh(boxMesh({1.0, 1.0, 1.0}, {0.0, 0.0, 5.0})),
               low = Body::planarMesh(boxMesh({1.0, 1.0, 1.0}));
    for (const Body &primitive : {Body::disc(0.5), Body::box(1.0, 1.0), Body::planarCapsule(0.25, 0.5),
                                  Body::convexPolygon({{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}})})
        for (const auto &[a, b] : {std::pair{mesh, primitive}, {primitive, mesh}})
        {
            EXPECT_TRUE(areWithin(a, b, planarPose(1.3, 0.0), 0.3 + 1e-9));
            EXPECT_FALSE(areWithin(a, b, planarPose(1.3, 0.0), 0.3 - 1e-9));
        }
    EXPECT_FALSE(areWithin(mesh, low, planarPose(0.0, 0.0), 4.0 - 1e-9));
    EXPECT_TRUE(areWithin(mesh, low, planarPose(0.0, 0.0), 4.0 + 1e-9));
    EXPECT_FALSE(areWithin(mesh, low, planarPose(4.0, 0.0), 5.0 - 1e-9));
    EXPECT_TRUE(areWithin(mesh, low, planarPose(4.0, 0.0), 5.0 + 1e-9));
}
