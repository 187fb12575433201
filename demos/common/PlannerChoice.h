#ifndef OMPL_CERTIFICATES_DEMOS_COMMON_PLANNER_CHOICE_
#define OMPL_CERTIFICATES_DEMOS_COMMON_PLANNER_CHOICE_

#include "ompl_certificates/scene/SceneFile.h"

#include <functional>
#include <ompl/base/Planner.h>
#include <string>
#include <vector>

namespace demos
{
    /** \brief A parameter of a planner */
    struct PlannerParameter
    {
        std::string key, value;

        /** \brief What complaints about it begin with, such as a file and its section */
        std::string source;
    };

    /** \brief A planner and its parameters, as a command line or a .cfg file of OMPL.app chooses it */
    struct PlannerChoice
    {
        /** \brief DRRTstar, or the name of OMPL's class */
        std::string planner;

        /** \brief What tells it from others in tables and logs */
        std::string title;

        std::vector<PlannerParameter> parameters{};
    };

    /** \brief The planners of these names, with the parameters that \e file has for them, which may give one several
        times. Without names those of the file, else DRRTstar for two or more robots, RRTConnect for
        one. Titles that are taken get a number.
        \throws ompl::Exception that names the file, the section and the key if the file has a planner that is
        unknown */
    std::vector<PlannerChoice> choosePlanners(const ompl_certificates::SceneFile &file,
                                              const std::vector<std::string> &names);

    /** \brief The planner of that choice, with its parameters. Its solve() ends when the program is interrupted.
        \param afterSolve called as soon as solve() returns, before anybody looks at the solution
        \throws ompl::Exception as makePlanner() and setParameter() do */
    ompl::base::PlannerPtr makePlanner(const PlannerChoice &choice, const ompl::base::SpaceInformationPtr &si,
                                       const std::function<void()> &afterSolve = {});
}

#endif
