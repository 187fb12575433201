#include "ompl_certificates/control/CheckDynamicRobot.h"

#include "geometry/TrialText.h"

#include <cmath>
#include <limits>
#include <ompl/base/ScopedState.h>
#include <ompl/util/RandomNumbers.h>

namespace ompl_certificates
{
    namespace ob = ompl::base;

    namespace
    {
        /** Pays for numeric integration, relative to distances */
        constexpr double STEP_ROUNDING = 1e-6;

        /** The rounding error of points, relative to their coordinates */
        constexpr double POINT_ROUNDING = 1e-13;

        /** Whether all angles and quaternions of a state are as OMPL keeps them: it calls states with others invalid.
            */
        bool hasTurnsWithinBounds(const ob::StateSpace &space, const ob::State *state)
        {
            if (space.isCompound())
            {
                const auto &parts = *space.as<ob::CompoundStateSpace>();
                for (unsigned int i = 0; i < parts.getSubspaceCount(); ++i)
                    if (!hasTurnsWithinBounds(*parts.getSubspace(i), state->as<ob::CompoundState>()->components[i]))
                        return false;
                return true;
            }
            const bool turns = space.getType() == ob::STATE_SPACE_SO2 || space.getType() == ob::STATE_SPACE_SO3;
            return !turns || space.satisfiesBounds(state);
        }

        class StepTrial
        {
        public:
            StepTrial(const DynamicRobot &robot, double longest)
              : robot_(robot), space_(robot.getStateSpace()), longest_(longest), from_(space_)
            {
                space_->setup();
                sampler_ = space_->allocStateSampler();
            }

            void tryStep()
            {
                sampler_->sampleUniform(from_.get());
                const ob::RealVectorBounds &limits = robot_.getControlBounds();
                control_.clear();
                for (std::size_t i = 0; i < limits.low.size(); ++i)
                    control_.push_back(random_.uniformReal(limits.low[i], limits.high[i]));
                duration_ = longest_ * std::pow(10.0, random_.uniformReal(-3.0, 0.0));
                const ob::ScopedState<> end = stateAt(1.0);
                ob::ScopedState<> both = from_;
                robot_.propagate(both.get(), control_.data(), duration_, both.get());
                if (!space_->equalStates(both.get(), end.get()))
                    fail("propagate() writes " + textOf(*space_, end.get()) + ", but " + textOf(*space_, both.get()) +
                         " if both states are one");

                const std::size_t bodies = robot_.getBodies().size();
                constexpr double unwritten = std::numeric_limits<double>::quiet_NaN();
                std::vector<MotionBound> bounds(bodies + 1, MotionBound{unwritten, unwritten});
                robot_.computeStepBounds(from_.get(), control_.data(), duration_, bounds.data());
                if (!std::isnan(bounds[bodies].linear))
                    fail("computeStepBounds() writes more than the bounds of its " + std::to_string(bodies) +
                         " bodies");
                for (std::size_t body = 0; body < bodies; ++body)
                    if (!robot_.isZone(body) && !(bounds[body].linear >= 0.0 && bounds[body].angular >= 0.0))
                        fail("the bound of body " + std::to_string(body) +
                             " must not be negative, and must be written: it is " + textOf(bounds[body].linear) +
                             " and " + textOf(bounds[body].angular));
                const double time = random_.uniform01();
                tryInterval(bounds, 0.0, 1.0);
                tryInterval(bounds, time, std::min(1.0, time + std::pow(10.0, random_.uniformReal(-3.0, 0.0))));
            }

        private:
            [[noreturn]] void fail(const std::string &what) const
            {
                std::string controls;
                for (const double value : control_)
                    controls += (controls.empty() ? "" : ", ") + textOf(value);
                throw ompl::Exception("Robot '" + robot_.getName() + "': in the step from the state " +
                                      textOf(*space_, from_.get()) + " of " + textOf(duration_) +
                                      " s with the controls (" + controls + "), " + what);
            }

            ob::ScopedState<> stateAt(double time) const
            {
                ob::ScopedState<> state(space_);
                robot_.propagate(from_.get(), control_.data(), time * duration_, state.get());
                for (const double number : state.reals())
                    if (!std::isfinite(number))
                        fail("propagate() writes a number that is not finite: " + textOf(*space_, state.get()));
                if (!hasTurnsWithinBounds(*space_, state.get()))
                    fail("propagate() writes an angle beyond -pi to pi, or a quaternion that is not normalized: " +
                         textOf(*space_, state.get()));
                return state;
            }

            std::vector<Pose> posesAt(double time) const
            {
                std::vector<Pose> poses(robot_.getBodies().size());
                robot_.placeBodies(stateAt(time).get(), poses.data());
                return poses;
            }

            void tryInterval(const std::vector<MotionBound> &bounds, double first, double last) const
            {
                const std::vector<Pose> before = posesAt(first), after = posesAt(last);
                for (std::size_t body = 0; body < before.size(); ++body)
                {
                    // An infinite bound proves nothing, so it is not wrong.
                    if (!std::isfinite(bounds[body].linear) || !std::isfinite(bounds[body].angular))
                        continue;
                    const double radius = robot_.getBodies()[body].getBoundingRadius();
                    std::vector<Eigen::Vector3d> points{Eigen::Vector3d::Zero()};
                    for (int axis = 0; axis < static_cast<int>(robot_.getWorkspaceDimension()); ++axis)
                        for (const double side : {-radius, radius})
                            points.emplace_back(side * Eigen::Vector3d::Unit(axis));
                    const double slack = POINT_ROUNDING * (1.0 + radius + before[body].translation().norm());
                    for (const Eigen::Vector3d &point : points)
                    {
                        const double distance = (after[body] * point - before[body] * point).norm(),
                                     most = bounds[body].at(point.norm()) * (last - first);
                        if (!(distance <= most * (1.0 + STEP_ROUNDING) + slack))
                            fail("between times " + textOf(first) + " and " + textOf(last) + ", the point " +
                                 textOf(point) + " of body " + std::to_string(body) + " moves " + textOf(distance) +
                                 ", but its step bound (linear " + textOf(bounds[body].linear) + ", angular " +
                                 textOf(bounds[body].angular) + ") allows " + textOf(most));
                    }
                }
            }

            const DynamicRobot &robot_;
            const ob::StateSpacePtr space_;
            const double longest_;
            ob::StateSamplerPtr sampler_;
            ompl::RNG random_;
            ob::ScopedState<> from_;
            std::vector<double> control_;
            double duration_{0.0};
        };
    }

    void checkDynamicRobot(const DynamicRobot &robot, double longest, unsigned int steps)
    {
        if (!(longest > 0.0) || !std::isfinite(longest))
            throw ompl::Exception(robot.getName(), "the longest step must be positive, not " + textOf(longest) + " s");
        StepTrial trial(robot, longest);
        for (unsigned int i = 0; i < steps; ++i)
            trial.tryStep();
    }
}
