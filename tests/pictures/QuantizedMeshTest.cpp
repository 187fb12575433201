#include "pictures/QuantizedMesh.h"
#include "support/Random.h"

#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <vector>

namespace ompl_certificates
{
    TEST(QuantizedMesh, KeepsItsTriangles)
    {
        test::Random random(1);
        std::vector<std::array<Eigen::Vector3d, 3>> triangles;
        for (int i = 0; i < 500; ++i)
            triangles.push_back({random.point(3, 10.0), random.point(3, 10.0), random.point(3, 10.0)});
        // One without area, which is left out
        triangles.push_back({triangles[0][0], triangles[0][0], triangles[0][1]});
        const QuantizedMesh mesh(triangles, 1000);
        ASSERT_EQ(mesh.triangles.size(), 3u * 500);
        for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
            for (int axis = 0; axis < 3; ++axis)
            {
                const double coordinate = mesh.vertices[3 * mesh.triangles[i] + static_cast<std::size_t>(axis)];
                EXPECT_NEAR(mesh.low[axis] + coordinate * mesh.step[axis], triangles[i / 3][i % 3][axis],
                            0.51 * mesh.step.maxCoeff());
            }
        EXPECT_LT(mesh.step.maxCoeff(), 20.0 / 65000);
    }

    TEST(QuantizedMesh, IsCoarserIfItIsLarge)
    {
        std::vector<std::array<Eigen::Vector3d, 3>> triangles;
        constexpr int SIDE = 200;
        const auto at = [](int x, int y) { return Eigen::Vector3d(x, y, std::sin(0.05 * x) * std::cos(0.03 * y)); };
        for (int x = 0; x < SIDE; ++x)
            for (int y = 0; y < SIDE; ++y)
            {
                triangles.push_back({at(x, y), at(x + 1, y), at(x + 1, y + 1)});
                triangles.push_back({at(x, y), at(x + 1, y + 1), at(x, y + 1)});
            }
        const QuantizedMesh mesh(triangles, 20000);
        EXPECT_LE(mesh.triangles.size() / 3, 20000u);
        EXPECT_GE(mesh.triangles.size() / 3, 5000u);
    }
}
