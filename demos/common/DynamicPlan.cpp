#include "common/DynamicPlan.h"

#include "common/CommandLine.h"
#include "common/Interrupt.h"
#include "common/Limit.h"
#include "common/Outputs.h"
#include "common/PlanPage.h"
#include "common/PlanTeamSummary.h"
#include "common/SolutionProof.h"

#include "ompl_certificates/control/ControlPlanners.h"
#include "ompl_certificates/control/PathSteps.h"
#include "ompl_certificates/control/ProvePath.h"
#include "ompl_certificates/control/TeamControlSetup.h"
#include "ompl_certificates/pictures/PathFile.h"
#include "ompl_certificates/pictures/PlanAnimation.h"
#include "ompl_certificates/pictures/PlanReport.h"
#include "ompl_certificates/pictures/ScenePicture.h"
#include "ompl_certificates/scene/MoveItFiles.h"
#include "ompl_certificates/scene/SceneFile.h"
#include "ompl_certificates/team/PathTimes.h"

#include <cstdio>
#include <ompl/base/PlannerData.h>
#include <ompl/util/Console.h>
#include <ompl/util/Exception.h>
#include <ompl/util/RandomNumbers.h>

using namespace ompl_certificates;

namespace demos
{
    namespace ob = ompl::base;

    namespace
    {
        /** Plan, and fill in the report */
        void solve(TeamControlSetup &setup, const PlanTeamOptions &options, PlanReport &report)
        {
            const auto clock = std::make_shared<NearestClock>();
            const bool timed = timeNearest(*setup.getPlanner(), clock);
            Limit limit(options.seconds, options.iterations);
            const ob::PlannerStatus status = setup.solve(limit.condition());
            report.solved = status == ob::PlannerStatus::EXACT_SOLUTION;
            report.approximate = !report.solved && setup.haveSolutionPath();
            if (!report.solved)
                report.reason = reasonOf(status, *setup.getPlanner());
            report.totalSeconds = setup.getLastPlanComputationTime();
            report.checkingSeconds = setup.getStatistics().getCheckingSeconds();
            if (timed)
                report.nearestSeconds = clock->getSeconds();
            report.checks = setup.getStatistics().getCounts();
            report.iterations = limit.getEvaluations();
            report.certificates = setup.getTeamChecker()->getCertificateCount();
            if (report.solved)
                report.cost = stateTimes(setup.getSolutionPath()).back();
        }

        /** Simplify the solution until nothing improves any more, an interrupt comes, or as much time has passed as
            there was for planning */
        void simplify(TeamControlSetup &setup, const PlanTeamOptions &options, PlanReport &report)
        {
            setup.simplifySolution(ob::plannerOrTerminationCondition(
                ob::PlannerTerminationCondition(interrupted), ob::timedPlannerTerminationCondition(options.seconds)));
            report.simplifiedCost = stateTimes(setup.getSolutionPath()).back();
            report.simplifyingSeconds = setup.getLastSimplificationTime();
        }

        void print(const PlanReport &report, TeamControlSetup &setup)
        {
            const auto number = [](std::uint64_t value) { return static_cast<unsigned long long>(value); };
            std::printf("%s: %s by controls, method %s, seed %llu\n", report.scene.c_str(), report.planner.c_str(),
                        report.method.c_str(), number(report.seed));
            if (report.solved)
            {
                const ompl::control::PathControl &path = setup.getSolutionPath();
                std::printf("  solved        %.6g s", report.cost);
                if (report.simplifiedCost >= 0.0)
                    std::printf(", simplified %.6g s in %.3f s", report.simplifiedCost, report.simplifyingSeconds);
                std::printf(", %zu controls\n", path.getControlCount());
                printProof(report, pathSteps(path).getControlCount(), "steps", "their ends");
            }
            else
                std::printf("  not solved    %s\n", report.reason.c_str());
            printTree(report);
            std::printf(
                "  robot poses   %llu: certified %llu, by clearances %llu, by the contact test %llu, by FCL %llu\n",
                number(report.checks.robotPoses),
                number(report.checks.certifiedFree + report.checks.certifiedColliding),
                number(report.checks.byClearances), number(report.checks.byContact), number(report.checks.exact));
            std::printf("  calls of FCL  %llu\n", number(report.checks.exactCalls + report.checks.pairExact));
            std::printf("  certificates  %llu\n", number(report.certificates));
            std::printf("  time          %.3f s, in checking %.3f s", report.totalSeconds, report.checkingSeconds);
            if (report.nearestSeconds >= 0.0)
                std::printf(", in nearest neighbors %.3f s", report.nearestSeconds);
            std::puts("");
        }

