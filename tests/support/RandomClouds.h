#ifndef OMPL_CERTIFICATES_TESTS_SUPPORT_RANDOM_CLOUDS_
#define OMPL_CERTIFICATES_TESTS_SUPPORT_RANDOM_CLOUDS_

#include "Random.h"

#include <vector>

namespace ompl_certificates
{
    namespace test
    {
        /** \brief Points of some walls, some scattered ones, and some twice, within \e half of \e center */
        inline std::vector<Eigen::Vector3d> randomPoints(Random &random, unsigned int dimension, std::size_t count,
                                                         double half,
                                                         const Eigen::Vector3d &center = Eigen::Vector3d::Zero())
        {
            std::vector<Eigen::Vector3d> points;
            Eigen::Vector3d low = random.point(dimension, half), high = random.point(dimension, half);
            while (points.size() < count)
            {
                if (random.chance(20.0 / static_cast<double>(count + 20)))  // another wall
                {
                    low = random.point(dimension, half);
                    high = random.point(dimension, half);
                    high[random.below(dimension)] = low[random.below(dimension)];
                    if (dimension == 2)
                        high.z() = low.z() = 0.0;
                }
                Eigen::Vector3d point = random.chance(0.1) ? random.point(dimension, half) : low;
                if (point == low)
                    for (const Eigen::Index axis : {0, 1, 2})
                        point[axis] += random.uniform(0.0, 1.0) * (high - low)[axis];
                if (random.chance(0.05) && !points.empty())
                    points.push_back(points[random.below(points.size())]);
                else
                    points.push_back(point + center);
            }
            return points;
        }

        /** \brief A radius for each point, or one for all */
        inline std::vector<double> randomRadii(Random &random, std::size_t count, double most)
        {
            if (random.chance(0.5))
                return {random.chance(0.3) ? 0.0 : random.uniform(0.0, most)};
            std::vector<double> radii;
            while (radii.size() < count)
                radii.push_back(random.chance(0.3) ? 0.0 : most * random.logUniform(1e-3, 1.0));
            return radii;
        }
    }
}

#endif
