// Whole plans, with and without certificates in turns, and a table of what certificates save.
//
//     whole_plans ../demos/scenes/*.yaml --planners RRT,RRTstar --iterations 20000 --repeats 5
//     whole_plans ../demos/scenes/paper_five_discs.yaml --stock --robots 1,2,3,4,5 --planners RRT --iterations 100000

#include "common/Options.h"
#include "ompl_certificates/scene/SceneFile.h"

#include <algorithm>
#include <cstdio>
#include <iostream>

using namespace ompl_certificates;

namespace
{
    struct Options
    {
        std::vector<std::string> scenes;
        std::vector<std::string> planners{"RRT", "RRTConnect", "RRTstar", "EST", "KPIECE1"};
        std::vector<std::string> methods{"shared"};
        std::vector<std::size_t> robots;
        unsigned int iterations{10000};
        unsigned int repeats{3};
        std::uint32_t seed{1};
        double range{0.0};
        bool stopAtGoal{false};
        bool fastest{false};
        bool stock{false};
    };

    void declare(CLI::App &app, Options &options)
    {
        app.add_option("SCENES", options.scenes, "Scene files (YAML)")->required()->check(CLI::ExistingFile);
        benchmarks::addPlanners(app, options.planners);
        benchmarks::addMethods(app, options.methods);
        benchmarks::addList(app, "--robots", options.robots,
                            "Plan for the first so many robots of each scene that has as many; by default for all")
            ->check(benchmarks::positive());
        app.add_flag("--stock", options.stock,
                     "Compare with OMPL alone: its compound space and its nearest-neighbor structure, too");
        benchmarks::addPositive(app, "--iterations", options.iterations, "Iterations of each plan");
        benchmarks::addPositive(app, "--repeats", options.repeats, "How often each plan is made; medians are printed");
        benchmarks::addPositive(app, "--seed", options.seed, "Seed of OMPL's random numbers, the same for all plans");
        app.add_option("--range", options.range, "The length of the planners' steps; by default the planner's own")
            ->check(benchmarks::positive());
        app.add_flag("--stop-at-goal,!--keep-going", options.stopAtGoal,
                     "Plan only until the goal is reached; by default all iterations are made");
        app.add_flag("--fastest", options.fastest,
                     "Compare the fastest repeats and not medians: for a machine with other things to do");
        app.footer("Returns 1 if a tree differs from that of the standard method, 2 for bad input.");
    }

    double least(const std::vector<double> &values)
    {
        return *std::min_element(values.begin(), values.end());
    }

    /** Two times measured in turns */
    class Times
    {
    public:
        void add(double certified, double standard)
        {
            certified_.push_back(certified);
            standard_.push_back(standard);
            ratios_.push_back(certified / standard);
        }

        double getRatio(bool fastest) const
        {
            return fastest ? least(certified_) / least(standard_) : benchmarks::median(ratios_);
        }

        double getStandard(bool fastest) const
        {
            return fastest ? least(standard_) : benchmarks::median(standard_);
        }

    private:
        std::vector<double> certified_, standard_, ratios_;
    };

    /** The ratios of one row to the standard method */
    struct Row
    {
        double checking, total;
        bool equal;
    };

    Row compare(const Options &options, const Scene &scene, const std::string &planner, const std::string &method)
    {
        benchmarks::PlanTask task{scene, planner};
        task.iterations = options.iterations;
        task.range = options.range;
        task.seed = options.seed;
        task.keepGoing = !options.stopAtGoal;
        Times checking, total;
        benchmarks::PlanResult standard, certified;
        bool equal = true;
        for (unsigned int repeat = 0; repeat < options.repeats; ++repeat)
        {
            task.method = Method::STANDARD;
            task.stock = options.stock;
            standard = benchmarks::run(task);
            task.stock = false;
            task.method = methodOf(method);
            certified = benchmarks::run(task);
            equal = equal && standard.digests == certified.digests;
            checking.add(certified.checkingSeconds, standard.checkingSeconds);
            total.add(certified.totalSeconds, standard.totalSeconds);
        }
        const Row row{checking.getRatio(options.fastest), total.getRatio(options.fastest), equal};
        std::printf("| %s | %s | %s | %u | %zu | %llu | %llu | %.3f | %.2f | %.3f | %.2f | %s |\n",
                    scene.getName().c_str(), planner.c_str(), method.c_str(), options.iterations,
                    scene.getMembers().size(),
                    static_cast<unsigned long long>(standard.counts.exactCalls + standard.counts.pairExact),
                    static_cast<unsigned long long>(certified.counts.exactCalls + certified.counts.pairExact),
                    checking.getStandard(options.fastest), row.checking, total.getStandard(options.fastest), row.total,
                    equal ? "yes" : "NO");
        std::fflush(stdout);
        return row;
    }

    int run(const Options &options)
    {
        std::puts(
            "| scene | planner | method | iterations | R | FCL calls, standard | FCL calls | checking, "
            "standard (s) | checking, ratio | total, standard (s) | total, ratio | trees equal |");
        std::puts("|---|---|---|---|---|---|---|---|---|---|---|---|");
        std::vector<double> checking, total;
        unsigned int different = 0;
        for (const std::string &file : options.scenes)
        {
            const Scene scene = loadScene(file);
            scene.validate();
            const std::vector<std::size_t> all{scene.getMembers().size()};
            for (const std::size_t robots : options.robots.empty() ? all : options.robots)
            {
                if (robots > scene.getMembers().size())
                    continue;
                const Scene team = scene.withFirstRobots(robots);
                for (const std::string &planner : options.planners)
                    for (const std::string &method : options.methods)
                    {
                        const Row row = compare(options, team, planner, method);
                        checking.push_back(row.checking);
                        total.push_back(row.total);
                        different += row.equal ? 0 : 1;
                    }
            }
        }
        if (checking.empty())
            throw ompl::Exception("--robots", "no scene has so many");
        std::printf(
            "\nGeometric means of %zu rows: checking %.3f, total %.3f; the largest: checking %.2f, total %.2f. "
            "Trees that differ: %u.\n",
            checking.size(), benchmarks::geometricMean(checking), benchmarks::geometricMean(total),
            *std::max_element(checking.begin(), checking.end()), *std::max_element(total.begin(), total.end()),
            different);
        return different == 0 ? 0 : 1;
    }
}

int main(int argc, char **argv)
{
    CLI::App app("Compare whole plans with and without certificates", "whole_plans");
    Options options;
    declare(app, options);
    return benchmarks::runProgram(app, argc, argv, [&options] { return run(options); });
}
