// Plans for the team of a scene, tells how the collision checks were settled, and writes a picture, the path and a
// report.
//
//     plan_team scene.yaml --time 2 --seed 1 --picture plan.svg --report plan.json
//     plan_team team_with_controls.yaml --dynamics --time 10 --path plan.csv
//     plan_team scene0001.yaml --request request0001.yaml --urdf panda.urdf --srdf panda.srdf

#include "common/CommandLine.h"
#include "common/DynamicPlan.h"
#include "common/Interrupt.h"
#include "common/Limit.h"
#include "common/Outputs.h"
#include "common/PlannerChoice.h"
#include "common/PlannerFactory.h"
#include "common/PlannerList.h"
#include "common/ProgressBar.h"

#include "ompl_certificates/pictures/PathFile.h"
#include "ompl_certificates/pictures/PlanAnimation.h"
#include "ompl_certificates/pictures/PlanReport.h"
#include "ompl_certificates/pictures/PlanViewer.h"
#include "ompl_certificates/pictures/ScenePicture.h"
#include "ompl_certificates/planning/Planners.h"
#include "ompl_certificates/scene/MoveItFiles.h"
#include "ompl_certificates/team/TeamObjective.h"
#include "ompl_certificates/validity/CertificateFile.h"

#include <cstdio>
#include <iostream>
#include <ompl/base/goals/GoalState.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

using namespace ompl_certificates;
namespace ob = ompl::base;

namespace
{
    struct Options
    {
        std::string scene;
        std::string request, urdf, srdf;
        std::string planner;
        std::string method{"shared"};
        std::string motion{"discrete"};
        std::string nearest{"kdtree"};
        std::string objective{"length"};
        double seconds{0.0};
        std::uint64_t iterations{0};
        std::uint32_t seed{1};
        std::string range;
        std::vector<std::string> parameters;
        std::string picture, animation, view, path, report, loadedCertificates, savedCertificates;
        double goalTolerance{0.5};
        bool dynamics{false}, dryRun{false}, simplify{false}, pictureTree{false}, pictureCertificates{false},
            quiet{false};
    };

