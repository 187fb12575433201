// Arms among the problems of MotionBenchMaker: plans and checks with FCL alone, with the fastest check without
// certificates, and with certificates, from equal seeds, and whether the trees are equal.
//
//     arms FOLDER                                    all robots and families of problems in FOLDER
//     arms FOLDER --robots panda --families box,cage --planners RRT,RRTConnect --methods partial,shared
//
// FOLDER has for each robot a folder: panda/panda.urdf, panda/panda.srdf, panda/problems/box/scene0001.yaml and
// request0001.yaml, and so on.

#include "common/ArmProblems.h"
#include "common/Options.h"

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <ctime>
#include <ompl/util/RandomNumbers.h>

using namespace ompl_certificates;
namespace fs = std::filesystem;
namespace ob = ompl::base;

namespace
{
    volatile std::sig_atomic_t interrupted = 0;

    extern "C" void interrupt(int /*signal*/)
    {
        interrupted = 1;
    }

    struct Options
    {
        std::string folder;
        std::vector<std::string> robots, families;
        std::vector<std::string> planners{"RRTConnect"};
        std::vector<std::string> methods{"shared"};
        std::size_t problems{1000};
        double time{10.0};
        std::size_t states{500}, motions{50};
        unsigned int seed{1};
        double range{0.0};
        bool fresh{false};
    };

    void declare(CLI::App &app, Options &options)
    {
        app.add_option("FOLDER", options.folder, "Folder with a folder for each robot")
            ->required()
            ->check(CLI::ExistingDirectory);
        benchmarks::addList(app, "--robots", options.robots, "Robots, separated by commas; by default all");
        benchmarks::addList(app, "--families", options.families,
                            "Families of problems, separated by commas; by default all");
        benchmarks::addPlanners(app, options.planners);
        benchmarks::addMethods(app, options.methods);
        benchmarks::addPositive(app, "--problems", options.problems, "The first so many problems of each family");
        benchmarks::addPositive(app, "--time", options.time, "Time for each plan, in seconds of the clock");
        benchmarks::addPositive(app, "--states", options.states, "Random states to check in each scene");
        benchmarks::addPositive(app, "--motions", options.motions, "Random motions to check in each scene");
        benchmarks::addPositive(app, "--seed", options.seed, "Seed of all plans");
        app.add_option("--range", options.range,
                       "The length of the planners' steps; by default Arm::getPlannerRange()");
        app.add_flag("--fresh", options.fresh,
                     "Read the robot anew for each plan, as the first plan of a program finds it; no random checks");
        app.footer(
            "Rows without a problem that all three solved have no ratios.\n"
            "An interrupt ends it after the present row, with the means of what is done.\n"
            "Returns 1 if a tree or a verdict differs from that of FCL alone, 2 for bad input.");
    }

    double cpuSeconds()
    {
        return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
    }

    /** What one method needed for a family of problems */
    struct Family
    {
        std::string method;
        std::vector<double> planSeconds{};
        std::vector<bool> solved{};
        std::vector<double> checkingSeconds{};
        std::vector<std::vector<std::string>> digests{};
        double stateSeconds{0.0}, motionSeconds{0.0};
        std::vector<bool> verdicts{};

        void plan(const Scene &scene, const std::string &planner, const Options &options)
        {
            benchmarks::PlanTask task{scene, planner, methodOf(method)};
            task.iterations = 1000000000;
            task.seconds = options.time;
            task.seed = options.seed;
            task.range = options.range;
            task.keepGoing = false;
            const benchmarks::PlanResult result = benchmarks::run(task);
            planSeconds.push_back(result.totalSeconds);
            solved.push_back(result.solved);
            checkingSeconds.push_back(result.checkingSeconds);
            digests.push_back(result.digests);
        }

