#ifndef OMPL_CERTIFICATES_TESTS_SUPPORT_RANDOM_
#define OMPL_CERTIFICATES_TESTS_SUPPORT_RANDOM_

#include "generators/SeededRandom.h"
#include "ompl_certificates/geometry/Pose.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>

namespace ompl_certificates
{
    namespace test
    {
        /** \brief \e count times the environment variable OMPL_CERTIFICATES_TEST_SCALE, but at least one: the number of
            random cases of a test */
        inline unsigned int scaled(unsigned int count)
        {
            const char *text = std::getenv("OMPL_CERTIFICATES_TEST_SCALE");
            const double scale = text ? std::atof(text) : 1.0;
            return std::max(1U, static_cast<unsigned int>(scale * count));
        }

        /** \brief Random numbers, the same on every machine for a seed */
        class Random : public generators::SeededRandom
        {
        public:
            explicit Random(std::uint64_t seed) : SeededRandom(seed * 0x9E3779B97F4A7C15ULL + 1)
            {
            }

            /** \brief All orders of magnitude from \e low to \e high are equally likely. */
            double logUniform(double low, double high)
            {
                return std::exp(uniform(std::log(low), std::log(high)));
            }

            /** \brief One of 0, …, count - 1 */
            unsigned int below(std::size_t count)
            {
                return integer(0, static_cast<unsigned int>(count - 1));
            }

            bool chance(double probability)
            {
                return uniform(0.0, 1.0) < probability;
            }

            double sign()
            {
                return chance(0.5) ? 1.0 : -1.0;
            }

            /** \brief A point of the square (\e dimension 2) or cube (3) about the origin */
            Eigen::Vector3d point(unsigned int dimension, double half)
            {
                const double x = uniform(-half, half), y = uniform(-half, half);
                return {x, y, dimension == 2 ? 0.0 : uniform(-half, half)};
            }

            Eigen::Vector3d direction(unsigned int dimension)
            {
                for (;;)
                {
                    const Eigen::Vector3d v = point(dimension, 1.0);
                    if (v.norm() < 1.0 && v.norm() > 1e-3)
                        return v.normalized();
                }
            }

            Eigen::Quaterniond rotation()
            {
                for (;;)
                {
                    const Eigen::Vector4d q(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1), uniform(-1, 1));
                    if (q.norm() < 1.0 && q.norm() > 1e-3)
                        return Eigen::Quaterniond(q.normalized());
                }
            }

            /** \brief A pose somewhere in a square or cube, now and then along the axes */
            Pose pose(unsigned int dimension, double half)
            {
                const Eigen::Vector3d position = point(dimension, half);
                if (chance(0.2))
                    return poseAt(position);
                if (dimension == 2)
                    return planarPose(position.x(), position.y(), uniform(-M_PI, M_PI));
                Pose pose = poseAt(position);
                pose.linear() = rotation().toRotationMatrix();
                return pose;
            }
        };
    }
}

#endif
