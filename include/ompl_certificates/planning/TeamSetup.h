#ifndef OMPL_CERTIFICATES_PLANNING_TEAM_SETUP_
#define OMPL_CERTIFICATES_PLANNING_TEAM_SETUP_

#include "ompl_certificates/neighbors/PlannerNeighbors.h"
#include "ompl_certificates/validity/CertificateMotionValidator.h"

#include <functional>
#include <ompl/geometric/SimpleSetup.h>
#include <string>

namespace ompl_certificates
{
    /** \brief ompl::geometric::SimpleSetup for a team. Its validity checker and motion validator are in place, the
        planner's tree is in a PlannerKdTree, and the default objective is the team's path length. Without setPlanner(),
        a DRRTstar plans for two or more robots, and RRTConnect for one; or for any number where states have a validity
        checker of your own, which DRRTstar cannot heed, whatever the motion validator is. It is chosen anew where such
        a checker, or a rule, comes or goes: so give another one by setPlanner(), not the one that was chosen. For a
        goal that cannot be sampled OMPL chooses.

        All of OMPL's geometric planners for one space and one problem run in it. setup() gives the problem the
        planner's defaultObjective(), unless setOptimizationObjective() gave it another.

        An ompl::tools::Benchmark has planners of its own. All of them get a TeamPathLength; PRM then uses all of the
        time, as it does after RRTstar in OMPL. They keep OMPL's GNATs unless its PreRunEvent calls prepare(). */
    class TeamSetup : public ompl::geometric::SimpleSetup
    {
    public:
        /** \brief A setup for \e team among \e obstacles
            \throws ompl::Exception like TeamValidityChecker, or if the continuous mode is asked of a method without
            certificates */
        TeamSetup(const TeamStateSpacePtr &team, const ObstaclesPtr &obstacles,
                  Method method = Method::SHARED_PROJECTION,
                  CertificateMotionValidator::Mode mode = CertificateMotionValidator::DISCRETE);

        /** \brief Choose the structure in which the planner searches for near states. The default is a PlannerKdTree.
            It finds what a GNAT finds, so trees are the same, but may differ where distances are exactly equal. A
            structure of another class than OMPL's GNATs is kept.
            \throws ompl::Exception if the planner is set up already, and so has its structure */
        void setNearestStructure(NearestStructure structure);

        /** \brief Set up the space information and the planner, and the planner's structure; see SimpleSetup
            \throws ompl::Exception if there is neither a goal nor a planner */
        void setup() override;

        /** \brief Prepare a planner that others run, such as one of an ompl::tools::Benchmark, as setup() does its own:
            set it up with the problem and a range for teams, and give it the structure for near states. One that is set
            up already keeps its range. It must be without a tree.
            \throws ompl::Exception if it is of another space information */
        void prepare(ompl::base::Planner &planner) const;

        /** \brief Plan for at most \e time seconds; see SimpleSetup. Returns when the planner has ended: OMPL's own
            function then waits for a thread of its own, up to a millisecond, which is longer than many plans take. */
        ompl::base::PlannerStatus solve(double time = 1.0) override;

        /** \brief Plan until \e condition becomes true; see SimpleSetup. Paths are of this setup's space, those of
            CForest, too, which plans in spaces of its own. */
        ompl::base::PlannerStatus solve(const ompl::base::PlannerTerminationCondition &condition) override;

        /** \brief Simplify the solution with OMPL's PathSimplifier, then robot by robot with a TeamPathSimplifier, for
            at most \e duration seconds (0: as long as it helps). The cost by the problem's objective never rises.
            Steps of ompl::geometric::SimpleSetup::simplifySolution() keep pieces of motions that were never checked by
            themselves. This keeps the last path that the motion validator accepts. It hides that function, which is not
            virtual: whoever has a SimpleSetup &, such as ompl::tools::Benchmark, calls OMPL's. */
        void simplifySolution(double duration = 0.0);

        /** \brief The same, until \e condition becomes true */
        void simplifySolution(const ompl::base::PlannerTerminationCondition &condition);

        /** \brief The team's space */
        const TeamStateSpace &getTeam() const
        {
            return *getStateSpace()->as<TeamStateSpace>();
        }

        /** \brief The validity checker of the team: that of the space information, if it is a TeamValidityChecker, such
            as one of a class derived from it that was set later; else the one that this setup made */
        std::shared_ptr<TeamValidityChecker> getTeamChecker() const
        {
            const auto checker = std::dynamic_pointer_cast<TeamValidityChecker>(si_->getStateValidityChecker());
            return checker ? checker : checker_;
        }

        /** \brief How many checks there were, and how they were settled; those of getTeamChecker() */
        Statistics &getStatistics() const
        {
            return getTeamChecker()->getStatistics();
        }

    private:
        /** \brief Add \e path to the solutions, with its own cost: a later solve() then returns no worse one. */
        void noteCostOf(const ompl::geometric::PathGeometric &path);

        /** \brief Make all solutions paths of this setup's space. */
        void takePathsOfForest();

        /** \brief Simplify \e path step by step. Undo a step that makes it invalid or raises its cost. */
        void simplifyInSteps(ompl::geometric::PathGeometric &path,
                             const std::function<bool(const ompl::geometric::PathGeometric &)> &isNoWorse,
                             const ompl::base::PlannerTerminationCondition &condition);

        /** \brief Choose a planner for the number of robots and the checkers, unless the user gave one. Chooses anew if
            these are others now. */
        void choosePlanner();

        /** \brief Give the problem the planner's default objective, unless the user gave it one. */
        void chooseObjective();

        std::shared_ptr<TeamValidityChecker> checker_;
        /** \brief What choosePlanner() chose last */
        ompl::base::PlannerPtr chosenPlanner_;
        /** \brief What chooseObjective() gave last */
        ompl::base::OptimizationObjectivePtr objective_;
        NearestStructure nearestStructure_{NearestStructure::KD_TREE};
    };

    /** \brief A shared pointer to a team's setup */
    using TeamSetupPtr = std::shared_ptr<TeamSetup>;
}

#endif
