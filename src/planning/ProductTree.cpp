#include "ProductTree.h"

#include <algorithm>
#include <memory>
#include <numeric>
#include <ompl/datastructures/NearestNeighborsGNATNoThreadSafety.h>

namespace ompl_certificates
{
    namespace ob = ompl::base;

    namespace
    {
        /** The number of vertices around a new one that may become its parent or its children */
        constexpr std::size_t NEIGHBORS = 12;

        /** How often a robot goes to its goal while others explore */
        constexpr double GOAL_BIAS = 0.5;

        /** The target_ in nearest-neighbor queries */
        constexpr std::uint32_t TARGET = std::numeric_limits<std::uint32_t>::max() - 1;
    }

    ProductTree::ProductTree(ob::SpaceInformationPtr si, ob::OptimizationObjectivePtr objective, TeamRoadmaps &roadmaps)
      : si_(std::move(si))
      , objective_(std::move(objective))
      , roadmaps_(roadmaps)
      , near_(std::make_unique<ompl::NearestNeighborsGNATNoThreadSafety<Number>>())
      , randomTargets_(roadmaps.getRobotCount())
      , goesToGoal_(roadmaps.getRobotCount())
      , chooser_(roadmaps)
      , target_(si_->allocState())
    {
        const auto stateOf = [this](Number number) { return number == TARGET ? target_ : nodes_[number].state; };
        near_->setDistanceFunction([this, stateOf](Number a, Number b)
                                   { return si_->distance(stateOf(a), stateOf(b)); });
    }

    ProductTree::~ProductTree()
    {
        for (const Node &node : nodes_)
            si_->freeState(node.state);
        si_->freeStates(goalStates_);
        si_->freeState(target_);
    }

    void ProductTree::addStart(const Configuration &start)
    {
        const auto known = numbers_.find(start);
        if (known == numbers_.end())
        {
            add(start, NONE);
            return;
        }
        if (nodes_[known->second].parent == NONE)
            return;
        detach(known->second);
        nodes_[known->second].cost = objective_->initialCost(nodes_[known->second].state);
        lowerCosts(known->second);
    }

    void ProductTree::setGoals(std::vector<Goal> goals)
    {
        goals_ = std::move(goals);
        si_->freeStates(goalStates_);
        goalStates_.resize(goals_.size());
        si_->allocStates(goalStates_);
        for (std::size_t i = 0; i < goals_.size(); ++i)
            roadmaps_.copyTo(goals_[i].configuration, goalStates_[i]);
        goal_ = nullptr;
        last_ = NONE;
    }

    ProductTree::Number ProductTree::bestGoal() const
    {
        Number best = NONE;
        for (const Goal &goal : goals_)
            if (const auto entry = numbers_.find(goal.configuration);
                entry != numbers_.end() &&
                (best == NONE || objective_->isCostBetterThan(costOfPathTo(entry->second), costOfPathTo(best))))
                best = entry->second;
        return best;
    }

    ob::Cost ProductTree::costOfPathTo(Number node) const
    {
        return objective_->combineCosts(nodes_[node].cost, objective_->terminalCost(nodes_[node].state));
    }

    ob::Cost ProductTree::getCost() const
    {
        const Number best = bestGoal();
        return best == NONE ? objective_->infiniteCost() : costOfPathTo(best);
    }

    bool ProductTree::grow(std::uint64_t &iterations, ob::Cost bound, const ob::PlannerTerminationCondition &condition)
    {
        while (!objective_->isCostBetterThan(getCost(), bound))
        {
            if (iterations == 0 || condition)
                return false;
            --iterations;
            expand(bound);
        }
        return true;
    }

