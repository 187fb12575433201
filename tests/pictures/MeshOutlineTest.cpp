#include "pictures/MeshOutline.h"

#include <Eigen/Geometry>
#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <gtest/gtest.h>

namespace ompl_certificates
{
    namespace
    {
        /** The box around the outlines of one triangle in a picture of 100 by 100 */
        Eigen::AlignedBox2d boxOf(const std::array<Eigen::Vector3d, 3> &corners)
        {
            MeshOutline outline({0.0, 0.0}, {100.0, 100.0}, 0.5);
            outline.add(corners);
            Eigen::AlignedBox2d box;
            for (const MeshOutline::Loop &loop : outline.trace(-1e9))
                for (const Eigen::Vector2d &corner : loop)
                    box.extend(corner);
            return box;
        }
    }

    TEST(MeshOutlineTest, WallsMuchLongerThanThePictureAreDrawn)
    {
        for (const double half : {60.0, 1e3, 1e5, 1e8})
        {
            SCOPED_TRACE(half);
            // A wall seen from above has no area.
            const Eigen::AlignedBox2d box =
                boxOf({Eigen::Vector3d(50.1, 50.0 - half, 0.0), Eigen::Vector3d(50.1, 50.0 + half, 0.0),
                       Eigen::Vector3d(50.1, 50.0 + half, 3.0)});
            EXPECT_LT((box.min() - Eigen::Vector2d(50.0, 0.0)).norm(), 1e-6);
            EXPECT_LT((box.max() - Eigen::Vector2d(50.5, 100.0)).norm(), 1e-6);
            const Eigen::AlignedBox2d slant =
                boxOf({Eigen::Vector3d(-half, -half, 0.0), Eigen::Vector3d(half + 100.0, half + 100.0, 0.0),
                       Eigen::Vector3d(-half, -half, 3.0)});
            EXPECT_LT((slant.min() - Eigen::Vector2d(0.0, 0.0)).norm(), 2.0);
            EXPECT_LT((slant.max() - Eigen::Vector2d(100.0, 100.0)).norm(), 2.0);
        }
    }

    TEST(MeshOutlineTest, WallsAreOneLineInAnyDirection)
    {
        for (int degrees = 0; degrees < 180; degrees += 3)
        {
            SCOPED_TRACE(degrees);
            const double angle = degrees * boost::math::constants::degree<double>();
            const Eigen::Vector3d middle(50.0, 50.0, 0.0), half(30.0 * std::cos(angle), 30.0 * std::sin(angle), 0.0);
            MeshOutline outline({0.0, 0.0}, {100.0, 100.0}, 0.5);
            outline.add({middle - half, middle + half, middle + half + Eigen::Vector3d::UnitZ()});
            const std::vector<MeshOutline::Loop> loops = outline.trace(-1.0);
            ASSERT_EQ(loops.size(), 1U);
            Eigen::AlignedBox2d box;
            for (const Eigen::Vector2d &corner : loops.front())
                box.extend(corner);
            EXPECT_LT((box.sizes() - 2.0 * half.head<2>().cwiseAbs()).cwiseAbs().maxCoeff(), 1.1);
        }
    }

    TEST(MeshOutlineTest, WallsBesideThePictureAreNotThere)
    {
        for (const double x : {-1.0, 101.0})
            EXPECT_TRUE(
                boxOf({Eigen::Vector3d(x, -500.0, 0.0), Eigen::Vector3d(x, 500.0, 0.0), Eigen::Vector3d(x, 500.0, 3.0)})
                    .isEmpty());
        // Its box meets the picture, the wall does not.
        EXPECT_TRUE(boxOf({Eigen::Vector3d(-300.0, 100.0, 0.0), Eigen::Vector3d(100.0, 500.0, 0.0),
                           Eigen::Vector3d(100.0, 500.0, 3.0)})
                        .isEmpty());
    }
}
