#ifndef OMPL_CERTIFICATES_DEMOS_COMMON_PLANNER_FACTORY_
#define OMPL_CERTIFICATES_DEMOS_COMMON_PLANNER_FACTORY_

#include <ompl/base/Planner.h>
#include <string>
#include <vector>

namespace demos
{
    /** \brief The names of all methods; see ompl_certificates::Method */
    std::vector<std::string> methodNames();

    /** \brief The names of what a planner can look for near states in; see ompl_certificates::NearestStructure */
    std::vector<std::string> nearestNames();

    /** \brief The value of a planner's progress property by the first word of its name, such as iterations; empty if
        the planner has none */
    std::string progressOf(const ompl::base::Planner &planner, const std::string &property);

    /** \brief Add a progress property to any planner; \e name ends with its type, such as "certificates INTEGER" */
    void addProgressProperty(ompl::base::Planner &planner, const std::string &name,
                             const ompl::base::Planner::PlannerProgressProperty &property);
}

#endif
