#include "RobotTree.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ompl_certificates
{
    namespace ob = ompl::base;

    namespace
    {
        /** How many controls are tried from a node */
        constexpr unsigned int CONTROLS = 6;

        /** How often a new node is tried as the start of a shot to the goal; after a step towards the goal always */
        constexpr double SHOTS = 0.1;

        /** A robot brakes from no farther than so many times the tolerance, and for no longer than so many seconds */
        constexpr double BRAKING_DISTANCE = 2.0, BRAKING_SECONDS = 10.0;

        /** A robot rests where a step moves it by no more than rounding, as a part of the tolerance or of its space. */
        constexpr double LEAST_MOTION = 1e-9;

        constexpr std::uint32_t TARGET_NODE = std::numeric_limits<std::uint32_t>::max();
    }

    RobotTree::RobotTree(RobotTrajectories &others, const Task &task, const Shooting::Durations &durations,
                         ompl::RNG &random)
      : others_(others)
      , task_(task)
      , durations_(durations)
      , random_(random)
      , space_(others.getSpace(task.robot))
      , robot_(others.getRobot(task.robot))
      , sampler_(space_.allocStateSampler())
      , shooting_(robot_, space_, others.getStepSize())
      , before_(others.clone(task.robot, task.start))
      , after_(others.clone(task.robot, task.start))
      , nearest_(others.clone(task.robot, task.start))
      , target_(others.clone(task.robot, task.start))
    {
        near_.setDistanceFunction(
            [this](Number a, Number b)
            {
                const auto stateOf = [this](Number i)
                { return i == TARGET_NODE ? target_.get() : nodes_[i].state.get(); };
                return space_.distance(stateOf(a), stateOf(b));
            });
        nodes_.push_back({others.clone(task.robot, task.start), 0, {}, 0, 0});
        near_.add(0);
    }

    std::optional<RobotTree::Trajectory> RobotTree::search(std::uint64_t iterations, double goalBias,
                                                           const ob::PlannerTerminationCondition &condition)
    {
        const auto isNearGoal = [this]
        { return space_.distance(nodes_.back().state.get(), task_.goal) <= BRAKING_DISTANCE * task_.tolerance; };
        bool isNew = true, toGoal = true;
        for (; !condition; --iterations)
        {
            if (isNew && isNearGoal())
                if (auto trajectory = rest(condition))
                    return trajectory;
            if (isNew && (toGoal || random_.uniform01() < SHOTS) && shoot())
                if (auto trajectory = rest(condition))
                    return trajectory;
            if (iterations == 0)
                break;
            toGoal = random_.uniform01() < goalBias;
            if (toGoal)
                space_.copyState(target_.get(), task_.goal);
            else
                sampler_->sampleUniform(target_.get());
            isNew = extend();
        }
        return std::nullopt;
    }

    bool RobotTree::extend()
    {
        const Number parent = near_.nearest(TARGET_NODE);
        const std::size_t begin = nodes_[parent].step;
        const ob::RealVectorBounds &bounds = robot_.getControlBounds();
        Node best{nearest_, parent, {}, 0, 0};
        double least = std::numeric_limits<double>::infinity();
        RobotTrajectories::Control control(bounds.low.size());
        for (unsigned int i = 0; i < CONTROLS; ++i)
        {
            for (std::size_t k = 0; k < control.size(); ++k)
                control[k] = random_.uniformReal(bounds.low[k], bounds.high[k]);
            const auto most = static_cast<unsigned int>(
                random_.uniformInt(static_cast<int>(durations_.least), static_cast<int>(durations_.most)));
            space_.copyState(before_.get(), nodes_[parent].state.get());
            for (unsigned int steps = 1; steps <= most; ++steps)
            {
                if (!others_.move(task_.robot, before_.get(), control, begin + steps - 1, after_.get()))
                    break;
                std::swap(before_, after_);
                const double distance = space_.distance(before_.get(), target_.get());
                if (steps < durations_.least || distance >= least)
                    continue;
                least = distance;
                space_.copyState(nearest_.get(), before_.get());
                best.control = control;
                best.steps = steps;
            }
        }
        if (best.steps == 0)
            return false;
        best.state = others_.clone(task_.robot, nearest_.get());
        best.step = begin + best.steps;
        nodes_.push_back(std::move(best));
        near_.add(static_cast<Number>(nodes_.size() - 1));
        return true;
    }

    bool RobotTree::shoot()
    {
        // From one control to as many as a way is divided into, short ways as often as long ones.
        const double most = Shooting::PIECES * durations_.most, least = durations_.least;
        auto pieces =
            Shooting::divide(static_cast<std::size_t>(least * std::pow(most / least, random_.uniform01())), durations_);
        RobotTrajectories::Control control;
        const ob::RealVectorBounds &bounds = robot_.getControlBounds();
        for (std::size_t k = 0; k < bounds.low.size(); ++k)
            control.push_back(random_.uniformReal(bounds.low[k], bounds.high[k]));
        for (auto &piece : pieces)
            piece.control = control;
        if (!shooting_.solve(nodes_.back().state.get(), task_.goal, pieces))
            return false;
        const std::size_t size = nodes_.size();
        space_.copyState(before_.get(), nodes_.back().state.get());
        for (const auto &piece : pieces)
        {
            std::size_t step = nodes_.back().step;
            for (unsigned int i = 0; i < piece.steps; ++i, ++step)
            {
                if (!others_.move(task_.robot, before_.get(), piece.control, step, after_.get()))
                {
                    nodes_.resize(size);
                    return false;
                }
                std::swap(before_, after_);
            }
            nodes_.push_back({others_.clone(task_.robot, before_.get()), static_cast<Number>(nodes_.size() - 1),
                              piece.control, piece.steps, step});
        }
        for (std::size_t i = size; i < nodes_.size(); ++i)
            near_.add(static_cast<Number>(i));
        return true;
    }

    std::optional<RobotTree::Trajectory> RobotTree::rest(const ob::PlannerTerminationCondition &condition)
    {
        const Node &last = nodes_.back();
        space_.copyState(before_.get(), last.state.get());
        Trajectory end;
        const double leastMotion = LEAST_MOTION * std::min(task_.tolerance, space_.getMaximumExtent());
        bool rests = false;
        // Once at rest, until the others are, too. From then on nothing changes.
        for (unsigned int steps = 0; !rests || last.step + steps < others_.getSteps(); ++steps)
        {
            if (condition || (!rests && steps * others_.getStepSize() > BRAKING_SECONDS))
                return std::nullopt;
            RobotTrajectories::Control control(robot_.getControlNames().size());
            robot_.computeBrake(before_.get(), others_.getStepSize(), control.data());
            if (!others_.move(task_.robot, before_.get(), control, last.step + steps, after_.get()))
                return std::nullopt;
            rests = rests || space_.distance(before_.get(), after_.get()) <= leastMotion;
            end.states.push_back(others_.clone(task_.robot, after_.get()));
            end.controls.push_back(std::move(control));
            std::swap(before_, after_);
        }
        if (space_.distance(before_.get(), task_.goal) > task_.tolerance)
            return std::nullopt;
        Trajectory all = trajectoryTo(static_cast<Number>(nodes_.size() - 1));
        all.states.insert(all.states.end(), end.states.begin(), end.states.end());
        all.controls.insert(all.controls.end(), end.controls.begin(), end.controls.end());
        return all;
    }

    RobotTree::Trajectory RobotTree::trajectoryTo(Number node) const
    {
        std::vector<Number> way;
        for (Number i = node; i != 0; i = nodes_[i].parent)
            way.push_back(i);
        Trajectory trajectory;
        trajectory.states.push_back(nodes_.front().state);
        for (auto next = way.rbegin(); next != way.rend(); ++next)
            for (unsigned int step = 0; step < nodes_[*next].steps; ++step)
            {
                auto state = others_.clone(task_.robot, trajectory.states.back().get());
                robot_.propagate(state.get(), nodes_[*next].control.data(), others_.getStepSize(), state.get());
                trajectory.states.push_back(std::move(state));
                trajectory.controls.push_back(nodes_[*next].control);
            }
        return trajectory;
    }
}
