// The paper's own experiment: discs among random convex polygons, RRT without a goal. Which part of the robots' checks
// each method leaves to the obstacles, and its cost.
//
//     paper_fractions --robots 1,2,3 --iterations 100000

#include "common/Options.h"
#include "generators/RandomPolygons.h"

#include <algorithm>
#include <cstdio>
#include <iostream>

using namespace ompl_certificates;

namespace
{
    struct Options
    {
        std::vector<unsigned int> robots{1, 2, 3, 4, 5};
        std::vector<std::string> methods{"basic", "partial", "shared"};
        unsigned int iterations{100000};
        double step{5.0};
        double resolution{0.0};
        std::uint32_t seed{1};
        generators::PolygonSettings scene;

        Options()
        {
            // The paper's number, whatever the generator's default
            scene.obstacles = 40;
            scene.smallest = 0.02;
            scene.largest = 0.08;
        }
    };

    void declare(CLI::App &app, Options &options)
    {
        benchmarks::addList(app, "--robots", options.robots, "Numbers of robots, separated by commas")
            ->check(CLI::Range(1, 100))
            ->capture_default_str();
        benchmarks::addMethods(app, options.methods);
        benchmarks::addPositive(app, "--iterations", options.iterations, "Iterations of RRT");
        benchmarks::addPositive(app, "--step", options.step, "The length of RRT's steps");
        app.add_option(
               "--resolution", options.resolution,
               "The longest segment between two samples of a motion, as a fraction of a robot's space; 1 checks only "
               "the ends, as the paper does. By default OMPL's, 0.01")
            ->check(benchmarks::positive() & CLI::Range(0.0, 1.0));
        app.add_option("--radius", options.scene.radius, "The radius of the discs, in a square of side 100")
            ->capture_default_str();
        app.add_option("--obstacles", options.scene.obstacles, "The number of polygons")->capture_default_str();
        app.add_option("--scene-seed", options.scene.seed, "Which random scene")->capture_default_str();
        benchmarks::addPositive(app, "--seed", options.seed, "Seed of OMPL's random numbers");
        app.footer("Returns 1 if a tree differs from that of the standard method, 2 for bad input.");
    }

    double percent(std::uint64_t part, std::uint64_t whole)
    {
        return 100.0 * static_cast<double>(part) / static_cast<double>(std::max<std::uint64_t>(whole, 1));
    }

    /** Plan for \e robots robots with all methods, and return how many grew a tree other than the standard one's. */
    unsigned int compare(const Options &options, unsigned int robots)
    {
        generators::PolygonSettings settings = options.scene;
        settings.robots = robots;
        const Scene scene = generators::randomPolygons(settings);
        benchmarks::PlanTask task{scene, "RRT", Method::STANDARD};
        task.iterations = options.iterations;
        task.range = options.step;
        task.resolution = options.resolution;
        task.seed = options.seed;
        task.adaptive = false;
        const benchmarks::PlanResult standard = benchmarks::run(task);
        unsigned int different = 0;
        for (const std::string &method : options.methods)
        {
            task.method = methodOf(method);
            const benchmarks::PlanResult result = benchmarks::run(task);
            const CheckCounts &counts = result.counts;
            const bool equal = result.digests == standard.digests;
            different += equal ? 0 : 1;
            std::printf(
                "| %u | %s | %zu | %llu | %.2f %% | %.2f %% | %.2f %% | %.2f %% | %.2f %% | %zu | %.3f | %.3f "
                "| %.1f %% | %s |\n",
                robots, method.c_str(), result.states, static_cast<unsigned long long>(counts.robotPoses),
                percent(counts.asked, counts.robotPoses), percent(counts.askedColliding, counts.robotPoses),
                percent(counts.exactCalls, counts.robotPoses), percent(counts.asked, counts.motionSamples),
                percent(counts.asked, standard.counts.asked), result.certificates,
                result.checkingSeconds / standard.checkingSeconds, result.totalSeconds / standard.totalSeconds,
                100.0 * result.checkingSeconds / result.clockSeconds, equal ? "yes" : "NO");
            std::fflush(stdout);
        }
        return different;
    }

    int run(const Options &options)
    {
        std::printf("RRT, step %g, %u iterations, discs of radius %g among %u polygons, scene %llu, seed %u\n\n",
                    options.step, options.iterations, options.scene.radius, options.scene.obstacles,
                    static_cast<unsigned long long>(options.scene.seed), options.seed);
        std::puts(
            "| R | method | states | robot poses looked at | left to the obstacles | … and colliding | … to FCL "
            "| left to the obstacles, of all samples | … of the standard method's | certificates | checking, ratio "
            "| total, ratio | checking, of total | trees equal |");
        std::puts("|---|---|---|---|---|---|---|---|---|---|---|---|---|---|");
        unsigned int different = 0;
        for (const unsigned int robots : options.robots)
            different += compare(options, robots);
        return different == 0 ? 0 : 1;
    }
}

int main(int argc, char **argv)
{
    CLI::App app("Repeat the experiment of the paper", "paper_fractions");
    Options options;
    declare(app, options);
    return benchmarks::runProgram(app, argc, argv, [&options] { return run(options); });
}
