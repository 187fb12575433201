#include "common/PlannerList.h"

#include "ompl_certificates/control/ControlPlanners.h"
#include "ompl_certificates/planning/Planners.h"

#include <iomanip>
#include <iostream>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/control/SpaceInformation.h>
#include <ompl/control/spaces/RealVectorControlSpace.h>
#include <ompl/util/Console.h>
#include <sstream>

using namespace ompl_certificates;

namespace demos
{
    namespace ob = ompl::base;
    namespace oc = ompl::control;

    namespace
    {
        /** One planner and its parameters */
        void list(std::ostream &text, const std::string &name, const std::string &description,
                  const ob::Planner &planner)
        {
            text << std::setw(23) << name << std::setw(12) << (planner.getSpecs().optimizingPaths ? "optimizing" : "")
                 << description << '\n';
            for (const auto &[key, parameter] : planner.params().getParams())
                text << "    " << std::setw(43) << key << std::setw(12) << parameter->getValue()
                     << parameter->getRangeSuggestion() << '\n';
        }
    }

    std::string plannerList(bool withControls)
    {
        // Any space will do: what a planner is does not depend on it.
        const auto space = std::make_shared<ob::RealVectorStateSpace>(2);
        space->setBounds(0.0, 1.0);
        const auto si = std::make_shared<ob::SpaceInformation>(space);
        // Parameters that have no effect any more are told of, but not when they are asked for.
        const ompl::msg::LogLevel level = ompl::msg::getLogLevel();
        ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
        std::ostringstream text;
        text << std::left;
        for (const std::string &name : plannerNames())
            list(text, name, plannerDescription(name), *ompl_certificates::makePlanner(name, si));
        if (withControls)
        {
            const auto controls = std::make_shared<oc::RealVectorControlSpace>(space, 1);
            const auto controlled = std::make_shared<oc::SpaceInformation>(space, controls);
            for (const std::string &name : controlPlannerNames())
                list(text, name,
                     name == "PrioritizedRRT" ? "robot by robot, for teams that move by controls: with --dynamics"
                                              : "OMPL's planner of that name for controls: with --dynamics",
                     *makeControlPlanner(name, controlled));
        }
        ompl::msg::setLogLevel(level);
        return text.str();
    }

    void addPlannerList(CLI::App &app, bool withControls)
    {
        app.add_flag_callback(
            "--list-planners",
            [withControls]
            {
                std::cout << plannerList(withControls);
                throw CLI::Success();
            },
            "List the planners, each with its parameters, their values at first, and the ranges that OMPL suggests "
            "(lowest:step:highest, or the choices); then end. Optimizing are those that go on to improve a solution, "
            "as OMPL tells");
    }
}
