#include "ompl_certificates/team/TimedPath.h"

#include "geometry/ShortestText.h"
#include "ompl_certificates/team/PathTimes.h"
#include "ompl_certificates/team/Rotations.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <ompl/base/SpaceInformation.h>
#include <ompl/util/Exception.h>
#include <string>
#include <utility>

namespace ompl_certificates
{
    TimedPath::TimedPath(const ompl::geometric::PathGeometric &path) : TimedPath(path, stateTimes(path))
    {
    }

    TimedPath::TimedPath(const ompl::geometric::PathGeometric &path, std::vector<double> times)
      : path_(path), times_(std::move(times))
    {
        if (path.getStateCount() == 0)
            throw ompl::Exception("A path without states is nowhere at any time");
        if (times_.size() != path.getStateCount())
            throw ompl::Exception("A path of " + std::to_string(path.getStateCount()) + " states has " +
                                  std::to_string(times_.size()) + " times");
        const auto isAfter = [](double time, double next) { return !(time <= next); };
        if (std::adjacent_find(times_.begin(), times_.end(), isAfter) != times_.end())
            throw ompl::Exception("The times of a path's states must not decrease");
    }

    void TimedPath::computeState(double time, ompl::base::State *state) const
    {
        const ompl::base::StateSpace &space = *path_.getSpaceInformation()->getStateSpace();
        const auto next = std::upper_bound(times_.begin(), times_.end(), time);
        const auto i = static_cast<unsigned int>(next - times_.begin());
        if (next == times_.begin() || next == times_.end() || time == times_[i - 1])
            return space.copyState(state, path_.getState(i == 0 ? 0 : i - 1));
        space.interpolate(path_.getState(i - 1), path_.getState(i),
                          (time - times_[i - 1]) / (times_[i] - times_[i - 1]), state);
        wrapAngles(space, state);
    }

    std::vector<double> TimedPath::listTimes(double step) const
    {
        if (!(step > 0.0) || !std::isfinite(step))
            throw ompl::Exception("The step of a path's times must be positive, not " + shortestText(step));
        const double first = times_.front(), count = (times_.back() - first) / step;
        if (!(count + static_cast<double>(times_.size()) <= static_cast<double>(MOST_TIMES)))
            throw ompl::Exception("Steps of " + shortestText(step) + " on a path that takes " +
                                  shortestText(times_.back() - first) + " are more than " + std::to_string(MOST_TIMES));
        // What rounding alone sets apart: of the step, and of times that may be large.
        const double rounding = 1e-9 * step + 4.0 * std::numeric_limits<double>::epsilon() *
                                                  std::max(std::abs(first), times_.back() - first);
        const auto tickAt = [&](std::size_t tick) { return static_cast<double>(tick) * step; };
        std::vector<double> all;
        std::size_t tick = 1;
        for (const double time : times_)
        {
            for (; tickAt(tick) < time - first - rounding; ++tick)
                all.push_back(first + withoutRounding(tickAt(tick)));
            if (tickAt(tick) <= time - first + rounding)
                ++tick;
            all.push_back(time);
        }
        return all;
    }
}
