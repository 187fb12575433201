#include "TeamRoadmaps.h"

#include <algorithm>
#include <boost/functional/hash.hpp>

namespace ompl_certificates
{
    namespace ob = ompl::base;

    TeamRoadmaps::TeamRoadmaps(const TeamValidityChecker &checker) : checker_(checker)
    {
        const auto &robots = checker.getTeam().getRobots();
        std::vector<unsigned int> owners;  // The first robot of each roadmap
        for (unsigned int robot = 0; robot < robots.size(); ++robot)
        {
            const auto alike = std::find_if(owners.begin(), owners.end(),
                                            [&](unsigned int owner) { return robots[owner]->isLike(*robots[robot]); });
            roadmapOf_.push_back(static_cast<unsigned int>(alike - owners.begin()));
            if (alike == owners.end())
            {
                owners.push_back(robot);
                roadmaps_.push_back(std::make_unique<Roadmap>(checker, robot));
            }
        }
    }

    TeamRoadmaps::Configuration TeamRoadmaps::add(const ob::State *state)
    {
        Configuration configuration;
        for (unsigned int robot = 0; robot < getRobotCount(); ++robot)
            configuration.push_back(getRoadmap(robot).add(checker_.getTeam().getRobotState(state, robot)));
        return configuration;
    }

    bool TeamRoadmaps::grow(Vertex count, const ob::PlannerTerminationCondition &condition)
    {
        return std::all_of(roadmaps_.begin(), roadmaps_.end(),
                           [&](const auto &roadmap) { return roadmap->grow(count, condition); });
    }

    std::size_t TeamRoadmaps::Hash::operator()(const PairMotion &motion) const
    {
        return boost::hash_range(motion.begin(), motion.end());
    }

    TeamRoadmaps::PairMotion TeamRoadmaps::keyOf(unsigned int first, Vertex firstFrom, Vertex firstTo,
                                                 unsigned int second, Vertex secondFrom, Vertex secondTo) const
    {
        const Vertex a = roadmapOf_[first], b = roadmapOf_[second];
        return std::min({PairMotion{a, firstFrom, firstTo, b, secondFrom, secondTo},
                         PairMotion{a, firstTo, firstFrom, b, secondTo, secondFrom},
                         PairMotion{b, secondFrom, secondTo, a, firstFrom, firstTo},
                         PairMotion{b, secondTo, secondFrom, a, firstTo, firstFrom}});
    }

    bool TeamRoadmaps::areApart(unsigned int first, Vertex firstFrom, const Roadmap::Edge &firstEdge,
                                unsigned int second, Vertex secondFrom, const Roadmap::Edge &secondEdge)
    {
        const Ball &a = firstEdge.swept, &b = secondEdge.swept;
        const double reach = a.radius + b.radius;
        if ((a.center - b.center).squaredNorm() > 1.0001 * reach * reach)
            return true;
        const auto [entry, isNew] =
            motions_.try_emplace(keyOf(first, firstFrom, firstEdge.to, second, secondFrom, secondEdge.to), false);
        if (isNew)
        {
            const Roadmap &one = getRoadmap(first), &other = getRoadmap(second);
            entry->second =
                checker_.isPairMotionFree(first, one.getState(firstFrom), one.getState(firstEdge.to), second,
                                          other.getState(secondFrom), other.getState(secondEdge.to));
        }
        return entry->second;
    }

    void TeamRoadmaps::refute(unsigned int first, Vertex firstFrom, Vertex firstTo, unsigned int second,
                              Vertex secondFrom, Vertex secondTo)
    {
        motions_[keyOf(first, firstFrom, firstTo, second, secondFrom, secondTo)] = false;
    }

    void TeamRoadmaps::copyTo(const Configuration &configuration, ob::State *state) const
    {
        for (unsigned int robot = 0; robot < getRobotCount(); ++robot)
            checker_.getTeam().getRobotSpace(robot).copyState(state->as<ob::CompoundState>()->components[robot],
                                                              getRoadmap(robot).getState(configuration[robot]));
    }
}
