// Planners for teams at equal time: success, time to the first solution, cost at the end, and the checks.
//
//     teams demos/scenes/*.yaml --planners DRRTstar,RRTConnect,RRTstar,BITstar --time 10 --seeds 20
//     teams --kind boxes --robots 8 --instances 100 --planners DRRTstar --time 1 --first

#include "common/Options.h"
#include "generators/TeamScenes.h"
#include "ompl_certificates/planning/DRRTstar.h"
#include "ompl_certificates/planning/Planners.h"
#include "ompl_certificates/scene/SceneFile.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>
#include <ompl/util/Time.h>

using namespace ompl_certificates;
namespace ob = ompl::base;

namespace
{
    struct Options
    {
        std::vector<std::string> scenes;
        std::vector<std::string> planners{"DRRTstar", "RRTConnect", "RRT", "BKPIECE1", "KPIECE1", "BITstar"};
        std::vector<std::string> methods{"shared"};
        std::string kind;
        std::vector<std::size_t> robots;
        double seconds{5.0}, size{0.0};
        unsigned int seeds{5}, instances{1};
        bool onlyFirst{false}, separate{false};
    };

    /** One plan */
    struct Run
    {
        double first{std::numeric_limits<double>::infinity()}, cost{std::numeric_limits<double>::infinity()};
        double questions{0.0}, pairs{0.0};
        bool isValid{true};
    };

    Run plan(const Options &options, const Scene &scene, const std::string &planner, Method method, std::uint32_t seed)
    {
        ompl::RNG::setSeed(seed);
        const TeamSetupPtr setup = scene.makeSetup(method);
        setup->setPlanner(makePlanner(planner, setup->getSpaceInformation()));
        if (options.separate && planner == "DRRTstar")
            setup->getPlanner()->params().setParam("share_roadmaps", "0");
        setup->setup();
        setup->getStatistics().reset();
        Run run;
        const ompl::time::point start = ompl::time::now();
        const auto elapsed = [&start] { return ompl::time::seconds(ompl::time::now() - start); };
        setup->getProblemDefinition()->setIntermediateSolutionCallback(
            [&](const ob::Planner *, const std::vector<const ob::State *> &, ob::Cost)
            { run.first = std::min(run.first, elapsed()); });
        setup->solve(ob::PlannerTerminationCondition(
            [&] { return elapsed() > options.seconds || (options.onlyFirst && std::isfinite(run.first)); }));
        const double end = elapsed();
        // The check of the path, below, asks as well.
        const CheckCounts counts = setup->getStatistics().getCounts();
        run.questions = static_cast<double>(counts.asked);
        run.pairs = static_cast<double>(counts.pairPoses);
        if (setup->haveExactSolutionPath())
        {
            run.first = std::min(run.first, end);
            run.cost = setup->getSolutionPath().length();
            run.isValid = setup->getSolutionPath().check();
        }
        else
            run.first = std::numeric_limits<double>::infinity();
        return run;
    }

    double medianOf(const std::vector<Run> &runs, double Run::*field)
    {
        std::vector<double> values;
        for (const Run &run : runs)
            values.push_back(run.*field);
        return benchmarks::median(values);
    }

    /** A number, or a dash where half of the runs have none */
    std::string text(double value, const char *format)
    {
        char digits[32];
        std::snprintf(digits, sizeof(digits), format, value);
        return std::isfinite(value) ? digits : "–";
    }

    void printRow(const std::string &name, std::size_t robots, const std::string &planner, Method method,
                  const std::vector<Run> &runs)
    {
        const auto solved =
            std::count_if(runs.begin(), runs.end(), [](const Run &run) { return std::isfinite(run.cost); });
        double worst = 0.0;
        for (const Run &run : runs)
            worst = std::max(worst, run.first);
        std::printf("| %s | %zu | %s | %s | %td of %zu | %s | %s | %s | %.0f | %.0f |\n", name.c_str(), robots,
                    planner.c_str(), nameOf(method).c_str(), solved, runs.size(),
                    text(medianOf(runs, &Run::first), "%.4f").c_str(), text(worst, "%.3f").c_str(),
                    text(medianOf(runs, &Run::cost), "%.5g").c_str(), medianOf(runs, &Run::questions),
                    medianOf(runs, &Run::pairs));
        std::fflush(stdout);
        if (!std::all_of(runs.begin(), runs.end(), [](const Run &run) { return run.isValid; }))
            throw ompl::Exception(name, planner + " gave a path that is not valid");
    }

    /** A row for each planner and method, over all seeds of all scenes */
    void compare(const Options &options, const std::string &name, const std::vector<Scene> &scenes)
    {
        for (const std::string &planner : options.planners)
            for (const std::string &method : options.methods)
            {
                std::vector<Run> runs;
                for (const Scene &scene : scenes)
                    for (std::uint32_t seed = 1; seed <= options.seeds; ++seed)
                        runs.push_back(plan(options, scene, planner, methodOf(method), seed));
                printRow(name, scenes.front().getMembers().size(), planner, methodOf(method), runs);
            }
    }

