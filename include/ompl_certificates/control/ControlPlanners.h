#ifndef OMPL_CERTIFICATES_CONTROL_CONTROL_PLANNERS_
#define OMPL_CERTIFICATES_CONTROL_CONTROL_PLANNERS_

#include <ompl/base/Planner.h>
#include <ompl/control/SpaceInformation.h>
#include <string>
#include <vector>

namespace ompl_certificates
{
    /** \brief The names of OMPL's control planners that need no more than a space information and a problem. Syclop
        also needs a decomposition of the workspace, so it is not among them. */
    std::vector<std::string> controlPlannerNames();

    /** \brief The planner to choose for a team of so many robots: PrioritizedRRT for several, RRT for one. OMPL's
        planners hardly plan for more than three. */
    std::string defaultControlPlanner(unsigned int robots);

    /** \brief A new control planner of that name
        \throws ompl::Exception that lists the names if there is no such planner */
    ompl::base::PlannerPtr makeControlPlanner(const std::string &name, const ompl::control::SpaceInformationPtr &si);
}

#endif
