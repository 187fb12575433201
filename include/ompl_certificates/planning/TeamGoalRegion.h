#ifndef OMPL_CERTIFICATES_PLANNING_TEAM_GOAL_REGION_
#define OMPL_CERTIFICATES_PLANNING_TEAM_GOAL_REGION_

#include "ompl_certificates/robots/RobotGoal.h"
#include "ompl_certificates/validity/TeamValidityChecker.h"

#include <mutex>
#include <ompl/base/ScopedState.h>
#include <ompl/base/goals/GoalSampleableRegion.h>
#include <vector>

namespace ompl_certificates
{
    /** \brief The goal of a team some of whose robots shall go to a RobotGoal, such as a pose of an arm's hand, and the
        others to one state each.

        Planners take it that take an ompl::base::GoalSampleableRegion. Of OMPL's, BFMT, LazyLBTRRT and AITstar go wrong
        with several goals, and pSBL knows none of this kind: makePlanner() makes such that refuse it. LazyPRM,
        LazyPRMstar and FMT may hold on to one goal, which they do not always reach. */
    class TeamGoalRegion : public ompl::base::GoalSampleableRegion
    {
    public:
        /** \brief The goal of the team of \e si
            \param si has a TeamStateSpace and a TeamValidityChecker, so it is not that of a TeamControlSetup
            \param state a state of the goal: the first one that is sampled, and where robots without a RobotGoal go
            \param goals of the robots, in the team's order; null for those that go to \e state
            \throws ompl::Exception if \e si has another space or checker, there are not as many goals as robots, or
            \e state is not in the goal */
        TeamGoalRegion(const ompl::base::SpaceInformationPtr &si, const ompl::base::ScopedState<> &state,
                       std::vector<RobotGoalPtr> goals);

        /** \brief How many goals are sampled at most. BIT* and its kin sample all of them first. */
        static constexpr unsigned int MAX_SAMPLE_COUNT = 100;

        /** \brief The state of the goal that the constructor got */
        const ompl::base::ScopedState<> &getState() const
        {
            return state_;
        }

        /** \brief The goals of the robots; null for those that go to getState() */
        const std::vector<RobotGoalPtr> &getGoals() const
        {
            return goals_;
        }

        /** \brief The largest distance of a robot from its goal. Its space's distance counts if it goes to a state. */
        double distanceGoal(const ompl::base::State *state) const override;

        /** \brief Write a state of the goal in which the team is free: robot by robot, 20 states each are tried. Up to
            20 times a robot that finds no room is placed before the others. If none is found it is the state that the
            constructor got, which also is every tenth one. May be called from many threads at once. */
        void sampleGoal(ompl::base::State *state) const override;

        /** \brief The same by the numbers of \e random. The known state is one where no other is found. */
        void sampleGoal(ompl::RNG &random, ompl::base::State *state) const;

        /** \brief MAX_SAMPLE_COUNT */
        unsigned int maxSampleCount() const override
        {
            return MAX_SAMPLE_COUNT;
        }

    private:
        /** \brief Write a state of a robot's goal in which it is free, and apart from those that are \e placed
            \return false if none was found */
        bool sampleRobot(unsigned int robot, const std::vector<unsigned int> &placed, ompl::RNG &random,
                         ompl::base::State *state) const;

        const std::shared_ptr<const TeamValidityChecker> checker_;
        const ompl::base::ScopedState<> state_;
        const std::vector<RobotGoalPtr> goals_;
        mutable std::mutex sampling_;
        mutable ompl::RNG random_;
        mutable unsigned int samples_{0};
    };
}

#endif
