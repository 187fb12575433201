#ifndef OMPL_CERTIFICATES_BENCHMARKS_COMMON_RANDOM_WORLD_
#define OMPL_CERTIFICATES_BENCHMARKS_COMMON_RANDOM_WORLD_

#include "ompl_certificates/obstacles/FclObstacles.h"

#include <cmath>
#include <random>
#include <vector>

namespace benchmarks
{
    /** \brief Random points and obstacles in a square or a cube of side SIZE, the same in every run */
    class RandomWorld
    {
    public:
        static constexpr double SIZE = 100.0;

        RandomWorld(unsigned int dimension, std::uint64_t seed) : dimension_(dimension), engine_(seed)
        {
        }

        double uniform(double low, double high)
        {
            return std::uniform_real_distribution<double>(low, high)(engine_);
        }

        Eigen::Vector3d point()
        {
            const double x = uniform(0.0, SIZE), y = uniform(0.0, SIZE);
            return {x, y, dimension_ == 2 ? 0.0 : uniform(0.0, SIZE)};
        }

        Eigen::Vector3d direction()
        {
            std::normal_distribution<double> normal;
            Eigen::Vector3d d(normal(engine_), normal(engine_), dimension_ == 2 ? 0.0 : normal(engine_));
            return d.normalized();
        }

        /** \brief A random point and a random orientation */
        ompl_certificates::Pose pose()
        {
            const Eigen::Vector3d at = point();
            if (dimension_ == 2)
                return ompl_certificates::planarPose(at.x(), at.y(), uniform(-M_PI, M_PI));
            std::normal_distribution<double> normal;
            ompl_certificates::Pose pose = ompl_certificates::poseAt(at);
            Eigen::Quaterniond turn(normal(engine_), normal(engine_), normal(engine_), normal(engine_));
            pose.linear() = turn.normalized().toRotationMatrix();
            return pose;
        }

        /** \brief Boxes and convex polygons or polytopes that fill a good fifth of the world, whatever their number */
        std::vector<ompl_certificates::PlacedBody> obstacles(unsigned int count)
        {
            using ompl_certificates::Body;
            const double size = SIZE * std::pow(0.25 / count, 1.0 / dimension_);
            std::vector<ompl_certificates::PlacedBody> all;
            for (unsigned int i = 0; i < count; ++i)
            {
                const auto extent = [&] { return size * uniform(0.5, 1.5); };
                const double x = extent(), y = extent(), z = extent();
                if (i % 2 == 0)
                    all.push_back({dimension_ == 2 ? Body::box(x, y) : Body::box(x, y, z), pose()});
                else
                    all.push_back({polytope(0.6 * size), pose()});
            }
            return all;
        }

        /** \brief A convex polygon or polytope with corners on a sphere of radius \e radius */
        ompl_certificates::Body polytope(double radius)
        {
            if (dimension_ == 2)
            {
                std::vector<Eigen::Vector2d> corners;
                for (int i = 0; i < 6; ++i)
                {
                    const double angle = M_PI / 3.0 * (i + uniform(-0.3, 0.3));
                    corners.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
                }
                return ompl_certificates::Body::convexPolygon(corners);
            }
            std::vector<Eigen::Vector3d> corners;
            for (int i = 0; i < 10; ++i)
                corners.push_back(radius * direction());
            return ompl_certificates::Body::convexPolytope(corners);
        }

    private:
        unsigned int dimension_;
        std::mt19937_64 engine_;
    };
}

#endif
