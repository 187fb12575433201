#ifndef OMPL_CERTIFICATES_TEAM_TEAM_STATE_SPACE_
#define OMPL_CERTIFICATES_TEAM_TEAM_STATE_SPACE_

#include "ompl_certificates/neighbors/SearchableStateSpace.h"
#include "ompl_certificates/robots/Robot.h"

#include <atomic>
#include <cstdint>
#include <functional>
#include <limits>
#include <ompl/base/StateSpace.h>
#include <vector>

namespace ompl_certificates
{
    class SegmentCount;

    /** \brief The state space of a team: a CompoundStateSpace with one component per robot.

        The distance between two states is Euclidean over the robots by default, as in the paper's RD-dimensional space.
        With SUM, a program that used a CompoundStateSpace keeps its distances, ranges and trees; see Metric.

        Every state carries, for each body of each robot, a reference to a certificate that proved it free. References
        are hints. copyState(), cloneState() and interpolate() pass them on; sampling and deserialization clear them;
        serialization, equality and distance ignore them. */
    class TeamStateSpace : public SearchableStateSpace
    {
    public:
        /** \brief Which certificate a state refers to: a number whose meaning only the validity checker knows */
        using Reference = std::uint32_t;

        /** \brief Refers to no certificate */
        static constexpr Reference NO_REFERENCE = std::numeric_limits<Reference>::max();

        /** \brief A state of the team: the robots' states, and a certificate reference for each of their bodies */
        class StateType : public SearchableStateSpace::StateType
        {
        public:
            /** \brief The certificate that proved a body free, or NO_REFERENCE; bodies count through the whole team */
            Reference getReference(std::size_t body) const
            {
                return references_[body].load(std::memory_order_relaxed);
            }

            /** \brief Remember that \e certificate proved a body free. Part of the state's cache, not of its value: may
                be called on a constant state, and from many threads at once. */
            void setReference(std::size_t body, Reference certificate) const
            {
                references_[body].store(certificate, std::memory_order_relaxed);
            }

        private:
            friend class TeamStateSpace;

            /** The adjacent coordinates of all components that are R^n; they follow the state in its memory */
            const double *vectorValues() const
            {
                return reinterpret_cast<const double *>(this + 1);
            }

            std::atomic<Reference> *references_{nullptr};
        };

        /** \brief How the robots' weighted distances compose the team's */
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

        ~TeamStateSpace() override;

        /** \brief How the robots' distances compose the team's */
        Metric getMetric() const
        {
            return metric_;
        }

        /** \brief Add a robot; distances in its component count \e weight times.
            \throws ompl::Exception if \e robot is null, its name is taken, its workspace differs from the others',
            \e weight is negative or not finite, or the space is locked */
        void addRobot(const RobotPtr &robot, double weight = 1.0);

        /** \brief Set how fast a robot moves: so much of its own space's distance in one unit of time, 1 unless it is
            set. Times go by it: those of paths, see stateTimes(), and those that TeamObjective adds up. Distances,
            ranges and verdicts do not. Set it before objectives are made and planners set up.
            \throws ompl::Exception if \e speed is not from 1e-9 to 1e9, or there is no such robot */
        void setSpeed(unsigned int robot, double speed);

        /** \brief How fast a robot moves; see setSpeed(). The robot must be there. */
        double getSpeed(unsigned int robot) const
        {
            return speeds_[robot];
        }

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

        /** \brief The number of bodies of all robots */
        std::size_t getBodyCount() const
        {
            return bodyCount_;
        }

        /** \brief The dimension of the team's workspace: 2 or 3; 0 while there is no robot */
        unsigned int getWorkspaceDimension() const;

        /** \brief The z-interval of all robots' bodies, for planar teams of meshes; see Body::getZInterval() */
        ZInterval getZInterval() const;

        /** \brief Forget the certificate references of \e state */
        void clearReferences(const ompl::base::State *state) const;

        /** \brief Set the resolution of motions, as a fraction of each component's extent; see
            ompl::base::StateSpace. Other than in a CompoundStateSpace it is the team's own: the robots' spaces, which
            other teams may share, keep theirs. Only spaces of classes that OMPL does not have are changed. Takes effect
            with setup().
            \throws ompl::Exception if the fraction is not above 0 and below 1 */
        void setLongestValidSegmentFraction(double segmentFraction) override;

