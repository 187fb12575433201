#ifndef OMPL_CERTIFICATES_PLANNING_PRIORITIZED_SEARCH_
#define OMPL_CERTIFICATES_PLANNING_PRIORITIZED_SEARCH_

#include "TeamRoadmaps.h"

#include <optional>

namespace ompl_certificates
{
    /** \brief Finds a path in the tensor product of a team's roadmaps robot by robot: each takes the shortest path in time that
        avoids those planned before. A robot that finds none moves to the front, and the search begins again.

        Not complete: some problems need robots that make way for others. Quick where it succeeds.

        @par External documentation
        M. Erdmann, T. Lozano-Pérez, On multiple moving objects, 1987; J. van den Berg, M. Overmars, Prioritized motion
        planning for multiple robots, 2005; D. Silver, Cooperative pathfinding, 2005. */
    class PrioritizedSearch
    {
    public:
        using Vertex = TeamRoadmaps::Vertex;
        using Path = std::vector<TeamRoadmaps::Configuration>;

        PrioritizedSearch(TeamRoadmaps &roadmaps, TeamRoadmaps::Configuration start, TeamRoadmaps::Configuration goal);

        /** \brief Try orders of the robots until one succeeds, \e orders have failed, or \e condition becomes true
            \return the configurations of the team, step by step */
        std::optional<Path> search(unsigned int orders, const ompl::base::PlannerTerminationCondition &condition);

    private:
        /** \brief Find robot's path in time around those in planned_
            \return whether there is one */
        bool plan(unsigned int robot, const ompl::base::PlannerTerminationCondition &condition);

        /** \brief Whether a robot may take an edge in a step */
        bool isFree(unsigned int robot, Vertex from, const Roadmap::Edge &edge, std::size_t step);

        TeamRoadmaps &roadmaps_;
        const TeamRoadmaps::Configuration start_, goal_;
        std::vector<std::vector<double>> distances_;
        /** \brief The robots that have a path, and the path of each robot: the vertex after each step */
        std::vector<unsigned int> planned_;
        std::vector<std::vector<Vertex>> paths_;
        /** \brief The number of steps until all planned robots have arrived */
        std::size_t arrival_{0};
    };
}

#endif
