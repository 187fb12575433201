#include "common/PlannerFactory.h"

#include "common/Interrupt.h"
#include "common/Suggestion.h"

#include "ompl_certificates/neighbors/PlannerNeighbors.h"
#include "ompl_certificates/planning/TeamSetup.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <ompl/geometric/planners/AnytimePathShortening.h>
#include <ompl/geometric/planners/cforest/CForest.h>
#include <ompl/geometric/planners/est/BiEST.h>
#include <ompl/geometric/planners/est/EST.h>
#include <ompl/geometric/planners/est/ProjEST.h>
#include <ompl/geometric/planners/fmt/BFMT.h>
#include <ompl/geometric/planners/fmt/FMT.h>
#include <ompl/geometric/planners/informedtrees/ABITstar.h>
#include <ompl/geometric/planners/informedtrees/AITstar.h>
#include <ompl/geometric/planners/informedtrees/BITstar.h>
#include <ompl/geometric/planners/kpiece/BKPIECE1.h>
#include <ompl/geometric/planners/kpiece/KPIECE1.h>
#include <ompl/geometric/planners/kpiece/LBKPIECE1.h>
#include <ompl/geometric/planners/pdst/PDST.h>
#include <ompl/geometric/planners/prm/LazyPRM.h>
#include <ompl/geometric/planners/prm/LazyPRMstar.h>
#include <ompl/geometric/planners/prm/PRM.h>
#include <ompl/geometric/planners/prm/PRMstar.h>
#include <ompl/geometric/planners/prm/SPARS.h>
#include <ompl/geometric/planners/prm/SPARStwo.h>
#include <ompl/geometric/planners/rlrt/BiRLRT.h>
#include <ompl/geometric/planners/rlrt/RLRT.h>
#include <ompl/geometric/planners/rrt/BiTRRT.h>
#include <ompl/geometric/planners/rrt/InformedRRTstar.h>
#include <ompl/geometric/planners/rrt/LBTRRT.h>
#include <ompl/geometric/planners/rrt/LazyLBTRRT.h>
#include <ompl/geometric/planners/rrt/LazyRRT.h>
#include <ompl/geometric/planners/rrt/RRT.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/geometric/planners/rrt/RRTXstatic.h>
#include <ompl/geometric/planners/rrt/RRTsharp.h>
#include <ompl/geometric/planners/rrt/RRTstar.h>
#include <ompl/geometric/planners/rrt/SORRTstar.h>
#include <ompl/geometric/planners/rrt/TRRT.h>
#include <ompl/geometric/planners/rrt/pRRT.h>
#include <ompl/geometric/planners/sbl/SBL.h>
#include <ompl/geometric/planners/sbl/pSBL.h>
#include <ompl/geometric/planners/sst/SST.h>
#include <ompl/geometric/planners/stride/STRIDE.h>
#include <ompl/util/Exception.h>

namespace demos
{
    namespace ob = ompl::base;
    namespace og = ompl::geometric;

    namespace
    {
        /** A planner that tells when it has finished */
        template <typename PlannerType>
        class Observed : public PlannerType
        {
        public:
            Observed(const ob::SpaceInformationPtr &si, SolveEvent afterSolve)
              : PlannerType(si), afterSolve_(std::move(afterSolve))
            {
                // BITstar counts these by walking through its graph. Progress is asked for from another thread, which
                // then walks through memory that the planner has just freed.
                for (const char *name : {"current free states INTEGER", "current graph vertices INTEGER"})
                    this->plannerProgressProperties_.erase(name);
            }

            ob::PlannerStatus solve(const ob::PlannerTerminationCondition &ptc) override
            {
                const ob::PlannerTerminationCondition stopped(interrupted);
                const ob::PlannerStatus status = PlannerType::solve(ob::plannerOrTerminationCondition(ptc, stopped));
                if (afterSolve_)
                    afterSolve_();
                return status;
            }

        private:
            SolveEvent afterSolve_;
        };

        template <typename PlannerType>
        ob::PlannerPtr make(const ob::SpaceInformationPtr &si, const SolveEvent &afterSolve)
        {
            return std::make_shared<Observed<PlannerType>>(si, afterSolve);
        }

        using Allocator = ob::PlannerPtr (*)(const ob::SpaceInformationPtr &, const SolveEvent &);