        /** Check random states, and motions from such as are valid towards others, by a planner's step. Half as many
            before fill the certificates. */
        void check(const Scene &scene, const Options &options)
        {
            const TeamSetupPtr setup = scene.makeSetup(methodOf(method));
            setup->setup();
            const auto &si = setup->getSpaceInformation();
            const auto &space = setup->getStateSpace();
            ompl::RNG rng(options.seed);
            const double step = 0.2 * space->getMaximumExtent();
            std::vector<ob::ScopedState<>> states(options.states * 3 / 2, ob::ScopedState<>(space));
            for (auto &state : states)
                space->copyFromReals(state.get(), benchmarks::randomReals(scene, rng));
            std::vector<std::size_t> valid;
            double start = 0.0;
            for (std::size_t i = 0; i < states.size(); ++i)
            {
                if (i == options.states / 2)
                    start = cpuSeconds();
                verdicts.push_back(si->isValid(states[i].get()));
                if (verdicts.back())
                    valid.push_back(i);
            }
            stateSeconds += cpuSeconds() - start;
            if (valid.empty())
                return;
            ob::ScopedState<> target(space);
            for (std::size_t i = 0; i < options.motions * 3 / 2; ++i)
            {
                const ob::State *from = states[valid[i % valid.size()]].get(), *to = states[i % states.size()].get();
                const double distance = space->distance(from, to);
                space->interpolate(from, to, distance > step ? step / distance : 1.0, target.get());
                if (i == options.motions / 2)
                    start = cpuSeconds();
                verdicts.push_back(si->checkMotion(from, target.get()));
            }
            motionSeconds += cpuSeconds() - start;
        }

        std::size_t solvedCount() const
        {
            return static_cast<std::size_t>(std::count(solved.begin(), solved.end(), true));
        }

        /** The time that the share \e quantile of all plans needs, in milliseconds; what was not solved counts by its
            time */
        double planMilliseconds(double quantile) const
        {
            std::vector<double> sorted = planSeconds;
            std::sort(sorted.begin(), sorted.end());
            const double rank = std::ceil(quantile * static_cast<double>(sorted.size()));
            return 1e3 * sorted[static_cast<std::size_t>(std::max(rank, 1.0)) - 1];
        }
    };

    /** Ratios of times, one for each row that has one */
    struct Ratios
    {
        std::vector<double> values;

        /** The ratio as the table shows it */
        std::string add(double numerator, double denominator)
        {
            if (numerator <= 0.0 || denominator <= 0.0)
                return "-";
            values.push_back(numerator / denominator);
            char text[32];
            std::snprintf(text, sizeof(text), "%.2f", values.back());
            return text;
        }

        void print(const char *name) const
        {
            std::printf("%s: geometric mean %.2f, smallest %.2f\n", name, benchmarks::geometricMean(values),
                        *std::min_element(values.begin(), values.end()));
        }
    };

    class Table
    {
    public:
        Table()
        {
            std::puts(
                "| robot | family | planner | method | solved: fcl, standard, method | median plan (ms): fcl, "
                "standard, method | 95 % (ms) | checking: fcl (s) | fcl / standard | fcl / method | standard / method "
                "| us a state: fcl, standard, method | us a motion | equal |");
            std::puts("|---|---|---|---|---|---|---|---|---|---|---|---|---|---|");
        }

        void add(const std::string &robot, const std::string &family, const std::string &planner, const Family &fcl,
                 const Family &standard, const Family &method, const Options &options)
        {
            const auto problems = fcl.solved.size();
            const Family *all[]{&fcl, &standard, &method};
            const auto printThree = [&](const char *format, const auto &value)
            {
                std::printf(" ");
                for (const Family *each : all)
                {
                    std::printf(format, value(*each));
                    std::printf(each == &method ? " |" : ", ");
                }
            };
            std::printf("| %s | %s | %s | %s |", robot.c_str(), family.c_str(), planner.c_str(), method.method.c_str());
            printThree("%zu", [](const Family &each) { return each.solvedCount(); });
            printThree("%.3g", [](const Family &each) { return each.planMilliseconds(0.5); });
            printThree("%.3g", [](const Family &each) { return each.planMilliseconds(0.95); });
            // Plans that ran out of time are not the same plans.
            double seconds[3]{};
            bool equal = fcl.verdicts == standard.verdicts && fcl.verdicts == method.verdicts;
            for (std::size_t i = 0; i < problems; ++i)
                if (fcl.solved[i] && standard.solved[i] && method.solved[i])
                {
                    for (std::size_t k = 0; k < 3; ++k)
                        seconds[k] += all[k]->checkingSeconds[i];
                    equal = equal && fcl.digests[i] == standard.digests[i] && fcl.digests[i] == method.digests[i];
                }
            different_ += equal ? 0 : 1;
            ++rows_;
            std::printf(" %.3f | %s | %s | %s |", seconds[0], fclToStandard_.add(seconds[0], seconds[1]).c_str(),
                        fclToMethod_.add(seconds[0], seconds[2]).c_str(),
                        standardToMethod_.add(seconds[1], seconds[2]).c_str());
            const double scale = 1e6 / static_cast<double>(problems);
            const auto states = static_cast<double>(options.states), motions = static_cast<double>(options.motions);
            if (options.fresh)
                std::printf(" - | - |");
            else
            {
                printThree("%.3g", [&](const Family &each) { return scale * each.stateSeconds / states; });
                printThree("%.3g", [&](const Family &each) { return scale * each.motionSeconds / motions; });
            }
            std::printf(" %s |\n", equal ? "yes" : "NO");
            std::fflush(stdout);
        }

