// Plans for three teams with OMPL and FCL as they are, with this library's check that remembers nothing, and with
// certificates, and prints one table of what each took. All have the same planner, seeds, iterations and metric, so
// their trees must be equal.
//
//     certificates compare --scenes demos/scenes --out out

#include "commands/Commands.h"
#include "common/CommandLine.h"
#include "common/FclChecker.h"
#include "common/Interrupt.h"
#include "common/Limit.h"
#include "common/Outputs.h"
#include "common/ProgressBar.h"

#include "ompl_certificates/pictures/PlanReport.h"
#include "ompl_certificates/pictures/ScenePicture.h"
#include "ompl_certificates/planning/Planners.h"
#include "ompl_certificates/scene/SceneFile.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

using namespace ompl_certificates;
namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace
{
    struct Options
    {
        std::string scenes{"demos/scenes"};
        std::string out{"out"};
        unsigned int seeds{3};
        bool quiet{false};
    };

    /** What is planned. RRT* makes all its iterations, RRTConnect ends with its first solution. */
    struct Task
    {
        std::string scene;
        std::string planner;

        /** The length of the planner's steps, summed over the robots; empty for the planner's own */
        std::string range;

        /** The most iterations */
        std::uint64_t iterations;

        /** The longest valid segment as a fraction of each robot's extent. OMPL's is 0.01: enough for the carts, but
            discs of radius 1 would jump by 1.4, and drones of 1 m by 0.9 m. */
        double resolution;
    };

    const std::vector<Task> TASKS{{"paper_five_discs", "RRTstar", "60", 12000, 0.001},
                                  {"maze", "RRTConnect", "", 1000000, 0.01},
                                  {"sixteen_robots", "RRTConnect", "60", 1000000, 0.002}};

    /** What came of one plan */
    struct Run
    {
        bool solved{false};
        double cost{0.0};
        double totalSeconds{0.0}, checkingSeconds{0.0};
        std::uint64_t motions{0}, robotPoses{0}, fclCalls{0}, states{0};
        std::string digest;
    };

    double secondsSince(std::chrono::steady_clock::time_point start)
    {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    }

    /** Plan in a space that has the start and the goal, and fill in all but what only the checker knows. */
    Run plan(og::SimpleSetup &setup, const Task &task, demos::Limit &limit)
    {
        const ob::SpaceInformationPtr &si = setup.getSpaceInformation();
        setup.setPlanner(makePlanner(task.planner, si));
        if (!task.range.empty())
            setParameter(*setup.getPlanner(), "range", task.range);
        setup.solve(limit.condition());
        Run run;
        run.solved = setup.haveExactSolutionPath();
        run.cost = run.solved ? setup.getSolutionPath().length() : 0.0;
        run.motions = si->getCheckedMotionCount();
        return run;
    }

    void describeTree(const og::SimpleSetup &setup, Run &run)
    {
        ob::PlannerData tree(setup.getSpaceInformation());
        setup.getPlanner()->getPlannerData(tree);
        run.states = tree.numVertices();
        run.digest = treeDigest(tree);
    }

    void setStartAndGoal(og::SimpleSetup &setup, const Scene &scene)
    {
        setup.getStateSpace()->computeLocations();
        const auto stateOf = [&](std::vector<double> Scene::Member::*coordinates)
        {
            std::vector<double> reals;
            for (const Scene::Member &member : scene.getMembers())
                reals.insert(reals.end(), (member.*coordinates).begin(), (member.*coordinates).end());
            ob::ScopedState<> state(setup.getStateSpace());
            setup.getStateSpace()->copyFromReals(state.get(), reals);
            return state;
        };
        setup.setStartAndGoalStates(stateOf(&Scene::Member::start), stateOf(&Scene::Member::goal));
    }

    /** As programs have it today: a compound space of the robots' spaces, FCL, and what OMPL gives its planners */
    Run planWithOmpl(const Scene &scene, const Task &task, demos::Limit &limit)
    {
        const auto start = std::chrono::steady_clock::now();
        const auto space = std::make_shared<ob::CompoundStateSpace>();
        for (const Scene::Member &member : scene.getMembers())
            space->addSubspace(member.robot->getStateSpace(), member.weight);
        space->setLongestValidSegmentFraction(task.resolution);
        og::SimpleSetup setup(space);
        const auto checker = std::make_shared<demos::FclChecker>(setup.getSpaceInformation(), scene);
        setup.setStateValidityChecker(checker);
        setup.getSpaceInformation()->setMotionValidator(
            std::make_shared<demos::TimedMotionValidator>(setup.getSpaceInformation(), checker));
        setStartAndGoal(setup, scene);

        Run run = plan(setup, task, limit);
        run.totalSeconds = secondsSince(start);
        run.checkingSeconds = checker->getStopwatch().getSeconds();
        run.robotPoses = checker->getCounts().robotPoses;
        run.fclCalls = checker->getCounts().fclCalls;
        describeTree(setup, run);
        return run;
    }

    /** With this library: the same in a TeamSetup. SUM is the metric of a compound space. */
    Run planWithTeam(Method method, const Scene &scene, const Task &task, demos::Limit &limit,
                     const std::string &picture)
    {
        const auto start = std::chrono::steady_clock::now();
        const auto team = std::make_shared<TeamStateSpace>(TeamStateSpace::SUM);
        for (const Scene::Member &member : scene.getMembers())
            team->addRobot(member.robot, member.weight);
        team->setLongestValidSegmentFraction(task.resolution);
        TeamSetup setup(team, scene.makeObstacles(), method);
        setStartAndGoal(setup, scene);

        Run run = plan(setup, task, limit);
        run.totalSeconds = secondsSince(start);
        run.checkingSeconds = setup.getStatistics().getCheckingSeconds();
        const CheckCounts counts = setup.getStatistics().getCounts();
        run.robotPoses = counts.robotPoses;
        run.fclCalls = counts.exactCalls + counts.pairExact;
        describeTree(setup, run);
        if (!picture.empty() && run.solved)
        {
            setup.simplifySolution(ob::PlannerTerminationCondition(demos::interrupted));
            ScenePicture drawn(scene);
            drawn.setPath(setup.getSolutionPath());
            drawn.write(picture);
        }
        return run;
    }

    /** What is compared, the one to compare with first */
    const std::vector<std::string> PROGRAMS{"OMPL and FCL", "ours, standard", "ours, shared"};

    Run planWith(std::size_t program, const Scene &scene, const Task &task, demos::Limit &limit,
                 const std::string &picture)
    {
        return program == 0   ? planWithOmpl(scene, task, limit)
               : program == 1 ? planWithTeam(Method::STANDARD, scene, task, limit, "")
                              : planWithTeam(Method::SHARED_PROJECTION, scene, task, limit, picture);
    }

    /** 1234567 as 1 234 567 */
    std::string grouped(std::uint64_t number)
    {
        std::string text = std::to_string(number);
        for (std::size_t i = text.size(); i > 3; i -= 3)
            text.insert(i - 3, 1, ' ');
        return text;
    }

    std::string sceneFileOf(const Options &options, const Task &task)
    {
        return options.scenes + "/" + task.scene + ".yaml";
    }

    std::string pictureOf(const Options &options, const Task &task)
    {
        return options.out + "/" + task.scene + ".svg";
    }

    /** All plans of one scene: for each seed one with each program, in turns */
    class Comparison
    {
    public:
        Comparison(const Options &options, const Task &task) : options_(options), task_(task), runs_(PROGRAMS.size())
        {
        }

        /** Returns false if interrupted. Then the seed that was under way is left out. */
        bool run()
        {
            const demos::ProgressBar bar([this] { return getProgress(); }, options_.quiet);
            for (unsigned int seed = 1; seed <= options_.seeds; ++seed)
                for (std::size_t program = 0; program < PROGRAMS.size(); ++program, ++plansDone_)
                {
                    // Read anew each time: the trees of bodies are kept with them, and are part of what is measured.
                    const Scene scene = loadScene(sceneFileOf(options_, task_));
                    ompl::RNG::setSeed(seed);
                    demos::Limit limit(0.0, task_.iterations);
                    const std::string picture = countSolved(program) > 0 ? "" : pictureOf(options_, task_);
                    runs_[program].push_back(planWith(program, scene, task_, limit, picture));
                    if (demos::interrupted())
                    {
                        for (std::vector<Run> &runs : runs_)
                            runs.resize(seed - 1);
                        return false;
                    }
                }
            return true;
        }

        /** The seeds that all programs have planned with */
        std::size_t countSeeds() const
        {
            return runs_[0].size();
        }

        bool areTreesEqual() const
        {
            bool equal = true;
            for (std::size_t program = 0; program < PROGRAMS.size(); ++program)
                equal = equal && areTreesEqual(program);
            return equal;
        }

        void print() const
        {
            for (std::size_t program = 0; program < PROGRAMS.size(); ++program)
            {
                char faster[32] = "";
                if (program > 0)
                    std::snprintf(faster, sizeof(faster), "%.1f",
                                  sum(0, &Run::totalSeconds) / sum(program, &Run::totalSeconds));
                std::printf(
                    "| %-26s | %-14s | %3d of %-3zu | %8.2f | %11.2f | %12s | %9s | %11s | %9s | %7s | %-11s |\n",
                    program == 0 ? (task_.scene + ", " + task_.planner).c_str() : "", PROGRAMS[program].c_str(),
                    countSolved(program), countSeeds(), sum(program, &Run::totalSeconds),
                    sum(program, &Run::checkingSeconds), faster, grouped(sum(program, &Run::motions)).c_str(),
                    grouped(sum(program, &Run::robotPoses)).c_str(), grouped(sum(program, &Run::fclCalls)).c_str(),
                    grouped(sum(program, &Run::states)).c_str(),
                    program == 0             ? ""
                    : areTreesEqual(program) ? "yes"
                                             : "NO");
            }
            std::fflush(stdout);
        }

        static void printHeader()
        {
            std::puts(
                "| scene, planner             | program        | solved     | total, s | checking, s | times faster | "
                "motions   | robot poses | FCL calls | states  | trees equal |\n"
                "|----------------------------|----------------|------------|----------|-------------|--------------|-"
                "----------|-------------|-----------|---------|-------------|");
        }

    private:
        demos::ProgressBar::Progress getProgress() const
        {
            const std::size_t done = plansDone_, all = options_.seeds * PROGRAMS.size();
            return {static_cast<double>(done) / static_cast<double>(all),
                    task_.scene + ", " + PROGRAMS[done % PROGRAMS.size()]};
        }

        /** Whether the trees of a program are those of the first, seed by seed */
        bool areTreesEqual(std::size_t program) const
        {
            return std::equal(runs_[0].begin(), runs_[0].end(), runs_[program].begin(), runs_[program].end(),
                              [](const Run &a, const Run &b)
                              { return a.digest == b.digest && a.solved == b.solved && a.cost == b.cost; });
        }

        int countSolved(std::size_t program) const
        {
            return static_cast<int>(
                std::count_if(runs_[program].begin(), runs_[program].end(), [](const Run &run) { return run.solved; }));
        }

        template <typename Number>
        Number sum(std::size_t program, Number Run::*value) const
        {
            Number sum = 0;
            for (const Run &run : runs_[program])
                sum += run.*value;
            return sum;
        }

        const Options &options_;
        const Task &task_;
        std::vector<std::vector<Run>> runs_;
        std::atomic<std::size_t> plansDone_{0};
    };

    void declare(CLI::App &app, Options &options)
    {
        app.add_option("--scenes", options.scenes, "Folder of the scenes")->capture_default_str();
        app.add_option("--out", options.out, "Folder for pictures of the plans, made if need be")
            ->capture_default_str();
        app.add_option("--seeds", options.seeds, "How many plans each program makes, with seeds 1, 2, ...")
            ->check(demos::countUpTo(1000))
            ->capture_default_str();
        app.add_flag("--quiet", options.quiet, "No progress");
        app.footer(
            "Numbers are sums over all seeds; times are of all that follows the reading of a scene. Returns 0 if all "
            "trees were equal, 1 if not or if interrupted, 2 for bad input.");
    }

    /** What cannot be read or written shows here, before anything is planned. */
    void prepare(const Options &options)
    {
        std::vector<std::pair<std::string, std::string>> pictures;
        std::vector<std::string> scenes;
        for (const Task &task : TASKS)
        {
            scenes.push_back(sceneFileOf(options, task));
            loadScene(scenes.back()).validate();
            pictures.emplace_back("--out", pictureOf(options, task));
        }
        demos::prepareOutputs(pictures, scenes);
    }

    int run(const Options &options)
    {
        // OMPL complains about every seed but the first, though all that is made later obeys it.
        ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
        demos::catchInterrupts();
        std::error_code error;
        std::filesystem::create_directories(options.out, error);
        if (error)
            throw ompl::Exception("--out", options.out + " cannot be made: " + error.message());
        prepare(options);
        bool equal = true;
        for (const Task &task : TASKS)
        {
            Comparison comparison(options, task);
            const bool isComplete = comparison.run();
            if (&task == &TASKS.front() && comparison.countSeeds() > 0)
                Comparison::printHeader();
            if (comparison.countSeeds() > 0)
                comparison.print();
            if (!isComplete)
            {
                std::puts("interrupted: rows have the seeds that were complete");
                return demos::NOT_SOLVED;
            }
            equal = equal && comparison.areTreesEqual();
        }
        return equal ? demos::SOLVED : demos::NOT_SOLVED;
    }
}

demos::Work demos::declareCompare(CLI::App &app)
{
    const auto options = std::make_shared<Options>();
    declare(app, *options);
    return [options] { return run(*options); };
}
