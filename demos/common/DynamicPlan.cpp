#include "common/DynamicPlan.h"

#include "common/CommandLine.h"
#include "common/Interrupt.h"
#include "common/Limit.h"
#include "common/Outputs.h"

#include "ompl_certificates/control/ControlPlanners.h"
#include "ompl_certificates/control/TeamControlSetup.h"
#include "ompl_certificates/pictures/PathFile.h"
#include "ompl_certificates/pictures/PlanReport.h"
#include "ompl_certificates/pictures/PlanViewer.h"
#include "ompl_certificates/pictures/ScenePicture.h"
#include "ompl_certificates/scene/SceneFile.h"

#include <cstdio>
#include <numeric>
#include <ompl/base/PlannerData.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

using namespace ompl_certificates;

namespace demos
{
    namespace ob = ompl::base;

    namespace
    {
        /** Plan, and fill in the report */
        void solve(TeamControlSetup &setup, const DynamicPlan &plan, PlanReport &report)
        {
            Limit limit(plan.seconds, plan.iterations);
            const ob::PlannerStatus status = setup.solve(limit.condition());
            report.solved = status == ob::PlannerStatus::EXACT_SOLUTION && setup.haveExactSolutionPath();
            report.approximate = !report.solved && setup.haveSolutionPath();
            report.totalSeconds = setup.getLastPlanComputationTime();
            report.checkingSeconds = setup.getStatistics().getCheckingSeconds();
            report.checks = setup.getStatistics().getCounts();
            report.iterations = limit.getEvaluations();
            report.certificates = setup.getTeamChecker()->getCertificateCount();
            if (report.solved)
                report.cost = setup.getSolutionPath().length();  // its duration
        }

        void print(const PlanReport &report, TeamControlSetup &setup)
        {
            const auto number = [](std::uint64_t value) { return static_cast<unsigned long long>(value); };
            std::printf("%s: %s by controls, method %s, seed %llu\n", report.scene.c_str(), report.planner.c_str(),
                        report.method.c_str(), number(report.seed));
            if (report.solved)
                std::printf("  solved        %.6g s, %zu controls\n", report.cost,
                            setup.getSolutionPath().getControlCount());
            else if (report.approximate)
                std::printf("  not solved    an approximate solution ends %.6g from the goal\n",
                            setup.getProblemDefinition()->getSolutionDifference());
            else
                std::puts("  not solved");
            std::printf("  tree          %llu states, %llu edges, after %llu iterations\n", number(report.treeStates),
                        number(report.treeEdges), number(report.iterations));
            std::printf(
                "  robot poses   %llu: certified %llu, by clearances %llu, by the contact test %llu, by FCL %llu\n",
                number(report.checks.robotPoses),
                number(report.checks.certifiedFree + report.checks.certifiedColliding),
                number(report.checks.byClearances), number(report.checks.byContact), number(report.checks.exact));
            std::printf("  calls of FCL  %llu\n", number(report.checks.exactCalls + report.checks.pairExact));
            std::printf("  certificates  %llu\n", number(report.certificates));
            std::printf("  time          %.3f s, in checking %.3f s\n", report.totalSeconds, report.checkingSeconds);
        }

        std::string drawn(const DynamicPlan &plan, const Scene &scene, const TeamControlSetup &setup,
                          const ob::PlannerData &tree)
        {
            ScenePicture picture(scene);
            if (setup.haveSolutionPath())
            {
                // The states of equal steps are at equal times, however far they are from each other.
                const auto path = setup.getSolutionPath().asGeometric();
                std::vector<double> times(path.getStateCount());
                std::iota(times.begin(), times.end(), 0.0);
                picture.setPath(path, times);
            }
            if (plan.pictureTree)
                picture.setTree(tree);
            if (plan.pictureCertificates)
                picture.setCertificates(setup.getTeamChecker()->getCertificates());
            return picture.toSvg();
        }

        std::string viewed(const Scene &scene, const TeamControlSetup &setup, const PlanReport &report,
                           const ob::PlannerData &tree)
        {
            PlanViewer viewer(scene);
            if (report.solved)
                viewer.setPath(setup.getSolutionPath());
            viewer.setTree(tree);
            viewer.setCertificates(setup.getTeamChecker()->getCertificates());
            viewer.setReport(report);
            return viewer.toHtml();
        }
    }

    int run(const DynamicPlan &plan)
    {
        ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
        ompl::RNG::setSeed(plan.seed);
        const Scene scene = loadScene(plan.scene, true);
        scene.validate();
        const TeamStateSpacePtr team = scene.makeTeam();
        TeamControlSetup setup(team, scene.makeObstacles(), methodOf(plan.method),
                               plan.proven ? CertificateMotionValidator::CONTINUOUS
                                           : CertificateMotionValidator::DISCRETE);
        setup.setStartAndGoalStates(scene.makeStart(team), scene.makeGoal(team), plan.goalTolerance);
        setup.setPlanner(makeControlPlanner(plan.planner, setup.getSpaceInformation()));
        plan.setParameters(*setup.getPlanner());
        prepareOutputs(
            {{"--picture", plan.picture}, {"--view", plan.view}, {"--path", plan.path}, {"--report", plan.report}},
            {plan.scene});
        setup.setup();
        setup.getStatistics().reset();
        ompl::msg::setLogLevel(plan.quiet ? ompl::msg::LOG_ERROR : ompl::msg::LOG_WARN);
        catchInterrupts();

        PlanReport report;
        report.scene = scene.getName();
        report.planner = plan.planner;
        report.method = plan.method;
        report.motion = plan.proven ? "continuous" : "discrete";
        report.objective = "duration";
        report.seed = plan.seed;
        solve(setup, plan, report);
        ob::PlannerData tree(setup.getSpaceInformation());
        setup.getPlanner()->getPlannerData(tree);
        report.setTree(tree);
        if (!plan.quiet)
        {
            print(report, setup);
            if (!report.solved && !plan.path.empty())
                std::printf("no path was written to %s\n", plan.path.c_str());
        }
        std::fflush(stdout);
        if (!plan.report.empty())
            writeOutput(plan.report, report.toJson());
        if (report.solved && !plan.path.empty())
            writeOutput(plan.path, toCsv(setup.getSolutionPath()));
        if (!plan.picture.empty())
            writeOutput(plan.picture, drawn(plan, scene, setup, tree));
        if (!plan.view.empty())
            writeOutput(plan.view, viewed(scene, setup, report, tree));
        return report.solved ? SOLVED : NOT_SOLVED;
    }
}
