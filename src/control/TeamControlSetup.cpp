#include "ompl_certificates/control/TeamControlSetup.h"

#include "ompl_certificates/control/ControlPathSimplifier.h"
#include "ompl_certificates/control/ControlPlanners.h"
#include "ompl_certificates/control/LimitedValidityChecker.h"

#include <cmath>
#include <ompl/base/goals/GoalSampleableRegion.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/util/Console.h>
#include <ompl/util/Exception.h>
#include <ompl/util/Time.h>

namespace ompl_certificates
{
    namespace ob = ompl::base;

    namespace
    {
        /** The checker of this library that another one asks, or is; null if that is not known */
        const TeamValidityChecker *teamCheckerOf(const ob::StateValidityChecker *checker)
        {
            if (const auto *limited = dynamic_cast<const LimitedValidityChecker *>(checker))
                return limited->getTeamChecker().get();
            return dynamic_cast<const TeamValidityChecker *>(checker);
        }

        TeamStateSpacePtr teamSpaceOf(const std::shared_ptr<TeamValidityChecker> &checker)
        {
            if (!checker)
                throw ompl::Exception("A TeamControlSetup needs a TeamValidityChecker");
            auto space = std::dynamic_pointer_cast<TeamStateSpace>(checker->getTeam().getStateSpace());
            if (!space)
                throw ompl::Exception("A TeamControlSetup needs a checker whose space is a TeamStateSpace");
            return space;
        }
    }

    TeamControlSetup::TeamControlSetup(const TeamStateSpacePtr &team, const ObstaclesPtr &obstacles, Method method,
                                       CertificateMotionValidator::Mode mode)
      : SimpleSetup(TeamPropagator::makeControlSpace(team)), mode_(mode)
    {
        useChecker(std::make_shared<TeamValidityChecker>(getSpaceInformation(), obstacles, method));
    }

    TeamControlSetup::TeamControlSetup(const std::shared_ptr<TeamValidityChecker> &checker,
                                       CertificateMotionValidator::Mode mode)
      : SimpleSetup(TeamPropagator::makeControlSpace(teamSpaceOf(checker))), mode_(mode)
    {
        useChecker(checker);
    }

    void TeamControlSetup::useChecker(std::shared_ptr<TeamValidityChecker> checker)
    {
        checker_ = std::move(checker);
        const auto propagator = std::make_shared<TeamPropagator>(getSpaceInformation());
        propagator_ = propagator.get();
        if (mode_ == CertificateMotionValidator::CONTINUOUS)
            propagator->requireProof(checker_);
        setStatePropagator(propagator);
        setStateValidityChecker(std::make_shared<LimitedValidityChecker>(checker_));
        constexpr double step = 0.1;
        getSpaceInformation()->setPropagationStepSize(step);
        getSpaceInformation()->setMinMaxControlDuration(1, 10);
    }

    void TeamControlSetup::setNearestStructure(NearestStructure structure)
    {
        if (configured_)
            throw ompl::Exception("Choose the structure for near states before setup()");
        nearestStructure_ = structure;
    }

    void TeamControlSetup::choosePlanner()
    {
        // Whoever brings a propagator, a checker or a goal of another kind gets OMPL's choice.
        const bool isOurs =
            getStatePropagator().get() == propagator_ &&
            dynamic_cast<const LimitedValidityChecker *>(getSpaceInformation()->getStateValidityChecker().get()) &&
            dynamic_cast<const ob::GoalSampleableRegion *>(pdef_->getGoal().get());
        if (!planner_ && !pa_ && isOurs)
            planner_ =
                makeControlPlanner(defaultControlPlanner(checker_->getTeam().getRobotCount()), getSpaceInformation());
    }

    void TeamControlSetup::setup()
    {
        // OMPL would look into the goal to choose a planner, whether there is one or not.
        if (!planner_ && !pa_ && !pdef_->getGoal())
            throw ompl::Exception(
                "Set a goal or a planner before setup(). To check states, getSpaceInformation()->setup() "
                "is enough");
        // OMPL lets it pass, and finds nothing.
        if (const double step = getSpaceInformation()->getPropagationStepSize(); !std::isfinite(step))
            throw ompl::Exception("The propagation step size must be finite, not " + std::to_string(step));
        if (mode_ == CertificateMotionValidator::CONTINUOUS &&
            getSpaceInformation()->getStatePropagator().get() != propagator_)
            OMPL_WARN(
                "TeamControlSetup: steps are proved by the propagator of this setup, which another one has "
                "replaced. They are not proved unless that one does it, as by TeamPropagator::requireProof().");
        const auto *asked = teamCheckerOf(getSpaceInformation()->getStateValidityChecker().get());
        if (mode_ == CertificateMotionValidator::CONTINUOUS && asked && asked != checker_.get())
            OMPL_WARN(
                "TeamControlSetup: steps are proved with the validity checker of this setup, which another one has "
                "replaced. Give that to the propagator, too: TeamPropagator::requireProof().");
        choosePlanner();
        if (!pdef_->hasOptimizationObjective())
            pdef_->setOptimizationObjective(
                std::make_shared<ob::PathLengthOptimizationObjective>(getSpaceInformation()));
        SimpleSetup::setup();
        if (nearestStructure_ == NearestStructure::KD_TREE)
            useKdTree(*planner_);
    }

    ob::PlannerStatus TeamControlSetup::solve(double time)
    {
        return solve(ob::timedPlannerTerminationCondition(time));
    }

    ob::PlannerStatus TeamControlSetup::solve(const ob::PlannerTerminationCondition &condition)
    {
        SimpleSetup::solve(condition);
        if (last_status_ == ob::PlannerStatus::EXACT_SOLUTION && !haveExactSolutionPath())
            last_status_ = ob::PlannerStatus::APPROXIMATE_SOLUTION;
        return last_status_;
    }

    void TeamControlSetup::simplifySolution(double duration)
    {
        simplifySolution(duration > 0.0 ? ob::timedPlannerTerminationCondition(duration)
                                        : ob::plannerNonTerminatingCondition());
    }

    void TeamControlSetup::simplifySolution(const ob::PlannerTerminationCondition &condition)
    {
        if (!haveSolutionPath())
        {
            OMPL_WARN("%s: there is no solution to simplify", getStateSpace()->getName().c_str());
            return;
        }
        const auto start = ompl::time::now();
        ompl::control::PathControl &path = getSolutionPath();
        ControlPathSimplifier(si_, getGoal()).simplify(path, condition);
        // OMPL keeps each solution with its length and cost, by which it chooses the best one.
        ob::PlannerSolution simplified(nullptr);
        pdef_->getSolution(simplified);
        simplified.length_ = path.length();
        if (simplified.approximate_)
        {
            simplified.approximate_ = !getGoal()->isSatisfied(path.getStates().back(), &simplified.difference_);
            if (!simplified.approximate_)
            {
                simplified.difference_ = 0.0;
                last_status_ = ob::PlannerStatus::EXACT_SOLUTION;
            }
        }
        if (simplified.opt_)
            simplified.cost_ = path.asGeometric().cost(simplified.opt_);
        pdef_->clearSolutionPaths();
        pdef_->addSolutionPath(simplified);
        simplifyTime_ = ompl::time::seconds(ompl::time::now() - start);
    }
}
