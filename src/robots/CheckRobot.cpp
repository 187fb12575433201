#include "ompl_certificates/robots/CheckRobot.h"

#include "geometry/TrialText.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <ompl/base/ScopedState.h>
#include <ompl/util/RandomNumbers.h>

namespace ompl_certificates
{
    namespace ob = ompl::base;

    namespace
    {
        constexpr double NONE = std::numeric_limits<double>::quiet_NaN();

        /** The rounding error of coordinates and rotations, relative to their size */
        constexpr double ROUNDING = 1e-9;

        /** The shortest interval of a motion that is tried: below it, rounding hides the movement */
        constexpr double SHORTEST = 1e-3;

        constexpr unsigned int INTERVALS = 8;

        class RobotTrial
        {
        public:
            explicit RobotTrial(const Robot &robot)
              : robot_(robot), space_(robot.getStateSpace()), bodies_(robot.getBodies().size())
            {
                space_->setup();
                sampler_ = space_->allocStateSampler();
            }

            void run(unsigned int motions)
            {
                ob::ScopedState<> from(space_), to(space_);
                for (unsigned int i = 0; i < motions; ++i)
                {
                    sampler_->sampleUniform(from.get());
                    sampler_->sampleUniform(to.get());
                    // Short motions too: bounds need not be linear in their length.
                    if (random_.uniform01() < 0.5)
                        space_->interpolate(from.get(), to.get(), std::pow(10.0, random_.uniformReal(-4.0, 0.0)),
                                            to.get());
                    tryMotion(from.get(), to.get());
                }
            }

        private:
            [[noreturn]] void fail(const std::string &what) const
            {
                throw ompl::Exception("Robot '" + robot_.getName() + "': " + what);
            }

            std::string motionText(const ob::State *from, const ob::State *to) const
            {
                return "on the motion from the state " + textOf(*space_, from) + " to " + textOf(*space_, to);
            }

            std::vector<Pose> posesOf(const ob::State *state) const
            {
                Pose none;
                none.matrix().setConstant(NONE);
                std::vector<Pose> poses(bodies_ + 1, none);
                robot_.computePoses(state, poses.data());
                for (std::size_t i = 0; i < bodies_; ++i)
                {
                    const std::string where =
                        " of body " + std::to_string(i) + " in the state " + textOf(*space_, state);
                    const Eigen::Matrix3d turn = poses[i].linear();
                    if (!poses[i].matrix().allFinite())
                        fail("the pose" + where + " is not finite, or was not written");
                    if (!turn.isUnitary(1e-6) || turn.determinant() < 0.0)
                        fail("the pose" + where + " is not a rotation and a translation");
                    if (robot_.getWorkspaceDimension() != 2)
                        continue;
                    const double tilt = (turn.col(2) - Eigen::Vector3d::UnitZ()).norm();
                    const double z = poses[i].translation().z();
                    if (tilt > ROUNDING || std::abs(z) > ROUNDING * (1.0 + poses[i].translation().norm()))
                        fail("the pose" + where + " leaves the plane: z = " + textOf(z) + ", tilted by " +
                             textOf(tilt));
                }
                if (!std::isnan(poses[bodies_].translation().x()))
                    fail("computePoses() writes more than the poses of its " + std::to_string(bodies_) + " bodies");
                return poses;
            }

            std::vector<MotionBound> boundsOf(const ob::State *from, const ob::State *to) const
            {
                std::vector<MotionBound> bounds(bodies_ + 1, MotionBound{NONE, NONE});
                robot_.computeMotionBounds(from, to, bounds.data());
                for (std::size_t i = 0; i < bodies_; ++i)
                    if (!(bounds[i].linear >= 0.0 && bounds[i].angular >= 0.0))
                        fail("the motion bound of body " + std::to_string(i) + " " + motionText(from, to) +
                             " must not be negative, and must be written: it is " + textOf(bounds[i].linear) + " and " +
                             textOf(bounds[i].angular));
                if (!std::isnan(bounds[bodies_].linear))
                    fail("computeMotionBounds() writes more than the bounds of its " + std::to_string(bodies_) +
                         " bodies");
                return bounds;
            }

            /** The poses at time \e t, from the state that a checker would use */
            std::vector<Pose> posesAt(const ob::State *from, const ob::State *to, double t) const
            {
                if (t == 0.0 || t == 1.0)
                    return posesOf(t == 0.0 ? from : to);
                ob::ScopedState<> between(space_);
                space_->interpolate(from, to, t, between.get());
                return posesOf(between.get());
            }

            void tryMotion(const ob::State *from, const ob::State *to)
            {
                const std::vector<MotionBound> bounds = boundsOf(from, to);
                std::vector<double> times{0.0, 1.0};
                for (unsigned int i = 0; i < INTERVALS; ++i)
                {
                    times.push_back(random_.uniform01());
                    times.push_back(std::min(1.0, times.back() + std::pow(10.0, random_.uniformReal(-3.0, 0.0))));
                }
                std::sort(times.begin(), times.end());
                std::vector<std::vector<Pose>> poses;
                poses.reserve(times.size());
                for (const double time : times)
                    poses.push_back(posesAt(from, to, time));
                for (std::size_t i = 0; i < times.size(); ++i)
                    for (std::size_t k = i + 1; k < times.size(); ++k)
                        if (times[k] - times[i] >= SHORTEST)
                            for (std::size_t body = 0; body < bodies_; ++body)
                                tryInterval(from, to, times[i], times[k], body, poses[i][body], poses[k][body],
                                            bounds[body]);
            }

            void tryInterval(const ob::State *from, const ob::State *to, double first, double last, std::size_t body,
                             const Pose &before, const Pose &after, const MotionBound &bound) const
            {
                const double radius = robot_.getBodies()[body].getBoundingRadius();
                const Eigen::Vector3d moved = after.translation() - before.translation();
                const Eigen::Matrix3d turned = after.linear() - before.linear();
                const double slack = ROUNDING * (1.0 + radius + before.translation().norm());
                // The origin, points along the axes, and the point that the rotation moves in the direction of the
                // translation.
                const Eigen::Vector3d along = turned.transpose() * moved;
                std::vector<Eigen::Vector3d> points{Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitX(),
                                                    Eigen::Vector3d::UnitY()};
                if (robot_.getWorkspaceDimension() == 3)
                    points.push_back(Eigen::Vector3d::UnitZ());
                if (along.norm() > 0.0)
                    points.push_back(along.normalized());
                for (const Eigen::Vector3d &direction : points)
                {
                    const Eigen::Vector3d point = radius * direction;
                    const double distance = (moved + turned * point).norm(),
                                 most = bound.at(point.norm()) * (last - first);
                    if (!(distance <= most * (1.0 + ROUNDING) + slack))
                        fail(motionText(from, to) + ", between times " + textOf(first) + " and " + textOf(last) +
                             ", the point " + textOf(point) + " of body " + std::to_string(body) + " moves " +
                             textOf(distance) + ", but its motion bound (linear " + textOf(bound.linear) +
                             ", angular " + textOf(bound.angular) + ") allows " + textOf(most));
                }
            }

            const Robot &robot_;
            const ob::StateSpacePtr space_;
            const std::size_t bodies_;
            ob::StateSamplerPtr sampler_;
            ompl::RNG random_;
        };
    }

    void checkRobot(const Robot &robot, unsigned int motions)
    {
        RobotTrial(robot).run(motions);
    }
}
