#include "common/PlannerChoice.h"

#include "common/Interrupt.h"

#include "ompl_certificates/files/Suggestion.h"
#include "ompl_certificates/planning/Planners.h"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <map>
#include <ompl/util/Exception.h>
#include <set>

using namespace ompl_certificates;

namespace demos
{
    namespace
    {
        std::string lowerCase(std::string text)
        {
            std::transform(text.begin(), text.end(), text.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
            return text;
        }

        /** The class that OMPL.app's files call \e type: its name in lower case, but for a few */
        std::string classOf(const std::string &type)
        {
            static const std::map<std::string, std::string> others{{"aps", "AnytimePathShortening"},
                                                                   {"bkpiece", "BKPIECE1"},
                                                                   {"kpiece", "KPIECE1"},
                                                                   {"lbkpiece", "LBKPIECE1"},
                                                                   {"spars2", "SPARStwo"}};
            if (const auto other = others.find(type); other != others.end())
                return other->second;
            const std::vector<std::string> names = plannerNames();
            const auto name = std::find_if(names.begin(), names.end(),
                                           [&type](const std::string &known) { return lowerCase(known) == type; });
            return name == names.end() ? std::string() : *name;
        }
    }

    std::vector<PlannerChoice> choosePlanners(const ompl_certificates::SceneFile &file,
                                              const std::vector<std::string> &names)
    {
        std::vector<PlannerChoice> known, chosen;
        for (const auto &planner : file.planners)
        {
            const std::string source = file.scene.getSource() + ": [planner] " + planner.type;
            const std::string name = classOf(planner.type);
            if (name.empty())
                throw ompl::Exception(source, "there is no such planner, or it needs more than a problem to solve" +
                                                  didYouMean(planner.type, plannerNames()));
            known.push_back({name, planner.title.empty() ? name : planner.title});
            for (const auto &[key, value] : planner.parameters)
                known.back().parameters.push_back({key, value, source});
        }
        for (const std::string &name : names)
        {
            const std::size_t before = chosen.size();
            std::copy_if(known.begin(), known.end(), std::back_inserter(chosen),
                         [&name](const PlannerChoice &choice) { return choice.planner == name; });
            if (chosen.size() == before)
                chosen.push_back({name, name});
        }
        if (names.empty())
        {
            const std::string usual = file.scene.getMembers().size() > 1 ? "DRRTstar" : "RRTConnect";
            chosen = known.empty() ? std::vector<PlannerChoice>{{usual, usual}} : known;
        }
        std::set<std::string> titles;
        for (PlannerChoice &choice : chosen)
        {
            const std::string wanted = choice.title;
            for (int number = 2; !titles.insert(choice.title).second; ++number)
                choice.title = wanted + " " + std::to_string(number);
        }
        return chosen;
    }

    ompl::base::PlannerPtr makePlanner(const PlannerChoice &choice, const ompl::base::SpaceInformationPtr &si,
                                       const std::function<void()> &afterSolve)
    {
        const ompl::base::PlannerPtr planner =
            ompl_certificates::makePlanner(choice.planner, si, {interrupted, afterSolve});
        for (const PlannerParameter &parameter : choice.parameters)
            try
            {
                setParameter(*planner, parameter.key, parameter.value);
            }
            catch (const std::exception &exception)
            {
                throw ompl::Exception(parameter.source, exception.what());
            }
        return planner;
    }
}
