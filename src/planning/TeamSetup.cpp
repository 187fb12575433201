#include "ompl_certificates/planning/TeamSetup.h"

#include "ompl_certificates/planning/DRRTstar.h"
#include "ompl_certificates/planning/Planners.h"
#include "ompl_certificates/planning/TeamPathSimplifier.h"
#include "ompl_certificates/team/TeamPathLength.h"

#include <functional>
#include <ompl/base/goals/GoalSampleableRegion.h>
#include <ompl/geometric/planners/cforest/CForestStateSpaceWrapper.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/util/Console.h>
#include <ompl/util/Exception.h>
#include <ompl/util/Time.h>

namespace ompl_certificates
{
    namespace ob = ompl::base;
    namespace og = ompl::geometric;

    namespace
    {
        /** Whether the checkers know what this library's do, and no more, so that DRRTstar may ask for single robots */
        bool isAskedByRobots(const ob::SpaceInformationPtr &si)
        {
            const auto checker = std::dynamic_pointer_cast<const TeamValidityChecker>(si->getStateValidityChecker());
            const auto *validator = dynamic_cast<const CertificateMotionValidator *>(si->getMotionValidator().get());
            return checker && !CertificateMotionValidator(si, checker).getFurtherChecker() &&
                   !(validator && validator->getFurtherChecker());
        }

        const ob::State *endOf(const og::PathGeometric &path)
        {
            return path.getState(static_cast<unsigned int>(path.getStateCount() - 1));
        }
    }

    TeamSetup::TeamSetup(const TeamStateSpacePtr &team, const ObstaclesPtr &obstacles, Method method,
                         CertificateMotionValidator::Mode mode)
      : SimpleSetup(team), checker_(std::make_shared<TeamValidityChecker>(si_, obstacles, method))
    {
        setStateValidityChecker(checker_);
        si_->setMotionValidator(std::make_shared<CertificateMotionValidator>(checker_, mode));
        // Planners that others set up, as OMPL's Benchmark does, would make one that knows no teams.
        objective_ = std::make_shared<TeamPathLength>(si_);
        pdef_->setOptimizationObjective(objective_);
    }

    void TeamSetup::simplifySolution(double duration)
    {
        simplifySolution(duration > 0.0 ? ob::timedPlannerTerminationCondition(duration)
                                        : ob::plannerNonTerminatingCondition());
    }

    void TeamSetup::simplifySolution(const ob::PlannerTerminationCondition &condition)
    {
        if (!haveSolutionPath())
        {
            OMPL_WARN("%s: there is no solution to simplify", getTeam().getName().c_str());
            return;
        }
        const auto start = ompl::time::now();
        og::PathGeometric &solution = getSolutionPath();
        const ob::OptimizationObjectivePtr objective = pdef_->hasOptimizationObjective()
                                                           ? pdef_->getOptimizationObjective()
                                                           : std::make_shared<TeamPathLength>(si_);
        const auto isAtGoal = [this](const og::PathGeometric &path) { return getGoal()->isSatisfied(endOf(path)); };
        // OMPL's simplifier may know a goal from before, and lead there.
        const bool wasAtGoal = isAtGoal(solution);
        const auto isNoWorse = [&](const og::PathGeometric &path)
        {
            return !objective->isCostBetterThan(solution.cost(objective), path.cost(objective)) &&
                   (!wasAtGoal || isAtGoal(path));
        };
        // SimpleSetup makes one with the goal that is given to itself, not to the problem.
        if (!psk_)
            psk_ = std::make_shared<og::PathSimplifier>(si_, getGoal());
        og::PathGeometric simplified = solution;
        psk_->simplify(simplified, condition);
        if (simplified.check() && isNoWorse(simplified))
            solution = simplified;
        else
            simplifyInSteps(solution, isNoWorse, condition);
        TeamPathSimplifier(si_, objective).simplify(solution, condition);
        noteCostOf(solution);
        simplifyTime_ = ompl::time::seconds(ompl::time::now() - start);
    }

    void TeamSetup::noteCostOf(const og::PathGeometric &path)
    {
        ob::PlannerSolution better(nullptr);
        if (!pdef_->getSolution(better))
            return;
        better.path_ = std::make_shared<og::PathGeometric>(path);
        better.length_ = path.length();
        if (better.approximate_)
        {
            better.approximate_ = !getGoal()->isSatisfied(endOf(path), &better.difference_);
            if (!better.approximate_)
            {
                better.difference_ = 0.0;
                lastStatus_ = ob::PlannerStatus::EXACT_SOLUTION;
            }
        }
        if (better.opt_)
        {
            better.cost_ = path.cost(better.opt_);
            better.optimized_ = better.optimized_ || better.opt_->isSatisfied(better.cost_);
        }
        pdef_->addSolutionPath(better);
    }

