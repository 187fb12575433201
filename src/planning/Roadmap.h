#ifndef OMPL_CERTIFICATES_PLANNING_ROADMAP_
#define OMPL_CERTIFICATES_PLANNING_ROADMAP_

#include "ompl_certificates/geometry/Ball.h"
#include "ompl_certificates/validity/TeamValidityChecker.h"

#include <cstdint>
#include <memory>
#include <ompl/base/PlannerTerminationCondition.h>
#include <ompl/base/StateSampler.h>
#include <ompl/datastructures/NearestNeighbors.h>
#include <vector>

namespace ompl_certificates
{
    /** \brief A roadmap for one robot, or for several that are alike: PRM* in the robot's own space, by the team's checker.

        Each vertex is joined to the k(n) nearest ones by the motions that are free; k(n) grows with the logarithm of the
        number of vertices, so that shortest paths approach the shortest free path.

        @par External documentation
        S. Karaman, E. Frazzoli, Sampling-based algorithms for optimal motion planning, 2011, section 3.3. */
    class Roadmap
    {
    public:
        using Vertex = std::uint32_t;

        /** \brief A motion to another vertex */
        struct Edge
        {
            Vertex to;
            double length;

            /** \brief A ball of the workspace that contains the robot for all of the motion */
            Ball swept;
        };

        /** \brief An empty roadmap for robot number \e robot of \e checker's team */
        Roadmap(const TeamValidityChecker &checker, unsigned int robot);
        ~Roadmap();

        Roadmap(const Roadmap &) = delete;
        Roadmap &operator=(const Roadmap &) = delete;

        /** \brief The number of vertices */
        Vertex size() const
        {
            return static_cast<Vertex>(states_.size());
        }

        /** \brief The state of a vertex */
        const ompl::base::State *getState(Vertex vertex) const
        {
            return states_[vertex];
        }

        /** \brief The motions from a vertex; the first one is to stay there */
        const std::vector<Edge> &getEdges(Vertex vertex) const
        {
            return edges_[vertex];
        }

        /** \brief Add a copy of a free state, and join it to those around it */
        Vertex add(const ompl::base::State *state);

        /** \brief Sample and add \e count more free states
            \return false if \e condition became true before */
        bool grow(Vertex count, const ompl::base::PlannerTerminationCondition &condition);

        /** \brief Remove the motion between two vertices, in both directions */
        void remove(Vertex a, Vertex b);

        /** \brief The lengths of the shortest paths from all vertices to \e goal; infinite where there is none. Cost: that of
            Dijkstra's algorithm. */
        std::vector<double> distancesTo(Vertex goal) const;

    private:
        /** \brief The motion between two vertices, if the robot stays free */
        void join(Vertex a, Vertex b);

        Ball sweptBy(const ompl::base::State *from, const ompl::base::State *to) const;

        const TeamValidityChecker &checker_;
        const unsigned int robot_;
        const ompl::base::StateSpace &space_;
        ompl::base::StateSamplerPtr sampler_;
        std::vector<ompl::base::State *> states_;
        std::vector<std::vector<Edge>> edges_;
        std::unique_ptr<ompl::NearestNeighbors<Vertex>> near_;
        ompl::base::State *sample_;
    };
}

#endif