        void printControls(const PlanTeamOptions &options, const TeamControlSetup &setup)
        {
            const auto &si = *setup.getSpaceInformation();
            std::printf("  controls      each for %u to %u steps of %g s\n", si.getMinControlDuration(),
                        si.getMaxControlDuration(), si.getPropagationStepSize());
            std::printf("  goal          within %g\n", options.goalTolerance);
        }

        std::string drawn(const PlanTeamOptions &options, const Scene &scene, const TeamControlSetup &setup,
                          const ob::PlannerData &tree)
        {
            ScenePicture picture(scene);
            if (setup.haveSolutionPath())
                picture.setPath(setup.getSolutionPath());
            if (options.pictureTree)
                picture.setTree(tree);
            if (options.pictureCertificates)
                picture.setCertificates(setup.getTeamChecker()->getCertificates());
            return picture.toSvg();
        }
    }

    int runDynamics(PlanTeamOptions options)
    {
        if (options.seconds == 0.0)
            options.seconds = 10.0;
        options.objective = "duration";
        ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
        ompl::RNG::setSeed(options.seed);
        if (isMoveItScene(options.scene))
            throw ompl::Exception("--dynamics", "is for scenes whose robots move by controls; " + options.scene +
                                                    " is a planning scene of MoveIt");
        const Scene scene = loadScene(options.scene, true);
        scene.validate();
        const std::string planner = options.planner.empty()
                                        ? defaultControlPlanner(static_cast<unsigned int>(scene.getMembers().size()))
                                        : options.planner;
        const TeamControlSetupPtr owner =
            scene.makeControlSetup(options.goalTolerance, methodOf(options.method), modeOf(options));
        TeamControlSetup &setup = *owner;
        setup.setPlanner(makeControlPlanner(planner, setup.getSpaceInformation()));
        setParameters(options, *setup.getPlanner());
        std::vector<std::string> inputs = scene.getFiles();
        inputs.push_back(options.scene);
        prepareOutputs(outputsOf(options), inputs);
        setup.setNearestStructure(nearestStructureOf(options.nearest));
        setup.setup();
        setup.getStatistics().reset();
        ompl::msg::setLogLevel(options.quiet ? ompl::msg::LOG_ERROR : ompl::msg::LOG_WARN);
        if (!options.quiet)
            printNotes(scene);
        if (options.dryRun)
        {
            if (!options.quiet)
            {
                printTask(options, scene, *setup.getPlanner());
                printControls(options, setup);
            }
            return SOLVED;
        }
        catchInterrupts();

        PlanReport report;
        report.scene = scene.getName();
        report.planner = planner;
        report.method = options.method;
        report.motion = options.motion;
        report.objective = options.objective;
        report.seed = options.seed;
        solve(setup, options, report);
        // The next interrupt ends the proof.
        const bool stopped = takeInterrupt();
        ob::PlannerData tree(setup.getSpaceInformation());
        if (needsTree(options))
        {
            setup.getPlanner()->getPlannerData(tree);
            report.setTree(tree);
        }
        if (options.simplify && report.solved && stopped && !options.quiet)
            std::fprintf(stderr, "interrupted: now simplifying, for %g s at most; another interrupt ends that\n",
                         options.seconds);
        if (options.simplify && report.solved)
            simplify(setup, options, report);
        proveSolution(setup, scene, options, report);
        if (!options.quiet)
        {
            if (stopped || interrupted())
                std::puts("interrupted: this is what was found so far");
            print(report, setup);
            printUnwritten(options, report);
        }
        std::fflush(stdout);
        Outputs outputs;
        outputs.attempt(options.report, [&](const std::string &file) { writeOutput(file, report.toJson()); });
        if (report.solved)
        {
            outputs.attempt(options.path,
                            [&](const std::string &file) { writeOutput(file, toCsv(setup.getSolutionPath())); });
            outputs.attempt(options.animation, [&](const std::string &file)
                            { writeOutput(file, PlanAnimation(scene, setup.getSolutionPath()).toSvg()); });
        }
        outputs.attempt(options.picture,
                        [&](const std::string &file) { writeOutput(file, drawn(options, scene, setup, tree)); });
        outputs.attempt(options.view,
                        [&](const std::string &file) { writeOutput(file, planPage(scene, setup, report, tree)); });
        outputs.finish();
        return report.solved ? SOLVED : NOT_SOLVED;
    }
}