    void ProductTree::expand(ob::Cost bound)
    {
        const bool continues = last_ != NONE;
        chooseTargets(continues);
        const Number from = continues ? last_ : nearestToRandom();
        last_ = NONE;
        const Configuration configuration = nodes_[from].configuration;
        if (!chooseStep(configuration))
            return;
        const Configuration next = chooser_.getEnd();
        double before = 0.0, after = 0.0;
        for (unsigned int robot = 0; robot < next.size(); ++robot)
        {
            before += goal_->distances[robot][configuration[robot]];
            after += goal_->distances[robot][next[robot]];
        }
        const bool isNew = numbers_.count(next) == 0;
        const Number added = add(next, from, bound);
        if (added != NONE && isNew && (after < before || !continues))
            last_ = added;
    }

    ProductTree::Number ProductTree::nearestToRandom()
    {
        Configuration random(roadmaps_.getRobotCount());
        for (unsigned int robot = 0; robot < random.size(); ++robot)
            random[robot] = goesToGoal_[robot] ? goal_->configuration[robot] : randomTargets_[robot];
        roadmaps_.copyTo(random, target_);
        return near_->nearest(TARGET);
    }

    void ProductTree::chooseTargets(bool onlyGoals)
    {
        if (!goal_ || !onlyGoals)
            goal_ = &goals_[static_cast<std::size_t>(random_.uniformInt(0, static_cast<int>(goals_.size()) - 1))];
        for (unsigned int robot = 0; robot < roadmaps_.getRobotCount(); ++robot)
        {
            goesToGoal_[robot] = onlyGoals || random_.uniform01() < GOAL_BIAS;
            if (!goesToGoal_[robot])
                randomTargets_[robot] = static_cast<Vertex>(
                    random_.uniformInt(0, static_cast<int>(roadmaps_.getRoadmap(robot).size()) - 1));
        }
    }

    double ProductTree::rate(unsigned int robot, const Roadmap::Edge &edge) const
    {
        if (goesToGoal_[robot])
            return edge.length + goal_->distances[robot][edge.to];
        return roadmaps_.getRoadmap(robot).distance(edge.to, randomTargets_[robot]);
    }

    bool ProductTree::chooseStep(const Configuration &from)
    {
        std::vector<unsigned int> order(from.size());
        std::iota(order.begin(), order.end(), 0U);
        random_.shuffle(order.begin(), order.end());
        chooser_.begin(from);
        return chooser_.complete(order,
                                 [this](unsigned int robot, const Roadmap::Edge &edge) { return rate(robot, edge); });
    }

    ob::Cost ProductTree::costThrough(Number parent, const ob::State *state) const
    {
        const Node &node = nodes_[parent];
        return objective_->combineCosts(node.cost, objective_->motionCost(node.state, state));
    }

    bool ProductTree::mayImprove(ob::Cost bound, ob::Cost cost, const ob::State *state) const
    {
        return std::any_of(goalStates_.begin(), goalStates_.end(),
                           [&](const ob::State *goal)
                           {
                               const ob::Cost rest = objective_->combineCosts(
                                   objective_->motionCostHeuristic(state, goal), objective_->terminalCost(goal));
                               return objective_->isCostBetterThan(objective_->combineCosts(cost, rest), bound);
                           });
    }

