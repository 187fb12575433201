#include "Roadmap.h"

#include "LimitedRRTConnect.h"
#include "RobotSpaceInformation.h"
#include "team/OwnedState.h"

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <limits>
#include <ompl/base/ScopedState.h>
#include <ompl/datastructures/NearestNeighborsGNATNoThreadSafety.h>
#include <ompl/geometric/PathGeometric.h>
#include <queue>

namespace ompl_certificates
{
    namespace ob = ompl::base;

    Roadmap::Roadmap(const CertificateMotionValidator &validator, unsigned int robot)
      : validator_(validator)
      , robot_(robot)
      , space_(validator.getChecker().getTeam().getRobotSpace(robot))
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

    const Roadmap::Edge *Roadmap::findEdge(Vertex from, Vertex to) const
    {
        const auto &edges = edges_[from];
        const auto edge = std::find_if(edges.begin(), edges.end(), [to](const Edge &one) { return one.to == to; });
        return edge == edges.end() ? nullptr : &*edge;
    }

    Roadmap::Vertex Roadmap::add(const ob::State *state)
    {
        const Vertex vertex = size();
        states_.push_back(space_.cloneState(state));
        const double dimension = space_.getDimension();
        const double constant = boost::math::constants::e<double>() * (1.0 + 1.0 / dimension);
        const auto neighbors =
            static_cast<std::size_t>(std::ceil(constant * std::log(static_cast<double>(vertex) + 1.0)));
        std::vector<Vertex> nearest;
        if (vertex > 0)
            near_->nearestK(vertex, neighbors, nearest);
        if (!nearest.empty() && space_.distance(states_[nearest.front()], state) == 0.0)
        {
            space_.freeState(states_.back());
            states_.pop_back();
            return nearest.front();
        }
        edges_.push_back({{vertex, static_cast<Motion>(motions_.size()), 0.0}});
        motions_.push_back({});
        setFree(edges_.back().front().motion, vertex, vertex);
        for (const Vertex other : nearest)
            join(vertex, other, Knowledge::UNCHECKED);
        near_->add(vertex);
        return vertex;
    }

    void Roadmap::join(Vertex a, Vertex b, Knowledge knowledge)
    {
        if (const Edge *edge = knowledge == Knowledge::FREE ? findEdge(a, b) : nullptr)
        {
            // What the check of a whole path has refuted stays so.
            if (motions_[edge->motion].knowledge == Knowledge::UNCHECKED)
                setFree(edge->motion, a, b);
            return;
        }
        const double length = space_.distance(states_[a], states_[b]);
        const auto motion = static_cast<Motion>(motions_.size());
        edges_[a].push_back({b, motion, length});
        edges_[b].push_back({a, motion, length});
        motions_.push_back({knowledge, 0});
        if (knowledge == Knowledge::FREE)
            setFree(motion, a, b);
    }

    bool Roadmap::isFree(Vertex from, const Edge &edge)
    {
        if (motions_[edge.motion].knowledge == Knowledge::UNCHECKED)
        {
            if (validator_.isRobotMotionFree(robot_, states_[from], states_[edge.to]))
                setFree(edge.motion, from, edge.to);
            else
                refute(edge);
        }
        return motions_[edge.motion].knowledge == Knowledge::FREE;
    }

    void Roadmap::setFree(Motion motion, Vertex a, Vertex b)
    {
        MotionData &data = motions_[motion];
        if (data.knowledge != Knowledge::FREE)
        {
            data = {Knowledge::FREE, static_cast<std::uint32_t>(swept_.size())};
            swept_.emplace_back();
        }
        Swept &swept = swept_[data.swept];
        const ob::State *from = states_[std::min(a, b)], *to = states_[std::max(a, b)];
        swept.all = sweptBy(from, to, 0.5, 1.0);
        for (std::size_t i = 0; i < swept.quarters.size(); ++i)
            swept.setQuarter(i, a == b ? swept.all : sweptBy(from, to, 0.125 + 0.25 * static_cast<double>(i), 0.25));
    }

    void Roadmap::refute(const Edge &edge)
    {
        blocked_ += motions_[edge.motion].knowledge == Knowledge::BLOCKED ? 0 : 1;
        motions_[edge.motion].knowledge = Knowledge::BLOCKED;
    }

    void Roadmap::forgetSwept(Motion motion)
    {
        const Ball everywhere{Eigen::Vector3d::Zero(), std::numeric_limits<double>::infinity()};
        Swept &swept = swept_[motions_[motion].swept];
        swept.all = everywhere;
        for (std::size_t i = 0; i < swept.quarters.size(); ++i)
            swept.setQuarter(i, everywhere);
    }

