#include "TimedPaths.h"

#include "team/OwnedState.h"

#include "ompl_certificates/team/PathTimes.h"
#include "ompl_certificates/team/Rotations.h"

#include <algorithm>

namespace ompl_certificates
{
    namespace ob = ompl::base;

    namespace
    {
        /** OMPL calls orientations equal that nearly are: a motion between two such is a motion. */
        bool areSame(const ob::StateSpace &space, const ob::State *a, const ob::State *b)
        {
            std::vector<double> first, second;
            space.copyToReals(first, a);
            space.copyToReals(second, b);
            return first.empty() ? space.equalStates(a, b) : first == second;
        }
    }

    TimedPaths::TimedPaths(const Team &team, const ompl::geometric::PathGeometric &path)
      : team_(team), knots_(team.getRobotCount())
    {
        for (unsigned int i = 0; i < path.getStateCount(); ++i)
        {
            const ob::State *whole = path.getState(i);
            const double step = i > 0 ? motionTime(*team.getStateSpace(), path.getState(i - 1), whole) : 0.0;
            if (i > 0 && !(step > 0.0))
            {
                hasLeftOut_ = true;
                continue;
            }
            duration_ += step;
            for (unsigned int robot = 0; robot < team.getRobotCount(); ++robot)
            {
                auto &knots = knots_[robot];
                const ob::State *state = team.getRobotState(whole, robot);
                const auto isHere = [&](const Knot &knot)
                { return areSame(team.getRobotSpace(robot), knot.state.get(), state); };
                // One that waits needs a knot at either end of the wait.
                if (knots.size() > 1 && isHere(knots.back()) && isHere(knots[knots.size() - 2]))
                    knots.back().time = duration_;
                else
                    knots.push_back({duration_, clone(robot, state)});
            }
        }
    }

    std::shared_ptr<ob::State> TimedPaths::clone(unsigned int robot, const ob::State *state) const
    {
        return cloneState(team_.getRobotSpace(robot), state);
    }

    namespace
    {
        /** The first of some knots that is not before a time */
        template <typename Knots>
        auto firstFrom(const Knots &knots, double time)
        {
            return std::lower_bound(knots.begin(), knots.end(), time,
                                    [](const TimedPaths::Knot &knot, double t) { return knot.time < t; });
        }

        void interpolate(const ob::StateSpace &space, const TimedPaths::Knot &from, const TimedPaths::Knot &to,
                         double time, ob::State *state)
        {
            // One that waits is where it is, without rounding: at its goal it has arrived.
            if (areSame(space, from.state.get(), to.state.get()))
                return space.copyState(state, to.state.get());
            space.interpolate(from.state.get(), to.state.get(), (time - from.time) / (to.time - from.time), state);
            wrapAngles(space, state);
        }
    }

    TimedPaths::Knot TimedPaths::at(unsigned int robot, double time) const
    {
        const auto [previous, next] = around(robot, time);
        if (previous == next)
            return *next;
        Knot knot{time, clone(robot, previous->state.get())};
        interpolate(team_.getRobotSpace(robot), *previous, *next, time, knot.state.get());
        return knot;
    }

    std::pair<const TimedPaths::Knot *, const TimedPaths::Knot *> TimedPaths::around(unsigned int robot,
                                                                                     double time) const
    {
        const auto &knots = knots_[robot];
        const auto next = firstFrom(knots, time);
        if (next == knots.end())
            return {&knots.back(), &knots.back()};
        return {next->time == time || next == knots.begin() ? &*next : &*(next - 1), &*next};
    }

    std::vector<double> TimedPaths::timesWithin(double first, double last) const
    {
        std::vector<double> times;
        for (const auto &knots : knots_)
            for (auto knot = firstFrom(knots, first); knot != knots.end() && knot->time <= last; ++knot)
                times.push_back(knot->time);
        std::sort(times.begin(), times.end());
        times.erase(std::unique(times.begin(), times.end()), times.end());
        return times;
    }

    double TimedPaths::knotBefore(double time) const
    {
        double before = 0.0;
        for (unsigned int robot = 0; robot < knots_.size(); ++robot)
            before = std::max(before, knotBefore(robot, time));
        return before;
    }

    double TimedPaths::knotBefore(unsigned int robot, double time) const
    {
        const auto &knots = knots_[robot];
        const auto next = std::upper_bound(knots.begin(), knots.end(), time,
                                           [](double t, const Knot &knot) { return t < knot.time; });
        return next == knots.begin() ? 0.0 : (next - 1)->time;
    }

    double TimedPaths::knotAfter(double time) const
    {
        double after = duration_;
        for (unsigned int robot = 0; robot < knots_.size(); ++robot)
            after = std::min(after, knotAfter(robot, time));
        return after;
    }

    double TimedPaths::knotAfter(unsigned int robot, double time) const
    {
        const auto next = firstFrom(knots_[robot], time);
        return next == knots_[robot].end() ? duration_ : next->time;
    }

    void TimedPaths::copyTo(double time, ob::State *state) const
    {
        for (unsigned int robot = 0; robot < team_.getRobotCount(); ++robot)
        {
            ob::State *own = const_cast<ob::State *>(team_.getRobotState(state, robot));
            const auto [previous, next] = around(robot, time);
            if (previous == next)
                team_.getRobotSpace(robot).copyState(own, next->state.get());
            else
                interpolate(team_.getRobotSpace(robot), *previous, *next, time, own);
        }
    }
}
