#include "common/PlannerList.h"

#include "ompl_certificates/planning/Planners.h"

#include <iomanip>
#include <iostream>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <sstream>

using namespace ompl_certificates;

namespace demos
{
    namespace ob = ompl::base;

    std::string plannerList()
    {
        // Any space will do: what a planner is does not depend on it.
        const auto space = std::make_shared<ob::RealVectorStateSpace>(2);
        space->setBounds(0.0, 1.0);
        const auto si = std::make_shared<ob::SpaceInformation>(space);
        std::ostringstream text;
        for (const std::string &name : plannerNames())
            text << std::left << std::setw(23) << name << std::setw(12)
                 << (makePlanner(name, si)->getSpecs().optimizingPaths ? "optimizing" : "") << plannerDescription(name)
                 << '\n';
        return text.str();
    }

    void addPlannerList(CLI::App &app)
    {
        app.add_flag_callback(
            "--list-planners",
            []
            {
                std::cout << plannerList();
                throw CLI::Success();
            },
            "List the planners, a line each, and end. Optimizing are those that go on to improve a solution, as OMPL "
            "tells");
    }
}
