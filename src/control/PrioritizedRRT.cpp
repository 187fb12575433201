#include "ompl_certificates/control/PrioritizedRRT.h"

#include "RobotTree.h"
#include "team/OwnedState.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <ompl/base/goals/GoalSampleableRegion.h>
#include <ompl/control/PathControl.h>
#include <ompl/control/PlannerData.h>
#include <ompl/util/Exception.h>

namespace ompl_certificates
{
    namespace ob = ompl::base;
    namespace oc = ompl::control;

    namespace
    {
        const ob::State *partOf(const ob::State *state, unsigned int robot)
        {
            return state->as<ob::CompoundState>()->components[robot];
        }
    }

    PrioritizedRRT::PrioritizedRRT(const oc::SpaceInformationPtr &si)
      : Planner(si, "PrioritizedRRT"), controlSpaceInformation_(si.get())
    {
        specs_.recognizedGoal = ob::GOAL_SAMPLEABLE_REGION;
        Planner::declareParam<double>("goal_bias", this, &PrioritizedRRT::setGoalBias, &PrioritizedRRT::getGoalBias,
                                      "0.:.05:1.");
        Planner::declareParam<unsigned int>("iterations", this, &PrioritizedRRT::setIterations,
                                            &PrioritizedRRT::getIterations, "100:100:1000000");
    }

    void PrioritizedRRT::setup()
    {
        Planner::setup();
        RobotTrajectories::requireTeam(*controlSpaceInformation_, getName());
    }

    void PrioritizedRRT::clear()
    {
        Planner::clear();
        path_.reset();
        stuckRobot_.clear();
    }

    void PrioritizedRRT::setGoalBias(double bias)
    {
        if (!(bias >= 0.0 && bias <= 1.0))
            throw ompl::Exception(getName(), "goal_bias must be from 0 to 1, not " + std::to_string(bias));
        goalBias_ = bias;
    }

    void PrioritizedRRT::setIterations(unsigned int iterations)
    {
        if (iterations == 0)
            throw ompl::Exception(getName(), "iterations must be positive, not 0");
        iterations_ = iterations;
    }

    ob::PlannerStatus PrioritizedRRT::solve(const ob::PlannerTerminationCondition &condition)
    {
        checkValidity();
        pis_.restart();
        stuckRobot_.clear();
        const auto *region = dynamic_cast<const ob::GoalSampleableRegion *>(pdef_->getGoal().get());
        if (!region)
            return ob::PlannerStatus::UNRECOGNIZED_GOAL_TYPE;
        const ob::State *start = pis_.nextStart();
        if (!start)
            return ob::PlannerStatus::INVALID_START;
        const ob::State *first = pis_.nextGoal(condition);
        if (!first)
            return ob::PlannerStatus::INVALID_GOAL;
        // A copy: the next goal overwrites it, also one that is refused.
        const OwnedState goal = cloneState(*si_->getStateSpace(), first);

        const auto &team = *si_->getStateSpace()->as<TeamStateSpace>();
        const unsigned int robots = team.getSubspaceCount();
        // If all robots use up their shares, the team uses up its threshold.
        const double share = team.getMetric() == TeamStateSpace::EUCLIDEAN ? std::sqrt(robots) : robots;
        const Shooting::Durations durations{controlSpaceInformation_->getMinControlDuration(),
                                            controlSpaceInformation_->getMaxControlDuration()};
        RobotTrajectories trajectories(std::static_pointer_cast<oc::SpaceInformation>(si_), getName());
        std::vector<unsigned int> order(robots);
        std::iota(order.begin(), order.end(), 0U);
        for (unsigned int attempt = 0; !condition; ++attempt)
        {
            trajectories.clear();
            if (const ob::State *next = attempt > 0 && pis_.haveMoreGoalStates() ? pis_.nextGoal() : nullptr)
                si_->copyState(goal.get(), next);
            const auto plan = [&](unsigned int robot)
            {
                const double tolerance = region->getThreshold() / share / team.getSubspaceWeight(robot);
                RobotTree tree(trajectories, {robot, partOf(start, robot), partOf(goal.get(), robot), tolerance},
                               durations, random_);
                auto trajectory =
                    tree.search(iterations_ * (1 + std::uint64_t(attempt / robots)), goalBias_, condition);
                if (!trajectory)
                    return false;
                trajectories.add(robot, std::move(*trajectory));
                return true;
            };
            const auto failed = std::find_if_not(order.begin(), order.end(), plan);
            if (failed != order.end())
            {
                if (!condition)
                    stuckRobot_ = team.getRobots()[*failed]->getName();
                std::rotate(order.begin(), failed, failed + 1);
                continue;
            }
            const auto path = trajectories.toPath(start);
            if (!path || !region->isSatisfied(path->getStates().back()))
            {
                random_.shuffle(order.begin(), order.end());
                continue;
            }
            path_ = path;
            stuckRobot_.clear();
            ob::PlannerSolution solution(std::make_shared<oc::PathControl>(*path));
            solution.setPlannerName(getName());
            pdef_->addSolutionPath(solution);
            return ob::PlannerStatus::EXACT_SOLUTION;
        }
        return ob::PlannerStatus::TIMEOUT;
    }

    void PrioritizedRRT::getPlannerData(ob::PlannerData &data) const
    {
        Planner::getPlannerData(data);
        if (!path_)
            return;
        auto &path = *path_->as<oc::PathControl>();
        const auto &states = path.getStates();
        data.addStartVertex(ob::PlannerDataVertex(states.front()));
        data.addGoalVertex(ob::PlannerDataVertex(states.back()));
        for (unsigned int i = 1; i < states.size(); ++i)
        {
            const ob::PlannerDataVertex from(states[i - 1]), to(states[i]);
            if (data.hasControls())
                data.addEdge(from, to,
                             oc::PlannerDataEdgeControl(path.getControl(i - 1), path.getControlDuration(i - 1)));
            else
                data.addEdge(from, to);
        }
    }
}
