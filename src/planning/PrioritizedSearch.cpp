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
        constexpr std::uint32_t NO_NODE = std::numeric_limits<std::uint32_t>::max();

        /** A robot at a vertex after a step */
        struct Node
        {
            Roadmap::Vertex vertex;
            std::uint32_t step, parent;
            double time;
        };

        struct Open
        {
            double estimate;
            std::uint32_t step, node;

            /** The quicker one first; of equal ones that which is farther in time */
            bool operator<(const Open &other) const
            {
                return estimate > other.estimate || (estimate == other.estimate && step < other.step);
            }
        };
    }

    PrioritizedSearch::PrioritizedSearch(TeamRoadmaps &roadmaps, const TeamRoadmaps::Configuration &start,
                                         const TeamRoadmaps::Configuration &goal,
                                         const std::vector<std::vector<double>> &distances, unsigned int orders)
      : roadmaps_(roadmaps), start_(start), goal_(goal), distances_(distances), order_(start.size()), orders_(orders)
    {
        std::iota(order_.begin(), order_.end(), 0U);
        // Those with the longest way first
        std::stable_sort(order_.begin(), order_.end(),
                         [this](unsigned int a, unsigned int b)
                         { return timeToGoal(a, start_[a]) > timeToGoal(b, start_[b]); });
        begin();
    }

    void PrioritizedSearch::begin()
    {
        moves_.assign(1, {});
        durations_.assign(1, 0.0);
        planned_ = 0;
    }

    std::optional<TeamRoadmaps::Path>
    PrioritizedSearch::search(const ompl::base::PlannerTerminationCondition &condition)
    {
        for (; orders_ > 0 && !condition; --orders_)
        {
            while (planned_ < order_.size() && plan(order_[planned_], condition))
                ++planned_;
            if (planned_ == order_.size())
                return getPath();
            if (condition)
                return std::nullopt;
            const auto failed = order_.begin() + static_cast<std::ptrdiff_t>(planned_);
            std::rotate(order_.begin(), failed, failed + 1);
            begin();
        }
        return std::nullopt;
    }

    TeamRoadmaps::Path PrioritizedSearch::getPath() const
    {
        TeamRoadmaps::Path path(moves_.size(), goal_);
        for (std::size_t step = 0; step < moves_.size(); ++step)
            for (const Move &move : moves_[step])
                path[step][move.robot] = move.from;
        return path;
    }

    double PrioritizedSearch::timeToGoal(unsigned int robot, Vertex vertex) const
    {
        return distances_[robot][vertex] / roadmaps_.getSpeed(robot);
    }

    bool PrioritizedSearch::isFree(unsigned int robot, Vertex from, const Roadmap::Edge &edge, std::size_t step)
    {
        Roadmap &roadmap = roadmaps_.getRoadmap(robot);
        if (!roadmap.isFree(from, edge))
            return false;
        const Ball &swept = roadmap.getSwept(edge.motion).all;
        const auto avoids = [&](const Move &other)
        {
            if (areApart(swept, other.swept))
                return true;
            return roadmaps_.areApart(robot, from, edge, other.robot, other.from, *other.edge);
        };
        const std::vector<Move> &others = moves_[std::min(step, moves_.size() - 1)];
        return std::all_of(others.begin(), others.end(), avoids);
    }

    PrioritizedSearch::Move PrioritizedSearch::stayOf(unsigned int robot) const
    {
        const Roadmap &roadmap = roadmaps_.getRoadmap(robot);
        const Roadmap::Edge &stay = roadmap.getEdges(goal_[robot]).front();
        return {roadmap.getSwept(stay.motion).all, robot, goal_[robot], &stay};
    }

    void PrioritizedSearch::keep(unsigned int robot, const std::vector<Vertex> &path)
    {
        const std::vector<Move> allStay = moves_.back();
        if (path.size() > moves_.size())
        {
            moves_.resize(path.size(), allStay);
            durations_.resize(path.size(), 0.0);
        }
        const Roadmap &roadmap = roadmaps_.getRoadmap(robot);
        for (std::size_t step = 0; step < moves_.size(); ++step)
            if (step + 1 < path.size())
            {
                const Roadmap::Edge *edge = roadmap.findEdge(path[step], path[step + 1]);
                moves_[step].push_back({roadmap.getSwept(edge->motion).all, robot, path[step], edge});
                durations_[step] = std::max(durations_[step], edge->length / roadmaps_.getSpeed(robot));
            }
            else
                moves_[step].push_back(stayOf(robot));
    }

    bool PrioritizedSearch::plan(unsigned int robot, const ompl::base::PlannerTerminationCondition &condition)
    {
        const Roadmap &roadmap = roadmaps_.getRoadmap(robot);
        const double speed = roadmaps_.getSpeed(robot);
        const std::size_t last = moves_.size() - 1;  // From then on the others stay.
        // From when on the robot may stay at its goal
        std::size_t goalFree = last + 1;
        while (goalFree > 0 && isFree(robot, goal_[robot], roadmap.getEdges(goal_[robot]).front(), goalFree - 1))
            --goalFree;
        if (goalFree > last)
            return false;

        std::vector<Node> nodes{{start_[robot], 0, NO_NODE, 0.0}};
        std::priority_queue<Open> open;
        open.push({timeToGoal(robot, start_[robot]), 0, 0});
        // After the others have arrived, one step is as another.
        std::unordered_map<std::uint64_t, double> known;
        const auto keyOf = [last](Vertex vertex, std::uint32_t step)
        { return static_cast<std::uint64_t>(std::min<std::size_t>(step, last)) << 32U | vertex; };
        while (!open.empty() && !condition)
        {
            const std::uint32_t index = open.top().node;
            open.pop();
            const Node node = nodes[index];
            if (node.step > 0 && known[keyOf(node.vertex, node.step)] < node.time)
                continue;
            if (node.vertex == goal_[robot] && node.step >= goalFree)
            {
                std::vector<Vertex> path(node.step + 1);
                for (std::uint32_t i = index; i != NO_NODE; i = nodes[i].parent)
                    path[nodes[i].step] = nodes[i].vertex;
                keep(robot, path);
                return true;
            }
            for (const Roadmap::Edge &edge : roadmap.getEdges(node.vertex))
            {
                const double time =
                    node.time + std::max(edge.length / speed, durations_[std::min<std::size_t>(node.step, last)]);
                // After all others have arrived there is nothing to wait for.
                if (!std::isfinite(distances_[robot][edge.to]) || (edge.to == node.vertex && node.step >= last))
                    continue;
                const auto [entry, isNew] =
                    known.try_emplace(keyOf(edge.to, node.step + 1), std::numeric_limits<double>::infinity());
                if (time >= entry->second || !isFree(robot, node.vertex, edge, node.step))
                    continue;
                entry->second = time;
                nodes.push_back({edge.to, node.step + 1, index, time});
                open.push(
                    {time + timeToGoal(robot, edge.to), node.step + 1, static_cast<std::uint32_t>(nodes.size() - 1)});
            }
        }
        return false;
    }
}
