#include "TeamRoadmaps.h"

#include "ompl_certificates/team/PathTimes.h"

#include <algorithm>
#include <boost/functional/hash.hpp>
#include <future>
#include <thread>

namespace ompl_certificates
{
    namespace ob = ompl::base;

    namespace
    {
        /** How many samples a roadmap draws before the condition is asked */
        constexpr unsigned int BATCH = 100;

        /** How many samples may be drawn for each vertex by which a roadmap shall grow: a robot that is hardly ever
            free, or has few states, must not keep others waiting. */
        constexpr std::uint64_t SAMPLES_PER_VERTEX = 100;

        /** How many motions of two robots are remembered; they take some 700 MB */
        constexpr std::size_t MOST_PAIR_MOTIONS = 10'000'000;
    }

    TeamRoadmaps::TeamRoadmaps(const CertificateMotionValidator &validator, bool shares, unsigned int threads)
      : validator_(validator), threads_(threads > 0 ? threads : std::max(1U, std::thread::hardware_concurrency()))
    {
        const auto &robots = validator.getChecker().getTeam().getRobots();
        std::vector<unsigned int> owners;  // The first robot of each roadmap
        for (unsigned int robot = 0; robot < robots.size(); ++robot)
        {
            speeds_.push_back(speedOf(*validator.getChecker().getSpaceInformation()->getStateSpace(), robot));
            const auto alike =
                std::find_if(owners.begin(), owners.end(),
                             [&](unsigned int owner) { return shares && robots[owner]->isLike(*robots[robot]); });
            roadmapOf_.push_back(static_cast<unsigned int>(alike - owners.begin()));
            if (alike == owners.end())
            {
                owners.push_back(robot);
                roadmaps_.push_back(std::make_unique<Roadmap>(validator, robot));
            }
        }
    }

    TeamRoadmaps::Configuration TeamRoadmaps::add(const ob::State *state)
    {
        Configuration configuration;
        for (unsigned int robot = 0; robot < getRobotCount(); ++robot)
            configuration.push_back(
                getRoadmap(robot).add(validator_.getChecker().getTeam().getRobotState(state, robot)));
        return configuration;
    }

    bool TeamRoadmaps::grow(std::uint64_t count, Vertex most, const ob::PlannerTerminationCondition &condition)
    {
        std::vector<Growth> &open = growths_;
        if (open.empty())
            for (const auto &roadmap : roadmaps_)
                open.push_back({roadmap.get(),
                                static_cast<Vertex>(std::min<std::uint64_t>(roadmap->size() + count, most)),
                                SAMPLES_PER_VERTEX * count});
        const auto isDone = [](const Growth &growth)
        { return growth.roadmap->size() >= growth.most || growth.samples == 0; };
        // The condition is asked between batches alone, and as often for any number of threads.
        for (;;)
        {
            open.erase(std::remove_if(open.begin(), open.end(), isDone), open.end());
            if (open.empty() || condition)
                return open.empty();
            const std::size_t threads = std::min<std::size_t>(threads_, open.size());
            const auto growSome = [&open, threads](std::size_t first)
            {
                for (std::size_t i = first; i < open.size(); i += threads)
                {
                    open[i].roadmap->grow(BATCH, open[i].most);
                    open[i].samples -= std::min<std::uint64_t>(BATCH, open[i].samples);
                }
            };
            std::vector<std::future<void>> others;
            for (std::size_t i = 1; i < threads; ++i)
                others.push_back(std::async(std::launch::async, growSome, i));
            growSome(0);
            for (auto &other : others)
                other.get();
        }
    }

    std::size_t TeamRoadmaps::Hash::operator()(const PairMotion &motion) const
    {
        std::size_t hash = motion.isReversed;
        boost::hash_combine(hash, motion.first);
        boost::hash_combine(hash, motion.second);
        return hash;
    }

