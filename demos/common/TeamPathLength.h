#ifndef OMPL_CERTIFICATES_DEMOS_COMMON_TEAM_PATH_LENGTH_
#define OMPL_CERTIFICATES_DEMOS_COMMON_TEAM_PATH_LENGTH_

#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/base/samplers/informed/RejectionInfSampler.h>

namespace demos
{
    /** \brief The length of a team's path, for planners that sample the states that can improve a solution.

        OMPL's own objective samples them directly, which it can do in R^n, SE(2) and SE(3) only and refuses in any other
        compound space. This one samples by rejection. Costs are the same. */
    class TeamPathLength : public ompl::base::PathLengthOptimizationObjective
    {
    public:
        using PathLengthOptimizationObjective::PathLengthOptimizationObjective;

        ompl::base::InformedSamplerPtr allocInformedStateSampler(const ompl::base::ProblemDefinitionPtr &problem,
                                                                 unsigned int maxNumberCalls) const override
        {
            return std::make_shared<ompl::base::RejectionInfSampler>(problem, maxNumberCalls);
        }
    };
}

#endif
