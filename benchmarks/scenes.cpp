// Teams of one to three robots in every scene there is, with and without certificates, in turns and from equal seeds:
// what certificates save, and that the trees are equal.
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
            ->check(CLI::PositiveNumber)
            ->capture_default_str();
        benchmarks::addPositive(app, "--iterations", options.iterations, "Iterations of each plan");
        benchmarks::addPositive(app, "--seeds", options.seeds, "Plans of each row, from seeds 1, 2, ...");
        app.footer(
            "An interrupt ends it after the present row, with the means of what is done.\n"
            "Returns 1 if a tree differs from that of the standard method, 2 for bad input.");
    }

    /** The scene with its first \e robots robots alone */
    Scene withFirst(const Scene &scene, std::size_t robots)
    {
        Scene first(scene.getName(), scene.getSource(), scene.getBounds());
        for (const PlacedBody &obstacle : scene.getObstacles())
            first.addObstacle(obstacle);
        for (std::size_t i = 0; i < robots; ++i)
            first.addMember(scene.getMembers()[i]);
        if (scene.getResolution() > 0.0)
            first.setResolution(scene.getResolution());
        return first;
    }

    /** What came of the plans of one row with one method, over all seeds */
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

    class Table
    {
    public:
        Table()
        {
            std::puts(
                "| scene | planner | R | method | exact checks, standard | exact checks | ratio | checking, "
                "standard (s) | standard / method, checking | total | trees equal |");
            std::puts("|---|---|---|---|---|---|---|---|---|---|---|");
        }

        void add(const std::string &scene, const std::string &planner, std::size_t robots, const std::string &method,
                 const Sum &standard, const Sum &certified)
        {
            checking_.push_back(standard.checkingSeconds / certified.checkingSeconds);
            total_.push_back(standard.totalSeconds / certified.totalSeconds);
            const bool equal = standard.digests == certified.digests;
            different_ += equal ? 0 : 1;
            std::printf("| %s | %s | %zu | %s | %llu | %llu | %.3f | %.3f | %.2f | %.2f | %s |\n", scene.c_str(),
                        planner.c_str(), robots, method.c_str(), static_cast<unsigned long long>(standard.exactCalls),
                        static_cast<unsigned long long>(certified.exactCalls),
                        static_cast<double>(certified.exactCalls) / static_cast<double>(standard.exactCalls),
                        standard.checkingSeconds, checking_.back(), total_.back(), equal ? "yes" : "NO");
            std::fflush(stdout);
        }

        /** Prints the means. Whether all trees were equal. */
        bool finish() const
        {
            if (checking_.empty())
                return true;
            std::printf(
                "\nstandard / method, geometric means of %zu rows: checking %.2f, total %.2f; the smallest: "
                "checking %.2f, total %.2f. Rows with trees that differ: %u.\n",
                checking_.size(), benchmarks::geometricMean(checking_), benchmarks::geometricMean(total_),
                *std::min_element(checking_.begin(), checking_.end()), *std::min_element(total_.begin(), total_.end()),
                different_);
            return different_ == 0;
        }

    private:
        std::vector<double> checking_, total_;
        unsigned int different_{0};
    };

    void compare(const Options &options, const Scene &scene, const std::string &planner, Table &table)
    {
        benchmarks::PlanTask task{scene, planner};
        task.iterations = options.iterations;
        Sum standard;
        std::vector<Sum> certified(options.methods.size());
        for (task.seed = 1; task.seed <= options.seeds; ++task.seed)
        {
            task.method = Method::STANDARD;
            standard.add(benchmarks::run(task));
            for (std::size_t i = 0; i < certified.size(); ++i)
            {
                task.method = methodOf(options.methods[i]);
                certified[i].add(benchmarks::run(task));
            }
        }
        for (std::size_t i = 0; i < certified.size(); ++i)
            table.add(scene.getName(), planner, scene.getMembers().size(), options.methods[i], standard, certified[i]);
    }

    int run(const Options &options)
    {
        const std::vector<std::string> files = options.scenes.empty() ? allScenes() : options.scenes;
        std::vector<std::unique_ptr<Scene>> scenes;
        for (const std::string &file : files)
        {
            scenes.push_back(loadScene(file));
            scenes.back()->validate();
        }
        std::signal(SIGINT, interrupt);
        std::signal(SIGTERM, interrupt);
        Table table;
        for (const auto &scene : scenes)
            for (const std::size_t robots : options.robots)
                if (robots <= scene->getMembers().size())
                    for (const std::string &planner : options.planners)
                        if (!interrupted)
                            compare(options, withFirst(*scene, robots), planner, table);
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
