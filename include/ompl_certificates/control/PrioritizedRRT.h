#ifndef OMPL_CERTIFICATES_CONTROL_PRIORITIZED_RRT_
#define OMPL_CERTIFICATES_CONTROL_PRIORITIZED_RRT_

#include "ompl_certificates/control/TeamPropagator.h"

#include <ompl/base/Planner.h>
#include <ompl/control/SpaceInformation.h>
#include <ompl/util/RandomNumbers.h>
#include <string>

namespace ompl_certificates
{
    /** \brief A planner for teams of DynamicRobots that plans robot by robot: RRT in the state and the time of one robot,
        around those planned before.

        OMPL's control planners search the space of the whole team, where few controls bring all robots forward at once.
        Here a tree grows for each robot. An iteration tries some controls from the state nearest to a sample, and keeps
        the one that comes nearest to it. From some of the new states it shoots: it looks for controls that lead from
        there to the goal, by Newton's method on DynamicRobot::propagate(). A robot that reaches its goal brakes, and
        stays there until all others have arrived; DynamicRobot::computeBrake() tells how. One that finds no way moves
        to the front of the order, and planning begins anew.

        Not complete: some problems need robots that make way for others. A robot that cannot stop, or whose goal has
        more speed than the tolerance allows at rest, finds no way. The planner ends with the first path, which is not
        the quickest; see ControlPathSimplifier. Controls are held for as long as the space information tells until a
        robot brakes; those of the team change whenever a robot's do. The path is checked as a whole by the space
        information's propagator and validity checker, which in continuous mode prove its steps.

        Needs a TeamStateSpace, a TeamPropagator, and a LimitedValidityChecker or a TeamValidityChecker; all of them are
        in place in a TeamControlSetup. Of the goal's threshold each robot gets its share. The first start counts, and
        each order tries another goal if there are more.

        @par External documentation
        M. Erdmann, T. Lozano-Pérez, On multiple moving objects, 1987; S. LaValle, J. Kuffner, Randomized kinodynamic
        planning, 2001. */
    class PrioritizedRRT : public ompl::base::Planner
    {
    public:
        /** \brief A planner for the team of \e si */
        explicit PrioritizedRRT(const ompl::control::SpaceInformationPtr &si);

        /** \throws ompl::Exception if space, propagator or validity checker are none that the planner can use */
        void setup() override;

        /** \brief Forget the solution */
        void clear() override;

        /** \brief Try orders of the robots until one gives a path, or \e condition becomes true. Each call begins
            anew. */
        ompl::base::PlannerStatus solve(const ompl::base::PlannerTerminationCondition &condition) override;

        /** \brief The states of the solution, one after the other. The trees are not of the team's states. */
        void getPlannerData(ompl::base::PlannerData &data) const override;

        /** \brief How often a tree grows towards the goal, not towards a random state; 0.15 by default. Parameter
            goal_bias.
            \throws ompl::Exception if it is not from 0 to 1 */
        void setGoalBias(double bias);

        /** \brief See setGoalBias() */
        double getGoalBias() const
        {
            return goalBias_;
        }

        /** \brief How often a robot's tree grows before another order is tried; 5000 by default, and more when all
            robots have been first. Parameter iterations.
            \throws ompl::Exception if it is 0 */
        void setIterations(unsigned int iterations);

        /** \brief See setIterations() */
        unsigned int getIterations() const
        {
            return iterations_;
        }

        /** \brief The name of the robot that found no way in the last order that solve() tried to the end; empty if there
            was none, or one led to a path */
        const std::string &getStuckRobot() const
        {
            return stuckRobot_;
        }

    private:
        const ompl::control::SpaceInformation *const controlSpaceInformation_;
        ompl::RNG random_;
        double goalBias_{0.15};
        unsigned int iterations_{5000};
        /** \brief The last solution */
        ompl::base::PathPtr path_;
        std::string stuckRobot_;
    };
}

#endif
