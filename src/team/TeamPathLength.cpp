#include "ompl_certificates/team/TeamPathLength.h"

#include <ompl/geometric/planners/prm/LazyPRM.h>
#include <ompl/geometric/planners/prm/PRM.h>
#include <ompl/geometric/planners/rrt/BiTRRT.h>
#include <ompl/geometric/planners/rrt/TRRT.h>

namespace ompl_certificates
{
    namespace og = ompl::geometric;

    namespace
    {
        template <typename... Planners>
        bool isOneOf(const ompl::base::Planner &planner)
        {
            return (... || (dynamic_cast<const Planners *>(&planner) != nullptr));
        }
    }

    ompl::base::OptimizationObjectivePtr defaultObjective(const ompl::base::Planner &planner)
    {
        if (isOneOf<og::PRM, og::LazyPRM, og::TRRT, og::BiTRRT>(planner))
            return nullptr;
        return std::make_shared<TeamPathLength>(planner.getSpaceInformation());
    }
}
