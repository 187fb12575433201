#include "LimitedRRTConnect.h"

#include <ompl/base/SpaceInformation.h>
#include <utility>

namespace ompl_certificates
{
    namespace ob = ompl::base;
    namespace og = ompl::geometric;

    LimitedRRTConnect::LimitedRRTConnect(ob::ProblemDefinitionPtr problem, const std::string &name, double range,
                                         unsigned int iterations)
      : problem_(std::move(problem))
      , iterations_(iterations)
      , planner_(problem_->getSpaceInformation())
      , limit_(iterations)
    {
        planner_.setName(name);
        planner_.setRange(range);
        planner_.setProblemDefinition(problem_);
        planner_.setup();
    }

    std::shared_ptr<og::PathGeometric> LimitedRRTConnect::search(const ob::PlannerTerminationCondition &condition)
    {
        planner_.solve(ob::plannerOrTerminationCondition(condition, limit_));
        return problem_->hasExactSolution() ? std::static_pointer_cast<og::PathGeometric>(problem_->getSolutionPath())
                                            : nullptr;
    }
}
