#include "ompl_certificates/planning/Planners.h"

#include "MendedPlanners.h"

#include "ompl_certificates/files/Suggestion.h"
#include "ompl_certificates/planning/DRRTstar.h"
#include "ompl_certificates/team/TeamStateSpace.h"

#include <cmath>
#include <limits>
#include <locale>
#include <map>
#include <ompl/geometric/planners/AnytimePathShortening.h>
#include <ompl/geometric/planners/cforest/CForest.h>
#include <ompl/geometric/planners/est/BiEST.h>
#include <ompl/geometric/planners/est/EST.h>
#include <ompl/geometric/planners/est/ProjEST.h>
#include <ompl/geometric/planners/fmt/BFMT.h>
#include <ompl/geometric/planners/fmt/FMT.h>
#include <ompl/geometric/planners/informedtrees/ABITstar.h>
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
#include <ompl/tools/config/MagicConstants.h>
#include <ompl/util/Console.h>
#include <ompl/util/Exception.h>
#include <optional>
#include <sstream>
#include <utility>

namespace ompl_certificates
{
    namespace ob = ompl::base;
    namespace og = ompl::geometric;

    namespace
    {
        /** Where a start is a goal, makes it the solution: many planners leave it and come back by a detour, or never
            look at it.
            \return whether there is such a start */
        bool isSolvedByStart(const ob::SpaceInformationPtr &si, ob::ProblemDefinition &problem,
                             const std::string &planner)
        {
            for (unsigned int i = 0; problem.getGoal() && i < problem.getStartStateCount(); ++i)
            {
                const ob::State *start = problem.getStartState(i);
                if (!problem.getGoal()->isSatisfied(start) || !si->satisfiesBounds(start) || !si->isValid(start))
                    continue;
                const auto path = std::make_shared<og::PathGeometric>(si, start);
                ob::PlannerSolution solution(path);
                solution.setPlannerName(planner);
                if (const ob::OptimizationObjectivePtr &objective = problem.getOptimizationObjective())
                    solution.setOptimized(objective, path->cost(objective), true);
                problem.addSolutionPath(solution);
                return true;
            }
            return false;
        }

        /** A planner with hooks around its solve() */
        template <typename PlannerType>
        class Hooked : public PlannerType
        {
        public:
            Hooked(const ob::SpaceInformationPtr &si, SolveHooks hooks) : PlannerType(si), hooks_(std::move(hooks))
            {
                // BITstar counts these by walking through its graph. OMPL asks for progress from another thread, which
                // then walks through memory that the planner has just freed.
                for (const char *name : {"current free states INTEGER", "current graph vertices INTEGER"})
                    this->plannerProgressProperties_.erase(name);
            }

            ob::PlannerStatus solve(const ob::PlannerTerminationCondition &ptc) override
            {
                const ob::PlannerStatus status = solveUnlessAtGoal(ptc);
                if (hooks_.after)
                    hooks_.after();
                return status;
            }

        private:
            ob::PlannerStatus solveUnlessAtGoal(const ob::PlannerTerminationCondition &ptc)
            {
                this->checkValidity();
                if (isSolvedByStart(this->si_, *this->pdef_, this->getName()))
                    return ob::PlannerStatus::EXACT_SOLUTION;
                if (!hooks_.stop)
                    return PlannerType::solve(ptc);
                return PlannerType::solve(
                    ob::plannerOrTerminationCondition(ptc, ob::PlannerTerminationCondition(hooks_.stop)));
            }

            SolveHooks hooks_;
        };

        template <typename PlannerType>
        ob::PlannerPtr make(const ob::SpaceInformationPtr &si, const SolveHooks &hooks)
        {
            return std::make_shared<Hooked<PlannerType>>(si, hooks);
        }

        struct Entry
        {
            ob::PlannerPtr (*make)(const ob::SpaceInformationPtr &, const SolveHooks &);
            const char *description;
        };

