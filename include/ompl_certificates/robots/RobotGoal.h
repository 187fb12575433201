#ifndef OMPL_CERTIFICATES_ROBOTS_ROBOT_GOAL_
#define OMPL_CERTIFICATES_ROBOTS_ROBOT_GOAL_

#include "ompl_certificates/robots/Robot.h"

#include <memory>
#include <ompl/base/State.h>
#include <ompl/util/RandomNumbers.h>
#include <string>

namespace ompl_certificates
{
    /** \brief Where one robot of a team shall go, if that is more than one state: such as all states in which an arm
        has its hand at a pose. TeamGoalRegion makes the goal of a team from such goals.

        Derive from this class to bring your own kind of goal. Its functions may be called from many threads
        at once. */
    class RobotGoal
    {
    public:
        virtual ~RobotGoal() = default;

        /** \brief How far \e state of the robot's space is from the goal; 0 for all states of the goal, and for them
            alone. In any unit. */
        virtual double distance(const ompl::base::State *state) const = 0;

        /** \brief Write a state of the goal to \e state, within the bounds of the robot's space. Collisions do not
            matter.
            \return false if none was found. What is in \e state then means nothing. */
        virtual bool sample(ompl::RNG &random, ompl::base::State *state) const = 0;

        /** \brief Whether the goal is one of \e robot: whether its states mean to this robot what they mean to the
            goal. A robot may be made anew, such as with an object in its hand. True by default. */
        virtual bool isFor(const Robot & /*robot*/) const
        {
            return true;
        }

        /** \brief What messages call the goal */
        virtual std::string describe() const
        {
            return "its goal";
        }
    };

    /** \brief A shared pointer to a robot's goal */
    using RobotGoalPtr = std::shared_ptr<const RobotGoal>;
}

#endif
