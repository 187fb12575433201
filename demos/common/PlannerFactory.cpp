#include "common/PlannerFactory.h"

#include "ompl_certificates/neighbors/PlannerNeighbors.h"
#include "ompl_certificates/planning/TeamSetup.h"

namespace demos
{
    namespace ob = ompl::base;

    std::vector<std::string> methodNames()
    {
        std::vector<std::string> names;
        for (const auto method : ompl_certificates::allMethods())
            names.push_back(nameOf(method));
        return names;
    }

    std::vector<std::string> nearestNames()
    {
        std::vector<std::string> names;
        for (const auto structure : ompl_certificates::allNearestStructures())
            names.push_back(nameOf(structure));
        return names;
    }

    std::string progressOf(const ob::Planner &planner, const std::string &property)
    {
        for (const auto &[name, query] : planner.getPlannerProgressProperties())
            if (name.compare(0, property.size() + 1, property + ' ') == 0)
                return query();
        return std::string();
    }

    void addProgressProperty(ob::Planner &planner, const std::string &name,
                             const ob::Planner::PlannerProgressProperty &property)
    {
        // OMPL leaves this to derived classes; naming the function through one gives it to any planner.
        struct Access : ob::Planner
        {
            using ob::Planner::addPlannerProgressProperty;
        };
        (planner.*&Access::addPlannerProgressProperty)(name, property);
    }
}
