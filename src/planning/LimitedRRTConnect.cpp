#include "LimitedRRTConnect.h"

#include <ompl/base/SpaceInformation.h>
#include <ompl/base/terminationconditions/IterationTerminationCondition.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>

namespace ompl_certificates
{
    namespace ob = ompl::base;
    namespace og = ompl::geometric;

    std::shared_ptr<og::PathGeometric> planByRRTConnect(const ob::ProblemDefinitionPtr &problem,
                                                        const std::string &name, double range, unsigned int iterations,
                                                        const ob::PlannerTerminationCondition &condition)
    {
        og::RRTConnect planner(problem->getSpaceInformation());
        planner.setName(name);
        planner.setRange(range);
        planner.setProblemDefinition(problem);
        planner.setup();
        ob::IterationTerminationCondition limit(iterations);
        planner.solve(ob::plannerOrTerminationCondition(condition, limit));
        return problem->hasExactSolution() ? std::static_pointer_cast<og::PathGeometric>(problem->getSolutionPath())
                                           : nullptr;
    }
}
