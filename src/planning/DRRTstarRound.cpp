// The part of DRRTstar that works in rounds. Each phase of them can be stopped, and goes on in the next call of solve().
#include "DRRTstarRound.h"

#include "RoadmapPathCheck.h"
#include "TeamGoals.h"

#include <algorithm>

namespace ompl_certificates
{
    namespace ob = ompl::base;

    namespace
    {
        /** How many orders of the robots each round tries */
        constexpr unsigned int ORDERS = 20;

        /** What the first round does: iterations of the tree, iterations of RRTConnect for a robot, and steps of the
            search in a crowd for each robot, for all starts and goals. Each later round does twice as much. */
        constexpr unsigned int TREE_ITERATIONS = 10, ROBOT_ITERATIONS = 500, CROWD_STEPS = 40;
    }

    bool DRRTstar::continueRound(const ob::PlannerTerminationCondition &condition)
    {
        Round &round = *round_;
        if (round.phase == Round::GROWTH)
        {
            if (rounds_ > 0 && !growRoadmaps(condition))
                return false;
            takeGoals();
            round.phase = Round::CONNECTION;
        }
        if (round.phase == Round::CONNECTION)
        {
            round.isConnected = connect(condition);
            if (!round.isConnected && !(round.chosen && round.chosen->empty()))
                return false;
            round.phase = round.isConnected ? Round::PRIORITIES : Round::END;
            round.treeIterations = effort(TREE_ITERATIONS);
        }
        if (round.phase == Round::PRIORITIES && searchByPriorities(condition))
            round.phase = Round::CROWD;
        if (round.phase == Round::CROWD && (best_ || searchInCrowd(condition)))
            round.phase = Round::TREE;
        if (round.phase == Round::TREE && (isDone() || searchTree(condition)))
            round.phase = Round::SHORTENING;
        if (round.phase == Round::SHORTENING)
        {
            if (best_)
                shorten(*best_, condition);
            round.phase = Round::END;
        }
        return round.phase == Round::END;
    }

    void DRRTstar::beginRound()
    {
        const bool hasGrown = round_ && round_->phase != Round::GROWTH;
        round_ = std::make_unique<Round>();
        if (!hasGrown)
            return;
        takeGoals();
        round_->phase = Round::CONNECTION;
    }

    std::uint64_t DRRTstar::effort(unsigned int first) const
    {
        return static_cast<std::uint64_t>(first) << std::min(rounds_, 30U);
    }

    bool DRRTstar::growRoadmaps(const ob::PlannerTerminationCondition &condition)
    {
        // The round before the first growth counts, too.
        const bool isFinished = roadmaps_->grow(effort(roadmapSize_) / 2, maxRoadmapSize_, condition);
        std::uint64_t vertices = 0;
        for (const auto &roadmap : roadmaps_->getRoadmaps())
            vertices += roadmap->size();
        vertices_ = vertices;
        return isFinished;
    }

    bool DRRTstar::isAtLimit() const
    {
        return std::all_of(roadmaps_->getRoadmaps().begin(), roadmaps_->getRoadmaps().end(),
                           [this](const auto &roadmap) { return roadmap->size() >= maxRoadmapSize_; });
    }

    bool DRRTstar::connect(const ob::PlannerTerminationCondition &condition)
    {
        Round &round = *round_;
        if (!round.chosen)
        {
            round.chosen = goals_->choose(*pdef_->getGoal(), starts_, effort(ROBOT_ITERATIONS), condition);
            if (!round.chosen)
                return false;
            const auto stuck = goals_->getStuckRobot();
            stuckRobot_ = stuck ? checker_->getTeam().getRobot(*stuck).getName() : std::string();
        }
        for (std::size_t i = 0; i < round.chosen->size(); ++i)
        {
            const Configuration &goal = (*round.chosen)[i];
            if (round.goals.size() == i)
                round.goals.push_back({goal, {}});
            std::vector<std::vector<double>> &distances = round.goals[i].distances;
            while (distances.size() < goal.size())
            {
                if (condition)
                    return false;
                const auto robot = static_cast<unsigned int>(distances.size());
                distances.push_back(roadmaps_->getRoadmap(robot).distancesTo(goal[robot]));
            }
        }
        if (round.goals.empty())
            return false;
        tree_->setGoals(std::move(round.goals));
        return true;
    }

    bool DRRTstar::searchByPriorities(const ob::PlannerTerminationCondition &condition)
    {
        Round &round = *round_;
        for (; round.pair < tree_->getGoals().size() * starts_.size(); ++round.pair)
        {
            const ProductTree::Goal &goal = tree_->getGoals()[round.pair / starts_.size()];
            const Configuration &start = starts_[round.pair % starts_.size()];
            for (;;)
            {
                if (!round.priorities)
                    round.priorities = std::make_unique<PrioritizedSearch>(*roadmaps_, start, goal.configuration,
                                                                           goal.distances, ORDERS);
                auto path = round.priorities->search(condition);
                if (!path && !round.priorities->isOver())
                    return false;
                round.priorities.reset();
                if (!path)
                    break;
                if (check_->confirm(*path))
                {
                    tree_->insert(*path);
                    take(*path, condition);
                    round.pair = 0;
                    return true;
                }
            }
        }
        round.pair = 0;
        return true;
    }

    bool DRRTstar::searchInCrowd(const ob::PlannerTerminationCondition &condition)
    {
        Round &round = *round_;
        const std::size_t pairs = tree_->getGoals().size() * starts_.size();
        const std::uint64_t steps = effort(CROWD_STEPS) * roadmaps_->getRobotCount() / pairs + 1;
        for (; round.pair < pairs; ++round.pair)
        {
            const ProductTree::Goal &goal = tree_->getGoals()[round.pair / starts_.size()];
            if (round.path.empty())
                round.path = {starts_[round.pair % starts_.size()]};
            for (;;)
            {
                if (!round.crowd)
                {
                    if (condition)
                        return false;
                    round.crowd = std::make_unique<CrowdSearch>(*roadmaps_, round.path.back(), goal, steps, ORDERS);
                }
                const auto rest = round.crowd->search(condition);
                if (!rest && !round.crowd->isOver())
                    return false;
                round.crowd.reset();
                if (!rest)
                    break;
                round.path.insert(round.path.end(), rest->begin() + 1, rest->end());
                if (check_->confirm(round.path))
                {
                    tree_->insert(round.path);
                    take(round.path, condition);
                    return true;
                }
            }
            round.path.clear();
        }
        return true;
    }

    bool DRRTstar::searchTree(const ob::PlannerTerminationCondition &condition)
    {
        std::uint64_t &left = round_->treeIterations;
        const std::uint64_t before = left;
        while (tree_->grow(left, treeCost_, condition))
        {
            Path path = tree_->getPath();
            if (!check_->confirm(path))
            {
                if (condition)
                    break;
                continue;
            }
            treeCost_ = tree_->getCost();
            take(path, condition);
        }
        iterations_ += before - left;
        return left == 0 || !condition;
    }
}
