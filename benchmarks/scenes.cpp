// Plans for teams of one to three robots in every scene: what certificates save, and that the trees are equal. Each
// plan is made with FCL alone, with the fastest check without certificates, and with certificates, from equal seeds.
//
//     scenes                                   all scenes of the project, and the shared ones where they are present
//     scenes maze.yaml --planners RRT --robots 3 --methods basic,partial,shared --seeds 10

#include "common/Options.h"

#include "ompl_certificates/scene/SceneFile.h"

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <iostream>

using namespace ompl_certificates;

namespace
{
    volatile std::sig_atomic_t interrupted = 0;

    extern "C" void interrupt(int /*signal*/)
    {
        interrupted = 1;
    }

    struct Options
    {
        std::vector<std::string> scenes;
        std::vector<std::string> planners{"RRT", "RRTConnect", "RRTstar"};
        std::vector<std::string> methods{"shared"};
        std::vector<std::size_t> robots{1, 2, 3};
        unsigned int iterations{10000};
        unsigned int seeds{3};
        bool warm{false};
    };

    /** The scenes of the project, and those of teams among shared meshes, which may be absent */
    std::vector<std::string> allScenes()
    {
        std::vector<std::string> files, folders{OMPL_CERTIFICATES_SCENES};
        if (std::filesystem::is_directory(OMPL_CERTIFICATES_SHARED_MESHES))
            folders.push_back(OMPL_CERTIFICATES_SHARED_SCENES);
        else
            std::cerr << "scenes: " OMPL_CERTIFICATES_SHARED_MESHES " is not there, nor are its scenes in the table\n";
        for (const std::string &folder : folders)
            for (const auto &entry : std::filesystem::directory_iterator(folder))
                if (entry.path().extension() == ".yaml")
                    files.push_back(entry.path().string());
        std::sort(files.begin(), files.end());
        return files;
    }

    void declare(CLI::App &app, Options &options)
    {
        app.add_option("SCENES", options.scenes,
                       "Scene files; by default those of the project and those among shared meshes, where present")
            ->check(CLI::ExistingFile);
        benchmarks::addPlanners(app, options.planners);
        benchmarks::addMethods(app, options.methods);
        benchmarks::addList(app, "--robots", options.robots, "Team sizes: the first robots of each scene")
            ->check(benchmarks::positive())
            ->capture_default_str();
        benchmarks::addPositive(app, "--iterations", options.iterations, "Iterations of each plan");
        benchmarks::addPositive(app, "--seeds", options.seeds, "Plans of each row, from seeds 1, 2, ...");
        app.add_flag("--warm", options.warm, "Also plan with the certificates of another plan, in rows of their own");
        app.footer(
            "An interrupt ends it after the present row, with the means of what is done.\n"
            "Returns 1 if a tree differs from that of FCL alone, 2 for bad input.");
    }

    /** The plans of one row with one method, summed over all seeds */
    struct Sum
    {
        std::uint64_t exactCalls{0};
        double checkingSeconds{0.0}, totalSeconds{0.0};
        std::vector<std::vector<std::string>> digests;

        void add(const benchmarks::PlanResult &result)
        {
            exactCalls += result.counts.exactCalls + result.counts.pairExact;
            checkingSeconds += result.checkingSeconds;
            totalSeconds += result.totalSeconds;
            digests.push_back(result.digests);
        }
    };

    /** Ratios of times, one for each row */
    class Ratios
    {
    public:
        double add(double numerator, double denominator)
        {
            values_.push_back(numerator / denominator);
            return values_.back();
        }

        void print(const char *name) const
        {
            std::printf("%s: geometric mean %.2f, smallest %.2f\n", name, benchmarks::geometricMean(values_),
                        *std::min_element(values_.begin(), values_.end()));
        }

        bool isEmpty() const
        {
            return values_.empty();
        }

    private:
        std::vector<double> values_;
    };

    class Table
    {
    public:
        Table()
        {
            std::puts(
                "| scene | planner | R | method | FCL calls: fcl | method | checking: fcl (s) | fcl / standard | "
                "fcl / method | standard / method | total: fcl / method | standard / method | trees equal |");
            std::puts("|---|---|---|---|---|---|---|---|---|---|---|---|---|");
        }

