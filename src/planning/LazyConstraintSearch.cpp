#include "LazyConstraintSearch.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace ompl_certificates
{
    namespace
    {
        /** How many numbers of robots in configurations, and constraints, are kept */
        constexpr std::size_t MOST_KEPT = 20'000'000;
    }

    LazyConstraintSearch::LazyConstraintSearch(TeamRoadmaps &roadmaps, const Configuration &start,
                                               const Configuration &goal)
      : roadmaps_(roadmaps), goal_(goal), distances_(goal.size()), chooser_(roadmaps)
    {
        updateDistances();
        add(start, NONE);
        if (!isSolvable())
            stack_.clear();
    }

    bool LazyConstraintSearch::isSolvable() const
    {
        // Motions go both ways, so what holds of the start holds of all configurations.
        const Configuration &start = nodes_.front().configuration;
        for (unsigned int robot = 0; robot < start.size(); ++robot)
            if (!std::isfinite(distances_[robot][start[robot]]))
                return false;
        return true;
    }

    bool LazyConstraintSearch::isFull() const
    {
        return nodes_.size() * goal_.size() + constraints_.size() > MOST_KEPT;
    }

    void LazyConstraintSearch::add(Configuration configuration, Number parent)
    {
        const std::size_t robots = configuration.size();
        Node node{std::move(configuration),          parent, std::vector<double>(robots),
                  std::vector<unsigned int>(robots), {},     0};
        for (unsigned int robot = 0; robot < robots; ++robot)
        {
            const double distance = distances_[robot][node.configuration[robot]];
            double &priority = node.priorities[robot];
            // Less than one, so that it only decides between robots that have been on their way for equally long
            priority = parent == NONE ? 1.0 - 1.0 / (1.0 + distance) : nodes_[parent].priorities[robot];
            if (parent != NONE)
                priority = node.configuration[robot] == goal_[robot] ? priority - std::floor(priority) : priority + 1.0;
        }
        std::iota(node.order.begin(), node.order.end(), 0U);
        std::stable_sort(node.order.begin(), node.order.end(),
                         [&node](unsigned int a, unsigned int b) { return node.priorities[a] > node.priorities[b]; });
        node.constraints.push_back(static_cast<Number>(constraints_.size()));
        constraints_.push_back({NONE, 0, 0, nullptr});
        const auto number = static_cast<Number>(nodes_.size());
        numbers_.emplace(node.configuration, number);
        nodes_.push_back(std::move(node));
        stack_.push_back(number);
    }

    std::optional<TeamRoadmaps::Path>
    LazyConstraintSearch::search(std::uint64_t steps, const ompl::base::PlannerTerminationCondition &condition)
    {
        for (; !isOver(steps) && !condition; ++step_)
        {
            const Number from = stack_.back();
            if (nodes_[from].configuration == goal_)
                return pathTo(from);
            if (nodes_[from].next == nodes_[from].constraints.size())
            {
                stack_.pop_back();
                continue;
            }
            // At steps 16, 32, 64, ...: it costs a search in each roadmap.
            if (step_ >= 16 && (step_ & (step_ - 1)) == 0)
            {
                updateDistances();
                if (!isSolvable())
                {
                    stack_.clear();
                    break;
                }
            }
            if (!chooseStep(nodes_[from], takeConstraint(nodes_[from])))
                continue;
            Configuration next = chooser_.getEnd();
            if (const auto known = numbers_.find(next); known != numbers_.end())
                stack_.push_back(known->second);
            else
                add(std::move(next), from);
        }
        return std::nullopt;
    }

    LazyConstraintSearch::Number LazyConstraintSearch::takeConstraint(Node &node)
    {
        const Number taken = node.constraints[node.next++];
        const unsigned int depth = constraints_[taken].depth;
        if (depth == node.order.size())
            return taken;
        const unsigned int robot = node.order[depth];
        const std::size_t before = node.constraints.size();
        Roadmap &roadmap = roadmaps_.getRoadmap(robot);
        for (const Roadmap::Edge &edge : roadmap.getEdges(node.configuration[robot]))
        {
            if (!roadmap.isFree(node.configuration[robot], edge))
                continue;
            node.constraints.push_back(static_cast<Number>(constraints_.size()));
            constraints_.push_back({taken, robot, depth + 1, &edge});
        }
        random_.shuffle(node.constraints.begin() + static_cast<std::ptrdiff_t>(before), node.constraints.end());
        return taken;
    }

    bool LazyConstraintSearch::chooseStep(const Node &node, Number constraint)
    {
        chooser_.begin(node.configuration);
        for (; constraints_[constraint].edge; constraint = constraints_[constraint].parent)
            if (!chooser_.choose(constraints_[constraint].robot, *constraints_[constraint].edge))
                return false;
        return chooser_.complete(node.order, [this](unsigned int robot, const Roadmap::Edge &edge)
                                 { return distances_[robot][edge.to]; });
    }

    void LazyConstraintSearch::updateDistances()
    {
        if (const std::size_t blocked = roadmaps_.countBlocked(); knownBlocked_ != blocked)
        {
            knownBlocked_ = blocked;
            for (unsigned int robot = 0; robot < goal_.size(); ++robot)
                distances_[robot] = roadmaps_.getRoadmap(robot).distancesTo(goal_[robot]);
        }
    }

    TeamRoadmaps::Path LazyConstraintSearch::getNearest() const
    {
        Number nearest = 0;
        double least = std::numeric_limits<double>::infinity();
        for (Number number = 0; number < nodes_.size(); ++number)
        {
            double rest = 0.0;
            for (unsigned int robot = 0; robot < goal_.size(); ++robot)
                rest += distances_[robot][nodes_[number].configuration[robot]];
            if (rest < least)
            {
                least = rest;
                nearest = number;
            }
        }
        return pathTo(nearest);
    }

    TeamRoadmaps::Path LazyConstraintSearch::pathTo(Number node) const
    {
        TeamRoadmaps::Path path;
        for (; node != NONE; node = nodes_[node].parent)
            path.push_back(nodes_[node].configuration);
        std::reverse(path.begin(), path.end());
        return path;
    }
}