    Ball Roadmap::sweptBy(const ob::State *from, const ob::State *to, double time, double duration) const
    {
        const Robot &robot = validator_.getChecker().getTeam().getRobot(robot_);
        const std::size_t bodies = robot.getBodies().size();
        std::vector<Pose> poses(bodies);
        std::vector<MotionBound> bounds(bodies);
        space_.interpolate(from, to, time, sample_);
        robot.computePoses(sample_, poses.data());
        robot.computeMotionBounds(from, to, bounds.data());
        std::vector<Ball> balls;
        balls.reserve(bodies);
        for (std::size_t i = 0; i < bodies; ++i)
            if (!robot.isZone(i))
            {
                const Ball &own = robot.getBodies()[i].getSphereTree().getRoot();
                balls.push_back({poses[i] * own.center, own.radius + 0.5 * duration * bounds[i].at(own.center.norm())});
            }
        Ball all = balls.front();
        for (const Ball &ball : balls)
            all.radius = std::max(all.radius, (ball.center - all.center).norm() + ball.radius);
        return all;
    }

    void Roadmap::grow(unsigned int samples, Vertex most)
    {
        const OwnedState sample = newState(space_);
        for (; samples > 0 && size() < most; --samples)
        {
            sampler_->sampleUniform(sample.get());
            if (validator_.getChecker().isRobotFree(robot_, sample.get()))
                add(sample.get());
        }
    }

    std::vector<double> Roadmap::distancesTo(Vertex goal, std::vector<Vertex> *next) const
    {
        using Entry = std::pair<double, Vertex>;
        std::vector<double> distances(size(), std::numeric_limits<double>::infinity());
        std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
        distances[goal] = 0.0;
        queue.push({0.0, goal});
        if (next)
            next->assign(size(), goal);
        while (!queue.empty())
        {
            const auto [distance, vertex] = queue.top();
            queue.pop();
            if (distance > distances[vertex])
                continue;
            for (const Edge &edge : edges_[vertex])
                if (const double longer = distance + edge.length;
                    longer < distances[edge.to] && motions_[edge.motion].knowledge != Knowledge::BLOCKED)
                {
                    distances[edge.to] = longer;
                    queue.push({longer, edge.to});
                    if (next)
                        (*next)[edge.to] = vertex;
                }
        }
        return distances;
    }

    bool Roadmap::isPathFree(Vertex start, Vertex goal, const std::vector<Vertex> &next)
    {
        bool isFreeSoFar = true;
        // All of it is checked: what is blocked near the end would be found later anyway.
        for (Vertex vertex = start; vertex != goal; vertex = next[vertex])
        {
            const auto isUsable = [&](const Edge &edge)
            { return edge.to == next[vertex] && motions_[edge.motion].knowledge != Knowledge::BLOCKED; };
            const auto edge = std::find_if(edges_[vertex].begin(), edges_[vertex].end(), isUsable);
            isFreeSoFar = edge != edges_[vertex].end() && isFree(vertex, *edge) && isFreeSoFar;
        }
        return isFreeSoFar;
    }

    bool Roadmap::connect(Vertex start, Vertex goal, unsigned int iterations,
                          const ob::PlannerTerminationCondition &condition)
    {
        while (!condition)
        {
            std::vector<Vertex> next;
            const std::vector<double> distances = distancesTo(goal, &next);
            if (!std::isfinite(distances[start]))
                return plan(start, goal, iterations, condition);
            if (isPathFree(start, goal, next))
                return true;
        }
        return false;
    }

    bool Roadmap::plan(Vertex start, Vertex goal, unsigned int iterations,
                       const ob::PlannerTerminationCondition &condition)
    {
        if (!search_ || searched_ != std::pair(start, goal))
        {
            const ob::SpaceInformationPtr si = makeRobotSpaceInformation(validator_, robot_);
            auto problem = std::make_shared<ob::ProblemDefinition>(si);
            problem->setStartAndGoalStates(ob::ScopedState<>(si->getStateSpace(), states_[start]),
                                           ob::ScopedState<>(si->getStateSpace(), states_[goal]));
            const Robot &robot = validator_.getChecker().getTeam().getRobot(robot_);
            search_ = std::make_unique<LimitedRRTConnect>(problem, "Roadmap of robot '" + robot.getName() + "'",
                                                          robot.getPlannerRange(), iterations);
            searched_ = {start, goal};
        }
        const auto path = search_->search(condition);
        if (path || search_->isOver())
            search_.reset();
        if (!path)
            return false;
        Vertex last = start;
        for (unsigned int i = 1; i < path->getStateCount(); ++i)
        {
            const Vertex next = i + 1 < path->getStateCount() ? add(path->getState(i)) : goal;
            join(last, next, Knowledge::FREE);
            last = next;
        }
        return true;
    }
}