        /** Left out are the planners that need more than a space information: a task space (TSRRT), a vector field
            (VFRRT), a decomposition (XXL), a sequence of spaces (QRRT) or a database (those that plan from experience).
            */
        const std::map<std::string, Allocator> &allocators()
        {
            static const std::map<std::string, Allocator> table{
                {"ABITstar", make<og::ABITstar>},
                {"AITstar", make<og::AITstar>},
                {"AnytimePathShortening", make<og::AnytimePathShortening>},
                {"BFMT", make<og::BFMT>},
                {"BITstar", make<og::BITstar>},
                {"BKPIECE1", make<og::BKPIECE1>},
                {"BiEST", make<og::BiEST>},
                {"BiRLRT", make<og::BiRLRT>},
                {"BiTRRT", make<og::BiTRRT>},
                {"CForest", make<og::CForest>},
                {"EST", make<og::EST>},
                {"FMT", make<og::FMT>},
                {"InformedRRTstar", make<og::InformedRRTstar>},
                {"KPIECE1", make<og::KPIECE1>},
                {"LBKPIECE1", make<og::LBKPIECE1>},
                {"LBTRRT", make<og::LBTRRT>},
                {"LazyLBTRRT", make<og::LazyLBTRRT>},
                {"LazyPRM", make<og::LazyPRM>},
                {"LazyPRMstar", make<og::LazyPRMstar>},
                {"LazyRRT", make<og::LazyRRT>},
                {"PDST", make<og::PDST>},
                {"PRM", make<og::PRM>},
                {"PRMstar", make<og::PRMstar>},
                {"ProjEST", make<og::ProjEST>},
                {"RLRT", make<og::RLRT>},
                {"RRT", make<og::RRT>},
                {"RRTConnect", make<og::RRTConnect>},
                {"RRTXstatic", make<og::RRTXstatic>},
                {"RRTsharp", make<og::RRTsharp>},
                {"RRTstar", make<og::RRTstar>},
                {"SBL", make<og::SBL>},
                {"SORRTstar", make<og::SORRTstar>},
                {"SPARS", make<og::SPARS>},
                {"SPARStwo", make<og::SPARStwo>},
                {"SST", make<og::SST>},
                {"STRIDE", make<og::STRIDE>},
                {"TRRT", make<og::TRRT>},
                {"pRRT", make<og::pRRT>},
                {"pSBL", make<og::pSBL>}};
            return table;
        }

        /** What OMPL's class is called where others write RRT* or RRT# */
        std::string spelledOut(const std::string &name)
        {
            std::string text;
            for (const char c : name)
                text += c == '*' ? "star" : c == '#' ? "sharp" : std::string(1, c);
            return text;
        }

        /** Whether a planner that was given \e value and now has \e result understood it. OMPL reads numbers up to the
            first character that is none, and takes every word but "false" for true. */
        bool understood(const std::string &value, const std::string &result)
        {
            char *end = nullptr;
            const double has = std::strtod(result.c_str(), &end);
            if (result.empty() || *end != '\0')
                return result.empty() || result == value;
            const double given = std::strtod(value.c_str(), &end);
            if (end != value.c_str() && *end == '\0')
                return std::abs(given - has) <= 1e-6 * std::abs(given);
            return (value == "true" && has == 1.0) || (value == "false" && has == 0.0);
        }
    }

    std::vector<std::string> plannerNames()
    {
        std::vector<std::string> names;
        for (const auto &entry : allocators())
            names.push_back(entry.first);
        return names;
    }

    ob::PlannerPtr makePlanner(const std::string &name, const ob::SpaceInformationPtr &si, const SolveEvent &afterSolve)
    {
        const auto entry = allocators().find(name);
        if (entry == allocators().end())
        {
            const std::string suggestion = didYouMean(spelledOut(name), plannerNames());
            throw ompl::Exception("There is no planner '" + name + "'" +
                                  (suggestion.empty() ? "; the planners are " + joined(plannerNames()) : suggestion));
        }
        return entry->second(si, afterSolve);
    }

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

    void setParameter(ob::Planner &planner, const std::string &key, const std::string &value)
    {
        if (!planner.params().hasParam(key))
        {
            std::vector<std::string> names;
            planner.params().getParamNames(names);
            throw ompl::Exception(planner.getName() + " has no parameter '" + key + "'; it has " + joined(names) +
                                  didYouMean(key, names));
        }
        const std::string refusal = planner.getName() + " refuses '" + value + "' as its parameter '" + key + "'";
        bool accepted = false;
        try
        {
            std::string result;
            accepted = planner.params().setParam(key, value) && planner.params().getParam(key, result) &&
                       understood(value, result);
        }
        catch (const std::exception &e)
        {
            throw ompl::Exception(refusal + ": " + e.what());
        }
        if (!accepted)
            throw ompl::Exception(refusal);
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
