#include "ompl_certificates/control/ControlPlanners.h"

#include "ompl_certificates/control/PrioritizedRRT.h"
#include "ompl_certificates/files/Suggestion.h"

#include <map>
#include <ompl/control/planners/est/EST.h>
#include <ompl/control/planners/kpiece/KPIECE1.h>
#include <ompl/control/planners/pdst/PDST.h>
#include <ompl/control/planners/rrt/RRT.h>
#include <ompl/control/planners/sst/SST.h>
#include <ompl/util/Exception.h>

namespace ompl_certificates
{
    namespace ob = ompl::base;
    namespace oc = ompl::control;

    namespace
    {
        template <typename Planner>
        ob::PlannerPtr make(const oc::SpaceInformationPtr &si)
        {
            return std::make_shared<Planner>(si);
        }

        const std::map<std::string, ob::PlannerPtr (*)(const oc::SpaceInformationPtr &)> PLANNERS{
            {"EST", make<oc::EST>},   {"KPIECE1", make<oc::KPIECE1>},
            {"PDST", make<oc::PDST>}, {"PrioritizedRRT", make<PrioritizedRRT>},
            {"RRT", make<oc::RRT>},   {"SST", make<oc::SST>}};
    }

    std::vector<std::string> controlPlannerNames()
    {
        std::vector<std::string> names;
        names.reserve(PLANNERS.size());
        for (const auto &planner : PLANNERS)
            names.push_back(planner.first);
        return names;
    }

    std::string defaultControlPlanner(unsigned int robots)
    {
        return robots > 1 ? "PrioritizedRRT" : "RRT";
    }

    ob::PlannerPtr makeControlPlanner(const std::string &name, const oc::SpaceInformationPtr &si)
    {
        if (const auto planner = PLANNERS.find(name); planner != PLANNERS.end())
            return planner->second(si);
        throw ompl::Exception(name, "there is no such control planner; known are: " + joined(controlPlannerNames()) +
                                        ". Syclop's need a decomposition of the workspace, so programs make them" +
                                        didYouMean(name, controlPlannerNames()));
    }
}
