#include "pictures/ViewerShapes.h"
#include "support/Random.h"

#include <chrono>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace ompl_certificates
{
    TEST(ViewerShapesTest, ManyShapesTakeLittleTime)
    {
        ViewerShapes shapes;
        test::Random random(1);
        std::vector<Shape> different;
        for (int i = 0; i < 40000; ++i)
            different.push_back(Shape::ball(2, random.uniform(0.1, 1.0)));
        const auto begin = std::chrono::steady_clock::now();
        for (int round = 0; round < 2; ++round)
            for (std::size_t i = 0; i < different.size(); ++i)
                ASSERT_EQ(shapes.add(different[i]), i);
        EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(3));
    }

    TEST(ViewerShapesTest, EqualShapesAreThereOnce)
    {
        const auto mesh = [](double x)
        {
            return std::make_shared<TriangleMesh>(std::vector<Eigen::Vector3d>{{0, 0, 0}, {x, 0, 0}, {0, 1, 1}},
                                                  std::vector<TriangleMesh::Triangle>{{0, 1, 2}});
        };
        const std::vector<Eigen::Vector3d> square{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}},
            other{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 2, 0}};
        const std::vector<Shape> different{Shape::ball(3, 1.0),
                                           Shape::ball(2, 1.0),
                                           Shape::box(Eigen::Vector2d(1.0, 2.0)),
                                           Shape::box(Eigen::Vector3d(1.0, 2.0, 3.0)),
                                           Shape::capsule(3, 1.0, 2.0),
                                           Shape::cylinder(1.0, 2.0),
                                           Shape::polytope(2, square),
                                           Shape::polytope(2, other),
                                           Shape::mesh(3, mesh(1.0)),
                                           Shape::mesh(3, mesh(2.0)),
                                           Shape::mesh(2, mesh(1.0))};
        ViewerShapes shapes;
        for (std::size_t i = 0; i < different.size(); ++i)
            EXPECT_EQ(shapes.add(different[i]), i);
        EXPECT_EQ(shapes.add(Shape::ball(3, 1.0)), 0U);
        EXPECT_EQ(shapes.add(Shape::polytope(2, other)), 7U);
        // Others of the same triangles, and of a planar mesh what another interval shows
        EXPECT_EQ(shapes.add(Shape::mesh(3, mesh(2.0)), {0.0, 1.0}), 9U);
        EXPECT_EQ(shapes.add(Shape::mesh(2, mesh(1.0)), {0.0, 1.0}), 11U);
        EXPECT_EQ(shapes.add(Shape::mesh(2, mesh(1.0)), {0.0, 1.0}), 11U);
        EXPECT_EQ(shapes.toJson().size(), 12U);
    }
}