    const generators::TeamKind &kindOf(const Options &options)
    {
        const auto &kinds = generators::teamKinds();
        const auto kind = std::find_if(kinds.begin(), kinds.end(),
                                       [&](const generators::TeamKind &one) { return one.name == options.kind; });
        if (kind == kinds.end())
            throw ompl::Exception("--kind", "there is no kind '" + options.kind + "'");
        return *kind;
    }

    /** Generated scenes of a kind, from seeds 1, 2, ... */
    std::vector<Scene> generated(const Options &options, std::size_t robots)
    {
        const generators::TeamKind &kind = kindOf(options);
        std::vector<Scene> scenes;
        for (std::uint64_t seed = 1; seed <= options.instances; ++seed)
        {
            generators::TeamSettings settings = kind.defaults;
            settings.robots = static_cast<unsigned int>(robots);
            settings.seed = seed;
            if (options.size > 0.0)
                settings.size = options.size;
            const generators::SceneTexts texts = kind.make(settings);
            if (!texts.meshes.empty())
                throw ompl::Exception("--kind", options.kind + " has meshes: certificates generate writes its files");
            scenes.push_back(sceneFromYaml(texts.yaml, options.kind));
        }
        return scenes;
    }

    /** The scenes of one row: one of a file, or all instances of a kind */
    struct Group
    {
        std::string name;
        std::vector<Scene> scenes;
    };

    /** All groups: what cannot be read or made shows before anything is planned. */
    std::vector<Group> groupsOf(const Options &options)
    {
        const auto sizesOr = [&options](std::size_t all)
        { return options.robots.empty() ? std::vector<std::size_t>{all} : options.robots; };
        if (options.scenes.empty() && options.kind.empty())
            throw ompl::Exception("Scene files or --kind are needed");
        std::vector<Group> groups;
        for (const std::string &file : options.scenes)
        {
            const Scene scene = loadScene(file);
            scene.validate();
            for (const std::size_t robots : sizesOr(scene.getMembers().size()))
                if (robots <= scene.getMembers().size())
                    groups.push_back({scene.getName(), {scene.withFirstRobots(robots)}});
        }
        if (!options.kind.empty())
            for (const std::size_t robots : sizesOr(kindOf(options).defaults.robots))
                groups.push_back({options.kind, generated(options, robots)});
        if (groups.empty())
            throw ompl::Exception("--robots", "no scene has so many");
        return groups;
    }

    int run(const Options &options)
    {
        ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
        // Throws if there is no such planner.
        for (const std::string &planner : options.planners)
            plannerDescription(planner);
        const std::vector<Group> groups = groupsOf(options);
        std::puts(
            "| scene | R | planner | method | solved | first solution (s) | slowest (s) | cost | obstacle questions "
            "| robot pairs |");
        std::puts("|---|---|---|---|---|---|---|---|---|---|");
        for (const Group &group : groups)
            compare(options, group.name, group.scenes);
        return 0;
    }
}

int main(int argc, char **argv)
{
    CLI::App app("Planners for teams at equal time", "teams");
    Options options;
    app.add_option("SCENES", options.scenes, "Scene files")->check(CLI::ExistingFile);
    benchmarks::addList(app, "--planners", options.planners, "Planners, separated by commas");
    benchmarks::addAllMethods(app, options.methods);
    std::vector<std::string> kinds;
    for (const generators::TeamKind &kind : generators::teamKinds())
        kinds.push_back(kind.name);
    CLI::Option *kind =
        app.add_option("--kind", options.kind, "Generated scenes of that kind; see certificates generate --help")
            ->check(CLI::IsMember(kinds));
    benchmarks::addList(app, "--robots", options.robots,
                        "Team sizes: the first robots of each scene; by default all of a scene, or as many as the kind "
                        "has by default")
        ->check(benchmarks::positive());
    app.add_option("--size", options.size, "The side of generated scenes")->check(benchmarks::positive())->needs(kind);
    app.add_option("--time", options.seconds, "Time for each plan, in seconds")->check(benchmarks::positive());
    benchmarks::addPositive(app, "--seeds", options.seeds, "Plans of each scene, from seeds 1, 2, ...");
    benchmarks::addPositive(app, "--instances", options.instances,
                            "Generated scenes of each size, from seeds 1, 2, ...")
        ->needs(kind);
    app.add_flag("--first", options.onlyFirst, "End each plan with its first solution");
    app.add_flag("--separate-roadmaps", options.separate, "DRRTstar with a roadmap for each robot");
    app.footer(
        "Medians are over all runs; an unsolved one takes for ever. Questions are robots' poses for which the "
        "obstacles were asked, pairs those that were checked. Returns 2 for bad input.");
    return benchmarks::runProgram(app, argc, argv, [&options] { return run(options); });
}