        void add(const std::string &scene, const std::string &planner, std::size_t robots, const std::string &method,
                 const Sum &fcl, const Sum &standard, const Sum &certified)
        {
            const bool equal = fcl.digests == certified.digests && fcl.digests == standard.digests;
            different_ += equal ? 0 : 1;
            std::printf("| %s | %s | %zu | %s | %llu | %llu | %.3f |", scene.c_str(), planner.c_str(), robots,
                        method.c_str(), static_cast<unsigned long long>(fcl.exactCalls),
                        static_cast<unsigned long long>(certified.exactCalls), fcl.checkingSeconds);
            std::printf(" %.2f | %.2f | %.2f |", fclToStandard_.add(fcl.checkingSeconds, standard.checkingSeconds),
                        fclToMethod_.add(fcl.checkingSeconds, certified.checkingSeconds),
                        standardToMethod_.add(standard.checkingSeconds, certified.checkingSeconds));
            std::printf(" %.2f | %.2f | %s |\n", fclToMethodTotal_.add(fcl.totalSeconds, certified.totalSeconds),
                        standardToMethodTotal_.add(standard.totalSeconds, certified.totalSeconds),
                        equal ? "yes" : "NO");
            std::fflush(stdout);
        }

        /** Prints the means, and returns whether all trees were equal. */
        bool finish() const
        {
            if (fclToMethod_.isEmpty())
                return true;
            std::puts("");
            fclToStandard_.print("checking, fcl / standard");
            fclToMethod_.print("checking, fcl / method");
            standardToMethod_.print("checking, standard / method");
            fclToMethodTotal_.print("total, fcl / method");
            standardToMethodTotal_.print("total, standard / method");
            std::printf("rows with trees that differ: %u\n", different_);
            return different_ == 0;
        }

    private:
        Ratios fclToStandard_, fclToMethod_, standardToMethod_, fclToMethodTotal_, standardToMethodTotal_;
        unsigned int different_{0};
    };

    void compare(const Options &options, const Scene &scene, const std::string &planner, Table &table)
    {
        benchmarks::PlanTask task{scene, planner};
        task.iterations = options.iterations;
        Sum fcl, standard;
        std::vector<Sum> cold(options.methods.size()), warm(options.methods.size());
        const auto add = [&task](Sum &sum, Method method, bool isWarm)
        {
            task.method = method;
            task.warm = isWarm;
            sum.add(benchmarks::run(task));
        };
        for (task.seed = 1; task.seed <= options.seeds; ++task.seed)
        {
            add(fcl, Method::FCL, false);
            add(standard, Method::STANDARD, false);
            for (std::size_t i = 0; i < options.methods.size(); ++i)
            {
                add(cold[i], methodOf(options.methods[i]), false);
                if (options.warm)
                    add(warm[i], methodOf(options.methods[i]), true);
            }
        }
        for (std::size_t i = 0; i < options.methods.size(); ++i)
        {
            const auto print = [&](const std::string &name, const Sum &sum)
            { table.add(scene.getName(), planner, scene.getMembers().size(), name, fcl, standard, sum); };
            print(options.methods[i], cold[i]);
            if (options.warm)
                print(options.methods[i] + ", warm", warm[i]);
        }
    }

    int run(const Options &options)
    {
        const std::vector<std::string> files = options.scenes.empty() ? allScenes() : options.scenes;
        std::vector<Scene> scenes;
        for (const std::string &file : files)
        {
            scenes.push_back(loadScene(file));
            scenes.back().validate();
        }
        const auto isPlannedFor = [&options](const Scene &scene)
        { return *std::min_element(options.robots.begin(), options.robots.end()) <= scene.getMembers().size(); };
        if (std::none_of(scenes.begin(), scenes.end(), isPlannedFor))
            throw ompl::Exception("--robots", "no scene has so many");
        std::signal(SIGINT, interrupt);
        std::signal(SIGTERM, interrupt);
        Table table;
        for (const Scene &scene : scenes)
            for (const std::size_t robots : options.robots)
                if (robots <= scene.getMembers().size())
                    for (const std::string &planner : options.planners)
                        if (!interrupted)
                            compare(options, scene.withFirstRobots(robots), planner, table);
        return table.finish() ? 0 : 1;
    }
}

int main(int argc, char **argv)
{
    CLI::App app("Teams in many scenes, with and without certificates", "scenes");
    Options options;
    declare(app, options);
    return benchmarks::runProgram(app, argc, argv, [&options] { return run(options); });
}
