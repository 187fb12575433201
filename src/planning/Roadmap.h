#ifndef OMPL_CERTIFICATES_PLANNING_ROADMAP_
#define OMPL_CERTIFICATES_PLANNING_ROADMAP_

#include "Swept.h"

#include "ompl_certificates/validity/CertificateMotionValidator.h"

#include <cstdint>
#include <memory>
#include <ompl/base/PlannerTerminationCondition.h>
#include <ompl/base/StateSampler.h>
#include <ompl/datastructures/NearestNeighbors.h>
#include <utility>
#include <vector>

namespace ompl_certificates
{
    class LimitedRRTConnect;

    /** \brief A roadmap for one robot, or for several that are alike: PRM* in the robot's own space, by the team's
        checker.

        Each vertex is joined to the k(n) nearest ones; k(n) grows with the logarithm of the number of vertices, so that
        shortest paths approach the shortest free path. Motions are checked when they are first needed.

        @par External documentation
        S. Karaman, E. Frazzoli, Sampling-based algorithms for optimal motion planning, 2011, section 3.3; R. Bohlin,
        L. Kavraki, Path planning using Lazy PRM, 2000. */
    class Roadmap
    {
    public:
        using Vertex = std::uint32_t;

        /** \brief A motion between two vertices, or a stay at one, by its number */
        using Motion = std::uint32_t;

        /** \brief A way from a vertex to another one, or to itself */
        struct Edge
        {
            Vertex to;
            Motion motion;
            double length;
        };

        /** \brief An empty roadmap for robot number \e robot of the team */
        Roadmap(const CertificateMotionValidator &validator, unsigned int robot);
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

        /** \brief The distance between two vertices */
        double distance(Vertex a, Vertex b) const
        {
            return space_.distance(states_[a], states_[b]);
        }

        /** \brief The edges from a vertex, those included that isFree() refuses. The first one is to stay there. */
        const std::vector<Edge> &getEdges(Vertex vertex) const
        {
            return edges_[vertex];
        }

        /** \brief The edge from a vertex to another one, or to itself; null if there is none */
        const Edge *findEdge(Vertex from, Vertex to) const;

        /** \brief Balls that contain the robot during a motion that is free. Those of the quarters go from the vertex
            of lower number to that of the higher one. */
        const Swept &getSwept(Motion motion) const
        {
            return swept_[motions_[motion].swept];
        }

        /** \brief Whether the robot touches no obstacle along an edge from \e from. Checked once, then remembered. */
        bool isFree(Vertex from, const Edge &edge);

        /** \brief How many motions were found to be blocked */
        std::size_t countBlocked() const
        {
            return blocked_;
        }

        /** \brief Note that an edge is not free, though isFree() said so */
        void refute(const Edge &edge);

        /** \brief Note that a motion is not within getSwept(): from then on, that is without bounds */
        void forgetSwept(Motion motion);

        /** \brief Add a copy of a free state, and join it to those around it. An equal vertex is taken if there is
            one. */
        Vertex add(const ompl::base::State *state);

        /** \brief Draw \e samples states, and add those that are free until there are \e most vertices. Other roadmaps
            of the team may grow at the same time in other threads. */
        void grow(unsigned int samples, Vertex most);

        /** \brief Find a free path between two vertices. If the roadmap has none, RRTConnect looks for one with at most
            \e iterations, and its path becomes part of the roadmap. If \e condition ends that, the next call for these
            vertices goes on.
            \return whether there is a path */
        bool connect(Vertex start, Vertex goal, unsigned int iterations,
                     const ompl::base::PlannerTerminationCondition &condition);

        /** \brief The lengths of the shortest paths from all vertices to \e goal along motions that are not known to
            be blocked; infinite where there is none. Cost: that of Dijkstra's algorithm.
            \param next if not null: set to the vertex that comes next on each of these paths */
        std::vector<double> distancesTo(Vertex goal, std::vector<Vertex> *next = nullptr) const;

    private:
        enum class Knowledge : std::uint8_t
        {
            UNCHECKED,
            FREE,
            BLOCKED
        };

        struct MotionData
        {
            Knowledge knowledge;
            /** \brief Its number in swept_, if it is free */
            std::uint32_t swept;
        };

        void join(Vertex a, Vertex b, Knowledge knowledge);

        /** \brief Check the path from \e start to \e goal, given the vertex that comes next after each
            \return whether all of it is free */
        bool isPathFree(Vertex start, Vertex goal, const std::vector<Vertex> &next);

        /** \brief Add a path of RRTConnect
            \return whether there is one */
        bool plan(Vertex start, Vertex goal, unsigned int iterations,
                  const ompl::base::PlannerTerminationCondition &condition);

        /** \brief Note that a motion is free, and what it sweeps */
        void setFree(Motion motion, Vertex a, Vertex b);

        /** \brief A ball that contains the robot in the part of a motion whose middle is at \e time, and which takes
            \e duration, of the motion's time from 0 to 1 */
        Ball sweptBy(const ompl::base::State *from, const ompl::base::State *to, double time, double duration) const;

        const CertificateMotionValidator &validator_;
        const unsigned int robot_;
        const ompl::base::StateSpace &space_;
        ompl::base::StateSamplerPtr sampler_;
        /** \brief What looks for a way between two vertices, if it was stopped; else null */
        std::unique_ptr<LimitedRRTConnect> search_;
        std::pair<Vertex, Vertex> searched_;
        std::vector<ompl::base::State *> states_;
        std::vector<std::vector<Edge>> edges_;
        std::vector<MotionData> motions_;
        std::vector<Swept> swept_;
        std::size_t blocked_{0};
        std::unique_ptr<ompl::NearestNeighbors<Vertex>> near_;
        ompl::base::State *sample_;
    };
}

#endif
