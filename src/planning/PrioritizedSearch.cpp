#include "PrioritizedSearch.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <queue>
#include <unordered_map>

namespace ompl_certificates
{
    namespace
    {
        constexpr std::uint32_t NONE = std::numeric_limits<std::uint32_t>::max();

        /** A robot at a vertex after a step */
        struct Node
        {
            Roadmap::Vertex vertex;
            std::uint32_t step, parent;
            double length;
        };

        struct Open
        {
            double estimate;
            std::uint32_t node;

            bool operator<(const Open &other) const
            {
                return estimate > other.estimate;
            }
        };
    }

    PrioritizedSearch::PrioritizedSearch(TeamRoadmaps &roadmaps, TeamRoadmaps::Configuration start,
                                         TeamRoadmaps::Configuration goal)
      : roadmaps_(roadmaps), start_(std::move(start)), goal_(std::move(goal)), paths_(start_.size())
    {
        for (unsigned int robot = 0; robot < start_.size(); ++robot)
            distances_.push_back(roadmaps_.getRoadmap(robot).distancesTo(goal_[robot]));
    }

    std::optional<PrioritizedSearch::Path>
    PrioritizedSearch::search(unsigned int orders, const ompl::base::PlannerTerminationCondition &condition)
    {
        std::vector<unsigned int> order(start_.size());
        std::iota(order.begin(), order.end(), 0U);
        // Those with the longest way first
        std::stable_sort(order.begin(), order.end(),
                         [this](unsigned int a, unsigned int b)
                         { return distances_[a][start_[a]] > distances_[b][start_[b]]; });
        for (; orders > 0 && !condition; --orders)
        {
            planned_.clear();
            arrival_ = 0;
            const auto failed =
                std::find_if(order.begin(), order.end(), [&](unsigned int robot) { return !plan(robot, condition); });
            if (failed != order.end())
            {
                std::rotate(order.begin(), failed, failed + 1);
                continue;
            }
            Path path(arrival_ + 1, TeamRoadmaps::Configuration(start_.size()));
            for (std::size_t step = 0; step < path.size(); ++step)
                for (unsigned int robot = 0; robot < start_.size(); ++robot)
                    path[step][robot] = paths_[robot][std::min(step, paths_[robot].size() - 1)];
            return path;
        }
        return std::nullopt;
    }

    bool PrioritizedSearch::isFree(unsigned int robot, Vertex from, const Roadmap::Edge &edge, std::size_t step)
    {
        const auto avoids = [&](unsigned int other)
        {
            const auto &path = paths_[other];
            const Vertex otherFrom = path[std::min(step, path.size() - 1)];
            const Vertex otherTo = path[std::min(step + 1, path.size() - 1)];
            const auto &edges = roadmaps_.getRoadmap(other).getEdges(otherFrom);
            const auto taken = std::find_if(edges.begin(), edges.end(),
                                            [otherTo](const Roadmap::Edge &one) { return one.to == otherTo; });
            return roadmaps_.areApart(robot, from, edge, other, otherFrom, *taken);
        };
        return std::all_of(planned_.begin(), planned_.end(), avoids);
    }

    bool PrioritizedSearch::plan(unsigned int robot, const ompl::base::PlannerTerminationCondition &condition)
    {
        const Roadmap &roadmap = roadmaps_.getRoadmap(robot);
        const std::vector<double> &distances = distances_[robot];
        // From when on the robot may stay at its goal
        std::size_t goalFree = arrival_;
        while (goalFree > 0 && isFree(robot, goal_[robot], roadmap.getEdges(goal_[robot]).front(), goalFree - 1))
            --goalFree;

        std::vector<Node> nodes{{start_[robot], 0, NONE, 0.0}};
        std::priority_queue<Open> open;
        open.push({distances[start_[robot]], 0});
        // After the others have arrived, one step is as another.
        std::unordered_map<std::uint64_t, double> known;
        const auto keyOf = [this](Vertex vertex, std::uint32_t step)
        { return static_cast<std::uint64_t>(std::min<std::size_t>(step, arrival_)) << 32U | vertex; };
        while (!open.empty() && !condition)
        {
            const std::uint32_t index = open.top().node;
            open.pop();
            const Node node = nodes[index];
            if (known[keyOf(node.vertex, node.step)] < node.length)
                continue;
            if (node.vertex == goal_[robot] && node.step >= goalFree)
            {
                std::vector<Vertex> &path = paths_[robot];
                path.assign(node.step + 1, 0);
                for (std::uint32_t i = index; i != NONE; i = nodes[i].parent)
                    path[nodes[i].step] = nodes[i].vertex;
                planned_.push_back(robot);
                arrival_ = std::max<std::size_t>(arrival_, node.step);
                return true;
            }
            for (const Roadmap::Edge &edge : roadmap.getEdges(node.vertex))
            {
                const double length = node.length + edge.length;
                // After all others have arrived there is nothing to wait for.
                if (!std::isfinite(distances[edge.to]) || (edge.to == node.vertex && node.step >= arrival_))
                    continue;
                const auto [entry, isNew] =
                    known.try_emplace(keyOf(edge.to, node.step + 1), std::numeric_limits<double>::infinity());
                if (length >= entry->second || !isFree(robot, node.vertex, edge, node.step))
                    continue;
                entry->second = length;
                nodes.push_back({edge.to, node.step + 1, index, length});
                open.push({length + distances[edge.to], static_cast<std::uint32_t>(nodes.size() - 1)});
            }
        }
        return false;
    }
}