        /** Planners that need more than a space information are left out. TSRRT needs a task space, VFRRT a vector
            field, XXL a decomposition and QRRT a sequence of spaces. Those that plan from experience need a
            database. */
        const std::map<std::string, Entry> &planners()
        {
            static const std::map<std::string, Entry> table{
                {"ABITstar",
                 {make<og::ABITstar>,
                  "BIT* with an inflated heuristic and truncated searches: first solutions sooner"}},
                {"AITstar", {make<OneGoal<EndingAITstar>>, "BIT* whose heuristic is a search backwards from the goal"}},
                {"AnytimePathShortening",
                 {make<og::AnytimePathShortening>,
                  "several planners in threads; their paths are shortened and joined"}},
                {"BFMT", {make<OneGoal<og::BFMT>>, "FMT* from both ends"}},
                {"BITstar", {make<og::BITstar>, "batches of informed samples, searched best first"}},
                {"BKPIECE1", {make<og::BKPIECE1>, "KPIECE1 from both ends"}},
                {"BiEST", {make<og::BiEST>, "EST from both ends"}},
                {"BiRLRT", {make<og::BiRLRT>, "RLRT from both ends"}},
                {"BiTRRT", {make<og::BiTRRT>, "TRRT from both ends"}},
                {"CForest", {make<og::CForest>, "RRT* in several threads that share their best paths"}},
                {"DRRTstar",
                 {make<DRRTstar>, "dRRT*, for teams: a roadmap for each robot, and a search in their product"}},
                {"EST", {make<og::EST>, "a tree that grows where it has few neighbors"}},
                {"FMT", {make<ValidEnds<og::FMT>>, "FMT*: one batch of samples, solved by dynamic programming"}},
                {"InformedRRTstar", {make<og::InformedRRTstar>, "RRT* that samples only where a better path may be"}},
                {"KPIECE1", {make<og::KPIECE1>, "a tree that grows where a grid of a projection is little explored"}},
                {"LBKPIECE1", {make<og::LBKPIECE1>, "BKPIECE1 that checks motions only when they are on a path"}},
                {"LBTRRT",
                 {make<og::LBTRRT>, "between RRT and RRT*: a path at most so many times as long as the best"}},
                {"LazyLBTRRT",
                 {make<OneGoal<ValidEnds<og::LazyLBTRRT>>>, "LBTRRT that checks motions only when they are on a path"}},
                {"LazyPRM", {make<og::LazyPRM>, "PRM that checks motions only when they are on a path"}},
                {"LazyPRMstar", {make<og::LazyPRMstar>, "PRM* that checks motions only when they are on a path"}},
                {"LazyRRT", {make<og::LazyRRT>, "RRT that checks motions only when they are on a path"}},
                {"PDST", {make<og::PDST>, "a tree whose motions subdivide a projection of the space"}},
                {"PRM", {make<og::PRM>, "a roadmap of random states"}},
                {"PRMstar",
                 {make<og::PRMstar>,
                  "PRM whose number of neighbors grows with the roadmap, so that paths converge to the best"}},
                {"ProjEST", {make<og::ProjEST>, "EST that measures density in a projection"}},
                {"RLRT", {make<og::RLRT>, "a tree that grows along random lines, without a search for near states"}},
                {"RRT", {make<og::RRT>, "a tree that grows towards random states"}},
                {"RRTConnect", {make<og::RRTConnect>, "two trees, from start and goal, that grow towards each other"}},
                {"RRTXstatic", {make<og::RRTXstatic>, "RRT# that keeps the tree consistent up to a small error"}},
                {"RRTsharp", {make<og::RRTsharp>, "RRT#: RRT* that passes each improvement on through the tree"}},
                {"RRTstar", {make<og::RRTstar>, "RRT*: RRT that rewires its tree, so that paths converge to the best"}},
                {"SBL",
                 {make<og::SBL>, "two trees on a grid of a projection; motions are checked when they are on a path"}},
                {"SORRTstar", {make<og::SORRTstar>, "Informed RRT* that takes its samples in order of their promise"}},
                {"SPARS", {make<og::SPARS>, "a sparse roadmap whose paths are near the best"}},
                {"SPARStwo", {make<og::SPARStwo>, "SPARS that needs no dense roadmap beside it"}},
                {"SST", {make<og::SST>, "a tree that keeps only the best state of each neighborhood"}},
                {"STRIDE", {make<og::STRIDE>, "EST that measures density by its nearest-neighbor structure"}},
                {"TRRT", {make<og::TRRT>, "RRT that avoids states of high cost"}},
                {"pRRT", {make<og::pRRT>, "RRT in several threads"}},
                {"pSBL", {make<OneGoal<og::pSBL>>, "SBL in several threads"}}};
            return table;
        }

