#include "support/Cuts.h"
#include "support/RandomMeshes.h"

#include <gtest/gtest.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;

class MeshSphereTree : public testing::TestWithParam<unsigned int>
{
};

TEST_P(MeshSphereTree, ContainsEveryTriangleAtEveryCut)
{
    for (unsigned int seed = 0; seed < scaled(300); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const TriangleMeshPtr mesh = randomMesh(random, random.logUniform(1e-3, 1e4));
        const Body body = meshBody(GetParam(), mesh);
        for (const double wholeChance : {1.0, 0.0, 0.2, 0.5})
        {
            std::vector<Ball> balls;
            cut(random, body.getSphereTree(), 0, wholeChance, balls);
            for (const Ball &ball : balls)
                if (GetParam() == 2)
                {
                    ASSERT_EQ(ball.center.z(), 0.0);
                }
            const auto check = [&](Eigen::Vector3d point)
            {
                if (GetParam() == 2)
                    point.z() = 0.0;
                ASSERT_TRUE(contains(balls, point)) << point.transpose() << ", " << balls.size() << " balls";
            };
            for (int i = 0; i < 60; ++i)
                check(pointOf(random, *mesh, random.below(mesh->getTriangles().size())));
            for (const auto &triangle : mesh->getTriangles())
                check(mesh->getVertices()[triangle[random.below(3)]]);
            if (HasFatalFailure())
                return;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Dimension, MeshSphereTree, testing::Values(2U, 3U));
