#ifndef OMPL_CERTIFICATES_PLANNING_PRODUCT_TREE_
#define OMPL_CERTIFICATES_PLANNING_PRODUCT_TREE_

#include "StepChooser.h"

#include <boost/functional/hash.hpp>
#include <limits>
#include <ompl/base/OptimizationObjective.h>
#include <ompl/util/RandomNumbers.h>
#include <optional>

namespace ompl_certificates
{
    /** \brief dRRT*: a tree in the tensor product of a team's roadmaps, from the team's starts.

        Each iteration expands a vertex by one step of the team. As long as that leads closer to the goal, the next one
        continues there; else it begins at the vertex nearest to a random one. In a step the robots choose their edges
        in random order, those first that lead best to their targets. A new vertex gets the best parent around it, and
        becomes the parent of those to which it is the better way.

        @par External documentation
        R. Shome, K. Solovey, A. Dobson, D. Halperin, K. E. Bekris, dRRT*: Scalable and informed asymptotically-optimal
        multi-robot motion planning, 2020. */
    class ProductTree
    {
    public:
        using Vertex = TeamRoadmaps::Vertex;
        using Configuration = TeamRoadmaps::Configuration;

        /** \brief Where the team shall go, and for each robot the distances of all vertices to its goal */
        struct Goal
        {
            Configuration configuration;
            std::vector<std::vector<double>> distances;
        };

        ProductTree(ompl::base::SpaceInformationPtr si, ompl::base::OptimizationObjectivePtr objective,
                    TeamRoadmaps &roadmaps);
        ~ProductTree();

        ProductTree(const ProductTree &) = delete;
        ProductTree &operator=(const ProductTree &) = delete;

        /** \brief Add a root; a vertex that is there becomes one. */
        void addStart(const Configuration &start);

        /** \brief The goals from now on, with distances for roadmaps that have grown */
        void setGoals(std::vector<Goal> goals);

        const std::vector<Goal> &getGoals() const
        {
            return goals_;
        }

        /** \brief The cost of getPath() */
        ompl::base::Cost getCost() const;

        /** \brief Iterate until a better path is found, or \e condition becomes true
            \param iterations at most that many; counted down
            \return whether the tree has a path of lower cost than \e bound */
        bool grow(std::uint64_t &iterations, ompl::base::Cost bound,
                  const ompl::base::PlannerTerminationCondition &condition);

        /** \brief Add a path that begins at a start */
        void insert(const TeamRoadmaps::Path &path);

        /** \brief The best path to a goal; empty if there is none */
        TeamRoadmaps::Path getPath() const;

        /** \brief Remove an edge, if it is one of the tree, and all that follows it */
        void cut(const Configuration &from, const Configuration &to);

        /** \brief The states of the starts */
        std::vector<const ompl::base::State *> getStarts() const;

        /** \brief The states of the goals that the tree has reached */
        std::vector<const ompl::base::State *> getReachedGoals() const;

        /** \brief Call \e visit for each edge with the states of its ends */
        template <typename Visitor>
        void visitEdges(const Visitor &visit) const
        {
            for (const auto &[configuration, number] : numbers_)
                if (nodes_[number].parent != NONE)
                    visit(nodes_[nodes_[number].parent].state, nodes_[number].state);
        }

    private:
        using Number = std::uint32_t;

        static constexpr Number NONE = std::numeric_limits<Number>::max();

        struct Node
        {
            Configuration configuration;
            ompl::base::State *state;
            ompl::base::Cost cost;
            Number parent;
            std::vector<Number> children;
        };

        void expand(ompl::base::Cost bound);

        /** \brief A vertex of the tree near a random configuration */
        Number nearestToRandom();

        /** \brief Choose a target for each robot: the goal, or with some probability a random vertex */
        void chooseTargets(bool onlyGoals);

        /** \brief How good it is for a robot to take an edge; less is better */
        double rate(unsigned int robot, const Roadmap::Edge &edge) const;

        /** \brief Choose an edge for each robot by chooser_
            \return false if there is none for one */
        bool chooseStep(const Configuration &from);

        /** \brief Whether a path through a state of that cost may be better than \e bound */
        bool mayImprove(ompl::base::Cost bound, ompl::base::Cost cost, const ompl::base::State *state) const;

        /** \brief Add a vertex, or a better way to it
            \return its number; NONE if there is a \e bound, and it cannot lead to a path better than that */
        Number add(const Configuration &configuration, Number parent, std::optional<ompl::base::Cost> bound = {});

        /** \brief Take a vertex from its parent, if it has one. */
        void detach(Number node);
        void moveTo(Number node, Number parent, ompl::base::Cost cost);
        void lowerCosts(Number node);
        void remove(Number node);
        ompl::base::Cost costThrough(Number parent, const ompl::base::State *state) const;
        /** \brief The cost of the path that ends at a vertex */
        ompl::base::Cost costOfPathTo(Number node) const;
        /** \brief The goal with the best path, or NONE */
        Number bestGoal() const;

        const ompl::base::SpaceInformationPtr si_;
        const ompl::base::OptimizationObjectivePtr objective_;
        TeamRoadmaps &roadmaps_;
        ompl::RNG random_;
        std::vector<Goal> goals_;
        std::vector<ompl::base::State *> goalStates_;
        std::vector<Node> nodes_;
        std::unordered_map<Configuration, Number, boost::hash<Configuration>> numbers_;
        std::unique_ptr<ompl::NearestNeighbors<Number>> near_;
        /** \brief The vertex that the next iteration continues, or NONE */
        Number last_{NONE};
        /** \brief The present targets: a goal, and for each robot whether it goes there or to a random vertex */
        const Goal *goal_{nullptr};
        std::vector<Vertex> randomTargets_;
        std::vector<bool> goesToGoal_;
        StepChooser chooser_;
        ompl::base::State *target_;
    };
}

#endif