        /** \brief The number of segments of a motion: the largest of all robots; see ompl::base::StateSpace. Those of
            curves of Dubins and of Reeds and Shepp are counted along the curve. OMPL 1.5 counts along the straight
            way. As in OMPL's CompoundStateSpace, setValidSegmentCountFactor() of the team itself has no effect; that of
            a robot's space has. */
        unsigned int validSegmentCount(const ompl::base::State *state1, const ompl::base::State *state2) const override;

        /** \brief The number of segments of a motion of one robot, from a state of its component to another */
        unsigned int validSegmentCount(unsigned int robot, const ompl::base::State *state1,
                                       const ompl::base::State *state2) const;

        Composition getComposition() const override;

        /** \brief Whether the spaces of all robots are metric: not so with one of DubinsStateSpace */
        bool isMetricSpace() const override;

        /** \brief Whether the distances of all robots are as long on the way back */
        bool hasSymmetricDistance() const override;

        /** \brief Whether the spaces of all robots say that the way back is the same way */
        bool hasSymmetricInterpolate() const override;

        /** \brief The largest distance() of two states within the bounds */
        double getMaximumExtent() const override;

        /** \brief How long a step of a planner's tree should be at most: Robot::getPlannerRange() of all robots, in the
            team's metric. OMPL's own choice, a fifth of the extent, unless there are arms. */
        double getPlannerRange() const;

        /** \brief The distance in the team's metric; see Metric */
        double distance(const ompl::base::State *state1, const ompl::base::State *state2) const override;

        /** \brief Copy a state, with its references */
        void copyState(ompl::base::State *destination, const ompl::base::State *source) const override;

        /** \brief The state at \e t of the way, robot by robot, with the references of \e from */
        void interpolate(const ompl::base::State *from, const ompl::base::State *to, double t,
                         ompl::base::State *state) const override;

        /** \brief Read a state from what serialize() wrote; it refers to no certificates */
        void deserialize(ompl::base::State *state, const void *serialization) const override;

        /** \brief A state in one piece of memory, but for the components that are not R^n. Planners look at many
            states' coordinates, and mostly wait for memory. */
        ompl::base::State *allocState() const override;

        /** \brief Free what allocState() allocated */
        void freeState(ompl::base::State *state) const override;

        /** \brief A sampler of all robots' spaces, whose states refer to no certificates */
        ompl::base::StateSamplerPtr allocDefaultStateSampler() const override;

        /** \brief Registers a default projection for planners that need one. It maps the positions of all robots' first
            bodies to two coordinates (three for spatial teams), each of which every robot moves. */
        void registerProjections() override;

        /** \brief Sets up the robots' spaces that are not set up, and this one. Where nothing has changed since, the
            next call changes nothing that checks read: other threads may check meanwhile, and other teams may have the
            same robots. It draws the same random numbers each time.
            \throws ompl::Exception if the team has no robot, a robot that cannot move, only weights of 0, or a
            component that was not added by addRobot() */
        void setup() override;

        using CompoundStateSpace::sanityChecks;

        /** \brief As OMPL does. Of a team with a robot in a ReedsSheppStateSpace or a DubinsStateSpace it checks what
            OMPL does of both: their curves are not always the shortest ones from a point in between. */
        void sanityChecks() const override;

        /** \brief Finds where the values of a state are. Other than in a CompoundStateSpace it leaves the robots'
            spaces alone: each robot has done that for its own, which others may be reading. */
        void computeLocations() override;

    private:
        /** What a length of each robot makes together, in the team's metric and by its weights */
        double combine(const std::function<double(unsigned int)> &lengthOf) const;

        /** \brief Does what StateSpace::setup() does with projections, which infers the sizes of their cells anew. */
        void setUpProjections();

        void copyReferences(const StateType *destination, const StateType *source) const;

        const Metric metric_;
        std::vector<RobotPtr> robots_;
        std::vector<double> speeds_;
        /** The dimensions of the components that are R^n, 0 for others, and their sum. Distances are what planners ask
            for most; these need no virtual call. */
        std::vector<unsigned int> vectors_;
        std::size_t vectorSum_{0};
        std::size_t bodyCount_{0};
        /** Whether the resolution was set for the team, and was known in the last setup(). How the team counts the
            segments of each robot's motions, if it does not leave that to their spaces. */
        bool hasResolution_{false}, countsByResolution_{false};
        std::vector<SegmentCount> segmentCounts_;
    };

    /** \brief The z-interval of all bodies of \e robots; see Body::getZInterval() */
    ZInterval zIntervalOf(const std::vector<RobotPtr> &robots);

    /** \brief A shared pointer to a team's state space */
    using TeamStateSpacePtr = std::shared_ptr<TeamStateSpace>;
}

#endif
