#ifndef OMPL_CERTIFICATES_PLANNING_TEAM_ROADMAPS_
#define OMPL_CERTIFICATES_PLANNING_TEAM_ROADMAPS_

#include "Roadmap.h"

#include <unordered_map>

namespace ompl_certificates
{
    /** \brief The roadmaps of a team, and what is known of its robots' motions against each other. Robots that are
        alike share a roadmap.

        A vertex of the roadmaps' tensor product has a vertex for each robot. In a step, each robot takes an edge of its
        roadmap, all in the same time, or stays.

        @par External documentation
        K. Solovey, O. Salzman, D. Halperin, Finding a needle in an exponential haystack: discrete RRT for exploration
        of implicit roadmaps in multi-robot motion planning, 2016. */
    class TeamRoadmaps
    {
    public:
        using Vertex = Roadmap::Vertex;

        /** \brief A vertex of the tensor product: one for each robot */
        using Configuration = std::vector<Vertex>;

        /** \brief Configurations of the team, one after each step */
        using Path = std::vector<Configuration>;

        /** \brief Empty roadmaps
            \param shares whether there is one for all robots that are alike, or one for each robot
            \param threads how many threads let them grow; 0 for as many as there are cores */
        TeamRoadmaps(const CertificateMotionValidator &validator, bool shares, unsigned int threads);

        unsigned int getRobotCount() const
        {
            return static_cast<unsigned int>(roadmapOf_.size());
        }

        Roadmap &getRoadmap(unsigned int robot)
        {
            return *roadmaps_[roadmapOf_[robot]];
        }

        const Roadmap &getRoadmap(unsigned int robot) const
        {
            return *roadmaps_[roadmapOf_[robot]];
        }

        /** \brief The roadmaps, each once */
        const std::vector<std::unique_ptr<Roadmap>> &getRoadmaps() const
        {
            return roadmaps_;
        }

        /** \brief How fast a robot moves along edges; see TeamStateSpace::setSpeed() */
        double getSpeed(unsigned int robot) const
        {
            return speeds_[robot];
        }

        /** \brief Add a free state of the team */
        Configuration add(const ompl::base::State *state);

        /** \brief Let each roadmap grow by \e count vertices, but to no more than \e most, until \e condition becomes
            true. Then another call finishes that growth. The number of threads changes nothing but the time.
            \return whether it is finished */
        bool grow(std::uint64_t count, Vertex most, const ompl::base::PlannerTerminationCondition &condition);

        /** \brief Whether two robots stay apart while each takes an edge of its roadmap, both of which are free.
            Checked once, then remembered, up to 10^7 such motions. */
        bool areApart(unsigned int first, Vertex firstFrom, const Roadmap::Edge &firstEdge, unsigned int second,
                      Vertex secondFrom, const Roadmap::Edge &secondEdge);

        /** \brief Whether the team may go from one configuration to another in a step: all edges exist and are free,
            and all robots stay apart */
        bool isStepFree(const Configuration &from, const Configuration &to);

        /** \brief How many motions were found to be blocked: it grows when distances may have changed */
        std::size_t countBlocked() const;

        /** \brief Note that a robot is not free in a step, though Roadmap::isFree() said so */
        void refute(unsigned int robot, Vertex from, Vertex to);

        /** \brief Note that two robots do not stay apart, though areApart() said so */
        void refute(unsigned int first, Vertex firstFrom, Vertex firstTo, unsigned int second, Vertex secondFrom,
                    Vertex secondTo);

        /** \brief Write the state of the team at \e configuration to \e state */
        void copyTo(const Configuration &configuration, ompl::base::State *state) const;

        /** \brief How many motions of two robots are remembered */
        std::size_t getRememberedPairMotions() const
        {
            return pairMotions_.size();
        }

    private:
        /** \brief A motion of two robots: the roadmap and the motion of either, and whether one of them is reversed */
        struct PairMotion
        {
            std::uint64_t first, second;
            bool isReversed;

            bool operator==(const PairMotion &other) const
            {
                return first == other.first && second == other.second && isReversed == other.isReversed;
            }
        };

        struct Hash
        {
            std::size_t operator()(const PairMotion &motion) const;
        };

        /** \brief The same for the robots in the other order and for the reverse motion */
        PairMotion keyOf(unsigned int first, Vertex firstFrom, const Roadmap::Edge &firstEdge, unsigned int second,
                         Vertex secondFrom, const Roadmap::Edge &secondEdge) const;

        const CertificateMotionValidator &validator_;
        const unsigned int threads_;
        /** \brief How far a roadmap is to grow */
        struct Growth
        {
            Roadmap *roadmap;
            Vertex most;
            /** \brief How many samples are left for it */
            std::uint64_t samples;
        };

        std::vector<std::unique_ptr<Roadmap>> roadmaps_;
        /** \brief Those that are not finished */
        std::vector<Growth> growths_;
        std::vector<unsigned int> roadmapOf_;
        std::vector<double> speeds_;
        /** \brief Whether the robots stay apart */
        std::unordered_map<PairMotion, bool, Hash> pairMotions_;
    };
}

#endif
