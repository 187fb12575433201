// Plans for the team of a scene, tells how the collision checks were settled, and writes a picture, the path and a
// report.
//
//     certificates plan scene.yaml --time 2 --seed 1 --picture plan.svg --report plan.json
//     certificates plan team_with_controls.yaml --dynamics --time 10 --path plan.csv
//     certificates plan scene0001.yaml --request request0001.yaml --urdf panda.urdf --srdf panda.srdf

#include "commands/Commands.h"
#include "common/CommandLine.h"
#include "common/DynamicPlan.h"
#include "common/Interrupt.h"
#include "common/Limit.h"
#include "common/Outputs.h"
#include "common/PlanPage.h"
#include "common/PlanTeamOptions.h"
#include "common/PlanTeamSummary.h"
#include "common/PlannerChoice.h"
#include "common/PlannerFactory.h"
#include "common/ProgressBar.h"
#include "common/SolutionProof.h"

#include "ompl_certificates/pictures/PathFile.h"
#include "ompl_certificates/pictures/PlanAnimation.h"
#include "ompl_certificates/pictures/PlanReport.h"
#include "ompl_certificates/pictures/ScenePicture.h"
#include "ompl_certificates/planning/ProvePath.h"
#include "ompl_certificates/planning/Planners.h"
#include "ompl_certificates/team/TeamObjective.h"
#include "ompl_certificates/validity/CertificateFile.h"

#include <cstdio>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

using namespace ompl_certificates;
using demos::PlanTeamOptions;
namespace ob = ompl::base;

namespace
{
    ob::PlannerPtr makePlanner(const PlanTeamOptions &options, const demos::PlannerChoice &choice,
                               const ob::SpaceInformationPtr &si)
    {
        ob::PlannerPtr planner = demos::makePlanner(choice, si);
        demos::setParameters(options, *planner);
        return planner;
    }

    void requireCertificates(const PlanTeamOptions &options, const TeamSetup &setup)
    {
        for (const auto &[option, file] : {std::pair{"--load-certificates", options.loadedCertificates},
                                           {"--save-certificates", options.savedCertificates}})
            if (!file.empty() && !makesCertificates(setup.getTeamChecker()->getMethod()))
                throw ompl::Exception(option, "the method " + nameOf(setup.getTeamChecker()->getMethod()) +
                                                  " has no certificates");
    }

    void loadCertificatesOf(const PlanTeamOptions &options, TeamValidityChecker &checker)
    {
        try
        {
            loadCertificates(checker, options.loadedCertificates);
        }
        catch (const std::exception &exception)
        {
            throw ompl::Exception("--load-certificates", exception.what());
        }
    }

    ob::OptimizationObjectivePtr objectiveOf(const TeamSetup &setup, const Scene &scene, const PlanTeamOptions &options)
    {
        const auto team = std::static_pointer_cast<TeamStateSpace>(setup.getStateSpace());
        return makeObjective(options.objective, setup.getSpaceInformation(), scene.makeGoal(team));
    }

    void requireOneGoal(const PlanTeamOptions &options, const Scene &scene)
    {
        if (options.objective == "arrival" && scene.hasRegions())
            throw ompl::Exception("--objective", "arrival needs one state as the goal of each robot");
    }

    /** Any solution is good enough. */
    void endWithFirst(ob::OptimizationObjective &objective)
    {
        objective.setCostThreshold(objective.infiniteCost());
    }

    double costOf(TeamSetup &setup, const Scene &scene, const PlanTeamOptions &options)
    {
        return setup.getSolutionPath().cost(objectiveOf(setup, scene, options)).value();
    }

