#ifndef OMPL_CERTIFICATES_TEAM_TEAM_
#define OMPL_CERTIFICATES_TEAM_TEAM_

#include "ompl_certificates/team/TeamStateSpace.h"

#include <ompl/base/spaces/WrapperStateSpace.h>
#include <vector>

namespace ompl_certificates
{
    /** \brief The robots of a state space, and where in its states each robot's own state is.

        The space may be
        - a TeamStateSpace,
        - an ompl::base::CompoundStateSpace with one component for each robot, in the robots' order,
        - the plain space of one robot, such as SE(2), SE(3) or R^n,
        - any of these in an ompl::base::WrapperStateSpace, such as an ompl::base::ProjectedStateSpace.

        A component need not be the robot's own space object, but must be of the same class. A class derived from
        SE2StateSpace, SE3StateSpace or RealVectorStateSpace will do for states, but not for motions; see
        interpolatesRobots(). So will a class derived from CompoundStateSpace or TeamStateSpace: it may interpolate as
        it likes. */
    class Team
    {
    public:
        /** \brief The team of a TeamStateSpace, which may be wrapped. The space is locked: no robot can be added later.
            \throws ompl::Exception if the space is another one, or has no robots */
        explicit Team(const ompl::base::StateSpacePtr &space);

        /** \brief The team of \e robots in any of the spaces above, which is locked
            \throws ompl::Exception if the space does not hold the states of these robots, if there are none, if one is
            null, or if their workspaces differ */
        Team(ompl::base::StateSpacePtr space, std::vector<RobotPtr> robots);

        /** \brief The space whose states are read */
        const ompl::base::StateSpacePtr &getStateSpace() const
        {
            return space_;
        }

        /** \brief The number of robots */
        unsigned int getRobotCount() const
        {
            return static_cast<unsigned int>(robots_.size());
        }

        /** \brief The robots */
        const std::vector<RobotPtr> &getRobots() const
        {
            return robots_;
        }

        /** \brief The robot number \e robot */
        const Robot &getRobot(unsigned int robot) const
        {
            return *robots_[robot];
        }

        /** \brief The space of a robot's own states: the component of the team's space */
        const ompl::base::StateSpace &getRobotSpace(unsigned int robot) const
        {
            return *spaces_[robot];
        }

        /** \brief The number of segments of a robot's motion, by the resolution of the team's space */
        unsigned int countSegments(unsigned int robot, const ompl::base::State *state1,
                                   const ompl::base::State *state2) const
        {
            return teamSpace_ ? teamSpace_->validSegmentCount(robot, state1, state2)
                              : spaces_[robot]->validSegmentCount(state1, state2);
        }

        /** \brief Require that the space knows its resolution: without it, motions have no samples.
            \throws ompl::Exception if it was not set up, as ompl::base::SpaceInformation::setup() does */
        void requireResolution() const;

        /** \brief The state of a robot within a state of the team's space. Costs a nanosecond. */
        const ompl::base::State *getRobotState(const ompl::base::State *state, unsigned int robot) const
        {
            state = unwrap(state);
            return isWhole_ ? state : state->as<ompl::base::CompoundState>()->components[robot];
        }

        /** \brief Where a robot's bodies begin among those of the team */
        std::size_t getFirstBody(unsigned int robot) const
        {
            return firstBody_[robot];
        }

        /** \brief The number of bodies of the team */
        std::size_t getBodyCount() const
        {
            return firstBody_.back();
        }

        /** \brief Whether a body, by its index among those of the team, may touch the obstacles; see
            Robot::mayTouchObstacles() */
        bool mayTouchObstacles(std::size_t body) const
        {
            return mayTouchObstacles_[body];
        }

        /** \brief The dimension of the workspace: 2 or 3 */
        unsigned int getWorkspaceDimension() const
        {
            return robots_.front()->getWorkspaceDimension();
        }

        /** \brief The z-interval of all bodies, for planar teams of meshes; see Body::getZInterval() */
        ZInterval getZInterval() const
        {
            return zIntervalOf(robots_);
        }

        /** \brief Whether the space moves each robot as its own space does, so that motion bounds hold. Not so for
            constrained spaces, for classes derived from CompoundStateSpace or TeamStateSpace, and for components of
            classes derived from the robots' spaces, such as DubinsStateSpace. A component of any class but those of
            R^n, SO(2), SO(3), SE(2), SE(3) and compounds of them must be the robot's own space: two may have different
            parameters. */
        bool interpolatesRobots() const
        {
            return interpolatesRobots_;
        }

        /** \brief Whether the way from one state to another is the way back, too. So it is in teams of spaces of R^n,
            SO(2), SO(3), SE(2) and SE(3), but not for curves such as those of ReedsSheppStateSpace. */
        bool isSymmetric() const
        {
            return isSymmetric_;
        }

        /** \brief The state in which references to certificates are kept, or null if the space's states keep none */
        const TeamStateSpace::StateType *getReferences(const ompl::base::State *state) const
        {
            return keepsReferences_ ? unwrap(state)->as<TeamStateSpace::StateType>() : nullptr;
        }

    private:
        /** \brief Find out how the states of \e inner, the space within all wrappers, hold those of the robots */
        void read(const ompl::base::StateSpacePtr &inner);

        /** \brief Note that \e component holds the states of a robot
            \throws ompl::Exception if it does not */
        void addSpace(const ompl::base::StateSpacePtr &component, const Robot &robot);

        const ompl::base::State *unwrap(const ompl::base::State *state) const
        {
            for (unsigned int i = 0; i < wrappers_; ++i)
                state = state->as<ompl::base::WrapperStateSpace::StateType>()->getState();
            return state;
        }

        ompl::base::StateSpacePtr space_;
        std::vector<RobotPtr> robots_;
        std::vector<ompl::base::StateSpacePtr> spaces_;
        std::vector<std::size_t> firstBody_;
        std::vector<bool> mayTouchObstacles_;
        /** \brief How many spaces wrap the one that holds the robots' states */
        unsigned int wrappers_{0};
        /** \brief Whether a state is that of the one robot, and not made up of components */
        bool isWhole_{false};
        /** \brief The space with the components if it is a TeamStateSpace, which may have a resolution of its own */
        const TeamStateSpace *teamSpace_{nullptr};
        bool keepsReferences_{false}, interpolatesRobots_{true}, isSymmetric_{false};
    };
}

#endif
