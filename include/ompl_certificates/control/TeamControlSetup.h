#ifndef OMPL_CERTIFICATES_CONTROL_TEAM_CONTROL_SETUP_
#define OMPL_CERTIFICATES_CONTROL_TEAM_CONTROL_SETUP_

#include "ompl_certificates/control/TeamPropagator.h"
#include "ompl_certificates/neighbors/PlannerNeighbors.h"
#include "ompl_certificates/validity/CertificateMotionValidator.h"

#include <memory>
#include <ompl/control/SimpleSetup.h>

namespace ompl_certificates
{
    /** \brief ompl::control::SimpleSetup for a team of DynamicRobots. Propagator, validity checker and limits are in
        place. Steps take 0.1 s and a control is held for 1 to 10 of them, unless the space information is told
        otherwise. */
    class TeamControlSetup : public ompl::control::SimpleSetup
    {
    public:
        /** \brief A setup for \e team among \e obstacles
            \param mode CONTINUOUS to prove each step free between its ends; see TeamPropagator. Another propagator
            that you set must prove them itself: setup() warns of it.
            \throws ompl::Exception as TeamPropagator and TeamValidityChecker do */
        TeamControlSetup(const TeamStateSpacePtr &team, const ObstaclesPtr &obstacles,
                         Method method = Method::SHARED_PROJECTION,
                         CertificateMotionValidator::Mode mode = CertificateMotionValidator::DISCRETE);

        /** \brief A setup for the team of \e checker among the obstacles that it has, and what it knows of them: for
            another plan, with another goal or after a change. What this plan learns serves the next one, too.
            \throws ompl::Exception as above, and if \e checker is null or its space is no TeamStateSpace */
        explicit TeamControlSetup(const std::shared_ptr<TeamValidityChecker> &checker,
                                  CertificateMotionValidator::Mode mode = CertificateMotionValidator::DISCRETE);

        /** \brief Choose the structure in which RRT and SST search for near states. The default is a PlannerKdTree. It
            finds what a GNAT finds: trees are the same, but may differ where distances are exactly equal. Without it,
            most of a plan's time goes into the GNAT.
            \throws ompl::Exception if the planner is set up already, and so has its structure */
        void setNearestStructure(NearestStructure structure);

        /** \brief Set up the space information and the planner, and the planner's structure; see SimpleSetup. If no
            planner was chosen, it is that of defaultControlPlanner(), or OMPL's choice where propagator or checker were
            replaced, or no goal can be sampled. A problem without an objective gets OMPL's
            PathLengthOptimizationObjective, which SST would take with a warning.
            \throws ompl::Exception if there is neither a goal nor a planner, or the propagation step is not finite */
        void setup() override;

        /** \brief Plan for at most \e time seconds; see SimpleSetup. Where only an approximate solution was found, it
            says so: OMPL's Syclop planners call that exact. */
        ompl::base::PlannerStatus solve(double time = 1.0) override;

        /** \brief The same, until \e condition becomes true */
        ompl::base::PlannerStatus solve(const ompl::base::PlannerTerminationCondition &condition) override;

        /** \brief Shorten the time that the solution takes with a ControlPathSimplifier, for at most \e duration
            seconds (0: as long as it helps). What getSolutionPath() tells changes, and the solution's length and cost.
            A later solve() returns no path that is worse.
            \throws ompl::Exception as ControlPathSimplifier does, if parts of this setup were replaced */
        void simplifySolution(double duration = 0.0);

        /** \brief The same, until \e condition becomes true */
        void simplifySolution(const ompl::base::PlannerTerminationCondition &condition);

        /** \brief How many seconds the last call of simplifySolution() took */
        double getLastSimplificationTime() const
        {
            return simplifyTime_;
        }

        /** \brief The validity checker of the team, which ignores limits: the one that this setup made or was given,
            and proves steps with, also if the space information has another one now */
        const std::shared_ptr<TeamValidityChecker> &getTeamChecker() const
        {
            return checker_;
        }

        /** \brief How many checks there were, and how they were settled */
        Statistics &getStatistics() const
        {
            return checker_->getStatistics();
        }

    private:
        /** \brief Put propagator and checkers in place. */
        void useChecker(std::shared_ptr<TeamValidityChecker> checker);

        /** \brief Choose a planner if nobody has */
        void choosePlanner();

        const CertificateMotionValidator::Mode mode_;
        /** \brief The one that this setup made, which proves steps in continuous mode */
        const ompl::control::StatePropagator *propagator_{nullptr};
        std::shared_ptr<TeamValidityChecker> checker_;
        NearestStructure nearestStructure_{NearestStructure::KD_TREE};
        double simplifyTime_{0.0};
    };

    /** \brief A shared pointer to a setup */
    using TeamControlSetupPtr = std::shared_ptr<TeamControlSetup>;
}

#endif
