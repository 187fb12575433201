#ifndef OMPL_CERTIFICATES_PLANNING_LAZY_CONSTRAINT_SEARCH_
#define OMPL_CERTIFICATES_PLANNING_LAZY_CONSTRAINT_SEARCH_

#include "StepChooser.h"

#include <boost/functional/hash.hpp>
#include <limits>
#include <ompl/util/RandomNumbers.h>
#include <optional>
#include <unordered_map>

namespace ompl_certificates
{
    /** \brief LaCAM: a depth-first search in the tensor product of a team's roadmaps, for any path, in a crowd.

        From each configuration the search goes on by one step at a time. In a step robots go towards their goals, those
        first that have been on their way for longest, and the others make way. Whenever the search comes back to a
        configuration, a step from there is constrained anew: first one robot has to take a given edge, later two, and
        so on. So in the end all steps are tried, and the search is complete.

        @par External documentation
        K. Okumura, LaCAM: Search-based algorithm for quick multi-agent pathfinding, 2023. */
    class LazyConstraintSearch
    {
    public:
        using Configuration = TeamRoadmaps::Configuration;

        /** \brief A search from \e start to \e goal. Cost: that of Dijkstra's algorithm for each robot. */
        LazyConstraintSearch(TeamRoadmaps &roadmaps, const Configuration &start, const Configuration &goal);

        /** \brief Try that many \e steps, in all calls together; another call goes on from there
            \return a path; none if the steps are used up, there is no path, \e condition becomes true, or the search
            has taken some 500 MB */
        std::optional<TeamRoadmaps::Path> search(std::uint64_t steps,
                                                 const ompl::base::PlannerTerminationCondition &condition);

        /** \brief Whether another call could find nothing: the steps are used up, there is no path, or no memory */
        bool isOver(std::uint64_t steps) const
        {
            return step_ > steps || stack_.empty() || isFull();
        }

        /** \brief The path to the configuration, among those found, from which the robots have the least way to go in
            sum. Cost: linear in the number of configurations. */
        TeamRoadmaps::Path getNearest() const;

    private:
        using Number = std::uint32_t;

        static constexpr Number NONE = std::numeric_limits<Number>::max();

        /** \brief A robot has to take an edge, besides what the parent says */
        struct Constraint
        {
            Number parent;
            unsigned int robot, depth;
            const Roadmap::Edge *edge;
        };

        struct Node
        {
            Configuration configuration;
            Number parent;
            /** \brief For how many steps each robot has been on its way */
            std::vector<double> priorities;
            /** \brief The robots, those of the highest priority first */
            std::vector<unsigned int> order;
            /** \brief Constraints of the steps from here; those before \e next were tried */
            std::vector<Number> constraints;
            std::size_t next;
        };

        void add(Configuration configuration, Number parent);

        /** \brief Take the next constraint of a node, and add to the node those that constrain one more robot
            \return its number */
        Number takeConstraint(Node &node);

        /** \brief Choose a step from a node under a constraint; it is chooser_'s
            \return whether there is one */
        bool chooseStep(const Node &node, Number constraint);

        /** \brief Bring distances_ up to date if motions were found to be blocked */
        void updateDistances();

        /** \brief Whether each robot alone can reach its goal by motions that are not known to be blocked */
        bool isSolvable() const;

        /** \brief Whether the search has taken all the memory that it may take */
        bool isFull() const;

        TeamRoadmaps::Path pathTo(Number node) const;

        TeamRoadmaps &roadmaps_;
        const Configuration goal_;
        /** \brief For each robot, the distances of all vertices to its goal; as of \e knownBlocked_ blocked motions */
        std::vector<std::vector<double>> distances_;
        std::optional<std::size_t> knownBlocked_;
        StepChooser chooser_;
        ompl::RNG random_;
        std::vector<Node> nodes_;
        std::vector<Constraint> constraints_;
        std::unordered_map<Configuration, Number, boost::hash<Configuration>> numbers_;
        /** \brief The nodes from the start to where the search is */
        std::vector<Number> stack_;
        /** \brief The number of the next step */
        std::uint64_t step_{1};
    };
}

#endif
