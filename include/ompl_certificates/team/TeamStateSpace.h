#ifndef OMPL_CERTIFICATES_TEAM_TEAM_STATE_SPACE_
#define OMPL_CERTIFICATES_TEAM_TEAM_STATE_SPACE_

#include "ompl_certificates/neighbors/SearchableStateSpace.h"
#include "ompl_certificates/robots/Robot.h"

#include <atomic>
#include <cstdint>
#include <limits>
#include <ompl/base/StateSpace.h>
#include <vector>

namespace ompl_certificates
{
    /** \brief The state space of a team: a CompoundStateSpace with one component per robot.

        The distance between two states is Euclidean over the robots by default, as in the paper's RD-dimensional space. A
        program that used a CompoundStateSpace keeps its distances, ranges and trees with SUM; see Metric.

        Every state carries, for each robot, a reference to a certificate that proved it free. References are hints:
        copyState(), cloneState() and interpolate() pass them on, sampling and deserialization clear them, and
        serialization, equality and distance ignore them. */
    class TeamStateSpace : public SearchableStateSpace
    {
    public:
        /** \brief Which certificate a state refers to: a number that the validity checker knows the meaning of */
        using Reference = std::uint32_t;

        /** \brief Refers to no certificate */
        static constexpr Reference NO_REFERENCE = std::numeric_limits<Reference>::max();

        /** \brief A state of the team: the robots' states, and a certificate reference for each robot. */
        class StateType : public SearchableStateSpace::StateType
        {
        public:
            /** \brief The certificate that proved robot \e robot free, or NO_REFERENCE */
            Reference getReference(unsigned int robot) const
            {
                return references_[robot].load(std::memory_order_relaxed);
            }

            /** \brief Remember that \e certificate proved robot \e robot free. Part of the state's cache, not of its value, so
                it may be called on a constant state and from many threads at once. */
            void setReference(unsigned int robot, Reference certificate) const
            {
                references_[robot].store(certificate, std::memory_order_relaxed);
            }

        private:
            friend class TeamStateSpace;

            /** The coordinates of all components that are R^n, side by side: they follow the state in its memory. */
            const double *vectorValues() const
            {
                return reinterpret_cast<const double *>(this + 1);
            }

            std::atomic<Reference> *references_{nullptr};
        };

        /** \brief How the robots' weighted distances make up the team's */
        enum Metric
        {
            /// The root of the sum of their squares
            EUCLIDEAN,
            /// Their sum: the distances and extents of an ompl::base::CompoundStateSpace of the same components and
            /// weights, to the last bit
            SUM
        };

        /** \brief A team without robots */
        explicit TeamStateSpace(Metric metric = EUCLIDEAN);

        /** \brief How the robots' distances make up the team's */
        Metric getMetric() const
        {
            return metric_;
        }

        /** \brief Add a robot; distances in its component count \e weight times
            \throws ompl::Exception if \e robot is null, if its name is taken, if its workspace is not the others', if
            \e weight is negative or not finite, or if the space is locked */
        void addRobot(const RobotPtr &robot, double weight = 1.0);

        /** \brief The number of robots */
        unsigned int getRobotCount() const
        {
            return static_cast<unsigned int>(robots_.size());
        }

        /** \brief The robots, in the order of the components */
        const std::vector<RobotPtr> &getRobots() const
        {
            return robots_;
        }

        /** \brief The robot of component \e index; see getRobots() */
        const Robot &getRobot(unsigned int index) const
        {
            return *robots_[index];
        }

        /** \brief The dimension of the team's workspace: 2 or 3; 0 while there is no robot */
        unsigned int getWorkspaceDimension() const;

        /** \brief The heights that the robots' bodies reach from and to, for planar teams of meshes; see Body::getZInterval() */
        ZInterval getZInterval() const;

        /** \brief Forget the certificate references of \e state */
        void clearReferences(const ompl::base::State *state) const;

        Composition getComposition() const override;

        /** \brief The largest distance() of two states within the bounds */
        double getMaximumExtent() const override;

        /** \brief The distance in the team's metric; see Metric */
        double distance(const ompl::base::State *state1, const ompl::base::State *state2) const override;

        /** \brief Copy a state, with its references */
        void copyState(ompl::base::State *destination, const ompl::base::State *source) const override;

        /** \brief The state at \e t of the way, robot by robot, with the references of \e from */
        void interpolate(const ompl::base::State *from, const ompl::base::State *to, double t,
                         ompl::base::State *state) const override;

        /** \brief Read a state from what serialize() wrote; it refers to no certificates */
        void deserialize(ompl::base::State *state, const void *serialization) const override;

        /** \brief A state in one piece of memory, but for the components that are not R^n: planners look at many states'
            coordinates, and most of that is waiting for memory. */
        ompl::base::State *allocState() const override;

        /** \brief Free what allocState() allocated */
        void freeState(ompl::base::State *state) const override;

        /** \brief A sampler of all robots' spaces, whose states refer to no certificates */
        ompl::base::StateSamplerPtr allocDefaultStateSampler() const override;

        /** \brief Registers a default projection for planners that need one: the positions of all robots' first bodies,
            combined into two (three for spatial teams) coordinates that every robot moves */
        void registerProjections() override;

        /** \throws ompl::Exception if the team has no robot, or a component that was not added by addRobot() */
        void setup() override;

    private:
        void copyReferences(const StateType *destination, const StateType *source) const;

        const Metric metric_;
        std::vector<RobotPtr> robots_;
        /** The dimensions of the components that are R^n, 0 for others, and their sum. Planners ask for distances more than
            for anything else, and those need no virtual call. */
        std::vector<unsigned int> vectors_;
        std::size_t vectorSum_{0};
    };

    /** \brief A shared pointer to a team's state space */
    using TeamStateSpacePtr = std::shared_ptr<TeamStateSpace>;
}

#endif
