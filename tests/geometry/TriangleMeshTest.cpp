#include "geometry/BodyContact.h"
#include "support/RandomMeshes.h"
#include "support/Warnings.h"

#include "ompl_certificates/obstacles/FclObstacles.h"

#include <gtest/gtest.h>
#include <limits>
#include <ompl/util/Exception.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;

namespace
{
    using Triangles = std::vector<TriangleMesh::Triangle>;

    const std::vector<Eigen::Vector3d> CORNERS{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

    TriangleMesh without(const TriangleMesh &mesh, std::size_t count)
    {
        Triangles triangles = mesh.getTriangles();
        triangles.resize(triangles.size() - count);
        return {mesh.getVertices(), triangles};
    }
}

TEST(TriangleMesh, RefusesWhatIsNoMesh)
{
    EXPECT_THROW(TriangleMesh({}, {}), ompl::Exception);
    EXPECT_THROW(TriangleMesh(CORNERS, {}), ompl::Exception);
    EXPECT_THROW(TriangleMesh(CORNERS, {{0, 1, 4}}), ompl::Exception);
    EXPECT_THROW(TriangleMesh(CORNERS, {{0, 1, 2}, {0, 1, 4000000000U}}), ompl::Exception);
    for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity(), 1e200})
    {
        for (const Eigen::Index coordinate : {0, 1, 2})
        {
            auto vertices = CORNERS;
            vertices[2][coordinate] = bad;
            EXPECT_THROW(TriangleMesh(vertices, {{0, 1, 2}, {0, 1, 3}}), ompl::Exception) << bad << " " << coordinate;
        }
    }
    EXPECT_THROW(TriangleMesh(CORNERS, {{0, 1, 1}, {2, 2, 2}}), ompl::Exception);
    EXPECT_THROW(TriangleMesh({{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}, {{0, 1, 2}}), ompl::Exception);
    EXPECT_THROW(Body::mesh(nullptr), ompl::Exception);
    EXPECT_THROW(Body::planarMesh(nullptr), ompl::Exception);
    Pose tilted = Pose::Identity();
    tilted.linear() = Eigen::AngleAxisd(0.1, Eigen::Vector3d::UnitX()).toRotationMatrix();
    EXPECT_THROW(Body({{Shape::mesh(2, boxMesh({1, 1, 1})), tilted}}), ompl::Exception);
}

TEST(TriangleMesh, KeepsWhatItIsGiven)
{
    const TriangleMesh mesh(CORNERS, {{0, 1, 2}, {0, 1, 1}, {2, 1, 0}});
    EXPECT_EQ(mesh.getVertices(), CORNERS);
    EXPECT_EQ(mesh.getTriangles(), (Triangles{{0, 1, 2}, {0, 1, 1}, {2, 1, 0}}));
    EXPECT_FALSE(mesh.isDegenerate(0));
    EXPECT_TRUE(mesh.isDegenerate(1));
    EXPECT_FALSE(mesh.isDegenerate(2));
    // The fourth vertex has no triangle.
    EXPECT_EQ(mesh.getBounds().max(), Eigen::Vector3d(1, 1, 0));
}

/** A curb in the coordinates of a map of the whole country */
TEST(TriangleMesh, KeepsThinTrianglesFarFromItsOrigin)
{
    const Eigen::Vector3d far(5e5, 5e6, 100.0);
    std::vector<Eigen::Vector3d> vertices{{0, 0, 0}, {100, 0, 0}, {100, 0, 0.4}, {0, 0, 0.4}, {50, 0, 1e-7}};
    for (Eigen::Vector3d &vertex : vertices)
        vertex += far;
    const auto mesh = std::make_shared<TriangleMesh>(vertices, Triangles{{0, 1, 2}, {0, 2, 3}, {0, 1, 4}});
    EXPECT_FALSE(mesh->isDegenerate(0));
    EXPECT_FALSE(mesh->isDegenerate(1));
    EXPECT_TRUE(mesh->isDegenerate(2));
    const Body ball = Body::sphere(1.0);
    for (const double side : {-0.9, 0.9, 1.1})
    {
        const Pose beside = poseAt(far + Eigen::Vector3d(50.0, side, 0.2));
        EXPECT_EQ(FclObstacles({{Body::mesh(mesh)}}, 3).collides(ball, beside), side < 1.0);
        if (side == 1.1)
            EXPECT_EQ(touching(Body::mesh(mesh), ball, beside, 1e-3), Touching::NO);
        else
            EXPECT_EQ(touching(Body::mesh(mesh), ball, beside, 1e-3), Touching::YES);
    }
}

/** A sliver between triangles is normal; where it is all there is, FCL may see it, and nobody else does. */
TEST(TriangleMesh, WarnsOfTrianglesWithoutAreaThatStandAlone)
{
    const auto warningsOf = [](const Eigen::Vector3d &end)
    {
        const Warnings warnings("1 of the 3 triangles of a mesh are wires");
        const TriangleMesh mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {4, 0, 0}, {5, 0, 0}, {4, 1, 0}, {1, 0, 0}, end},
                                {{0, 1, 2}, {3, 4, 5}, {0, 6, 7}});
        EXPECT_TRUE(mesh.isDegenerate(2));
        return warnings.count;
    };
    EXPECT_EQ(warningsOf({1, 0, 0}), 0U);
    EXPECT_EQ(warningsOf({0.3, 0, 0}), 0U) << "in the middle of an edge";
    EXPECT_EQ(warningsOf({2, 0, 0}), 1U);
    EXPECT_EQ(warningsOf({4, 0, 0}), 1U) << "from a corner to a corner of another";
    // A point is none.
    const Warnings warnings("wires");
    const TriangleMesh point({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 5, 5}}, {{0, 1, 2}, {3, 3, 3}});
    EXPECT_EQ(warnings.count, 0U);
}