        /** OMPL's class name for what others write as RRT* or RRT# */
        std::string spelledOut(const std::string &name)
        {
            std::string text;
            for (const char c : name)
                text += c == '*' ? "star" : c == '#' ? "sharp" : std::string(1, c);
            return text;
        }

        /** The number that a text is, whatever the program's locale; nothing if it is no number */
        std::optional<double> toNumber(const std::string &text)
        {
            std::istringstream in(text);
            in.imbue(std::locale::classic());
            double number;
            return in >> number && in.eof() ? std::optional<double>(number) : std::nullopt;
        }

        /** A number as a parameter, whatever the program's locale */
        std::string toText(double number)
        {
            std::ostringstream out;
            out.imbue(std::locale::classic());
            out.precision(std::numeric_limits<double>::max_digits10);
            out << number;
            return out.str();
        }

        /** Why a number makes no sense where OMPL suggests a range such as 1:64; empty if it may. Zero and negative
            numbers make some planners crash, but other numbers beyond those suggested may make sense. */
        std::string whySenseless(const std::string &key, const std::string &value, const std::string &range)
        {
            const std::size_t colon = range.find(':');
            const std::optional<double> number = toNumber(value), least = toNumber(range.substr(0, colon));
            if (!number || !least || colon == std::string::npos)
                return "";
            // OMPL's range of num_planners begins at 0, but AnytimePathShortening crashes with 0 planners.
            if ((*least > 0.0 || key == "num_planners") && *number <= 0.0)
                return "must be positive";
            if (key == "goal_bias" && *number > 1.0)
                return "must be at most 1";
            return *least >= 0.0 && *number < 0.0 ? "must not be negative" : "";
        }

        /** Whether a planner that was given \e value and now has \e result understood it. OMPL reads the leading number
            of a text, and takes every word but "false" for true. */
        bool understood(const std::string &value, const std::string &result)
        {
            const std::optional<double> has = toNumber(result), given = toNumber(value);
            if (!has)
                return result.empty() || result == value;
            if (given)
                // It writes six digits, or six decimals.
                return std::abs(*given - *has) <= 6e-6 * std::abs(*given) + 6e-7;
            return (value == "true" && *has == 1.0) || (value == "false" && *has == 0.0);
        }

        const Entry &find(const std::string &name)
        {
            const auto entry = planners().find(name);
            if (entry != planners().end())
                return entry->second;
            const std::string suggestion = didYouMean(spelledOut(name), plannerNames());
            throw ompl::Exception("There is no planner '" + name + "'" +
                                  (suggestion.empty() ? "; the planners are " + joined(plannerNames()) : suggestion));
        }
    }

    std::vector<std::string> plannerNames()
    {
        std::vector<std::string> names;
        for (const auto &entry : planners())
            names.push_back(entry.first);
        return names;
    }

    std::string plannerDescription(const std::string &name)
    {
        return find(name).description;
    }

    ob::PlannerPtr makePlanner(const std::string &name, const ob::SpaceInformationPtr &si, const SolveHooks &hooks)
    {
        ob::PlannerPtr planner = find(name).make(si, hooks);
        configureRange(*planner);
        return planner;
    }

    void configureRange(ob::Planner &planner)
    {
        const ob::SpaceInformation &si = *planner.getSpaceInformation();
        const auto *team = dynamic_cast<const TeamStateSpace *>(si.getStateSpace().get());
        std::string present;
        // Of a LazyPRM it is how far states may be from each other that become neighbors.
        if (!team || !planner.params().getParam("range", present) || toNumber(present) != 0.0 ||
            dynamic_cast<const og::LazyPRM *>(&planner))
            return;
        // Where the two are equal it is left to OMPL, to the last bit.
        const double range = team->getPlannerRange();
        if (range < (1.0 - 1e-9) * ompl::magic::MAX_MOTION_LENGTH_AS_SPACE_EXTENT_FRACTION * team->getMaximumExtent())
            planner.params().setParam("range", toText(range));
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
        const std::string senseless = whySenseless(key, value, planner.params()[key].getRangeSuggestion());
        if (!senseless.empty())
            throw ompl::Exception(refusal + ": " + senseless);
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
}
