#ifndef OMPL_CERTIFICATES_TESTS_CONTROL_OWN_DYNAMIC_ROBOTS_
#define OMPL_CERTIFICATES_TESTS_CONTROL_OWN_DYNAMIC_ROBOTS_

#include "DynamicProblems.h"

#include <algorithm>
#include <cmath>
#include <ompl/base/spaces/SE3StateSpace.h>

namespace ompl_certificates
{
    namespace test
    {
        /** \brief A body in space that is moved along the axes, and turned about one of its own */
        class Spinner : public DynamicRobot
        {
        public:
            explicit Spinner(const RobotPtr &shape)
              : DynamicRobot(shape, {}, ompl::base::RealVectorBounds(0), {"x", "y", "z", "turn"},
                             within({0.5, 0.5, 0.5, 1.0}))
            {
            }

            void propagate(const ompl::base::State *from, const double *control, double duration,
                           ompl::base::State *to) const override
            {
                const auto *start = from->as<ompl::base::SE3StateSpace::StateType>();
                auto *end = to->as<ompl::base::SE3StateSpace::StateType>();
                const auto &q = start->rotation();
                const Eigen::Quaterniond turned =
                    Eigen::Quaterniond(q.w, q.x, q.y, q.z) *
                    Eigen::AngleAxisd(duration * control[3], Eigen::Vector3d(0.6, 0.0, 0.8));
                end->setXYZ(start->getX() + duration * control[0], start->getY() + duration * control[1],
                            start->getZ() + duration * control[2]);
                end->rotation().x = turned.x();
                end->rotation().y = turned.y();
                end->rotation().z = turned.z();
                end->rotation().w = turned.w();
            }

            void computeStepBounds(const ompl::base::State * /*from*/, const double *control, double duration,
                                   MotionBound *bounds) const override
            {
                bounds[0] = {duration * Eigen::Vector3d(control[0], control[1], control[2]).norm(),
                             duration * std::abs(control[3])};
            }
        };

        /** \brief A disc that is pushed, and that loses half of its velocity in each step in which it brakes */
        class SoftBrake : public DynamicRobot
        {
        public:
            explicit SoftBrake(const RobotPtr &shape)
              : DynamicRobot(shape, {"vx", "vy"}, within({0.5, 0.5}), {"ax", "ay"}, within({2.0, 2.0}))
            {
            }

            void propagate(const ompl::base::State *from, const double *control, double duration,
                           ompl::base::State *to) const override
            {
                for (int i = 0; i < 2; ++i)
                {
                    const double v = velocitiesOf(from)[i];
                    const auto *start = poseOf(from)->as<ompl::base::RealVectorStateSpace::StateType>();
                    poseOf(to)->as<ompl::base::RealVectorStateSpace::StateType>()->values[i] =
                        start->values[i] + duration * (v + 0.5 * duration * control[i]);
                    velocitiesOf(to)[i] = v + duration * control[i];
                }
            }

            void computeStepBounds(const ompl::base::State *from, const double *control, double duration,
                                   MotionBound *bounds) const override
            {
                double way = 0.0;
                for (int i = 0; i < 2; ++i)
                    way += duration * (std::abs(velocitiesOf(from)[i]) + duration * std::abs(control[i]));
                bounds[0] = {way, 0.0};
            }

            void computeBrake(const ompl::base::State *state, double duration, double *control) const override
            {
                for (int i = 0; i < 2; ++i)
                    control[i] = std::clamp(-0.5 * velocitiesOf(state)[i] / duration, -2.0, 2.0);
            }
        };
    }
}

#endif
