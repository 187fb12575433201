#ifndef OMPL_CERTIFICATES_TEAM_TEAM_OBJECTIVE_
#define OMPL_CERTIFICATES_TEAM_TEAM_OBJECTIVE_

#include <ompl/base/OptimizationObjective.h>
#include <ompl/base/ScopedState.h>
#include <string>
#include <vector>

namespace ompl_certificates
{
    /** \brief Costs of a team's path that look at each robot. A robot's length is measured by its own space's distance.

        Times assume that no robot moves faster than its TeamStateSpace::getSpeed() when the objective is made. A motion
        of the team takes as long as the robot needs that needs longest. TeamPathLength is the length of the path in the
        team's space. */
    class TeamObjective : public ompl::base::OptimizationObjective
    {
    public:
        /** \brief What is added up */
        enum Kind
        {
            /// The lengths of all robots' paths
            SUM_OF_LENGTHS,
            /// The time until the last robot has arrived
            MAKESPAN,
            /// The times that all robots are on their way; a robot at its goal costs nothing
            SUM_OF_ARRIVAL_TIMES
        };

        /** \brief An objective for the team of \e si
            \throws ompl::Exception if the space is not a CompoundStateSpace of robots: not for an SE2StateSpace or an
            SE3StateSpace, which is one robot's; also for SUM_OF_ARRIVAL_TIMES, which needs the goal */
        TeamObjective(const ompl::base::SpaceInformationPtr &si, Kind kind);

        /** \brief The same; \e goal is where the robots arrive */
        TeamObjective(const ompl::base::SpaceInformationPtr &si, Kind kind, const ompl::base::ScopedState<> &goal);

        /** \brief 0: states cost nothing */
        ompl::base::Cost stateCost(const ompl::base::State *state) const override;

        /** \brief The cost of a motion of the team */
        ompl::base::Cost motionCost(const ompl::base::State *from, const ompl::base::State *to) const override;

        /** \brief A lower bound of the cost of any path between two states */
        ompl::base::Cost motionCostHeuristic(const ompl::base::State *from, const ompl::base::State *to) const override;

    private:
        TeamObjective(const ompl::base::SpaceInformationPtr &si, Kind kind,
                      std::vector<ompl::base::ScopedState<>> goal);

        /** \brief A lower bound of the cost to the nearest state of \e goal; 0 for other goals. BIT* finds next to
            nothing without it. */
        ompl::base::Cost costToGoal(const ompl::base::State *state, const ompl::base::Goal *goal) const;

        double distance(unsigned int robot, const ompl::base::State *from, const ompl::base::State *to) const;

        /** \brief How long a robot needs at least */
        double time(unsigned int robot, const ompl::base::State *from, const ompl::base::State *to) const;

        /** \brief Whether a robot is at its goal */
        bool hasArrived(unsigned int robot, const ompl::base::State *state) const;

        const Kind kind_;
        std::vector<const ompl::base::StateSpace *> spaces_;
        std::vector<double> speeds_;
        /** \brief The goal, if it is known */
        std::vector<ompl::base::ScopedState<>> goal_;
    };

    /** \brief The names that programs give to objectives: length (TeamPathLength), sum, makespan and arrival */
    std::vector<std::string> objectiveNames();

    /** \brief The objective of that name
        \throws ompl::Exception if there is none, or as TeamObjective::TeamObjective() */
    ompl::base::OptimizationObjectivePtr makeObjective(const std::string &name,
                                                       const ompl::base::SpaceInformationPtr &si,
                                                       const ompl::base::ScopedState<> &goal);
}

#endif
