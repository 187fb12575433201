#include "generators/Meshes.h"

#include <boost/math/constants/constants.hpp>
#include <cmath>

namespace generators
{
    namespace
    {
        constexpr double TURN = 2.0 * boost::math::constants::pi<double>();
    }

    std::vector<Eigen::Vector2d> circleOf(unsigned int corners, const std::function<double(unsigned int)> &radius)
    {
        std::vector<Eigen::Vector2d> points;
        for (unsigned int i = 0; i < corners; ++i)
        {
            const double angle = TURN * i / corners;
            points.emplace_back(radius(i) * std::cos(angle), radius(i) * std::sin(angle));
        }
        return points;
    }

    MeshBuilder knotMesh()
    {
        MeshBuilder knot;
        knot.addTube(
            [](double t)
            {
                const double angle = 2.0 * TURN * t, around = 2.0 + std::cos(1.5 * angle);
                return Eigen::Vector3d(around * std::cos(angle), around * std::sin(angle), std::sin(1.5 * angle));
            },
            0.25, 128, 10);
        return knot;
    }

    MeshBuilder gearMesh(double radius)
    {
        MeshBuilder gear;
        gear.addRing(circleOf(72, [&](unsigned int i) { return i % 6 < 3 ? radius : 1.15; }),
                     circleOf(72, [](unsigned int) { return 0.6; }), -0.2, 0.2);
        return gear;
    }

    MeshBuilder cartMesh()
    {
        MeshBuilder cart;
        cart.addPrism({{-0.2, -0.2}, {0.7, -0.2}, {0.7, 0.1}, {0.1, 0.1}, {0.1, 0.6}, {-0.2, 0.6}}, 0.1, 1.2);
        return cart;
    }
}
