#include "common/PlanTeamSummary.h"

#include <algorithm>
#include <cstdio>

using namespace ompl_certificates;

namespace demos
{
    namespace
    {
        void printShare(const char *label, std::uint64_t part, std::uint64_t whole)
        {
            std::printf("%s%llu (%.1f %%)", label, static_cast<unsigned long long>(part),
                        whole > 0 ? 100.0 * static_cast<double>(part) / static_cast<double>(whole) : 0.0);
        }
    }

    void printProof(const PlanReport &report, std::size_t count, const char *motions, const char *samples)
    {
        if (report.unprovedMotions < 0)
            return;
        if (report.unprovedMotions == 0 && report.unseenMotions == 0)
        {
            std::puts("  proved        free throughout");
            return;
        }
        std::printf("  not proved    %lld of %zu %s", static_cast<long long>(report.unprovedMotions), count, motions);
        if (report.unseenMotions > 0)
            std::printf("; %llu were not looked at in time", static_cast<unsigned long long>(report.unseenMotions));
        if (!report.collision.empty())
            std::printf("; between %s, %s", samples, report.collision.c_str());
        if (report.unprovedMotions == 0)
            std::puts("");
        else if (!makesCertificates(methodOf(report.method)))
            std::puts("; --method shared --motion continuous proves all of a path");
        else
            std::puts(report.motion == "continuous" ? "" : "; --motion continuous proves all of a path");
    }

    void printTree(const PlanReport &report)
    {
        const auto number = [](std::uint64_t value) { return static_cast<unsigned long long>(value); };
        std::printf("  iterations    %llu\n", number(report.iterations));
        if (!report.digest.empty())
            std::printf("  tree          %llu states, %llu edges\n", number(report.treeStates),
                        number(report.treeEdges));
    }

    void printUnwritten(const PlanTeamOptions &options, const PlanReport &report)
    {
        if (report.solved)
            return;
        for (const auto &[what, name] : {std::pair{"path", options.path}, {"animation", options.animation}})
            if (!name.empty())
                std::printf("no %s was written to %s\n", what, name.c_str());
    }

    void printNotes(const Scene &scene)
    {
        for (const std::string &note : scene.getNotes())
            std::printf("note: %s\n", note.c_str());
        std::fflush(stdout);
    }

    void print(const PlanReport &report, const TeamSetup &setup)
    {
        const CheckCounts &checks = report.checks;
        const auto number = [](std::uint64_t value) { return static_cast<unsigned long long>(value); };
        std::printf("%s: %s, method %s, seed %llu\n", report.scene.c_str(), report.planner.c_str(),
                    report.method.c_str(), number(report.seed));
        if (report.solved && report.simplifiedCost >= 0.0)
            std::printf("  solved        cost %.6g, simplified %.6g in %.3f s, %zu states\n", report.cost,
                        report.simplifiedCost, report.simplifyingSeconds, setup.getSolutionPath().getStateCount());
        else if (report.solved)
            std::printf("  solved        cost %.6g, %zu states\n", report.cost,
                        setup.getSolutionPath().getStateCount());
        else
            std::printf("  not solved    %s\n", report.reason.c_str());
        if (report.solved)
            printProof(report, setup.getSolutionPath().getStateCount() - 1, "motions", "samples");
        if (report.firstSolutionSeconds >= 0.0)
            std::printf("  first         after %.3f s\n", report.firstSolutionSeconds);
        printTree(report);
        std::printf("  robot poses   %llu:", number(checks.robotPoses));
        printShare(" certified free ", checks.certifiedFree, checks.robotPoses);
        printShare(", certified colliding ", checks.certifiedColliding, checks.robotPoses);
        if (checks.byClearances > 0)
            printShare(", by clearances ", checks.byClearances, checks.robotPoses);
        if (checks.contactTests > 0)
            printShare(", by the contact test ", checks.byContact, checks.robotPoses);
        printShare(", by FCL ", checks.exact, checks.robotPoses);
        std::printf("\n  motions       %llu:", number(checks.motions));
        printShare(" samples skipped ", checks.motionSamplesSkipped, checks.motionSamples);
        std::printf("\n  robot pairs   %llu:", number(checks.pairPoses));
        std::printf(" FCL called for %llu", number(checks.pairExact));
        std::printf("\n  calls of FCL  %llu", number(checks.exactCalls + checks.pairExact));
        std::printf("\n  certificates  %llu\n", number(report.certificates));
        std::printf("  time          %.3f s", report.totalSeconds);
        // Threads add up, and then there is no share of the whole.
        const bool threads = setup.getPlanner()->getSpecs().multithreaded;
        const auto printTime = [&](const char *label, double seconds)
        {
            std::printf(", %s %.3f s", label, seconds);
            if (!threads)
                std::printf(" (%.1f %%)", report.totalSeconds > 0.0 ? 100.0 * seconds / report.totalSeconds : 0.0);
        };
        printTime("in checking", report.checkingSeconds);
        if (report.nearestSeconds >= 0.0)
            printTime("in nearest neighbors", report.nearestSeconds);
        std::puts(threads ? " over all threads" : "");
    }

    void printTask(const PlanTeamOptions &options, const Scene &scene, const ompl::base::Planner &planner)
    {
        std::printf("%s: start and goal are free\n", scene.getName().c_str());
        std::printf("  workspace     dimensions %u, obstacles %zu, point clouds and maps %zu\n", scene.getDimension(),
                    scene.getObstacles().size(), scene.getSensedObstacles().size());
        for (const Scene::Member &member : scene.getMembers())
        {
            std::size_t bodies = 0;
            for (std::size_t i = 0; i < member.robot->getBodies().size(); ++i)
                bodies += member.robot->isZone(i) ? 0 : 1;
            std::printf("  robot         %s: dimensions %u, bodies %zu\n", member.robot->getName().c_str(),
                        member.robot->getStateSpace()->getDimension(), bodies);
        }
        // Controls are checked step by step.
        if (options.dynamics)
            std::printf("  steps         %s\n",
                        options.motion == "continuous" ? "proved free" : "checked at their ends");
        else
        {
            const double fraction = planner.getSpaceInformation()->getStateSpace()->getLongestValidSegmentFraction();
            double farthest = 0.0;
            for (const Scene::Member &member : scene.getMembers())
                farthest = std::max(farthest, fraction * member.robot->getStateSpace()->getMaximumExtent());
            std::printf("  resolution    %g of each robot's space, which is up to %g between samples, motions %s\n",
                        fraction, farthest, options.motion.c_str());
        }
        std::printf("  planner       %s, method %s, objective %s, seed %u\n", planner.getName().c_str(),
                    options.method.c_str(), options.objective.c_str(), options.seed);
        for (const auto &[key, parameter] : planner.params().getParams())
            std::printf("  %-13s %s = %s\n", "", key.c_str(), parameter->getValue().c_str());
        if (options.iterations > 0)
            std::printf("  limit         %llu iterations\n", static_cast<unsigned long long>(options.iterations));
        else
            std::printf("  limit         %g s\n", options.seconds);
        for (const auto &[option, file] : outputsOf(options))
            if (!file.empty())
                std::printf("  %-13s %s\n", option.substr(2).c_str(), file.c_str());
    }
}
