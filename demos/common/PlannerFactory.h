#ifndef OMPL_CERTIFICATES_DEMOS_COMMON_PLANNER_FACTORY_
#define OMPL_CERTIFICATES_DEMOS_COMMON_PLANNER_FACTORY_

#include <functional>
#include <ompl/base/Planner.h>
#include <string>
#include <vector>

namespace demos
{
    /** \brief What to do as soon as a planner's solve() returns, before anybody looks at the solution */
    using SolveEvent = std::function<void()>;

    /** \brief The names of all planners that makePlanner() makes: OMPL's classes, sorted */
    std::vector<std::string> plannerNames();

    /** \brief OMPL's geometric planner of that class name, such as RRTConnect
        \throws ompl::Exception if there is none; the message suggests a similar name, or lists all */
    ompl::base::PlannerPtr makePlanner(const std::string &name, const ompl::base::SpaceInformationPtr &si,
                                       const SolveEvent &afterSolve = SolveEvent());

    /** \brief The names of all methods; see ompl_certificates::Method */
    std::vector<std::string> methodNames();

    /** \brief The names of what a planner can look for near states in; see ompl_certificates::NearestStructure */
    std::vector<std::string> nearestNames();

    /** \brief Set a parameter of \e planner
        \throws ompl::Exception if the planner has none of that name (the message lists those it has), or refuses the
        value */
    void setParameter(ompl::base::Planner &planner, const std::string &key, const std::string &value);

    /** \brief The value of a planner's progress property by the first word of its name, such as iterations; empty if
        the planner has none */
    std::string progressOf(const ompl::base::Planner &planner, const std::string &property);

    /** \brief Add a progress property to any planner; \e name ends with its type, such as "certificates INTEGER" */
    void addProgressProperty(ompl::base::Planner &planner, const std::string &name,
                             const ompl::base::Planner::PlannerProgressProperty &property);
}

#endif
