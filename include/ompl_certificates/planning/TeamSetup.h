#ifndef OMPL_CERTIFICATES_PLANNING_TEAM_SETUP_
#define OMPL_CERTIFICATES_PLANNING_TEAM_SETUP_

#include "ompl_certificates/neighbors/PlannerNeighbors.h"
#include "ompl_certificates/validity/CertificateMotionValidator.h"

#include <ompl/geometric/SimpleSetup.h>
#include <string>

namespace ompl_certificates
{
    /** \brief ompl::geometric::SimpleSetup for a team: with its validity checker and motion validator in place, the
        planner's tree in a PlannerKdTree, and the team's path length to optimise.

        All of OMPL's geometric planners that take one space and one problem run in it. setup() gives the problem the
        planner's defaultObjective() unless setOptimizationObjective() gave it another one. In an ompl::tools::Benchmark,
        which sets up this class once, all planners get a TeamPathLength; PRM then plans for all of the time, as it does
        after RRTstar in OMPL. */
    class TeamSetup : public ompl::geometric::SimpleSetup
    {
    public:
        /** \brief A setup for \e team among \e obstacles
            \throws ompl::Exception as TeamValidityChecker does, or if the continuous mode is asked of a method without
            certificates */
        TeamSetup(const TeamStateSpacePtr &team, const ObstaclesPtr &obstacles,
                  Method method = Method::SHARED_PROJECTION,
                  CertificateMotionValidator::Mode mode = CertificateMotionValidator::DISCRETE);

        /** \brief Choose what the planner looks for near states in. By default it is a PlannerKdTree, which finds what a
            GNAT finds: trees are the same, but may differ where distances are exactly equal. A structure of another class
            than OMPL's GNATs that the planner was given is kept.
            \throws ompl::Exception if the planner is set up already, and has its structure */
        void setNearestStructure(NearestStructure structure);

        /** \brief Set up the space information and the planner, and the planner's structure; see SimpleSetup */
        void setup() override;

        /** \brief Simplify the solution with OMPL's PathSimplifier, for at most \e duration seconds (0: as long as it finds
            something to do). Unlike ompl::geometric::SimpleSetup::simplifySolution(), whose steps keep pieces of motions
            that were never checked by themselves, this keeps the last path that the motion validator accepts. */
        void simplifySolution(double duration = 0.0);

        /** \brief The same, until \e condition becomes true */
        void simplifySolution(const ompl::base::PlannerTerminationCondition &condition);

        /** \brief The team's space */
        const TeamStateSpace &getTeam() const
        {
            return *getStateSpace()->as<TeamStateSpace>();
        }

        /** \brief The validity checker of the team */
        const std::shared_ptr<TeamValidityChecker> &getTeamChecker() const
        {
            return checker_;
        }

        /** \brief What has been checked so far, and how */
        Statistics &getStatistics() const
        {
            return checker_->getStatistics();
        }

    private:
        /** \brief Simplify \e path step by step; a step whose path is refused, or longer, is taken back */
        void simplifyInSteps(ompl::geometric::PathGeometric &path,
                             const ompl::base::PlannerTerminationCondition &condition);

        /** \brief Give the problem the planner's default objective, unless it has one of the user's */
        void chooseObjective();

        std::shared_ptr<TeamValidityChecker> checker_;
        /** \brief What chooseObjective() gave last */
        ompl::base::OptimizationObjectivePtr objective_;
        NearestStructure nearestStructure_{NearestStructure::KD_TREE};
    };

    /** \brief A shared pointer to a team's setup */
    using TeamSetupPtr = std::shared_ptr<TeamSetup>;
}

#endif
