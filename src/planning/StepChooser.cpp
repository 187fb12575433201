#include "StepChooser.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ompl_certificates
{
    StepChooser::StepChooser(TeamRoadmaps &roadmaps)
      : roadmaps_(roadmaps), chosen_(roadmaps.getRobotCount()), isStuck_(roadmaps.getRobotCount())
    {
    }

    void StepChooser::begin(const Configuration &from)
    {
        from_ = &from;
        std::fill(chosen_.begin(), chosen_.end(), nullptr);
        std::fill(isStuck_.begin(), isStuck_.end(), false);
    }

    bool StepChooser::choose(unsigned int robot, const Roadmap::Edge &edge)
    {
        if (!fits(robot, edge))
            return false;
        chosen_[robot] = &edge;
        return true;
    }

    bool StepChooser::complete(const std::vector<unsigned int> &order, const Rating &rate)
    {
        // Those that are in the way of what was chosen before go first.
        for (unsigned int robot = 0; robot < chosen_.size(); ++robot)
            if (chosen_[robot] && !makeWay(robot, rate))
                return false;
        return std::all_of(order.begin(), order.end(),
                           [&](unsigned int robot) { return chosen_[robot] || chooseBest(robot, rate); });
    }

    StepChooser::Configuration StepChooser::getEnd() const
    {
        Configuration end;
        end.reserve(chosen_.size());
        for (const Roadmap::Edge *edge : chosen_)
            end.push_back(edge->to);
        return end;
    }

    bool StepChooser::fits(unsigned int robot, const Roadmap::Edge &edge)
    {
        const Configuration &from = *from_;
        if (!roadmaps_.getRoadmap(robot).isFree(from[robot], edge))
            return false;
        for (unsigned int other = 0; other < from.size(); ++other)
            if (other != robot && chosen_[other] &&
                !roadmaps_.areApart(robot, from[robot], edge, other, from[other], *chosen_[other]))
                return false;
        return true;
    }

    bool StepChooser::makeWay(unsigned int robot, const Rating &rate)
    {
        const Configuration &from = *from_;
        std::vector<unsigned int> inTheWay;
        for (unsigned int other = 0; other < from.size(); ++other)
            if (!chosen_[other])
            {
                const Roadmap::Edge &stay = roadmaps_.getRoadmap(other).getEdges(from[other]).front();
                if (roadmaps_.areApart(robot, from[robot], *chosen_[robot], other, from[other], stay))
                    continue;
                if (isStuck_[other])
                    return false;
                inTheWay.push_back(other);
            }
        return std::all_of(inTheWay.begin(), inTheWay.end(),
                           [&](unsigned int other)
                           { return chosen_[other] || (!isStuck_[other] && chooseBest(other, rate)); });
    }

    bool StepChooser::chooseBest(unsigned int robot, const Rating &rate)
    {
        std::vector<std::pair<double, const Roadmap::Edge *>> edges;
        for (const Roadmap::Edge &edge : roadmaps_.getRoadmap(robot).getEdges((*from_)[robot]))
            if (const double rating = rate(robot, edge); std::isfinite(rating))
                edges.emplace_back(rating, &edge);
        // A robot stays only if no way is as good: going on along a shortest path rates as staying does.
        std::rotate(edges.begin(), edges.begin() + (edges.empty() ? 0 : 1), edges.end());
        std::stable_sort(edges.begin(), edges.end(), [](const auto &a, const auto &b) { return a.first < b.first; });
        for (const auto &[rating, edge] : edges)
        {
            if (!fits(robot, *edge))
                continue;
            const std::vector<const Roadmap::Edge *> before = chosen_;
            chosen_[robot] = edge;
            if (makeWay(robot, rate))
                return true;
            chosen_ = before;
        }
        isStuck_[robot] = true;
        return false;
    }
}
