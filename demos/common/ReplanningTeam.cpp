#include "common/ReplanningTeam.h"

#include "common/Interrupt.h"
#include "common/Limit.h"

#include "ompl_certificates/planning/TeamPathSimplifier.h"
#include "ompl_certificates/team/PathTimes.h"
#include "ompl_certificates/validity/Revalidation.h"

#include <algorithm>
#include <chrono>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/util/RandomNumbers.h>

using namespace ompl_certificates;

namespace demos
{
    namespace ob = ompl::base;
    namespace og = ompl::geometric;

    namespace
    {
        /** So many changes of a path are tried to shorten it: some ten milliseconds' worth. */
        constexpr std::uint64_t ATTEMPTS_TO_SHORTEN = 200;

        /** The time that \e work takes, in seconds */
        template <typename Work>
        double timeOf(const Work &work)
        {
            const auto start = std::chrono::steady_clock::now();
            work();
            return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        }
    }

    ReplanningTeam::ReplanningTeam(Way way, const TeamStateSpacePtr &team, const ObstaclesPtr &obstacles,
                                   const ob::ScopedState<> &start, const ob::ScopedState<> &goal,
                                   const Settings &settings)
      : way_(way), team_(team), settings_(settings), path_{start}, goal_(goal), nextGoal_(start)
    {
        makeSetup(obstacles);
    }

    void ReplanningTeam::makeSetup(const ObstaclesPtr &obstacles)
    {
        setup_ = std::make_shared<TeamSetup>(team_, obstacles,
                                             way_ == STANDARD ? Method::STANDARD : Method::SHARED_PROJECTION);
        setup_->getTeamChecker()->setAdaptive(settings_.adaptive);
        setup_->getSpaceInformation()->setup();
    }

    void ReplanningTeam::takeChange(const ObstacleChange &change)
    {
        if (way_ == FRESH)
            makeSetup(change.after);
        else
            setup_->getTeamChecker()->changeObstacles(change);
    }

    std::vector<std::size_t> ReplanningTeam::findInvalid() const
    {
        const ob::SpaceInformation &si = *setup_->getSpaceInformation();
        std::vector<std::size_t> invalid;
        bool isValid = si.isValid(path_.front().get());
        for (std::size_t i = 0; i + 1 < path_.size(); ++i)
        {
            const bool isNextValid = si.isValid(path_[i + 1].get());
            if (!isValid || !isNextValid || !si.checkMotion(path_[i].get(), path_[i + 1].get()))
                invalid.push_back(i);
            isValid = isNextValid;
        }
        return invalid;
    }

    void ReplanningTeam::askForPath(const ObstacleChange &change, Frame &frame) const
    {
        if (way_ != KEPT)
        {
            frame.invalid = findInvalid();
            return;
        }
        const Revalidation revalidation(*setup_->getTeamChecker(), change);
        og::PathGeometric path(setup_->getSpaceInformation());
        for (const ob::ScopedState<> &state : path_)
            path.append(state.get());
        frame.invalid = revalidation.findInvalidEdges(path);
        if (revalidation.getChecker())
            frame.asked += revalidation.getChecker()->getStatistics().getCounts().asked;
    }

    bool ReplanningTeam::hasPath() const
    {
        return path_.size() > 1;
    }

    ReplanningTeam::Frame ReplanningTeam::meet(const ObstacleChange &change, std::uint64_t seed)
    {
        Frame frame;
        frame.changeSeconds = timeOf([&] { takeChange(change); });
        Statistics &statistics = setup_->getStatistics();
        statistics.reset();
        if (hasPath())
            frame.pathSeconds = timeOf([&] { askForPath(change, frame); });
        if (!frame.invalid.empty() || !hasPath())
        {
            const double before = statistics.getCheckingSeconds();
            frame.planSeconds = timeOf([&] { plan(seed, frame); });
            frame.planCheckingSeconds = statistics.getCheckingSeconds() - before;
        }
        frame.asked += statistics.getCounts().asked;
        frame.hasPath = hasPath();
        return frame;
    }

    void ReplanningTeam::plan(std::uint64_t seed, Frame &frame)
    {
        frame.planned = true;
        path_.erase(path_.begin() + 1, path_.end());
        const ob::SpaceInformationPtr &si = setup_->getSpaceInformation();
        setup_->clear();
        setup_->setStartAndGoalStates(path_.front(), goal_);
        // A planner of its own for each plan, and the random numbers of nothing else: equal seeds make equal plans.
        ompl::RNG::setSeed(seed);
        const auto planner = std::make_shared<og::RRTConnect>(si);
        planner->setRange(settings_.range);
        setup_->setPlanner(planner);
        Limit limit(0.0, settings_.iterations);
        if (setup_->solve(limit.condition()) != ob::PlannerStatus::EXACT_SOLUTION)
            return;
        og::PathGeometric path = setup_->getSolutionPath();
        TeamPathSimplifier(si, setup_->getOptimizationObjective())
            .simplify(path, ATTEMPTS_TO_SHORTEN, ob::PlannerTerminationCondition(interrupted));
        // Steps are tested, too: their samples are those of the path only to within rounding.
        if (!follow(path))
            follow(setup_->getSolutionPath());
    }

    bool ReplanningTeam::follow(const og::PathGeometric &path)
    {
        const std::vector<double> times = stateTimes(path);
        for (unsigned int i = 0; i + 1 < path.getStateCount(); ++i)
        {
            // Each step ends at a sample of the whole motion, so that its own samples are states that were checked.
            const unsigned int samples = std::max(1U, team_->validSegmentCount(path.getState(i), path.getState(i + 1)));
            const double perSample = (times[i + 1] - times[i]) / samples;
            const auto stride = static_cast<unsigned int>(std::clamp(settings_.step / perSample, 1.0, 1.0 * samples));
            for (unsigned int sample = stride; sample < samples; sample += stride)
            {
                path_.emplace_back(team_);
                team_->interpolate(path.getState(i), path.getState(i + 1), static_cast<double>(sample) / samples,
                                   path_.back().get());
            }
            path_.emplace_back(team_);
            path_.back() = path.getState(i + 1);
        }
        if (findInvalid().empty())
            return true;
        path_.erase(path_.begin() + 1, path_.end());
        return false;
    }

    void ReplanningTeam::moveOn()
    {
        if (hasPath())
            path_.pop_front();
        if (path_.size() == 1 && path_.front() == goal_)
            std::swap(goal_, nextGoal_);
    }
}
