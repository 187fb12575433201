#include "common/PlannerList.h"

#include "common/PlannerFactory.h"

#include <iomanip>
#include <iostream>
#include <map>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <sstream>

namespace demos
{
    namespace ob = ompl::base;

    namespace
    {
        const std::map<std::string, std::string> &descriptions()
        {
            static const std::map<std::string, std::string> table{
                {"ABITstar", "BIT* with an inflated heuristic and truncated searches: first solutions sooner"},
                {"AITstar", "BIT* whose heuristic is a search backwards from the goal"},
                {"AnytimePathShortening", "several planners in threads; their paths are shortened and joined"},
                {"BFMT", "FMT* from both ends"},
                {"BITstar", "batches of informed samples, searched best first"},
                {"BKPIECE1", "KPIECE1 from both ends"},
                {"BiEST", "EST from both ends"},
                {"BiRLRT", "RLRT from both ends"},
                {"BiTRRT", "TRRT from both ends"},
                {"CForest", "RRT* in several threads that share their best paths"},
                {"EST", "a tree that grows where it has few neighbors"},
                {"FMT", "FMT*: one batch of samples, solved by dynamic programming"},
                {"InformedRRTstar", "RRT* that samples only where a better path may be"},
                {"KPIECE1", "a tree that grows where a grid of a projection is little explored"},
                {"LBKPIECE1", "BKPIECE1 that checks motions only when they are on a path"},
                {"LBTRRT", "between RRT and RRT*: a path at most so many times as long as the best"},
                {"LazyLBTRRT", "LBTRRT that checks motions only when they are on a path"},
                {"LazyPRM", "PRM that checks motions only when they are on a path"},
                {"LazyPRMstar", "PRM* that checks motions only when they are on a path"},
                {"LazyRRT", "RRT that checks motions only when they are on a path"},
                {"PDST", "a tree whose motions subdivide a projection of the space"},
                {"PRM", "a roadmap of random states"},
                {"PRMstar", "PRM whose number of neighbors grows with the roadmap, so that paths become the best"},
                {"ProjEST", "EST that measures density in a projection"},
                {"RLRT", "a tree that grows along random lines, without a search for near states"},
                {"RRT", "a tree that grows towards random states"},
                {"RRTConnect", "two trees, from start and goal, that grow towards each other"},
                {"RRTXstatic", "RRT# that keeps the tree consistent up to a small error"},
                {"RRTsharp", "RRT#: RRT* that passes each improvement on through the tree"},
                {"RRTstar", "RRT*: RRT that rewires its tree, so that paths become the best"},
                {"SBL", "two trees on a grid of a projection; motions are checked when they are on a path"},
                {"SORRTstar", "Informed RRT* that takes its samples in order of their promise"},
                {"SPARS", "a sparse roadmap whose paths are near the best"},
                {"SPARStwo", "SPARS that needs no dense roadmap beside it"},
                {"SST", "a tree that keeps only the best state of each neighborhood"},
                {"STRIDE", "EST that measures density by its structure of near states"},
                {"TRRT", "RRT that avoids states of high cost"},
                {"pRRT", "RRT in several threads"},
                {"pSBL", "SBL in several threads"}};
            return table;
        }
    }

    std::string plannerList()
    {
        // Any space will do: what a planner is does not depend on it.
        const auto space = std::make_shared<ob::RealVectorStateSpace>(2);
        space->setBounds(0.0, 1.0);
        const auto si = std::make_shared<ob::SpaceInformation>(space);
        std::ostringstream text;
        for (const std::string &name : plannerNames())
            text << std::left << std::setw(23) << name << std::setw(12)
                 << (makePlanner(name, si)->getSpecs().optimizingPaths ? "optimizing" : "") << descriptions().at(name)
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
