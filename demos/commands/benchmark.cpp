// Benchmarks planners for the teams of scenes, once with each method, with OMPL's own Benchmark.
//
//     certificates benchmark scene.yaml --planners RRT,RRTConnect --runs 10 --time 5 --log scene.log
//     ompl_benchmark_statistics scene.log -d scene.db

#include "commands/Commands.h"
#include "common/CommandLine.h"
#include "common/Interrupt.h"
#include "common/MoveItOptions.h"
#include "common/Outputs.h"
#include "common/PlannerFactory.h"
#include "common/PlannerList.h"
#include "common/TeamBenchmark.h"

#include "ompl_certificates/team/TeamObjective.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>
#include <unistd.h>

using namespace ompl_certificates;

namespace
{
    struct Options
    {
        std::vector<std::string> scenes;
        demos::MoveItOptions moveIt;
        std::optional<std::string> planners;
        std::string methods;
        std::string nearest{"kdtree"};
        std::string motion{"discrete"};
        std::vector<std::string> parameters;
        std::string objective{"length"};
        bool first{false};
        unsigned int runs{0};
        double seconds{0.0};
        std::uint32_t seed{1};
        std::string log;
    };

    void declare(CLI::App &app, Options &options)
    {
        app.add_option(
               "SCENE", options.scenes,
               "Scene files: YAML, .cfg files of OMPL.app, or planning scenes of MoveIt (YAML) with one request and "
               "one robot")
            ->required();
        demos::declare(app, options.moveIt);
        app.add_option("--planners", options.planners,
                       "Planners: DRRTstar and names of OMPL's classes, separated by commas")
            ->default_str("those of a .cfg file, else DRRTstar for two or more robots and RRTConnect for one");
        demos::addPlannerList(app, false);
        app.add_option("--methods", options.methods, "Methods, separated by commas")
            ->default_str("all that can check motions");
        app.add_option("--motion", options.motion,
                       "How motions are checked: discrete, or continuous, which proves them")
            ->check(demos::oneOf({"discrete", "continuous"}))
            ->capture_default_str();
        app.add_option("--planner-param", options.parameters,
                       "Parameters of planners: NAME=VALUE for all of them, PLANNER.NAME=VALUE for one");
        app.add_option("--objective", options.objective,
                       "What planners that optimize lower, as in certificates plan; the table has costs by it")
            ->check(demos::oneOf(objectiveNames()))
            ->capture_default_str();
        app.add_flag("--first", options.first, "End each run with its first solution");
        app.add_option("--nearest", options.nearest, "What planners look for near states in")
            ->check(demos::oneOf(demos::nearestNames()))
            ->capture_default_str();
        app.add_option("--runs", options.runs, "Runs of each planner with each method")
            ->check(demos::countUpTo(1000000ull))
            ->default_str("that of a .cfg file, else 10");
        app.add_option("--time", options.seconds, "Time for each run, in seconds")
            ->check(demos::positiveNumber())
            ->default_str("that of a .cfg file or of a request, else 5");
        app.add_option("--seed", options.seed, "Seed of the first run; each further one adds 1")
            ->check(demos::countUpTo(4000000000ull))
            ->capture_default_str();
        app.add_option("--log", options.log,
                       "Write a log for ompl_benchmark_statistics. Of one scene it may be -, for standard output; of "
                       "several there is one each: of F.log they are F_SCENE.log");
        app.footer("Returns 0 when the benchmark is complete, 1 if it was interrupted, 2 for bad input.");
    }

    /** The words of a list; there must be one, and none may be repeated */
    std::vector<std::string> listOf(const std::string &option, const std::string &text)
    {
        std::vector<std::string> words = demos::splitAtCommas(text);
        if (words.empty())
            throw ompl::Exception(option, "names nothing");
        for (auto word = words.begin(); word != words.end(); ++word)
            if (std::find(words.begin(), word, *word) != word)
                throw ompl::Exception(option, "names " + *word + " twice");
        return words;
    }

    /** Where the log of a scene goes */
    std::string logOf(const Options &options, const std::string &scene)
    {
        if (options.log.empty() || options.log == "-" || options.scenes.size() == 1)
            return options.log;
        const std::filesystem::path log(options.log);
        const std::string name = log.stem().string() + "_" + std::filesystem::path(scene).stem().string();
        return (log.parent_path() / (name + (log.has_extension() ? log.extension().string() : ".log"))).string();
    }

