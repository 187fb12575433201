#ifndef OMPL_CERTIFICATES_CONTROL_CONTROL_PATH_SIMPLIFIER_
#define OMPL_CERTIFICATES_CONTROL_CONTROL_PATH_SIMPLIFIER_

#include "ompl_certificates/control/TeamPropagator.h"

#include <ompl/base/Goal.h>
#include <ompl/base/PlannerTerminationCondition.h>
#include <ompl/control/PathControl.h>
#include <ompl/control/SpaceInformation.h>
#include <ompl/util/RandomNumbers.h>

namespace ompl_certificates
{
    /** \brief Shortens the time that a team of DynamicRobots takes, by changing one robot's controls at a time.

        A part of a robot's way is replaced by controls that lead to the same state in fewer steps, found by Newton's
        method on DynamicRobot::propagate(): no steering function is needed. What follows comes earlier. First the
        robots are brought to the goal itself, if it is one state or several, and not only near it, as far as that is
        found. A change is kept if the robot then arrives earlier, or at the goal, and if its steps are valid among
        those of the others, which in continuous mode are proved free. A robot ends within 3e-5 of its space's extent of
        the goal, or else of where it ended before. Controls are held for as long as the space information tells; those
        of a team change whenever a robot's do. A robot that arrives before the others brakes and stays, as with
        PrioritizedRRT.

        The result is a local optimum: a robot keeps to its side of an obstacle, and of the other robots.

        @par External documentation
        K. Hauser, V. Ng-Thow-Hing, Fast smoothing of manipulator trajectories using optimal bounded-acceleration
        shortcuts, 2010 (shortcuts); J. Betts, Survey of numerical methods for trajectory optimization, 1998 (shooting).
        */
    class ControlPathSimplifier
    {
    public:
        /** \brief A simplifier for paths of \e si. Needs a TeamStateSpace, a TeamPropagator, and a
            LimitedValidityChecker or a TeamValidityChecker; all of them are in place in a TeamControlSetup.
            \param goal the goal of the paths; null if they end where they should
            \throws ompl::Exception if one of these is missing, the checker is for other robots, or \e si is not set
            up */
        explicit ControlPathSimplifier(ompl::control::SpaceInformationPtr si, ompl::base::GoalPtr goal = nullptr);

        /** \brief Change a valid path as long as that helps, or until \e condition becomes true. The path never takes
            longer than before. It ends when 200 changes for each robot have failed one after the other; that mostly
            takes some tenths of a second.
            \throws ompl::Exception if a duration is no whole number of propagation steps
            \return whether the path has changed */
        bool simplify(ompl::control::PathControl &path, const ompl::base::PlannerTerminationCondition &condition);

    private:
        const ompl::control::SpaceInformationPtr si_;
        const ompl::base::GoalPtr goal_;
        ompl::RNG random_;
    };
}

#endif