    ProductTree::Number ProductTree::add(const Configuration &configuration, Number parent,
                                         std::optional<ob::Cost> bound)
    {
        const auto known = numbers_.find(configuration);
        if (known != numbers_.end())
        {
            const Number number = known->second;
            if (parent != NONE && number != parent)
                if (const ob::Cost cost = costThrough(parent, nodes_[number].state);
                    objective_->isCostBetterThan(cost, nodes_[number].cost))
                    moveTo(number, parent, cost);
            return number;
        }
        // Frees the state until the tree does: a user's objective, obstacles and robots may throw.
        const auto freeState = [this](ob::State *one) { si_->freeState(one); };
        std::unique_ptr<ob::State, decltype(freeState)> owned(si_->allocState(), freeState);
        ob::State *const state = owned.get();
        roadmaps_.copyTo(configuration, state);
        ob::Cost cost = parent == NONE ? objective_->initialCost(state) : costThrough(parent, state);
        std::vector<Number> around;
        if (parent != NONE)
        {
            si_->copyState(target_, state);
            near_->nearestK(TARGET, NEIGHBORS, around);
            for (const Number other : around)
                if (const ob::Cost through = costThrough(other, state);
                    objective_->isCostBetterThan(through, cost) &&
                    roadmaps_.isStepFree(nodes_[other].configuration, configuration))
                {
                    parent = other;
                    cost = through;
                }
        }
        if (parent != NONE && bound && !mayImprove(*bound, cost, state))
            return NONE;
        const auto number = static_cast<Number>(nodes_.size());
        nodes_.push_back({configuration, state, cost, parent, {}});
        owned.release();
        numbers_.emplace(configuration, number);
        near_->add(number);
        if (parent != NONE)
            nodes_[parent].children.push_back(number);
        for (const Number other : around)
            if (other != parent)
                if (const ob::Cost through = costThrough(number, nodes_[other].state);
                    objective_->isCostBetterThan(through, nodes_[other].cost) &&
                    roadmaps_.isStepFree(configuration, nodes_[other].configuration))
                    moveTo(other, number, through);
        return number;
    }

    void ProductTree::moveTo(Number node, Number parent, ob::Cost cost)
    {
        detach(node);
        nodes_[node].parent = parent;
        nodes_[node].cost = cost;
        nodes_[parent].children.push_back(node);
        lowerCosts(node);
    }

    void ProductTree::detach(Number node)
    {
        if (nodes_[node].parent == NONE)
            return;
        auto &siblings = nodes_[nodes_[node].parent].children;
        siblings.erase(std::find(siblings.begin(), siblings.end(), node));
        nodes_[node].parent = NONE;
    }

    void ProductTree::lowerCosts(Number node)
    {
        std::vector<Number> changed{node};
        while (!changed.empty())
        {
            const Number parent = changed.back();
            changed.pop_back();
            for (const Number child : nodes_[parent].children)
            {
                nodes_[child].cost = costThrough(parent, nodes_[child].state);
                changed.push_back(child);
            }
        }
    }

    void ProductTree::insert(const TeamRoadmaps::Path &path)
    {
        addStart(path.front());
        for (std::size_t step = 1; step < path.size(); ++step)
            add(path[step], numbers_.at(path[step - 1]));
    }

    TeamRoadmaps::Path ProductTree::getPath() const
    {
        TeamRoadmaps::Path path;
        for (Number best = bestGoal(); best != NONE; best = nodes_[best].parent)
            path.push_back(nodes_[best].configuration);
        std::reverse(path.begin(), path.end());
        return path;
    }

    void ProductTree::cut(const Configuration &from, const Configuration &to)
    {
        const auto parent = numbers_.find(from), child = numbers_.find(to);
        if (parent == numbers_.end() || child == numbers_.end() || nodes_[child->second].parent != parent->second)
            return;
        const Number node = child->second;
        detach(node);
        remove(node);
        last_ = NONE;
    }

    std::vector<const ob::State *> ProductTree::getStarts() const
    {
        std::vector<const ob::State *> starts;
        for (const auto &entry : numbers_)
            if (nodes_[entry.second].parent == NONE)
                starts.push_back(nodes_[entry.second].state);
        return starts;
    }

    std::vector<const ob::State *> ProductTree::getReachedGoals() const
    {
        std::vector<const ob::State *> goals;
        for (const Goal &goal : goals_)
            if (const auto entry = numbers_.find(goal.configuration); entry != numbers_.end())
                goals.push_back(nodes_[entry->second].state);
        return goals;
    }

    void ProductTree::remove(Number node)
    {
        std::vector<Number> removed{node};
        while (!removed.empty())
        {
            Node &one = nodes_[removed.back()];
            near_->remove(removed.back());
            removed.pop_back();
            numbers_.erase(one.configuration);
            removed.insert(removed.end(), one.children.begin(), one.children.end());
            one.children.clear();
        }
    }
}