    void declare(CLI::App &app, Options &options)
    {
        app.add_option("SCENE", options.scene,
                       "Scene file: YAML, a .cfg file of OMPL.app, or a planning scene of MoveIt (YAML)")
            ->required();
        app.add_option("--request", options.request, "For a planning scene of MoveIt: its motion plan request (YAML)");
        app.add_option("--urdf", options.urdf, "For a planning scene of MoveIt: the robot's URDF file");
        app.add_option("--srdf", options.srdf,
                       "For a planning scene of MoveIt: the robot's SRDF file, with its groups");
        app.add_option(
               "--planner", options.planner,
               "Planner: DRRTstar, or the name of OMPL's class. Where a .cfg file has the same planner, its parameters "
               "are used")
            ->default_str("the first of a .cfg file, else DRRTstar for two or more robots and RRTConnect for one");
        demos::addPlannerList(app);
        app.add_option("--method", options.method, "How checks are saved")
            ->check(demos::oneOf(demos::methodNames()))
            ->capture_default_str();
        app.add_option("--motion", options.motion, "How motions are checked")
            ->check(demos::oneOf({"discrete", "continuous"}))
            ->capture_default_str();
        app.add_option("--nearest", options.nearest, "What the planner looks for near states in")
            ->check(demos::oneOf(demos::nearestNames()))
            ->capture_default_str();
        app.add_option("--objective", options.objective,
                       "What planners that optimize lower: the length of the path in the team's space, the sum of the "
                       "robots' lengths, the makespan, or the sum of their arrival times")
            ->check(demos::oneOf(objectiveNames()))
            ->capture_default_str();
        auto *time = app.add_option("--time", options.seconds, "Time to plan, in seconds")
                         ->check(demos::positiveNumber())
                         ->default_str("that of a .cfg file or of a request, else 10");
        app.add_option(
               "--iterations", options.iterations,
               "Plan for that many evaluations of the termination condition instead: one per iteration for most "
               "of OMPL's planners, more for some")
            ->check(demos::countUpTo(1000000000000ull))
            ->excludes(time);
        app.add_option("--seed", options.seed, "Seed of OMPL's random numbers; the same seed grows the same tree")
            ->check(demos::countUpTo(4294967295ull))
            ->capture_default_str();
        app.add_option("--range", options.range, "The planner's parameter 'range': the length of its steps")
            ->check(demos::positiveNumber());
        app.add_option("--planner-param", options.parameters, "Parameters of the planner: NAME=VALUE ...");
        app.add_flag("--simplify", options.simplify,
                     "Shorten the solution before it is written: with OMPL's simplifier, then robot by robot");
        auto *picture = app.add_option("--picture", options.picture, "Write a picture (SVG)");
        app.add_flag("--picture-tree", options.pictureTree, "Draw the planner's tree, too")->needs(picture);
        app.add_flag("--picture-certificates", options.pictureCertificates, "Draw the certificates, too")
            ->needs(picture);
        app.add_option("--animation", options.animation,
                       "Write a picture in which the robots follow the solution (SVG, for browsers)");
        app.add_option("--view", options.view,
                       "Write a page to look at all of it in a browser, in 3-D where the scene is (HTML, needs no "
                       "network)");
        app.add_option("--path", options.path, "Write the states of the solution, one a line (CSV)");
        app.add_option("--report", options.report, "Write a report (JSON)");
        app.add_option("--load-certificates", options.loadedCertificates,
                       "Begin with the certificates of a file, which --save-certificates wrote");
        app.add_option("--save-certificates", options.savedCertificates,
                       "Write what is known of the obstacles in the end, for a later run");
        auto *dynamics =
            app.add_flag("--dynamics", options.dynamics,
                         "Robots move by controls, with the limits of db-CBS; for YAML with robots of its types. "
                         "Planners are then EST, KPIECE1, PDST, RRT (the default) and SST of ompl::control, and "
                         "--motion continuous proves each step free between its ends");
        for (const char *option : {"--request", "--urdf", "--srdf", "--simplify", "--nearest", "--objective",
                                   "--animation", "--load-certificates", "--save-certificates"})
            dynamics->excludes(app.get_option(option));
        app.add_option("--goal-tolerance", options.goalTolerance,
                       "With --dynamics: how far from the goal the team may end, in its space's distance")
            ->check(demos::positiveNumber())
            ->capture_default_str()
            ->needs(dynamics);
        app.add_flag("--quiet", options.quiet, "Print errors only");
        app.add_flag(
               "--dry-run", options.dryRun,
               "Read all, check start and goal and whether files can be written, print what would be planned, and "
               "end")
            ->excludes(dynamics);
        demos::group(app, {{"Scenes of MoveIt", {"--request", "--urdf", "--srdf"}},
                           {"Planning",
                            {"--planner", "--list-planners", "--range", "--planner-param", "--time", "--iterations",
                             "--seed", "--nearest", "--objective", "--simplify", "--dry-run"}},
                           {"Checking", {"--method", "--motion", "--load-certificates", "--save-certificates"}},
                           {"Output",
                            {"--picture", "--picture-tree", "--picture-certificates", "--animation", "--view", "--path",
                             "--report", "--quiet"}},
                           {"Robots that move by controls", {"--dynamics", "--goal-tolerance"}}});
        app.footer(
            "Of picture, animation, view, path and report one may be -, for standard output; all else is then printed to "
            "standard error.\n"
            "Returns 0 if a solution was found, 1 if not (or only an approximate one), 2 for bad input or a file that "
            "could not be written.");
    }

    void setParameters(const Options &options, ob::Planner &planner)
    {
        const auto set = [&planner](const std::string &option, const std::string &key, const std::string &value)
        {
            try
            {
                setParameter(planner, key, value);
            }
            catch (const std::exception &e)
            {
                throw ompl::Exception(option, e.what());
            }
        };
        if (!options.range.empty())
            set("--range", "range", options.range);
        for (const std::string &parameter : options.parameters)
        {
            const std::size_t sign = parameter.find('=');
            if (sign == 0 || sign == std::string::npos)
                throw ompl::Exception("--planner-param", "'" + parameter + "' is not of the form NAME=VALUE");
            set("--planner-param", parameter.substr(0, sign), parameter.substr(sign + 1));
        }
    }

