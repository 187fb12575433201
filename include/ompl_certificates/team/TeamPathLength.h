#ifndef OMPL_CERTIFICATES_TEAM_TEAM_PATH_LENGTH_
#define OMPL_CERTIFICATES_TEAM_TEAM_PATH_LENGTH_

#include <ompl/base/Planner.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/base/samplers/informed/RejectionInfSampler.h>

namespace ompl_certificates
{
    /** \brief The length of a team's path. Planners that sample the states that can improve a solution need it:
        InformedRRTstar, SORRTstar, BITstar, ABITstar, AITstar and CForest.

        OMPL's own objective samples those states directly, which it can do in R^n, SE(2) and SE(3) only; it refuses
        other compound spaces. This one samples by rejection. Costs are the same. */
    class TeamPathLength : public ompl::base::PathLengthOptimizationObjective
    {
    public:
        /** \brief See ompl::base::PathLengthOptimizationObjective */
        using PathLengthOptimizationObjective::PathLengthOptimizationObjective;

        /** \brief A sampler by rejection for \e problem that gives up after \e maxNumberCalls */
        ompl::base::InformedSamplerPtr allocInformedStateSampler(const ompl::base::ProblemDefinitionPtr &problem,
                                                                 unsigned int maxNumberCalls) const override
        {
            return std::make_shared<ompl::base::RejectionInfSampler>(problem, maxNumberCalls);
        }
    };

    /** \brief The objective for a team's problem when the user chose none: a TeamPathLength in place of the path length
        that OMPL's planners default to. Null for planners that do something else without an objective: PRM and LazyPRM
        stop at their first solution, TRRT and BiTRRT minimise mechanical work. */
    ompl::base::OptimizationObjectivePtr defaultObjective(const ompl::base::Planner &planner);
}

#endif