    /** Plan, and fill in what of the report is known by then */
    void plan(TeamSetup &setup, const Scene &scene, const PlanTeamOptions &options, PlanReport &report)
    {
        const auto clock = std::make_shared<NearestClock>();
        const bool timed = timeNearest(*setup.getPlanner(), clock);
        const ob::Planner &planner = *setup.getPlanner();
        demos::Limit limit(options.seconds, options.iterations);
        {
            const demos::ProgressBar bar(
                [&limit, &planner]
                {
                    char text[64];
                    std::snprintf(text, sizeof(text), "%.1f s", limit.getSeconds());
                    const std::string cost = demos::progressOf(planner, "best cost");
                    return demos::ProgressBar::Progress{
                        limit.getFraction(), cost.empty() || cost == "inf" ? text : text + ("  cost " + cost)};
                },
                options.quiet);
            setup.getProblemDefinition()->setIntermediateSolutionCallback(
                [&](const ob::Planner *, const std::vector<const ob::State *> &, ob::Cost)
                {
                    if (report.firstSolutionSeconds < 0.0)
                        report.firstSolutionSeconds = limit.getSeconds();
                });
            const ob::PlannerStatus status = setup.solve(limit.condition());
            setup.getProblemDefinition()->setIntermediateSolutionCallback(nullptr);
            report.solved = status == ob::PlannerStatus::EXACT_SOLUTION && setup.haveExactSolutionPath();
            report.approximate = !report.solved && setup.haveSolutionPath();
            if (!report.solved)
                report.reason = reasonOf(status, *setup.getPlanner());
        }
        report.totalSeconds = setup.getLastPlanComputationTime();
        // A planner that ends before its time, and told of no solution until then, is taken to end with its first one.
        if (report.solved && report.firstSolutionSeconds < 0.0 && limit.getFraction() < 1.0 && !demos::interrupted())
            report.firstSolutionSeconds = report.totalSeconds;
        report.checkingSeconds = setup.getStatistics().getCheckingSeconds();
        if (timed)
            report.nearestSeconds = clock->getSeconds();
        report.checks = setup.getStatistics().getCounts();
        if (report.solved)
            report.cost = costOf(setup, scene, options);
        const std::string iterations = demos::progressOf(planner, "iterations");
        report.iterations = iterations.empty() ? limit.getEvaluations() : std::stoull(iterations);
        report.certificates = setup.getTeamChecker()->getCertificateCount();
    }

    /** Simplify the solution, if there is one, until nothing improves any more, an interrupt comes, or as much time has
        passed as there was for planning */
    void simplify(TeamSetup &setup, const Scene &scene, const PlanTeamOptions &options, PlanReport &report)
    {
        if (!report.solved)
            return;
        setup.simplifySolution(
            ob::plannerOrTerminationCondition(ob::PlannerTerminationCondition(demos::interrupted),
                                              ob::timedPlannerTerminationCondition(options.seconds)));
        report.simplifiedCost = costOf(setup, scene, options);
        report.simplifyingSeconds = setup.getLastSimplificationTime();
    }

