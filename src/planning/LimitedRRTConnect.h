#ifndef OMPL_CERTIFICATES_PLANNING_LIMITED_RRT_CONNECT_
#define OMPL_CERTIFICATES_PLANNING_LIMITED_RRT_CONNECT_

#include <memory>
#include <ompl/base/PlannerTerminationCondition.h>
#include <ompl/base/ProblemDefinition.h>
#include <ompl/geometric/PathGeometric.h>

namespace ompl_certificates
{
    /** \brief Let RRTConnect look for a path in at most \e iterations, or until \e condition becomes true.
        \param range its longest step
        \return a path to the goal, or null */
    std::shared_ptr<ompl::geometric::PathGeometric>
    planByRRTConnect(const ompl::base::ProblemDefinitionPtr &problem, double range, unsigned int iterations,
                     const ompl::base::PlannerTerminationCondition &condition);
}

#endif