    TeamRoadmaps::PairMotion TeamRoadmaps::keyOf(unsigned int first, Vertex firstFrom, const Roadmap::Edge &firstEdge,
                                                 unsigned int second, Vertex secondFrom,
                                                 const Roadmap::Edge &secondEdge) const
    {
        const auto numberOf = [this](unsigned int robot, const Roadmap::Edge &edge)
        { return static_cast<std::uint64_t>(roadmapOf_[robot]) << 32U | edge.motion; };
        const std::uint64_t a = numberOf(first, firstEdge), b = numberOf(second, secondEdge);
        // Two that stay, or one, move the same way forwards and backwards.
        const bool bothMove = firstFrom != firstEdge.to && secondFrom != secondEdge.to;
        const bool isReversed = bothMove && (firstFrom < firstEdge.to) != (secondFrom < secondEdge.to);
        return {std::min(a, b), std::max(a, b), isReversed};
    }

    bool TeamRoadmaps::areApart(unsigned int first, Vertex firstFrom, const Roadmap::Edge &firstEdge,
                                unsigned int second, Vertex secondFrom, const Roadmap::Edge &secondEdge)
    {
        const Roadmap &one = getRoadmap(first), &other = getRoadmap(second);
        const Swept &a = one.getSwept(firstEdge.motion), &b = other.getSwept(secondEdge.motion);
        if (ompl_certificates::areApart(a.all, b.all) ||
            a.isApartFrom(b, (firstFrom < firstEdge.to) != (secondFrom < secondEdge.to)))
            return true;
        const PairMotion key = keyOf(first, firstFrom, firstEdge, second, secondFrom, secondEdge);
        if (const auto known = pairMotions_.find(key); known != pairMotions_.end())
            return known->second;
        const bool areApart =
            validator_.isPairMotionFree(first, one.getState(firstFrom), one.getState(firstEdge.to), second,
                                        other.getState(secondFrom), other.getState(secondEdge.to));
        if (pairMotions_.size() < MOST_PAIR_MOTIONS)
            pairMotions_.emplace(key, areApart);
        return areApart;
    }

    bool TeamRoadmaps::isStepFree(const Configuration &from, const Configuration &to)
    {
        std::vector<const Roadmap::Edge *> edges;
        for (unsigned int robot = 0; robot < getRobotCount(); ++robot)
        {
            edges.push_back(getRoadmap(robot).findEdge(from[robot], to[robot]));
            if (!edges.back())
                return false;
        }
        for (unsigned int i = 0; i < getRobotCount(); ++i)
        {
            if (!getRoadmap(i).isFree(from[i], *edges[i]))
                return false;
            for (unsigned int j = 0; j < i; ++j)
                if (!areApart(i, from[i], *edges[i], j, from[j], *edges[j]))
                    return false;
        }
        return true;
    }

    std::size_t TeamRoadmaps::countBlocked() const
    {
        std::size_t blocked = 0;
        for (const auto &roadmap : roadmaps_)
            blocked += roadmap->countBlocked();
        return blocked;
    }

    void TeamRoadmaps::refute(unsigned int robot, Vertex from, Vertex to)
    {
        getRoadmap(robot).refute(*getRoadmap(robot).findEdge(from, to));
    }

    void TeamRoadmaps::refute(unsigned int first, Vertex firstFrom, Vertex firstTo, unsigned int second,
                              Vertex secondFrom, Vertex secondTo)
    {
        const Roadmap::Edge &a = *getRoadmap(first).findEdge(firstFrom, firstTo);
        const Roadmap::Edge &b = *getRoadmap(second).findEdge(secondFrom, secondTo);
        pairMotions_[keyOf(first, firstFrom, a, second, secondFrom, b)] = false;
        // Where the way back is another curve, it may leave the balls around the way there, or these around the other.
        getRoadmap(first).forgetSwept(a.motion);
        getRoadmap(second).forgetSwept(b.motion);
    }

    void TeamRoadmaps::copyTo(const Configuration &configuration, ob::State *state) const
    {
        for (unsigned int robot = 0; robot < getRobotCount(); ++robot)
            validator_.getChecker().getTeam().getRobotSpace(robot).copyState(
                state->as<ob::CompoundState>()->components[robot], getRoadmap(robot).getState(configuration[robot]));
    }
}
