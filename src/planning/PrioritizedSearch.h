#ifndef OMPL_CERTIFICATES_PLANNING_PRIORITIZED_SEARCH_
#define OMPL_CERTIFICATES_PLANNING_PRIORITIZED_SEARCH_

#include "TeamRoadmaps.h"

#include <optional>

namespace ompl_certificates
{
    /** \brief Finds a path in the tensor product of a team's roadmaps robot by robot: each takes the quickest path in
        time that avoids those planned before. A robot that finds none moves to the front, and the search begins again.

        Not complete: some problems need robots that make way for others. Quick where it succeeds.

        @par External documentation
        M. Erdmann, T. Lozano-Pérez, On multiple moving objects, 1987; J. van den Berg, M. Overmars, Prioritized motion
        planning for multiple robots, 2005; D. Silver, Cooperative pathfinding, 2005. */
    class PrioritizedSearch
    {
    public:
        using Vertex = TeamRoadmaps::Vertex;

        /** \brief A search from \e start to \e goal, which must live longer, that tries so many \e orders of the robots
            \param distances for each robot, the distances of all vertices to its goal; see Roadmap::distancesTo(). They
            must live longer. */
        PrioritizedSearch(TeamRoadmaps &roadmaps, const TeamRoadmaps::Configuration &start,
                          const TeamRoadmaps::Configuration &goal, const std::vector<std::vector<double>> &distances,
                          unsigned int orders);

        /** \brief Try orders until one succeeds, all have failed, or \e condition becomes true. Then another call goes
            on from there.
            \return a path; none if there is none yet */
        std::optional<TeamRoadmaps::Path> search(const ompl::base::PlannerTerminationCondition &condition);

        /** \brief Whether all orders have failed */
        bool isOver() const
        {
            return orders_ == 0;
        }

    private:
        /** \brief What a robot does in a step */
        struct Move
        {
            Ball swept;
            unsigned int robot;
            Vertex from;
            const Roadmap::Edge *edge;
        };

        /** \brief Begin with the first robot of the order. */
        void begin();

        /** \brief Find robot's path in time around those that are planned
            \return whether there is one */
        bool plan(unsigned int robot, const ompl::base::PlannerTerminationCondition &condition);

        /** \brief How long a robot needs at least from a vertex to its goal; infinite if there is no way */
        double timeToGoal(unsigned int robot, Vertex vertex) const;

        /** \brief Whether a robot may take an edge in a step */
        bool isFree(unsigned int robot, Vertex from, const Roadmap::Edge &edge, std::size_t step);

        /** \brief The path of all robots, once they are planned */
        TeamRoadmaps::Path getPath() const;

        /** \brief Note the path of a robot, one vertex after each step */
        void keep(unsigned int robot, const std::vector<Vertex> &path);

        /** \brief What a robot does in a step if it stays at its goal */
        Move stayOf(unsigned int robot) const;

        TeamRoadmaps &roadmaps_;
        const TeamRoadmaps::Configuration &start_, &goal_;
        const std::vector<std::vector<double>> &distances_;
        /** \brief What the planned robots do in each step, until all have arrived; the last entry is how they stay */
        std::vector<std::vector<Move>> moves_;
        /** \brief How long each of these steps takes: as long as the robot that needs longest */
        std::vector<double> durations_;
        /** \brief The order that is tried, and how many of its robots are planned */
        std::vector<unsigned int> order_;
        std::size_t planned_{0};
        /** \brief How many orders are left, this one among them */
        unsigned int orders_;
    };
}

#endif
