#ifndef OMPL_CERTIFICATES_PLANNING_LIMITED_RRT_CONNECT_
#define OMPL_CERTIFICATES_PLANNING_LIMITED_RRT_CONNECT_

#include <memory>
#include <ompl/base/PlannerTerminationCondition.h>
#include <ompl/base/ProblemDefinition.h>
#include <ompl/geometric/PathGeometric.h>
#include <string>

namespace ompl_certificates
{
    /** \brief Let RRTConnect look for a path in at most \e iterations, or until \e condition becomes true.
        \param name what its log messages begin with, which would otherwise look like those of the user's planner
        \param range its longest step
        \return a path to the goal, or null */
    std::shared_ptr<ompl::geometric::PathGeometric>
    planByRRTConnect(const ompl::base::ProblemDefinitionPtr &problem, const std::string &name, double range,
                     unsigned int iterations, const ompl::base::PlannerTerminationCondition &condition);
}

#endif