        /** Prints the means, and returns whether all trees and verdicts were equal. */
        bool finish() const
        {
            if (rows_ == 0)
                return true;
            std::puts("");
            if (!fclToMethod_.values.empty())
            {
                fclToStandard_.print("checking, fcl / standard");
                fclToMethod_.print("checking, fcl / method");
                standardToMethod_.print("checking, standard / method");
            }
            if (const std::size_t without = rows_ - fclToMethod_.values.size(); without > 0)
                std::printf("rows without a problem that all three solved, left out of the means: %zu\n", without);
            std::printf("rows with trees or verdicts that differ: %u\n", different_);
            return different_ == 0;
        }

    private:
        Ratios fclToStandard_, fclToMethod_, standardToMethod_;
        std::size_t rows_{0};
        unsigned int different_{0};
    };

    /** FCL alone, no certificates, and the methods to compare with these */
    std::vector<Family> familiesOf(const Options &options)
    {
        std::vector<Family> methods{{nameOf(Method::FCL)}, {nameOf(Method::STANDARD)}};
        for (const std::string &method : options.methods)
            methods.push_back({method});
        return methods;
    }

    void compare(const std::string &robot, const std::string &family, const std::vector<Scene> &scenes,
                 const std::string &planner, const Options &options, Table &table)
    {
        std::vector<Family> methods = familiesOf(options);
        for (const Scene &scene : scenes)
        {
            // The first use of a shape prepares it, so checks come first.
            for (Family &method : methods)
                method.check(scene, options);
            for (Family &method : methods)
                method.plan(scene, planner, options);
        }
        for (std::size_t i = 2; i < methods.size(); ++i)
            table.add(robot, family, planner, methods[0], methods[1], methods[i], options);
    }

    /** Each plan is the first that is made for its robot: nothing is known of the links' pairs. */
    void compareFresh(const std::string &robot, const std::string &description, const fs::path &family,
                      const std::string &planner, const Options &options, Table &table)
    {
        std::vector<Family> methods = familiesOf(options);
        for (const auto &files : benchmarks::problemFiles(family, options.problems))
            for (Family &method : methods)
            {
                const ArmFile file(description + ".urdf", description + ".srdf");
                const auto scene = benchmarks::problemOf(files, file);
                if (!scene)
                    break;
                method.plan(*scene, planner, options);
            }
        for (std::size_t i = 2; i < methods.size(); ++i)
            table.add(robot, family.filename().string(), planner, methods[0], methods[1], methods[i], options);
    }

    int run(const Options &options)
    {
        std::signal(SIGINT, interrupt);
        std::signal(SIGTERM, interrupt);
        Table table;
        const fs::path folder = options.folder;
        for (const std::string &robot : benchmarks::namesIn(folder, options.robots))
        {
            const fs::path description = folder / robot / robot;
            const ArmFile file(description.string() + ".urdf", description.string() + ".srdf");
            for (const std::string &family : benchmarks::namesIn(folder / robot / "problems", options.families))
            {
                const fs::path problems = folder / robot / "problems" / family;
                const auto scenes = benchmarks::problemsIn(problems, file, options.problems);
                for (const std::string &planner : options.planners)
                    if (!interrupted && !scenes.empty() && options.fresh)
                        compareFresh(robot, description.string(), problems, planner, options, table);
                    else if (!interrupted && !scenes.empty())
                        compare(robot, family, scenes, planner, options, table);
            }
        }
        return table.finish() ? 0 : 1;
    }
}

int main(int argc, char **argv)
{
    CLI::App app("Arms among the problems of MotionBenchMaker, with and without certificates", "arms");
    Options options;
    declare(app, options);
    return benchmarks::runProgram(app, argc, argv, [&options] { return run(options); });
}
