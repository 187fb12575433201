#include "TeamGoals.h"

#include "ompl_certificates/validity/TeamValidityChecker.h"

#include <algorithm>
#include <array>
#include <limits>

namespace ompl_certificates
{
    namespace ob = ompl::base;

    namespace
    {
        /** How many goals are searched for at once: each costs a search in each roadmap. */
        constexpr std::size_t MOST_CHOSEN_GOALS = 10;
    }

    TeamGoals::TeamGoals(ob::SpaceInformationPtr si, std::shared_ptr<const TeamValidityChecker> checker,
                         TeamRoadmaps &roadmaps)
      : si_(std::move(si)), checker_(std::move(checker)), roadmaps_(roadmaps), mixed_(si_->allocState())
    {
    }

    TeamGoals::~TeamGoals()
    {
        si_->freeState(mixed_);
    }

    void TeamGoals::add(const ob::State *goal)
    {
        Configuration added = roadmaps_.add(goal);
        if (std::find(goals_.begin(), goals_.end(), added) == goals_.end())
            goals_.push_back(std::move(added));
    }

    std::optional<std::vector<TeamGoals::Configuration>>
    TeamGoals::choose(const ob::Goal &region, const std::vector<Configuration> &starts, std::uint64_t iterations,
                      const ob::PlannerTerminationCondition &condition)
    {
        stuckRobot_.reset();
        const auto each = static_cast<unsigned int>(std::clamp<std::uint64_t>(
            iterations / std::max<std::size_t>(goals_.size(), 1), 1, std::numeric_limits<unsigned int>::max()));
        std::vector<Configuration> reachable;
        std::vector<bool> arrives(roadmaps_.getRobotCount(), false);
        for (const Configuration &start : starts)
            if (!addReachable(region, start, each, condition, reachable, arrives))
                return std::nullopt;
        tried_.clear();
        if (const auto stuck = std::find(arrives.begin(), arrives.end(), false); stuck != arrives.end())
            stuckRobot_ = static_cast<unsigned int>(stuck - arrives.begin());
        if (reachable.size() > MOST_CHOSEN_GOALS)
        {
            // The first one may be mixed.
            random_.shuffle(reachable.begin() + 1, reachable.end());
            if (const auto kept = std::find(reachable.begin() + 1, reachable.end(), kept_); kept != reachable.end())
                std::iter_swap(kept, reachable.begin() + 1);
            reachable.resize(MOST_CHOSEN_GOALS);
        }
        return reachable;
    }

    bool TeamGoals::addReachable(const ob::Goal &region, const Configuration &start, unsigned int iterations,
                                 const ob::PlannerTerminationCondition &condition,
                                 std::vector<Configuration> &reachable, std::vector<bool> &arrives)
    {
        std::vector<std::vector<Vertex>> reached(start.size());
        for (std::size_t number = 0; number < goals_.size(); ++number)
        {
            const Configuration &goal = goals_[number];
            bool isReachable = true;
            for (unsigned int robot = 0; robot < start.size(); ++robot)
            {
                const std::array<std::size_t, 3> way{robot, start[robot], number};
                auto known = tried_.find(way);
                if (known == tried_.end())
                {
                    const bool isFound =
                        roadmaps_.getRoadmap(robot).connect(start[robot], goal[robot], iterations, condition);
                    if (!isFound && condition)
                        return false;
                    known = tried_.emplace(way, isFound).first;
                }
                if (known->second)
                    reached[robot].push_back(goal[robot]);
                else
                    isReachable = false;
            }
            if (isReachable && std::find(reachable.begin(), reachable.end(), goal) == reachable.end())
                reachable.push_back(goal);
        }
        bool allArrive = true;
        for (unsigned int robot = 0; robot < start.size(); ++robot)
            if (reached[robot].empty())
                allArrive = false;
            else
                arrives[robot] = true;
        if (allArrive && goals_.size() > 1)
        {
            if (condition)
                return false;
            if (const auto mixed = mix(region, start, std::move(reached)))
            {
                reachable.erase(std::remove(reachable.begin(), reachable.end(), *mixed), reachable.end());
                reachable.insert(reachable.begin(), *mixed);
            }
        }
        return true;
    }

    std::optional<TeamGoals::Configuration> TeamGoals::mix(const ob::Goal &region, const Configuration &start,
                                                           std::vector<std::vector<Vertex>> reached) const
    {
        Configuration mixed;
        for (unsigned int robot = 0; robot < start.size(); ++robot)
        {
            const Roadmap &roadmap = roadmaps_.getRoadmap(robot);
            const std::vector<double> distances = roadmap.distancesTo(start[robot]);
            std::stable_sort(reached[robot].begin(), reached[robot].end(),
                             [&](Vertex a, Vertex b) { return distances[a] < distances[b]; });
            const auto isApart = [&](Vertex vertex)
            {
                for (unsigned int other = 0; other < robot; ++other)
                    if (!checker_->isPairFree(robot, roadmap.getState(vertex), other,
                                              roadmaps_.getRoadmap(other).getState(mixed[other])))
                        return false;
                return true;
            };
            const auto nearest = std::find_if(reached[robot].begin(), reached[robot].end(), isApart);
            if (nearest == reached[robot].end())
                return std::nullopt;
            mixed.push_back(*nearest);
        }
        roadmaps_.copyTo(mixed, mixed_);
        if (!si_->isValid(mixed_) || !region.isSatisfied(mixed_))
            return std::nullopt;
        return mixed;
    }
}