    /** Where the logs of all scenes go, which must be different files */
    std::vector<std::pair<std::string, std::string>> logsOf(const Options &options)
    {
        if (options.log == "-" && options.scenes.size() > 1)
            throw ompl::Exception("--log", "- is for one scene; of several, name a file");
        std::vector<std::pair<std::string, std::string>> logs;
        for (const std::string &scene : options.scenes)
        {
            const std::string log = logOf(options, scene);
            for (std::size_t i = 0; i < logs.size() && !log.empty(); ++i)
                if (logs[i].second == log)
                    throw ompl::Exception("--log", log + " would be the log of " + options.scenes[i] + " and of " +
                                                       scene + ": benchmark them one by one");
            logs.emplace_back("--log", log);
        }
        return logs;
    }

    /** A scene and what of its benchmark the options left open */
    struct Task
    {
        Scene scene;
        std::vector<demos::PlannerChoice> planners;
        ompl::tools::Benchmark::Request request;
    };

    /** Gives planners a parameter of the command line. */
    void addParameter(const std::string &parameter, std::vector<demos::PlannerChoice> &planners)
    {
        const auto [name, value] = demos::splitAtEquals("--planner-param", parameter);
        const std::string planner = name.substr(0, name.find('.'));
        const auto isNamed = [&planner](const demos::PlannerChoice &choice) { return choice.planner == planner; };
        const bool isForOne = planner != name && std::any_of(planners.begin(), planners.end(), isNamed);
        for (demos::PlannerChoice &choice : planners)
            if (!isForOne || isNamed(choice))
                choice.parameters.push_back(
                    {isForOne ? name.substr(planner.size() + 1) : name, value, "--planner-param: " + choice.planner});
    }

    Task readTask(const Options &options, const std::string &file)
    {
        const SceneFile content = demos::readScene(file, options.moveIt);
        content.scene.validate();
        Task task{content.scene, {}, {}};
        if (options.objective == "arrival" && content.scene.hasRegions())
            throw ompl::Exception("--objective", "arrival needs one state as the goal of each robot");
        task.planners = demos::choosePlanners(content, options.planners ? listOf("--planners", *options.planners)
                                                                        : std::vector<std::string>());
        for (const std::string &parameter : options.parameters)
            addParameter(parameter, task.planners);
        ompl::tools::Benchmark::Request &request = task.request;
        request = ompl::tools::Benchmark::Request(content.timeLimit.value_or(5.0), content.memoryLimit.value_or(4096.0),
                                                  content.runCount.value_or(10));
        if (options.seconds > 0.0)
            request.maxTime = options.seconds;
        if (options.runs > 0)
            request.runCount = options.runs;
        request.displayProgress = isatty(STDOUT_FILENO) != 0;
        request.saveConsoleOutput = false;
        request.simplify = false;
        return task;
    }

    using Run = demos::TeamBenchmark::Run;

    /** The median of a field of some runs, of which those that are not numbers are left out */
    double median(const std::vector<Run> &runs, const std::string &planner, Method method, double Run::*field)
    {
        std::vector<double> values;
        for (const Run &run : runs)
            if (run.planner == planner && run.method == method && !std::isnan(run.*field))
                values.push_back(run.*field);
        if (values.empty())
            return std::numeric_limits<double>::quiet_NaN();
        const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
        std::nth_element(values.begin(), middle, values.end());
        if (values.size() % 2 == 1)
            return *middle;
        return 0.5 * (*middle + *std::max_element(values.begin(), middle));
    }

    double solvedPercent(const std::vector<Run> &runs, const std::string &planner, Method method)
    {
        double count = 0.0, solved = 0.0;
        for (const Run &run : runs)
            if (run.planner == planner && run.method == method)
            {
                count += 1.0;
                solved += run.solved ? 1.0 : 0.0;
            }
        return 100.0 * solved / count;  // no number without runs
    }

    void printRatio(double value, double reference)
    {
        if (std::isnan(value) || std::isnan(reference) || reference <= 0.0)
            std::printf(" %11s", "-");
        else
            std::printf(" %10.2fx", value / reference);
    }

