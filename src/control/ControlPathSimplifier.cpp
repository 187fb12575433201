#include "ompl_certificates/control/ControlPathSimplifier.h"

#include "RobotShortcuts.h"

#include <deque>
#include <ompl/base/goals/GoalState.h>
#include <ompl/base/goals/GoalStates.h>
#include <ompl/util/Exception.h>
#include <utility>

namespace ompl_certificates
{
    namespace ob = ompl::base;
    namespace oc = ompl::control;

    namespace
    {
        constexpr const char *NAME = "ControlPathSimplifier";

        /** How often each robot tries to reach its goal, and how often in a row shortcuts may fail for each */
        constexpr unsigned int GOAL_ATTEMPTS = 30, FAILURES = 200;

        /** The goal's state nearest to a state; null if the goal does not consist of states */
        const ob::State *goalNear(const ob::SpaceInformation &si, const ob::Goal *goal, const ob::State *end)
        {
            if (const auto *one = dynamic_cast<const ob::GoalState *>(goal))
                return one->getState();
            const auto *several = dynamic_cast<const ob::GoalStates *>(goal);
            const ob::State *nearest = nullptr;
            for (unsigned int i = 0; several && i < several->getStateCount(); ++i)
                if (!nearest || si.distance(several->getState(i), end) < si.distance(nearest, end))
                    nearest = several->getState(i);
            return nearest;
        }
    }

    ControlPathSimplifier::ControlPathSimplifier(oc::SpaceInformationPtr si, ob::GoalPtr goal)
      : si_(std::move(si)), goal_(std::move(goal))
    {
        if (!si_)
            throw ompl::Exception(NAME, "needs space information");
        RobotTrajectories::requireTeam(*si_, NAME);
    }

    bool ControlPathSimplifier::simplify(oc::PathControl &path, const ob::PlannerTerminationCondition &condition)
    {
        if (path.getControlCount() == 0)
            return false;
        RobotTrajectories trajectories(si_, NAME);
        trajectories.read(path);
        const std::size_t steps = trajectories.getSteps();
        const ob::State *goal = goalNear(*si_, goal_.get(), path.getStates().back());
        std::deque<RobotShortcuts> robots;
        for (unsigned int i = 0; i < si_->getStateSpace()->as<TeamStateSpace>()->getSubspaceCount(); ++i)
            robots.emplace_back(trajectories, i, goal ? goal->as<ob::CompoundState>()->components[i] : nullptr,
                                Shooting::Durations{si_->getMinControlDuration(), si_->getMaxControlDuration()},
                                random_);
        bool isChanged = false;
        for (auto &robot : robots)
            for (unsigned int i = 0; i < GOAL_ATTEMPTS && !robot.isAtGoal() && !condition; ++i)
                isChanged = robot.reachGoal(steps) || isChanged;
        for (unsigned int failures = 0; failures < FAILURES * robots.size() && !condition; ++failures)
        {
            auto &robot = robots[static_cast<std::size_t>(random_.uniformInt(0, static_cast<int>(robots.size()) - 1))];
            const bool isNearer =
                !robot.isAtGoal() && random_.uniformBool() && robot.reachGoal(trajectories.getSteps());
            if (!isNearer && !robot.shorten())
                continue;
            isChanged = true;
            failures = 0;
        }
        if (!isChanged)
            return false;
        const auto changed = trajectories.toPath(path.getState(0));
        // Rounding may add up where all robots' steps are repeated as those of the team.
        if (!changed || !trajectories.endAt(changed->getStates().back(), 2.0 * RobotShortcuts::DRIFT) ||
            (goal_ && goal_->isSatisfied(path.getStates().back()) && !goal_->isSatisfied(changed->getStates().back())))
            return false;
        path = *changed;
        return true;
    }
}
