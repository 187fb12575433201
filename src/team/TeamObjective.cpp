#include "ompl_certificates/team/TeamObjective.h"

#include "ompl_certificates/files/Suggestion.h"
#include "ompl_certificates/team/PathTimes.h"
#include "ompl_certificates/team/TeamPathLength.h"

#include <algorithm>
#include <limits>
#include <ompl/base/goals/GoalState.h>
#include <ompl/base/goals/GoalStates.h>
#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/base/spaces/SE3StateSpace.h>
#include <ompl/util/Exception.h>
#include <typeinfo>

namespace ompl_certificates
{
    namespace ob = ompl::base;

    namespace
    {
        const ob::State *componentOf(const ob::State *state, unsigned int robot)
        {
            return state->as<ob::CompoundState>()->components[robot];
        }

        const ob::CompoundStateSpace &compoundSpaceOf(const ob::SpaceInformation &si)
        {
            const auto *space = dynamic_cast<const ob::CompoundStateSpace *>(si.getStateSpace().get());
            // One robot's position and rotation are no robots.
            if (!space || dynamic_cast<const ob::SE2StateSpace *>(space) ||
                dynamic_cast<const ob::SE3StateSpace *>(space))
                throw ompl::Exception(si.getStateSpace()->getName(),
                                      "is not a CompoundStateSpace of robots: there are no robots to look at");
            return *space;
        }
    }

    TeamObjective::TeamObjective(const ob::SpaceInformationPtr &si, Kind kind)
      : TeamObjective(si, kind, std::vector<ob::ScopedState<>>())
    {
        if (kind == SUM_OF_ARRIVAL_TIMES)
            throw ompl::Exception("The sum of arrival times needs the goal");
    }

    TeamObjective::TeamObjective(const ob::SpaceInformationPtr &si, Kind kind, const ob::ScopedState<> &goal)
      : TeamObjective(si, kind, std::vector<ob::ScopedState<>>{goal})
    {
    }

    TeamObjective::TeamObjective(const ob::SpaceInformationPtr &si, Kind kind, std::vector<ob::ScopedState<>> goal)
      : OptimizationObjective(si), kind_(kind), goal_(std::move(goal))
    {
        for (const ob::StateSpacePtr &space : compoundSpaceOf(*si).getSubspaces())
        {
            speeds_.push_back(speedOf(*si->getStateSpace(), static_cast<unsigned int>(spaces_.size())));
            spaces_.push_back(space.get());
        }
        description_ = kind == MAKESPAN         ? "Makespan"
                       : kind == SUM_OF_LENGTHS ? "Sum of lengths"
                                                : "Sum of arrival times";
        setCostToGoHeuristic([this](const ob::State *state, const ob::Goal *target)
                             { return costToGoal(state, target); });
    }

    ob::Cost TeamObjective::costToGoal(const ob::State *state, const ob::Goal *goal) const
    {
        // Not where a detour may be shorter than the way, nor goals that are wider than their states
        const bool isBounded = std::all_of(spaces_.begin(), spaces_.end(),
                                           [](const ob::StateSpace *space) { return space->isMetricSpace(); });
        const auto *region = dynamic_cast<const ob::GoalRegion *>(goal);
        if (!isBounded || !region || region->getThreshold() > std::numeric_limits<double>::epsilon())
            return identityCost();
        if (typeid(*goal) == typeid(ob::GoalState))
            return motionCostHeuristic(state, static_cast<const ob::GoalState &>(*goal).getState());
        // Not goals that grow as they are sampled
        if (typeid(*goal) != typeid(ob::GoalStates))
            return identityCost();
        const auto &states = static_cast<const ob::GoalStates &>(*goal);
        ob::Cost least = infiniteCost();
        for (std::size_t i = 0; i < states.getStateCount(); ++i)
            least = betterCost(least, motionCostHeuristic(state, states.getState(static_cast<unsigned int>(i))));
        return states.hasStates() ? least : identityCost();
    }

    double TeamObjective::distance(unsigned int robot, const ob::State *from, const ob::State *to) const
    {
        return spaces_[robot]->distance(componentOf(from, robot), componentOf(to, robot));
    }

    double TeamObjective::time(unsigned int robot, const ob::State *from, const ob::State *to) const
    {
        return distance(robot, from, to) / speeds_[robot];
    }

    bool TeamObjective::hasArrived(unsigned int robot, const ob::State *state) const
    {
        return spaces_[robot]->equalStates(componentOf(state, robot), componentOf(goal_.front().get(), robot));
    }

    ob::Cost TeamObjective::stateCost(const ob::State * /*state*/) const
    {
        return identityCost();
    }

    ob::Cost TeamObjective::motionCost(const ob::State *from, const ob::State *to) const
    {
        double lengths = 0.0, longest = 0.0;
        unsigned int away = 0;
        for (unsigned int robot = 0; robot < spaces_.size(); ++robot)
        {
            if (kind_ == SUM_OF_LENGTHS)
                lengths += distance(robot, from, to);
            else
                longest = std::max(longest, time(robot, from, to));
            if (kind_ == SUM_OF_ARRIVAL_TIMES && !(hasArrived(robot, from) && hasArrived(robot, to)))
                ++away;
        }
        return ob::Cost(kind_ == SUM_OF_LENGTHS ? lengths : kind_ == MAKESPAN ? longest : away * longest);
    }

    ob::Cost TeamObjective::motionCostHeuristic(const ob::State *from, const ob::State *to) const
    {
        if (kind_ != SUM_OF_ARRIVAL_TIMES)
            return motionCost(from, to);
        // Who moves is on its way.
        double sum = 0.0;
        for (unsigned int robot = 0; robot < spaces_.size(); ++robot)
            sum += time(robot, from, to);
        return ob::Cost(sum);
    }

    std::vector<std::string> objectiveNames()
    {
        return {"length", "sum", "makespan", "arrival"};
    }

    ob::OptimizationObjectivePtr makeObjective(const std::string &name, const ob::SpaceInformationPtr &si,
                                               const ob::ScopedState<> &goal)
    {
        if (name == "length")
            return std::make_shared<TeamPathLength>(si);
        if (name == "sum")
            return std::make_shared<TeamObjective>(si, TeamObjective::SUM_OF_LENGTHS, goal);
        if (name == "makespan")
            return std::make_shared<TeamObjective>(si, TeamObjective::MAKESPAN, goal);
        if (name == "arrival")
            return std::make_shared<TeamObjective>(si, TeamObjective::SUM_OF_ARRIVAL_TIMES, goal);
        throw ompl::Exception("There is no objective '" + name + "'; the objectives are " + joined(objectiveNames()) +
                              didYouMean(name, objectiveNames()));
    }
}
