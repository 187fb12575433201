#include "Roadmap.h"

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <limits>
#include <ompl/datastructures/NearestNeighborsGNATNoThreadSafety.h>
#include <queue>

namespace ompl_certificates
{
    namespace ob = ompl::base;

    Roadmap::Roadmap(const TeamValidityChecker &checker, unsigned int robot)
      : checker_(checker)
      , robot_(robot)
      , space_(checker.getTeam().getRobotSpace(robot))
      , sampler_(space_.allocStateSampler())
      , near_(std::make_unique<ompl::NearestNeighborsGNATNoThreadSafety<Vertex>>())
      , sample_(space_.allocState())
    {
        near_->setDistanceFunction([this](Vertex a, Vertex b) { return space_.distance(states_[a], states_[b]); });
    }

    Roadmap::~Roadmap()
    {
        for (ob::State *state : states_)
            space_.freeState(state);
        space_.freeState(sample_);
    }

    Roadmap::Vertex Roadmap::add(const ob::State *state)
    {
        const Vertex vertex = size();
        states_.push_back(space_.cloneState(state));
        edges_.push_back({{vertex, 0.0, sweptBy(state, state)}});
        const double dimension = space_.getDimension();
        const double constant = boost::math::constants::e<double>() * (1.0 + 1.0 / dimension);
        const auto neighbors =
            static_cast<std::size_t>(std::ceil(constant * std::log(static_cast<double>(vertex) + 1.0)));
        std::vector<Vertex> nearest;
        if (vertex > 0)
            near_->nearestK(vertex, neighbors, nearest);
        for (const Vertex other : nearest)
            join(vertex, other);
        near_->add(vertex);
        return vertex;
    }

    void Roadmap::join(Vertex a, Vertex b)
    {
        const double length = space_.distance(states_[a], states_[b]);
        if (!(length > 0.0) || !checker_.isRobotMotionFree(robot_, states_[a], states_[b]))
            return;
        const Ball swept = sweptBy(states_[a], states_[b]);
        edges_[a].push_back({b, length, swept});
        edges_[b].push_back({a, length, swept});
    }

    Ball Roadmap::sweptBy(const ob::State *from, const ob::State *to) const
    {
        const Robot &robot = checker_.getTeam().getRobot(robot_);
        const std::size_t bodies = robot.getBodies().size();
        std::vector<Pose> poses(bodies);
        std::vector<MotionBound> bounds(bodies);
        space_.interpolate(from, to, 0.5, sample_);
        robot.computePoses(sample_, poses.data());
        robot.computeMotionBounds(from, to, bounds.data());
        std::vector<Ball> balls;
        for (std::size_t i = 0; i < bodies; ++i)
        {
            const Ball &own = robot.getBodies()[i].getSphereTree().getRoot();
            balls.push_back({poses[i] * own.center, own.radius + 0.5 * bounds[i].at(own.center.norm())});
        }
        Ball all = balls.front();
        for (const Ball &ball : balls)
            all.radius = std::max(all.radius, (ball.center - all.center).norm() + ball.radius);
        return all;
    }

    bool Roadmap::grow(Vertex count, const ob::PlannerTerminationCondition &condition)
    {
        while (count > 0)
        {
            if (condition)
                return false;
            sampler_->sampleUniform(sample_);
            if (!checker_.isRobotFree(robot_, sample_))
                continue;
            // add() interpolates in sample_, so it gets a copy.
            ob::State *state = space_.cloneState(sample_);
            add(state);
            space_.freeState(state);
            --count;
        }
        return true;
    }

    void Roadmap::remove(Vertex a, Vertex b)
    {
        const auto removeFrom = [this](Vertex from, Vertex to)
        {
            auto &edges = edges_[from];
            edges.erase(
                std::remove_if(edges.begin() + 1, edges.end(), [to](const Edge &edge) { return edge.to == to; }),
                edges.end());
        };
        removeFrom(a, b);
        removeFrom(b, a);
    }

    std::vector<double> Roadmap::distancesTo(Vertex goal) const
    {
        using Entry = std::pair<double, Vertex>;
        std::vector<double> distances(size(), std::numeric_limits<double>::infinity());
        std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
        distances[goal] = 0.0;
        queue.push({0.0, goal});
        while (!queue.empty())
        {
            const auto [distance, vertex] = queue.top();
            queue.pop();
            if (distance > distances[vertex])
                continue;
            for (const Edge &edge : edges_[vertex])
                if (const double next = distance + edge.length; next < distances[edge.to])
                {
                    distances[edge.to] = next;
                    queue.push({next, edge.to});
                }
        }
        return distances;
    }
}