    void TeamSetup::simplifyInSteps(og::PathGeometric &path,
                                    const std::function<bool(const og::PathGeometric &)> &isNoWorse,
                                    const ob::PlannerTerminationCondition &condition)
    {
        const std::vector<std::function<void(og::PathGeometric &)>> steps{
            [this](og::PathGeometric &p) { psk_->reduceVertices(p); },
            [this](og::PathGeometric &p) { psk_->collapseCloseVertices(p); },
            [this](og::PathGeometric &p) { psk_->shortcutPath(p); },
            [this](og::PathGeometric &p) { psk_->smoothBSpline(p); }};
        for (const auto &step : steps)
        {
            if (condition)
                return;
            og::PathGeometric next = path;
            step(next);
            if (next.check() && isNoWorse(next))
                path = next;
        }
    }

    void TeamSetup::setNearestStructure(NearestStructure structure)
    {
        if (configured_)
            throw ompl::Exception("Choose the structure for near states before setup()");
        nearestStructure_ = structure;
    }

    void TeamSetup::choosePlanner()
    {
        // Other goals are left to OMPL's choice.
        if ((planner_ && planner_ != chosenPlanner_) || pa_ ||
            !dynamic_cast<ob::GoalSampleableRegion *>(pdef_->getGoal().get()))
            return;
        const bool byRobots = getTeam().getRobotCount() > 1 && isAskedByRobots(si_);
        if (planner_ && byRobots == (dynamic_cast<const DRRTstar *>(planner_.get()) != nullptr))
            return;
        if (byRobots)
            chosenPlanner_ = std::make_shared<DRRTstar>(si_);
        else
            chosenPlanner_ = std::make_shared<og::RRTConnect>(si_);
        planner_ = chosenPlanner_;
    }

    void TeamSetup::chooseObjective()
    {
        if (pdef_->hasOptimizationObjective() && pdef_->getOptimizationObjective() != objective_)
            return;
        // SimpleSetup would make it later, but in the same order.
        if (!planner_ && pa_)
        {
            si_->setup();
            planner_ = pa_(si_);
        }
        objective_ = planner_ ? defaultObjective(*planner_) : std::make_shared<TeamPathLength>(si_);
        pdef_->setOptimizationObjective(objective_);
    }

    ob::PlannerStatus TeamSetup::solve(double time)
    {
        return solve(ob::timedPlannerTerminationCondition(time));
    }

    ob::PlannerStatus TeamSetup::solve(const ob::PlannerTerminationCondition &condition)
    {
        const ob::PlannerStatus status = SimpleSetup::solve(condition);
        takePathsOfForest();
        return status;
    }

    void TeamSetup::takePathsOfForest()
    {
        std::vector<ob::PlannerSolution> solutions = pdef_->getSolutions();
        bool changed = false;
        for (ob::PlannerSolution &solution : solutions)
        {
            const auto *path = dynamic_cast<const og::PathGeometric *>(solution.path_.get());
            // Its states are those of the space that it wraps.
            if (!path ||
                !dynamic_cast<const ob::CForestStateSpaceWrapper *>(path->getSpaceInformation()->getStateSpace().get()))
                continue;
            const auto own = std::make_shared<og::PathGeometric>(si_);
            for (std::size_t i = 0; i < path->getStateCount(); ++i)
                own->append(path->getState(static_cast<unsigned int>(i)));
            solution.path_ = own;
            changed = true;
        }
        if (!changed)
            return;
        pdef_->clearSolutionPaths();
        for (const ob::PlannerSolution &solution : solutions)
            pdef_->addSolutionPath(solution);
    }

    void TeamSetup::setup()
    {
        // OMPL would look into the goal to choose a planner, whether there is one or not.
        if (!planner_ && !pa_ && !pdef_->getGoal())
            throw ompl::Exception(
                "Set a goal or a planner before setup(). To check states, getSpaceInformation()->setup() "
                "is enough");
        choosePlanner();
        if (!planner_ || !planner_->isSetup())
            chooseObjective();
        if (planner_ && !planner_->isSetup())
            configureRange(*planner_);
        SimpleSetup::setup();
        prepare(*planner_);
    }

    void TeamSetup::prepare(ob::Planner &planner) const
    {
        if (planner.getSpaceInformation() != si_)
            throw ompl::Exception(planner.getName(), "was made for another space information than this setup's");
        if (planner.getProblemDefinition() != pdef_)
            planner.setProblemDefinition(pdef_);
        if (!planner.isSetup())
        {
            configureRange(planner);
            planner.setup();
        }
        if (nearestStructure_ == NearestStructure::KD_TREE)
            useKdTree(planner);
    }
}
