#include "common/PlanTeamOptions.h"

#include "common/CommandLine.h"
#include "common/PlannerFactory.h"
#include "common/PlannerList.h"

#include "ompl_certificates/planning/Planners.h"
#include "ompl_certificates/team/TeamObjective.h"

#include <ompl/util/Exception.h>

using namespace ompl_certificates;

namespace demos
{
    void declare(CLI::App &app, PlanTeamOptions &options)
    {
        app.add_option("SCENE", options.scene,
                       "Scene file: YAML, a .cfg file of OMPL.app, or a planning scene of MoveIt (YAML)")
            ->required();
        declare(app, options.moveIt);
        app.add_option(
               "--planner", options.planner,
               "Planner: DRRTstar, or the name of OMPL's class. Where a .cfg file has the same planner, its parameters "
               "are used")
            ->default_str("the first of a .cfg file, else DRRTstar for two or more robots and RRTConnect for one");
        addPlannerList(app, true);
        app.add_option("--method", options.method, "How checks are saved")
            ->check(oneOf(methodNames()))
            ->capture_default_str();
        app.add_option("--motion", options.motion, "How motions are checked")
            ->check(oneOf({"discrete", "continuous"}))
            ->capture_default_str();
        app.add_option("--nearest", options.nearest, "What the planner looks for near states in")
            ->check(oneOf(nearestNames()))
            ->capture_default_str();
        app.add_option("--objective", options.objective,
                       "What planners that optimize lower: the length of the path in the team's space, the sum of the "
                       "robots' lengths, the makespan, or the sum of their arrival times")
            ->check(oneOf(objectiveNames()))
            ->capture_default_str();
        auto *time = app.add_option("--time", options.seconds, "Time to plan, in seconds")
                         ->check(positiveNumber())
                         ->default_str("that of a .cfg file or of a request, else 10");
        app.add_option(
               "--iterations", options.iterations,
               "Plan for that many evaluations of the termination condition instead: one per iteration for most "
               "of OMPL's planners, more for some")
            ->check(countUpTo(1000000000000ull))
            ->excludes(time);
        app.add_flag(
            "--first", options.first,
            "End with the first solution, also if the planner could lower its cost; LBTRRT and LazyLBTRRT go on");
        app.add_option(
               "--seed", options.seed,
               "Seed of OMPL's random numbers; the same seed grows the same tree, but for planners whose clock or "
               "threads decide, such as PRM")
            ->check(countUpTo(4294967295ull))
            ->capture_default_str();
        app.add_option("--range", options.range, "The planner's parameter 'range': the length of its steps")
            ->check(positiveNumber());
        app.add_option("--planner-param", options.parameters, "Parameters of the planner: NAME=VALUE ...");
        app.add_flag(
            "--simplify", options.simplify,
            "Shorten the solution before it is written, for --time at most: with OMPL's simplifier, then robot by "
            "robot; with --dynamics its time, robot by robot");
        auto *picture =
            app.add_option("--picture", options.picture, "Write a picture (SVG)")->check(fileEndingIn(".svg"));
        app.add_flag("--picture-tree", options.pictureTree, "Draw the planner's tree, too")->needs(picture);
        app.add_flag("--picture-certificates", options.pictureCertificates, "Draw the certificates, too")
            ->needs(picture);
        app.add_option("--animation", options.animation,
                       "Write a picture in which the robots follow the solution (SVG, for browsers)")
            ->check(fileEndingIn(".svg"));
        app.add_option("--view", options.view,
                       "Write a page to look at all of it in a browser, in 3-D where the scene is (HTML, needs no "
                       "network)")
            ->check(fileEndingIn(".html"));
        auto *path = app.add_option("--path", options.path, "Write the states of the solution, one a line (CSV)");
        auto *step = app.add_option("--path-step", options.pathStep,
                                    "Write a line at each multiple of this time, too, such as the period of a "
                                    "controller")
                         ->check(positiveNumber())
                         ->needs(path);
        app.add_option("--report", options.report, "Write a report (JSON)");
        app.add_option("--load-certificates", options.loadedCertificates,
                       "Begin with the certificates of a file, which --save-certificates wrote");
        app.add_option("--save-certificates", options.savedCertificates,
                       "Write what is known of the obstacles in the end, for a later run");
        auto *dynamics = app.add_flag(
            "--dynamics", options.dynamics,
            "Robots move by controls, with the limits of db-CBS; for YAML with robots of its types. "
            "Planners are then PrioritizedRRT (the default for several robots), and EST, KPIECE1, PDST, RRT (for "
            "one) and SST of ompl::control, and --motion continuous proves each step free between its ends");
        for (const std::string &option : moveItOptionNames())
            dynamics->excludes(app.get_option(option));
        for (const char *option : {"--first", "--objective", "--load-certificates", "--save-certificates"})
            dynamics->excludes(app.get_option(option));
        dynamics->excludes(step);
        app.add_option("--goal-tolerance", options.goalTolerance,
                       "With --dynamics: how far from the goal the team may end, in its space's distance")
            ->check(positiveNumber())
            ->capture_default_str()
            ->needs(dynamics);
        app.add_flag("--quiet", options.quiet, "Print errors only");
        app.add_flag(
            "--dry-run", options.dryRun,
            "Read all, check start and goal and whether files can be written, print what would be planned, and "
            "end");
        group(app, {{"Scenes of MoveIt", moveItOptionNames()},
                    {"Planning",
                     {"--planner", "--list-planners", "--range", "--planner-param", "--time", "--iterations", "--first",
                      "--seed", "--nearest", "--objective", "--simplify", "--dry-run"}},
                    {"Checking", {"--method", "--motion", "--load-certificates", "--save-certificates"}},
                    {"Output",
                     {"--picture", "--picture-tree", "--picture-certificates", "--animation", "--view", "--path",
                      "--path-step", "--report", "--quiet"}},
                    {"Robots that move by controls", {"--dynamics", "--goal-tolerance"}}});
        app.footer(
            "Of picture, animation, view, path and report one may be -, for standard output; all else is then printed to "
            "standard error.\n"
            "Returns 0 if a solution was found, 1 if not (or only an approximate one), 2 for bad input or a file that "
            "could not be written.");
    }

    std::vector<std::pair<std::string, std::string>> outputsOf(const PlanTeamOptions &options)
    {
        return {{"--picture", options.picture}, {"--animation", options.animation},
                {"--view", options.view},       {"--path", options.path},
                {"--report", options.report},   {"--save-certificates", options.savedCertificates}};
    }

    CertificateMotionValidator::Mode modeOf(const PlanTeamOptions &options)
    {
        if (options.motion != "continuous")
            return CertificateMotionValidator::DISCRETE;
        if (!makesCertificates(methodOf(options.method)))
            throw ompl::Exception("--motion",
                                  "continuous needs certificates, which --method " + options.method + " does not make");
        return CertificateMotionValidator::CONTINUOUS;
    }

    bool needsTree(const PlanTeamOptions &options)
    {
        return options.pictureTree || !options.view.empty() || !options.report.empty();
    }

    void setParameters(const PlanTeamOptions &options, ompl::base::Planner &planner)
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
            const auto [name, value] = splitAtEquals("--planner-param", parameter);
            if (name == "range" && !options.range.empty())
                throw ompl::Exception("--planner-param", "gives the range, which --range gives, too");
            set("--planner-param", name, value);
        }
    }
}