TEST(TriangleMesh, WarnsOfPartsThatAreTooSmallToBeChecked)
{
    const auto warningsOf = [](double ground)
    {
        const Warnings warnings("1 of its 2 triangles are too small to be checked");
        const TriangleMesh mesh(
            {{-ground, -ground, 0}, {ground, -ground, 0}, {0, ground, 0}, {0, 0, 1}, {0.01, 0, 1}, {0, 0.01, 1}},
            {{0, 1, 2}, {3, 4, 5}});
        EXPECT_EQ(mesh.isDegenerate(1), ground > 1e5);
        return warnings.count;
    };
    EXPECT_EQ(warningsOf(1e4), 0U);
    EXPECT_EQ(warningsOf(1e6), 1U);
}

TEST(TriangleMesh, IsClosedIfEachEdgeHasTwoTriangles)
{
    for (const auto &mesh : {boxMesh({1, 2, 3}), ballMesh(5)})
    {
        EXPECT_TRUE(mesh->isClosed());
        // One triangle missing, or one twice; not one of the flat ones at the pole of the ball
        EXPECT_FALSE(without(*mesh, mesh->getTriangles().size() / 2 - 1).isClosed());
        Triangles twice = mesh->getTriangles();
        twice.push_back(twice[twice.size() / 2]);
        EXPECT_FALSE(TriangleMesh(mesh->getVertices(), twice).isClosed());
        // Each triangle with corners of its own, as in an STL file, and one without area
        std::vector<Eigen::Vector3d> corners;
        Triangles own;
        for (const auto &triangle : mesh->getTriangles())
        {
            for (const auto vertex : triangle)
                corners.push_back(mesh->getVertices()[vertex]);
            const auto last = static_cast<std::uint32_t>(corners.size());
            own.push_back({last - 3, last - 2, last - 1});
        }
        own.push_back({0, 0, 1});
        EXPECT_TRUE(TriangleMesh(corners, own).isClosed());
    }
    EXPECT_FALSE(TriangleMesh(CORNERS, {{0, 1, 2}}).isClosed());
    EXPECT_TRUE(TriangleMesh(CORNERS, {{0, 1, 2}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}).isClosed());
}

TEST(TriangleMesh, BodiesAreEqualIfTheirMeshesAre)
{
    const Body body = Body::mesh(boxMesh({1, 2, 3}));
    EXPECT_TRUE(body == Body::mesh(boxMesh({1, 2, 3})));
    EXPECT_FALSE(body == Body::mesh(boxMesh({1, 2, 4})));
    EXPECT_FALSE(body == Body::planarMesh(boxMesh({1, 2, 3})));
    EXPECT_FALSE(body == Body::box(1, 2, 3));
}

TEST(TriangleMesh, BoundingRadiusIsThatOfTheFarthestVertex)
{
    EXPECT_DOUBLE_EQ(Body::mesh(boxMesh({2, 4, 4})).getBoundingRadius(), 3.0);
    EXPECT_DOUBLE_EQ(Body::planarMesh(boxMesh({6, 8, 4})).getBoundingRadius(), 5.0);
    const Body planar = Body::planarMesh(boxMesh({6, 8, 4}, {0, 0, 1}));
    EXPECT_EQ(planar.getZInterval().low, -1.0);
    EXPECT_EQ(planar.getZInterval().high, 3.0);
    EXPECT_EQ(planar.getDimension(), 2U);
    EXPECT_TRUE(std::isinf(Body::mesh(boxMesh({2, 4, 4})).getZInterval().low));
    EXPECT_TRUE(std::isinf(Body::disc(1.0).getZInterval().high));
    Pose lifted = planarPose(1.0, 2.0, 0.5);
    lifted.translation().z() = 10.0;
    const Body two(
        {{Shape::mesh(2, boxMesh({1, 1, 2})), lifted}, {Shape::mesh(2, boxMesh({1, 1, 1})), Pose::Identity()}});
    EXPECT_EQ(two.getZInterval().low, -0.5);
    EXPECT_EQ(two.getZInterval().high, 11.0);
    EXPECT_EQ(two.getSphereTree().getRoot().center.z(), 0.0);
    const Body mixed({{Shape::mesh(2, boxMesh({1, 1, 2})), lifted}, {Shape::ball(2, 1.0), Pose::Identity()}});
    EXPECT_TRUE(std::isinf(mixed.getZInterval().low));
    EXPECT_TRUE(std::isinf(mixed.getZInterval().high));
}

TEST(TriangleMesh, HasNoInside)
{
    const Body body = Body::mesh(boxMesh({2, 2, 2}));
    EXPECT_DOUBLE_EQ(body.signedDistance({0, 0, 0.25}), 0.75);
    EXPECT_DOUBLE_EQ(body.signedDistance({0, 0, 3}), 2.0);
    EXPECT_TRUE(body.getInnerSpheres().empty());
    EXPECT_DOUBLE_EQ(Body::planarMesh(boxMesh({2, 2, 2})).signedDistance({0, 0, 0}), 0.0);
    EXPECT_DOUBLE_EQ(Body::planarMesh(boxMesh({2, 2, 2})).signedDistance({4, 5, 0}), 5.0);
}