    ob::PlannerPtr makePlanner(const Options &options, const demos::PlannerChoice &choice,
                               const ob::SpaceInformationPtr &si)
    {
        const ob::PlannerPtr planner = demos::makePlanner(choice, si);
        setParameters(options, *planner);
        return planner;
    }

    void requireCertificates(const Options &options, const TeamSetup &setup)
    {
        for (const auto &[option, file] : {std::pair{"--load-certificates", options.loadedCertificates},
                                           {"--save-certificates", options.savedCertificates}})
            if (!file.empty() && !makesCertificates(setup.getTeamChecker()->getMethod()))
                throw ompl::Exception(option, "the method " + nameOf(setup.getTeamChecker()->getMethod()) +
                                                  " has no certificates");
    }

    ob::OptimizationObjectivePtr objectiveOf(const TeamSetup &setup, const Options &options)
    {
        ob::ScopedState<> goal(setup.getStateSpace());
        goal = setup.getGoal()->as<ob::GoalState>()->getState();
        return makeObjective(options.objective, setup.getSpaceInformation(), goal);
    }

    double costOf(TeamSetup &setup, const Options &options)
    {
        return setup.getSolutionPath().cost(objectiveOf(setup, options)).value();
    }

    /** Plan, and fill in what of the report is known by then */
    void plan(TeamSetup &setup, const Options &options, PlanReport &report)
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
        }
        report.totalSeconds = setup.getLastPlanComputationTime();
        report.checkingSeconds = setup.getStatistics().getCheckingSeconds();
        if (timed)
            report.nearestSeconds = clock->getSeconds();
        report.checks = setup.getStatistics().getCounts();
        if (report.solved)
            report.cost = costOf(setup, options);
        const std::string iterations = demos::progressOf(planner, "iterations");
        report.iterations = iterations.empty() ? limit.getEvaluations() : std::stoull(iterations);
        report.certificates = setup.getTeamChecker()->getCertificateCount();
    }

    /** Simplify the solution, if there is one, until nothing improves any more or an interrupt comes */
    void simplify(TeamSetup &setup, const Options &options, PlanReport &report)
    {
        if (!report.solved)
            return;
        setup.simplifySolution(ob::PlannerTerminationCondition(demos::interrupted));
        report.simplifiedCost = costOf(setup, options);
        report.simplifyingSeconds = setup.getLastSimplificationTime();
    }

    void printShare(const char *label, std::uint64_t part, std::uint64_t whole)
    {
        std::printf("%s%llu (%.1f %%)", label, static_cast<unsigned long long>(part),
                    whole > 0 ? 100.0 * static_cast<double>(part) / static_cast<double>(whole) : 0.0);
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
        else if (report.approximate)
            std::printf("  not solved    an approximate solution ends %.6g from the goal\n",
                        setup.getProblemDefinition()->getSolutionDifference());
        else
            std::printf("  not solved\n");
        if (report.firstSolutionSeconds >= 0.0)
            std::printf("  first         after %.3f s\n", report.firstSolutionSeconds);
        std::printf("  tree          %llu states, %llu edges, after %llu iterations\n", number(report.treeStates),
                    number(report.treeEdges), number(report.iterations));
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

    std::string drawn(const Options &options, const Scene &scene, const TeamSetup &setup, const ob::PlannerData &tree)
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

    std::string viewed(const Scene &scene, const TeamSetup &setup, const PlanReport &report,
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

    /** Write all files that are asked for; one that cannot be written does not keep the others from it. */
    void write(const Options &options, const Scene &scene, const TeamSetup &setup, const PlanReport &report,
               const ob::PlannerData &tree)
    {
        std::string failures;
        const auto attempt = [&failures](const std::string &file, const auto &writeFile)
        {
            if (!file.empty())
                try
                {
                    writeFile(file);
                }
                catch (const std::exception &exception)
                {
                    failures += (failures.empty() ? "" : "; ") + std::string(exception.what());
                }
        };
        attempt(options.savedCertificates,
                [&](const std::string &file) { saveCertificates(*setup.getTeamChecker(), file); });
        attempt(options.report, [&](const std::string &file) { demos::writeOutput(file, report.toJson()); });
        // An approximate path looks like any other in a file, and would be taken for a solution.
        if (report.solved)
        {
            attempt(options.path,
                    [&](const std::string &file) { demos::writeOutput(file, toCsv(setup.getSolutionPath())); });
            attempt(options.animation, [&](const std::string &file)
                    { demos::writeOutput(file, PlanAnimation(scene, setup.getSolutionPath()).toSvg()); });
        }
        attempt(options.picture,
                [&](const std::string &file) { demos::writeOutput(file, drawn(options, scene, setup, tree)); });
        attempt(options.view,
                [&](const std::string &file) { demos::writeOutput(file, viewed(scene, setup, report, tree)); });
        if (!failures.empty())
            throw ompl::Exception(failures);
    }

    /** The scene; a planning scene of MoveIt needs the files of --request, --urdf and --srdf. */
    SceneFile readScene(const Options &options)
    {
        const std::pair<std::string, std::string> files[]{
            {"--request", options.request}, {"--urdf", options.urdf}, {"--srdf", options.srdf}};
        if (!isMoveItScene(options.scene))
        {
            for (const auto &[option, file] : files)
                if (!file.empty())
                    throw ompl::Exception(option,
                                          "is for planning scenes of MoveIt, which " + options.scene + " is not");
            return readSceneFile(options.scene);
        }
        for (const auto &[option, file] : files)
            if (file.empty())
                throw ompl::Exception(options.scene, "is a planning scene of MoveIt, which needs " + option);
        return readMoveItFiles(options.scene, options.request, ArmFile(options.urdf, options.srdf));
    }

    /** What would be planned, for --dry-run */
    void printTask(const Options &options, const Scene &scene, TeamSetup &setup)
    {
        std::printf("%s: start and goal are free\n", scene.getName().c_str());
        std::printf("  workspace     dimensions %u, obstacles %zu, point clouds and maps %zu\n", scene.getDimension(),
                    scene.getObstacles().size(), scene.getSensedObstacles().size());
        for (const Scene::Member &member : scene.getMembers())
            std::printf("  robot         %s: dimensions %u, bodies %zu\n", member.robot->getName().c_str(),
                        member.robot->getStateSpace()->getDimension(), member.robot->getBodies().size());
        std::printf("  resolution    %g of each robot's space, motions %s\n",
                    setup.getStateSpace()->getLongestValidSegmentFraction(), options.motion.c_str());
        std::printf("  planner       %s, method %s, objective %s, seed %u\n", setup.getPlanner()->getName().c_str(),
                    options.method.c_str(), options.objective.c_str(), options.seed);
        for (const auto &[key, parameter] : setup.getPlanner()->params().getParams())
            std::printf("  %-13s %s = %s\n", "", key.c_str(), parameter->getValue().c_str());
        if (options.iterations > 0)
            std::printf("  limit         %llu iterations\n", static_cast<unsigned long long>(options.iterations));
        else
            std::printf("  limit         %g s\n", options.seconds);
        for (const auto &[what, file] : {std::pair{"picture", options.picture},
                                         {"animation", options.animation},
                                         {"path", options.path},
                                         {"report", options.report},
                                         {"certificates", options.savedCertificates}})
            if (!file.empty())
                std::printf("  %-13s %s\n", what, file.c_str());
    }

    int runDynamics(const Options &options)
    {
        demos::DynamicPlan plan;
        plan.scene = options.scene;
        plan.planner = options.planner.empty() ? "RRT" : options.planner;
        plan.method = options.method;
        plan.proven = options.motion == "continuous";
        plan.seconds = options.seconds == 0.0 ? 10.0 : options.seconds;
        plan.iterations = options.iterations;
        plan.seed = options.seed;
        plan.goalTolerance = options.goalTolerance;
        plan.setParameters = [&options](ob::Planner &planner) { setParameters(options, planner); };
        plan.picture = options.picture;
        plan.view = options.view;
        plan.pictureTree = options.pictureTree;
        plan.pictureCertificates = options.pictureCertificates;
        plan.path = options.path;
        plan.report = options.report;
        plan.quiet = options.quiet;
        return demos::run(plan);
    }

    int run(Options options)
    {
        if (options.dynamics)
            return runDynamics(options);
        // What is wrong with the input is told in one line, ours, and not in OMPL's words as well.
        ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
        ompl::RNG::setSeed(options.seed);
        const SceneFile file = readScene(options);
        const Scene &scene = file.scene;
        scene.validate();
        std::vector<std::string> named;
        if (!options.planner.empty())
            named.push_back(options.planner);
        const demos::PlannerChoice choice = demos::choosePlanners(file, named).front();
        if (options.seconds == 0.0)
            options.seconds = file.timeLimit.value_or(10.0);
        const Method method = methodOf(options.method);
        const TeamSetupPtr setup =
            scene.makeSetup(method, options.motion == "continuous" ? CertificateMotionValidator::CONTINUOUS
                                                                   : CertificateMotionValidator::DISCRETE);
        setup->setPlanner(makePlanner(options, choice, setup->getSpaceInformation()));
        if (options.savedCertificates == "-")
            throw ompl::Exception("--save-certificates", "must name a file: certificates are not text");
        demos::prepareOutputs({{"--picture", options.picture},
                               {"--animation", options.animation},
                               {"--view", options.view},
                               {"--path", options.path},
                               {"--report", options.report},
                               {"--save-certificates", options.savedCertificates}},
                              {options.scene, options.request, options.urdf, options.srdf});
        // With the default objective, planners keep their own ways: PRM ends with its first solution.
        if (options.objective != "length")
            setup->setOptimizationObjective(objectiveOf(*setup, options));
        setup->setNearestStructure(nearestStructureOf(options.nearest));
        setup->setup();
        setup->getStatistics().reset();
        requireCertificates(options, *setup);
        if (!options.loadedCertificates.empty())
            loadCertificates(*setup->getTeamChecker(), options.loadedCertificates);
        ompl::msg::setLogLevel(options.quiet ? ompl::msg::LOG_ERROR : ompl::msg::LOG_WARN);
        if (!options.quiet)
            for (const std::string &note : scene.getNotes())
                std::cout << "note: " << note << std::endl;

        if (options.dryRun)
        {
            printTask(options, scene, *setup);
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
        plan(*setup, options, report);
        // Ctrl-C has ended planning alone; another one ends simplifying.
        const bool stopped = demos::takeInterrupt();
        ompl::msg::setLogLevel(ompl::msg::LOG_ERROR);
        ob::PlannerData tree(setup->getSpaceInformation());
        setup->getPlanner()->getPlannerData(tree);
        report.setTree(tree);
        if (options.simplify)
            simplify(*setup, options, report);

        if (!options.quiet)
        {
            if (stopped || demos::interrupted())
                std::puts("interrupted: this is what was found so far");
            print(report, *setup);
        }
        if (!options.quiet && !report.solved)
            for (const auto &[what, name] : {std::pair{"path", options.path}, {"animation", options.animation}})
                if (!name.empty())
                    std::printf("no %s was written to %s\n", what, name.c_str());
        std::fflush(stdout);
        write(options, scene, *setup, report, tree);
        return report.solved ? demos::SOLVED : demos::NOT_SOLVED;
    }
}

int main(int argc, char **argv)
{
    CLI::App app("Plan for the team of a scene", "plan_team");
    Options options;
    declare(app, options);
    return demos::runProgram(app, argc, argv, [&options] { return run(options); });
}
