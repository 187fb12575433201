#ifndef OMPL_CERTIFICATES_ROBOTS_ANY_OF_GOALS_
#define OMPL_CERTIFICATES_ROBOTS_ANY_OF_GOALS_

#include "ompl_certificates/robots/Robot.h"
#include "ompl_certificates/robots/RobotGoal.h"

#include <ompl/base/ScopedState.h>
#include <vector>

namespace ompl_certificates
{
    /** \brief Several goals of a robot, any of which will do: docks, grasps, or the states of an arm that an inverse
        kinematics of your own found. */
    class AnyOfGoals : public RobotGoal
    {
    public:
        /** \brief The union of states and of other goals
            \param robot the robot whose goals they are
            \param states the coordinates of states, in the order of ompl::base::StateSpace::copyToReals()
            \param goals other goals of that robot
            \throws ompl::Exception that names the robot: if it is null, if there are neither states nor goals, if a
            state has another number of coordinates, is not finite or is out of the bounds, or if a goal is null */
        AnyOfGoals(const RobotPtr &robot, const std::vector<std::vector<double>> &states,
                   std::vector<RobotGoalPtr> goals = {});

        /** \brief The distance to the nearest of them; to a state it is that of the robot's space */
        double distance(const ompl::base::State *state) const override;

        /** \brief See RobotGoal: a state of one that is drawn at random, each as often as the others. If none is found
            in it, of another one. */
        bool sample(ompl::RNG &random, ompl::base::State *state) const override;

        /** \brief Whether all the other goals are for \e robot, and states are of its space's kind */
        bool isFor(const Robot &robot) const override;

        /** \brief Such as: any of its 3 goals */
        std::string describe() const override;

    private:
        std::vector<ompl::base::ScopedState<>> states_;
        std::vector<RobotGoalPtr> goals_;
    };
}

#endif