    std::string drawn(const PlanTeamOptions &options, const Scene &scene, const TeamSetup &setup,
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

    std::string tableOf(const ompl::geometric::PathGeometric &path, const PlanTeamOptions &options)
    {
        if (!(options.pathStep > 0.0))
            return toCsv(path);
        try
        {
            return toCsv(path, options.pathStep);
        }
        catch (const ompl::Exception &exception)
        {
            throw ompl::Exception("--path-step", exception.what());
        }
    }

    /** Write all files that are asked for; one that cannot be written does not keep the others from it. */
    void write(const PlanTeamOptions &options, const Scene &scene, const TeamSetup &setup, const PlanReport &report,
               const ob::PlannerData &tree)
    {
        demos::Outputs outputs;
        outputs.attempt(options.savedCertificates,
                        [&](const std::string &file) { saveCertificates(*setup.getTeamChecker(), file); });
        outputs.attempt(options.report, [&](const std::string &file) { demos::writeOutput(file, report.toJson()); });
        // An approximate path looks like any other in a file, and would be taken for a solution.
        if (report.solved)
        {
            outputs.attempt(options.path, [&](const std::string &file)
                            { demos::writeOutput(file, tableOf(setup.getSolutionPath(), options)); });
            outputs.attempt(options.animation, [&](const std::string &file)
                            { demos::writeOutput(file, PlanAnimation(scene, setup.getSolutionPath()).toSvg()); });
        }
        outputs.attempt(options.picture,
                        [&](const std::string &file) { demos::writeOutput(file, drawn(options, scene, setup, tree)); });
        outputs.attempt(options.view, [&](const std::string &file)
                        { demos::writeOutput(file, demos::planPage(scene, setup, report, tree)); });
        outputs.finish();
    }

    int run(PlanTeamOptions options)
    {
        if (options.dynamics)
            return demos::runDynamics(options);
        // What is wrong with the input is told in one line, ours, and not in OMPL's words as well.
        ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
        ompl::RNG::setSeed(options.seed);
        const SceneFile file = demos::readScene(options.scene, options.moveIt);
        const Scene &scene = file.scene;
        scene.validate();
        requireOneGoal(options, scene);
        std::vector<std::string> named;
        if (!options.planner.empty())
            named.push_back(options.planner);
        const demos::PlannerChoice choice = demos::choosePlanners(file, named).front();
        if (options.seconds == 0.0)
            options.seconds = file.timeLimit.value_or(10.0);
        const Method method = methodOf(options.method);
        const TeamSetupPtr setup = scene.makeSetup(method, demos::modeOf(options));
        setup->setPlanner(makePlanner(options, choice, setup->getSpaceInformation()));
        if (options.savedCertificates == "-")
            throw ompl::Exception("--save-certificates", "must name a file: certificates are not text");
        std::vector<std::string> inputs{options.scene, options.moveIt.request, options.moveIt.urdf,
                                        options.moveIt.srdf};
        // Certificates may grow in the file that they come from.
        if (!demos::isSameFile(options.loadedCertificates, options.savedCertificates))
            inputs.push_back(options.loadedCertificates);
        inputs.insert(inputs.end(), scene.getFiles().begin(), scene.getFiles().end());
        demos::prepareOutputs(demos::outputsOf(options), inputs);
        // With the default objective, planners keep their own ways: PRM ends with its first solution.
        if (options.objective != "length" || options.first)
            setup->setOptimizationObjective(objectiveOf(*setup, scene, options));
        if (options.first)
            endWithFirst(*setup->getOptimizationObjective());
        setup->setNearestStructure(nearestStructureOf(options.nearest));
        setup->setup();
        setup->getStatistics().reset();
        requireCertificates(options, *setup);
        if (!options.loadedCertificates.empty())
            loadCertificatesOf(options, *setup->getTeamChecker());
        ompl::msg::setLogLevel(options.quiet ? ompl::msg::LOG_ERROR : ompl::msg::LOG_WARN);
        if (!options.quiet)
            demos::printNotes(scene);

        if (options.dryRun)
        {
            if (!options.quiet)
                demos::printTask(options, scene, *setup->getPlanner());
            return demos::SOLVED;
        }

        PlanReport report;
        report.scene = scene.getName();
        report.planner = choice.planner;
        report.method = options.method;
        report.motion = options.motion;
        report.objective = options.objective;
        report.seed = options.seed;
        demos::catchInterrupts();
        plan(*setup, scene, options, report);
        // Ctrl-C has ended planning alone; another one ends simplifying.
        const bool stopped = demos::takeInterrupt();
        ompl::msg::setLogLevel(ompl::msg::LOG_ERROR);
        ob::PlannerData tree(setup->getSpaceInformation());
        if (demos::needsTree(options))
        {
            setup->getPlanner()->getPlannerData(tree);
            report.setTree(tree);
        }
        if (options.simplify && report.solved && stopped && !options.quiet)
            std::fprintf(stderr, "interrupted: now simplifying, for %g s at most; another interrupt ends that\n",
                         options.seconds);
        if (options.simplify)
            simplify(*setup, scene, options, report);
        proveSolution(*setup, scene, options, report);

        if (!options.quiet)
        {
            if (stopped || demos::interrupted())
                std::puts("interrupted: this is what was found so far");
            demos::print(report, *setup);
            demos::printUnwritten(options, report);
        }
        std::fflush(stdout);
        // Pictures show the goal that the path ends at.
        const Scene shown = report.solved ? scene.endingAt(setup->getSolutionPath().getStates().back()) : scene;
        write(options, shown, *setup, report, tree);
        return report.solved ? demos::SOLVED : demos::NOT_SOLVED;
    }
}

demos::Work demos::declarePlan(CLI::App &app)
{
    const auto options = std::make_shared<PlanTeamOptions>();
    declare(app, *options);
    return [options] { return run(*options); };
}
