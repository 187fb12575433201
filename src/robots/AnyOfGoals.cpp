#include "ompl_certificates/robots/AnyOfGoals.h"

#include "SpaceBounds.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <ompl/util/Exception.h>
#include <utility>

namespace ompl_certificates
{
    namespace ob = ompl::base;

    AnyOfGoals::AnyOfGoals(const RobotPtr &robot, const std::vector<std::vector<double>> &states,
                           std::vector<RobotGoalPtr> goals)
      : goals_(std::move(goals))
    {
        if (!robot)
            throw ompl::Exception("AnyOfGoals", "the robot must not be null");
        const std::string owner = robot->getName() + ": goal";
        if (states.empty() && goals_.empty())
            throw ompl::Exception(owner, "there must be one goal at least");
        if (std::find(goals_.begin(), goals_.end(), nullptr) != goals_.end())
            throw ompl::Exception(owner, "no goal may be null");
        ob::ScopedState<> state(robot->getStateSpace());
        const std::size_t count = state.reals().size();
        for (std::size_t i = 0; i < states.size(); ++i)
        {
            const std::string title = "state " + std::to_string(i);
            if (states[i].size() != count)
                throw ompl::Exception(owner, title + " must have " + std::to_string(count) + " coordinates, not " +
                                                 std::to_string(states[i].size()));
            if (!std::all_of(states[i].begin(), states[i].end(), [](double number) { return std::isfinite(number); }))
                throw ompl::Exception(owner, title + " must be finite");
            state = states[i];
            if (!state.satisfiesBounds())
                throw ompl::Exception(owner, title + " is outside the bounds");
            states_.push_back(state);
        }
    }

    double AnyOfGoals::distance(const ob::State *state) const
    {
        double nearest = std::numeric_limits<double>::infinity();
        for (const ob::ScopedState<> &other : states_)
            nearest = std::min(nearest, other.getSpace()->distance(state, other.get()));
        for (const RobotGoalPtr &goal : goals_)
            nearest = std::min(nearest, goal->distance(state));
        return nearest;
    }

    bool AnyOfGoals::sample(ompl::RNG &random, ob::State *state) const
    {
        const auto count = static_cast<int>(states_.size() + goals_.size());
        const int first = random.uniformInt(0, count - 1);
        for (int i = 0; i < count; ++i)
        {
            const auto which = static_cast<std::size_t>((first + i) % count);
            if (which < states_.size())
            {
                states_[which].getSpace()->copyState(state, states_[which].get());
                return true;
            }
            if (goals_[which - states_.size()]->sample(random, state))
                return true;
        }
        return false;
    }

    bool AnyOfGoals::isFor(const Robot &robot) const
    {
        return std::all_of(states_.begin(), states_.end(),
                           [&](const ob::ScopedState<> &state)
                           { return areAlike(*state.getSpace(), *robot.getStateSpace()); }) &&
               std::all_of(goals_.begin(), goals_.end(), [&](const RobotGoalPtr &goal) { return goal->isFor(robot); });
    }

    std::string AnyOfGoals::describe() const
    {
        return "any of its " + std::to_string(states_.size() + goals_.size()) + " goals";
    }
}