    /** Medians over the runs: of the first method as they are, of the others as multiples of those */
    void printTable(const std::string &scene, const std::vector<Run> &runs,
                    const std::vector<demos::PlannerChoice> &planners, const std::vector<Method> &methods)
    {
        const auto fields = {&Run::checkingSeconds, &Run::nearestSeconds, &Run::seconds, &Run::states, &Run::cost};
        std::printf("\n%s: medians, and multiples of those of %s\n%-24s%-10s %11s %11s %11s %11s %11s %11s\n",
                    scene.c_str(), nameOf(methods.front()).c_str(), "planner", "method", "checking s", "nearest s",
                    "total s", "states", "cost", "solved %");
        for (const demos::PlannerChoice &choice : planners)
            for (const Method method : methods)
            {
                const std::string &planner = choice.title;
                std::printf("%-24s%-10s", planner.c_str(), nameOf(method).c_str());
                for (const auto field : fields)
                {
                    const double value = median(runs, planner, method, field);
                    if (method != methods.front())
                        printRatio(value, median(runs, planner, methods.front(), field));
                    else if (std::isnan(value))
                        std::printf(" %11s", "-");
                    else
                        std::printf(" %11.4g", value);
                }
                const double solved = solvedPercent(runs, planner, method);
                if (std::isnan(solved))
                    std::printf(" %11s\n", "-");
                else
                    std::printf(" %11.0f\n", solved);
            }
    }

    std::vector<Method> methodsOf(const Options &options)
    {
        const bool isContinuous = options.motion == "continuous";
        std::vector<Method> methods;
        if (options.methods.empty())
        {
            for (const Method method : allMethods())
                if (!isContinuous || makesCertificates(method))
                    methods.push_back(method);
            return methods;
        }
        for (const std::string &name : listOf("--methods", options.methods))
        {
            if (const std::string why = demos::oneOf(demos::methodNames())(name); !why.empty())
                throw ompl::Exception("--methods", why);
            methods.push_back(methodOf(name));
            if (isContinuous && !makesCertificates(methods.back()))
                throw ompl::Exception("--motion",
                                      "continuous needs certificates, which method " + name + " does not make");
        }
        return methods;
    }

    int run(const Options &options)
    {
        ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
        ompl::RNG::setSeed(options.seed);
        std::vector<Method> methods = methodsOf(options);
        demos::TeamBenchmark::Settings settings;
        settings.nearest = nearestStructureOf(options.nearest);
        settings.mode = options.motion == "continuous" ? CertificateMotionValidator::CONTINUOUS
                                                       : CertificateMotionValidator::DISCRETE;
        settings.objective = options.objective;
        settings.endsAtFirst = options.first;
        settings.seed = options.seed;
        // The first one is what the others are compared with: one without certificates, FCL alone foremost.
        const auto order = [](Method method) { return method == Method::FCL ? 0 : method == Method::STANDARD ? 1 : 2; };
        std::stable_sort(methods.begin(), methods.end(), [&](Method a, Method b) { return order(a) < order(b); });

        const auto logs = logsOf(options);
        std::vector<std::string> inputs = options.scenes;
        inputs.insert(inputs.end(), {options.moveIt.request, options.moveIt.urdf, options.moveIt.srdf});
        std::vector<Task> tasks;
        for (const std::string &file : options.scenes)
        {
            tasks.push_back(readTask(options, file));
            // What cannot be planned for shows here, before hours have passed.
            demos::TeamBenchmark(tasks.back().scene, tasks.back().planners, methods, settings);
            const std::vector<std::string> &files = tasks.back().scene.getFiles();
            inputs.insert(inputs.end(), files.begin(), files.end());
        }
        demos::prepareOutputs(logs, inputs);

        demos::catchInterrupts();
        demos::Outputs outputs;
        for (std::size_t i = 0; i < tasks.size() && !demos::interrupted(); ++i)
        {
            const Task &task = tasks[i];
            for (const std::string &note : task.scene.getNotes())
                std::printf("note: %s: %s\n", task.scene.getName().c_str(), note.c_str());
            demos::TeamBenchmark benchmark(task.scene, task.planners, methods, settings);
            if (!benchmark.runAll(task.request))
                std::puts("interrupted: these are the runs that were complete");
            printTable(task.scene.getName(), benchmark.getRuns(), task.planners, methods);
            std::fflush(stdout);
            outputs.attempt(logs[i].second,
                            [&](const std::string &file)
                            {
                                std::ostringstream log;
                                benchmark.saveResultsToStream(log);
                                demos::writeOutput(file, log.str());
                            });
        }
        outputs.finish();
        return demos::interrupted() ? demos::NOT_SOLVED : demos::SOLVED;
    }
}

demos::Work demos::declareBenchmark(CLI::App &app)
{
    const auto options = std::make_shared<Options>();
    declare(app, *options);
    return [options] { return run(*options); };
}
