#ifndef OMPL_CERTIFICATES_PLANNING_MENDED_PLANNERS_
#define OMPL_CERTIFICATES_PLANNING_MENDED_PLANNERS_

// Planners of OMPL that go wrong with some problems, and here do not

#include <limits>
#include <ompl/base/goals/GoalState.h>
#include <ompl/base/goals/GoalStates.h>
#include <ompl/geometric/planners/informedtrees/AITstar.h>
#include <ompl/util/Console.h>

namespace ompl_certificates
{
    /** \brief AIT* samples on until it finds a state that could better the solution. Where that is the straight way,
        there is none, and it never looks at its termination condition again. So such a solution satisfies it. */
    class EndingAITstar : public ompl::geometric::AITstar
    {
    public:
        using AITstar::AITstar;

        ompl::base::PlannerStatus solve(const ompl::base::PlannerTerminationCondition &ptc) override
        {
            const ompl::base::OptimizationObjectivePtr objective = pdef_->getOptimizationObjective();
            const auto *goal = dynamic_cast<const ompl::base::GoalState *>(pdef_->getGoal().get());
            if (!objective || !goal || pdef_->getStartStateCount() != 1)
                return AITstar::solve(ptc);
            const ompl::base::Cost before = objective->getCostThreshold();
            const double best = objective->motionCostHeuristic(pdef_->getStartState(0), goal->getState()).value();
            const ompl::base::Cost least(best * (1.0 + 1e-9) + std::numeric_limits<double>::min());
            if (objective->isCostBetterThan(before, least))
                objective->setCostThreshold(least);
            try
            {
                const ompl::base::PlannerStatus status = AITstar::solve(ptc);
                objective->setCostThreshold(before);
                return status;
            }
            catch (...)
            {
                objective->setCostThreshold(before);
                throw;
            }
        }
    };

    /** \brief A planner that goes wrong with several goal states: BFMT reads memory that is not its own, LazyLBTRRT
        aborts or goes through obstacles, AITstar never ends where the straight way is free, and pSBL knows one kind of
        goal. */
    template <typename PlannerType>
    class OneGoal : public PlannerType
    {
    public:
        using PlannerType::PlannerType;

        ompl::base::PlannerStatus solve(const ompl::base::PlannerTerminationCondition &ptc) override
        {
            const ompl::base::Goal *goal = this->pdef_->getGoal().get();
            const auto *list = dynamic_cast<const ompl::base::GoalStates *>(goal);
            if (dynamic_cast<const ompl::base::GoalState *>(goal) || (list && list->getStateCount() == 1))
                return PlannerType::solve(ptc);
            OMPL_ERROR("%s: plans for a goal of one state alone", this->getName().c_str());
            return ompl::base::PlannerStatus::UNRECOGNIZED_GOAL_TYPE;
        }
    };

    /** \brief A planner that goes wrong without a valid start, or a valid goal state: FMT reads memory that is not its
        own, and LazyLBTRRT frees some twice once it has a valid start. */
    template <typename PlannerType>
    class ValidEnds : public PlannerType
    {
    public:
        using PlannerType::PlannerType;

        ompl::base::PlannerStatus solve(const ompl::base::PlannerTerminationCondition &ptc) override
        {
            const ompl::base::ProblemDefinition &problem = *this->pdef_;
            const auto isValid = [this](const ompl::base::State *state)
            { return this->si_->satisfiesBounds(state) && this->si_->isValid(state); };
            bool hasStart = false;
            for (unsigned int i = 0; i < problem.getStartStateCount() && !hasStart; ++i)
                hasStart = isValid(problem.getStartState(i));
            if (!hasStart)
            {
                OMPL_ERROR("%s: There are no valid initial states!", this->getName().c_str());
                return ompl::base::PlannerStatus::INVALID_START;
            }
            const auto *goal = dynamic_cast<const ompl::base::GoalState *>(problem.getGoal().get());
            if (goal && !isValid(goal->getState()))
            {
                OMPL_ERROR("%s: The goal is not valid!", this->getName().c_str());
                return ompl::base::PlannerStatus::INVALID_GOAL;
            }
            return PlannerType::solve(ptc);
        }
    };
}

#endif
