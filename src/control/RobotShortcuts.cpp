#include "RobotShortcuts.h"

#include <algorithm>
#include <cmath>

namespace ompl_certificates
{
    namespace ob = ompl::base;

    namespace
    {
        /** How far a robot moves in a step at rest, as a part of its space's extent */
        constexpr double REST = 1e-9;
    }

    RobotShortcuts::RobotShortcuts(RobotTrajectories &others, unsigned int robot, const ob::State *goal,
                                   const Shooting::Durations &durations, ompl::RNG &random)
      : others_(others)
      , robot_(robot)
      , durations_(durations)
      , random_(random)
      , space_(others.getSpace(robot))
      , shooting_(others.getRobot(robot), space_, others.getStepSize())
      , goal_(goal ? others.clone(robot, goal) : nullptr)
      , end_(others.clone(robot, others.getTrajectory(robot).states.back().get()))
      , isAtGoal_(!goal || space_.distance(end_.get(), goal) <= shooting_.getAccuracy())
    {
    }

    bool RobotShortcuts::reachGoal(std::size_t mostSteps)
    {
        const std::size_t size = others_.getTrajectory(robot_).controls.size();
        const double part = random_.uniform01();
        const auto longest = static_cast<double>(std::min(size, longestPart()));
        const std::size_t begin = changeBefore(size - static_cast<std::size_t>(part * part * longest));
        // Newton's method finds a way sooner if there is time to spare.
        const std::size_t old = size - begin, spare = std::min(mostSteps - size, longestPart());
        const auto steps = old + static_cast<std::size_t>(random_.uniformInt(0, static_cast<int>(spare)));
        if (!keep({begin, size, steps}, goal_.get(), mostSteps))
            return false;
        end_ = goal_;
        isAtGoal_ = true;
        return true;
    }

    bool RobotShortcuts::shorten()
    {
        // Often much, and often one step alone: long detours come first, and the last steps are found one by one.
        const std::size_t size = others_.getTrajectory(robot_).controls.size();
        if (size < 2)
            return false;
        const double part = random_.uniform01();
        const std::size_t longest = std::min(size, longestPart());
        const auto length = std::max<std::size_t>(2, static_cast<std::size_t>(part * static_cast<double>(longest)));
        const auto first = static_cast<std::size_t>(random_.uniformInt(0, static_cast<int>(size - length)));
        const std::size_t begin = changeBefore(first), end = changeBefore(first + length), steps = end - begin;
        const double share = random_.uniform01();
        const auto saved = static_cast<std::size_t>(0.7 * share * share * static_cast<double>(steps));
        if (steps < 1 + durations_.least)
            return false;
        const Part chosen{begin, end, std::max<std::size_t>(durations_.least, steps - std::max<std::size_t>(1, saved))};
        const auto &states = others_.getTrajectory(robot_).states;
        return keep(chosen, chosen.end == size ? end_.get() : states[chosen.end].get(), size - 1);
    }

    std::size_t RobotShortcuts::longestPart() const
    {
        // Longer ones need more pieces, for which shooting takes seconds.
        constexpr std::size_t mostPieces = std::size_t(4) * Shooting::PIECES;
        return mostPieces * durations_.most;
    }

    std::size_t RobotShortcuts::changeBefore(std::size_t step) const
    {
        // Elsewhere a control would be cut, and then be held for less than the least duration.
        const auto &controls = others_.getTrajectory(robot_).controls;
        while (durations_.least > 1 && step > 0 && step < controls.size() && controls[step] == controls[step - 1])
            --step;
        return step;
    }

    bool RobotShortcuts::keep(const Part &part, const ob::State *target, std::size_t mostSteps)
    {
        trajectory_ = others_.take(robot_);
        auto changed = replace(part, target);
        const bool isBetter = changed && changed->controls.size() <= mostSteps;
        others_.add(robot_, std::move(isBetter ? *changed : trajectory_));
        return isBetter;
    }

    std::vector<Shooting::Piece> RobotShortcuts::guess(const Part &part)
    {
        std::vector<Shooting::Piece> pieces = Shooting::divide(part.steps, durations_);
        const DynamicRobot &robot = others_.getRobot(robot_);
        const std::size_t controls = robot.getControlNames().size(), old = part.end - part.begin;
        // The old controls at the new pace, or the mean of all: the way is like the old one, or without its turns.
        const bool isMean = random_.uniformBool();
        std::size_t step = 0;
        for (auto &piece : pieces)
        {
            piece.control.assign(controls, 0.0);
            const std::size_t next = step + piece.steps;
            const std::size_t from = isMean ? 0 : old * step / part.steps;
            const std::size_t to = isMean ? old : std::max(from + 1, old * next / part.steps);
            if (old == 0)
                robot.computeBrake(trajectory_.states[part.begin].get(), others_.getStepSize(), piece.control.data());
            else
                for (std::size_t i = from; i < to; ++i)
                    for (std::size_t c = 0; c < controls; ++c)
                        piece.control[c] += trajectory_.controls[part.begin + i][c] / static_cast<double>(to - from);
            step = next;
        }
        return pieces;
    }

    std::optional<RobotShortcuts::Trajectory> RobotShortcuts::replace(const Part &part, const ob::State *target)
    {
        std::vector<Shooting::Piece> pieces;
        if (part.steps > 0)
        {
            pieces = guess(part);
            if (!shooting_.solve(trajectory_.states[part.begin].get(), target, pieces))
                return std::nullopt;
        }
        const auto at = [&](std::size_t step) { return static_cast<std::ptrdiff_t>(step); };
        const auto &old = trajectory_;
        Trajectory changed;
        changed.states.assign(old.states.begin(), old.states.begin() + at(part.begin + 1));
        changed.controls.assign(old.controls.begin(), old.controls.begin() + at(part.begin));
        for (const auto &piece : pieces)
            for (unsigned int step = 0; step < piece.steps; ++step)
                if (!follow(changed, piece.control))
                    return std::nullopt;
        for (std::size_t step = part.end; step < old.controls.size(); ++step)
            if (!follow(changed, old.controls[step]))
                return std::nullopt;
        const ob::State *end = part.end == old.controls.size() ? target : end_.get();
        if (!stay(changed) || space_.distance(changed.states.back().get(), end) > DRIFT * space_.getMaximumExtent())
            return std::nullopt;
        return changed;
    }

    bool RobotShortcuts::follow(Trajectory &trajectory, const RobotTrajectories::Control &control)
    {
        auto next = others_.clone(robot_, trajectory.states.back().get());
        if (!others_.move(robot_, trajectory.states.back().get(), control, trajectory.controls.size(), next.get()))
            return false;
        trajectory.states.push_back(std::move(next));
        trajectory.controls.push_back(control);
        return true;
    }

    bool RobotShortcuts::stay(Trajectory &trajectory)
    {
        RobotTrajectories::Control brake(others_.getRobot(robot_).getControlNames().size());
        std::size_t moving = trajectory.controls.size();
        while (trajectory.controls.size() < others_.getSteps())
        {
            const std::size_t last = trajectory.states.size() - 1;
            others_.getRobot(robot_).computeBrake(trajectory.states[last].get(), others_.getStepSize(), brake.data());
            if (!follow(trajectory, brake))
                return false;
            if (space_.distance(trajectory.states[last].get(), trajectory.states[last + 1].get()) >
                REST * space_.getMaximumExtent())
                moving = trajectory.controls.size();
        }
        trajectory.states.resize(moving + 1);
        trajectory.controls.resize(moving);
        return true;
    }
}
