#include "geometry/MeshSolid.h"

#include "support/RandomMeshes.h"

#include <gtest/gtest.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;

namespace
{
    using Triangles = std::vector<TriangleMesh::Triangle>;

    /** The mesh with some triangles wound the other way, some of them twice, corners that are not welded, and triangles
        that hang loose: far away, at a corner, and at an edge with one more behind it */
    TriangleMesh spoiled(const TriangleMesh &mesh, Random &random)
    {
        std::vector<Eigen::Vector3d> vertices;
        Triangles triangles;
        const auto add = [&](const std::array<Eigen::Vector3d, 3> &corners)
        {
            const auto first = static_cast<std::uint32_t>(vertices.size());
            vertices.insert(vertices.end(), corners.begin(), corners.end());
            triangles.push_back({first, first + 1, first + 2});
            if (random.chance(0.5))
                std::swap(triangles.back()[0], triangles.back()[1]);
        };
        for (std::size_t i = 0; i < mesh.getTriangles().size(); ++i)
            for (int times = random.chance(0.2) ? 2 : 1; times > 0; --times)
                add(mesh.getCorners(i));
        const auto [a, b, c] = mesh.getCorners(random.below(static_cast<unsigned int>(mesh.getTriangles().size())));
        const Eigen::Vector3d tip = random.point(3, 3.0), end = random.point(3, 3.0);
        add({a, tip, end});
        add({a, b, tip});
        add({b, tip, end});
        add({random.point(3, 3.0), random.point(3, 3.0), random.point(3, 3.0)});
        return {vertices, triangles};
    }

    bool isInBox(const Eigen::Vector3d &point, const Eigen::Vector3d &size, const Eigen::Vector3d &center)
    {
        return ((point - center).cwiseAbs() - 0.5 * size).maxCoeff() < 0.0;
    }
}

TEST(MeshSolid, IsThatOfABoxHoweverItsTrianglesAreWound)
{
    int inside = 0;
    for (unsigned int seed = 1; seed <= 60; ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const Eigen::Vector3d size = 0.2 * Eigen::Vector3d::Ones() + (random.point(3, 1.0)).cwiseAbs(),
                              center = random.point(3, 1.0);
        const TriangleMeshPtr box = boxMesh(size, center);
        const MeshSolid exact(*box), other(spoiled(*box, random));
        for (int i = 0; i < 300; ++i)
        {
            const Eigen::Vector3d point = center + 0.7 * random.point(3, 1.0).cwiseProduct(size);
            const bool is = isInBox(point, size, center);
            inside += is ? 1 : 0;
            ASSERT_EQ(exact.contains(point), is) << point.transpose();
            ASSERT_EQ(other.contains(point), is) << point.transpose();
        }
        // Rays from such points would meet edges and corners, were they along the axes.
        EXPECT_TRUE(exact.contains(center));
        EXPECT_FALSE(exact.contains(center - Eigen::Vector3d(0.0, 0.0, size.z())));
        EXPECT_FALSE(exact.contains(center - Eigen::Vector3d(0.5 * size.x(), 0.5 * size.y(), size.z())));
    }
    EXPECT_GT(inside, 3000);
}

TEST(MeshSolid, IsThatOfABallOfManyTriangles)
{
    const unsigned int rings = 24;
    const TriangleMeshPtr ball = ballMesh(rings, 2.0);
    Random random(1);
    const MeshSolid exact(*ball), other(spoiled(*ball, random));
    const double flat = 2.0 * std::pow(std::cos(0.5 * M_PI / rings), 2);
    for (int i = 0; i < 20000; ++i)
    {
        const Eigen::Vector3d point = random.point(3, 2.2);
        if (const double distance = point.norm(); distance < flat || distance > 2.0)
        {
            ASSERT_EQ(exact.contains(point), distance < flat) << point.transpose();
            ASSERT_EQ(other.contains(point), distance < flat) << point.transpose();
        }
    }
}

TEST(MeshSolid, IsThatOfAPrismWhoseTrianglesAreLong)
{
    // Each of them is in many columns of any grid.
    constexpr unsigned int sides = 2000;
    std::vector<Eigen::Vector3d> corners;
    for (unsigned int i = 0; i < sides; ++i)
        for (const double z : {-1.0, 1.0})
            corners.emplace_back(std::cos(2.0 * M_PI * i / sides), std::sin(2.0 * M_PI * i / sides), z);
    corners.emplace_back(0.0, 0.0, -1.0);
    corners.emplace_back(0.0, 0.0, 1.0);
    std::vector<TriangleMesh::Triangle> triangles;
    for (unsigned int i = 0; i < sides; ++i)
    {
        const unsigned int a = 2 * i, b = 2 * ((i + 1) % sides);
        triangles.insert(triangles.end(),
                         {{a, b, a + 1}, {b, b + 1, a + 1}, {a, b, 2 * sides}, {a + 1, b + 1, 2 * sides + 1}});
    }
    const MeshSolid prism(TriangleMesh(corners, triangles));
    Random random(1);
    for (int i = 0; i < 5000; ++i)
    {
        const Eigen::Vector3d point = random.point(3, 1.2);
        const double radius = point.head<2>().norm();
        if (std::abs(radius - 1.0) > 1e-5)
        {
            ASSERT_EQ(prism.contains(point), radius < 1.0 && std::abs(point.z()) < 1.0) << point.transpose();
        }
    }
}

TEST(MeshSolid, OfPiecesIsTheirUnion)
{
    const Eigen::Vector3d size(1.0, 1.0, 1.0), shifted(0.5, 0.4, 0.3);
    const MeshSolid both(*joined({boxMesh(size), boxMesh(size, shifted)}));
    Random random(1);
    for (int i = 0; i < 3000; ++i)
    {
        const Eigen::Vector3d point = random.point(3, 1.2);
        ASSERT_EQ(both.contains(point), isInBox(point, size, Eigen::Vector3d::Zero()) || isInBox(point, size, shifted))
            << point.transpose();
    }
}

TEST(MeshSolid, IsNowhereIfThereIsAHole)
{
    const TriangleMeshPtr box = boxMesh({1.0, 1.0, 1.0});
    for (std::size_t left = 0; left < box->getTriangles().size(); ++left)
    {
        Triangles triangles = box->getTriangles();
        triangles.erase(triangles.begin() + static_cast<std::ptrdiff_t>(left));
        EXPECT_FALSE(MeshSolid(TriangleMesh(box->getVertices(), triangles)).contains(Eigen::Vector3d::Zero()));
    }
    Random random(1);
    const MeshSolid soup(*randomSoup(random, 2.0));
    EXPECT_FALSE(soup.contains({100.0, 0.0, 0.0}));
}

TEST(MeshSolid, OfALargeOpenMeshIsFoundInTime)
{
    // A sheet that is taken apart from its rim, triangle after triangle
    constexpr std::uint32_t count = 200;
    std::vector<Eigen::Vector3d> vertices;
    Triangles triangles;
    for (std::uint32_t i = 0; i < count; ++i)
        for (std::uint32_t j = 0; j < count; ++j)
        {
            vertices.emplace_back(i, j, (i * j) % 7);
            if (i > 0 && j > 0)
            {
                const std::uint32_t at = i * count + j;
                triangles.push_back({at, at - 1, at - count});
                triangles.push_back({at - 1, at - count, at - count - 1});
            }
        }
    EXPECT_FALSE(MeshSolid(TriangleMesh(vertices, triangles)).contains({20.3, 30.7, 1.0}));
}
