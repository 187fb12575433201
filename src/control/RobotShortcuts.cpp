#include "RobotShortcuts.h"

#include <algorithm>
#include <cmath>

namespace ompl_certificates
{
    namespace ob = ompl::base;

    namespace
    {
        /** In how many pieces a part's controls are sought: more cost more, fewer turn and stop less */
        constexpr std::size_t PIECES = 12;

        /** How far a trajectory may end from where it should, and how far it moves at rest, as parts of the accuracy of
            shooting: controls after a change are repeated from a state that is so near the old one. */
        constexpr double DRIFT = 100.0, REST = 0.01;
    }

    RobotShortcuts::RobotShortcuts(RobotTrajectories &others, unsigned int robot, const ob::State *goal,
                                   unsigned int least, unsigned int most, ompl::RNG &random)
      : others_(others)
      , robot_(robot)
      , least_(least)
      , most_(most)
      , random_(random)
      , space_(others.getSpace(robot))
      , shooting_(others.getRobot(robot), space_, others.getStepSize())
      , goal_(goal ? others.clone(robot, goal) : nullptr)
      , end_(others.clone(robot, others.getTrajectory(robot).states.back().get()))
      , isAtGoal_(!goal)
    {
    }

    bool RobotShortcuts::reachGoal(std::size_t mostSteps)
    {
        const std::size_t size = others_.getTrajectory(robot_).controls.size();
        const auto begin = static_cast<std::size_t>(random_.uniformInt(0, static_cast<int>(size)));
        // Newton's method finds a way sooner if there is time to spare.
        const std::size_t old = size - begin, spare = mostSteps - size;
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
        const auto length = std::max<std::size_t>(2, static_cast<std::size_t>(part * static_cast<double>(size)));
        const auto begin = static_cast<std::size_t>(random_.uniformInt(0, static_cast<int>(size - length)));
        const double share = random_.uniform01();
        const auto saved = static_cast<std::size_t>(0.7 * share * share * static_cast<double>(length));
        const Part chosen{begin, begin + length, length - std::max<std::size_t>(1, saved)};
        const auto &states = others_.getTrajectory(robot_).states;
        return keep(chosen, chosen.end == size ? end_.get() : states[chosen.end].get(), size - 1);
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
        // As many steps each as may be; what is over goes to the first ones. Controls are those of the old part, at
        // the pace of the new one, or the mean of all: the way is like the old one, or the old one without its turns.
        const std::size_t most = std::max<std::size_t>(1, part.steps / least_);
        const std::size_t fewest = (part.steps + most_ - 1) / most_;
        const std::size_t count = std::min(most, std::max(fewest, PIECES));
        const bool smooth = random_.uniformBool();
        const double pace = static_cast<double>(part.end - part.begin) / static_cast<double>(part.steps);
        std::vector<Shooting::Piece> pieces;
        const std::size_t controls = others_.getRobot(robot_).getControlNames().size();
        std::size_t begin = 0;
        for (std::size_t i = 0; i < count; ++i)
        {
            const std::size_t steps = part.steps / count + (i < part.steps % count ? 1 : 0);
            const auto oldStep = [&](std::size_t step)
            { return part.begin + static_cast<std::size_t>(pace * static_cast<double>(step)); };
            if (part.begin == part.end)
            {
                pieces.push_back({std::vector<double>(controls), static_cast<unsigned int>(steps)});
                others_.getRobot(robot_).computeBrake(trajectory_.states[part.begin].get(), others_.getStepSize(),
                                                      pieces.back().control.data());
                continue;
            }
            const std::size_t from = smooth ? part.begin : oldStep(begin);
            const std::size_t to = smooth ? part.end : std::max(from + 1, std::min(part.end, oldStep(begin + steps)));
            std::vector<double> mean(controls, 0.0);
            for (std::size_t step = from; step < to; ++step)
                for (std::size_t c = 0; c < mean.size(); ++c)
                    mean[c] += trajectory_.controls[step][c] / static_cast<double>(to - from);
            pieces.push_back({std::move(mean), static_cast<unsigned int>(steps)});
            begin += steps;
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
        if (!stay(changed) || space_.distance(changed.states.back().get(), end) > DRIFT * shooting_.getAccuracy())
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
                REST * shooting_.getAccuracy())
                moving = trajectory.controls.size();
        }
        trajectory.states.resize(moving + 1);
        trajectory.controls.resize(moving);
        return true;
    }
}
