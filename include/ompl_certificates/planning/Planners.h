#ifndef OMPL_CERTIFICATES_PLANNING_PLANNERS_
#define OMPL_CERTIFICATES_PLANNING_PLANNERS_

#include <functional>
#include <ompl/base/Planner.h>
#include <string>
#include <vector>

namespace ompl_certificates
{
    /** \brief Hooks around a planner's solve() */
    struct SolveHooks
    {
        /** \brief Ends solve() once it returns true. The planner's threads call it often. */
        std::function<bool()> stop{};

        /** \brief Called as soon as solve() returns, before the solution is used */
        std::function<void()> after{};
    };

    /** \brief The names of all planners of makePlanner(), sorted: OMPL's classes, and DRRTstar */
    std::vector<std::string> plannerNames();

    /** \brief What the planner of that name is, in half a line
        \throws ompl::Exception like makePlanner() */
    std::string plannerDescription(const std::string &name);

    /** \brief Set the parameter range of \e planner, if it has one and that is 0, to TeamStateSpace::getPlannerRange().
        Leave OMPL's own choice where it is no longer than that: of this library's robots, only arms ask for shorter
        steps. TeamSetup::setup() and makePlanner() call this. Call it before the planner's setup(). */
    void configureRange(ompl::base::Planner &planner);

    /** \brief DRRTstar, or OMPL's geometric planner of that class name, such as RRTConnect, after configureRange()
        \throws ompl::Exception if there is none; the message suggests a similar name, or lists all */
    ompl::base::PlannerPtr makePlanner(const std::string &name, const ompl::base::SpaceInformationPtr &si,
                                       const SolveHooks &hooks = {});

    /** \brief Set a parameter of \e planner
        \throws ompl::Exception if the planner has none of that name (the message lists its parameters), or refuses the
        value. Also if it is negative, or zero, where OMPL suggests no such values: some planners crash with them. */
    void setParameter(ompl::base::Planner &planner, const std::string &key, const std::string &value);
}

#endif
