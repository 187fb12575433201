#include "demos/Program.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <set>
#include <sstream>
#include <thread>
#include <tuple>

namespace
{
    /** The runs of a planner in a log, each with its properties in the order of their names */
    std::vector<std::vector<std::string>> runsOf(const std::string &log, const std::string &planner,
                                                 std::vector<std::string> &names)
    {
        std::istringstream lines(log);
        std::string line;
        while (std::getline(lines, line) && line != planner)
            ;
        while (std::getline(lines, line) && line.find("properties for each run") == std::string::npos)
            ;
        names.clear();
        for (int count = std::atoi(line.c_str()); count > 0 && std::getline(lines, line); --count)
            names.push_back(line);
        std::getline(lines, line);
        std::vector<std::vector<std::string>> runs;
        for (int count = std::atoi(line.c_str()); count > 0 && std::getline(lines, line); --count)
        {
            runs.emplace_back();
            for (std::size_t at = 0, end; (end = line.find("; ", at)) != std::string::npos; at = end + 2)
                runs.back().push_back(line.substr(at, end - at));
        }
        return runs;
    }
}

TEST(BenchmarkTeam, logsEveryMethodWithTheSameRandomNumbers)
{
    const Folder folder;
    writeFile(folder / "first.yaml", easyScene());
    writeFile(folder / "second.yaml", easyScene());
    Program program("benchmark_team", {folder / "first.yaml", folder / "second.yaml", "--planners", "RRT,BITstar",
                                       "--runs", "3", "--time", "0.5", "--log", folder / "teams.log"});
    ASSERT_EQ(program.wait(), 0) << program.errors();
    EXPECT_EQ(program.errors(), "");
    EXPECT_NE(program.output().find("multiples of those of fcl"), std::string::npos);
    EXPECT_FALSE(std::filesystem::exists(folder / "teams.log"));

    const std::string log = contentOf(folder / "teams_first.log");
    ASSERT_NE(contentOf(folder / "teams_second.log"), "");
    // BITstar would count these from another thread by walking through its graph, and sometimes crash.
    EXPECT_EQ(log.find("current graph vertices"), std::string::npos);
    std::vector<std::string> states;
    for (const std::string method : {"fcl", "standard", "basic", "partial", "shared"})
    {
        SCOPED_TRACE(method);
        std::vector<std::string> names;
        const auto runs = runsOf(log, "geometric_RRT[" + method + "]", names);
        ASSERT_EQ(runs.size(), 3u);
        const auto value = [&names](const std::vector<std::string> &run, const std::string &name)
        {
            const auto found = std::find(names.begin(), names.end(), name);
            return found == names.end() ? std::string() : run.at(static_cast<std::size_t>(found - names.begin()));
        };
        std::vector<std::string> counts;
        for (const auto &run : runs)
        {
            counts.push_back(value(run, "graph states INTEGER"));
            const auto count = [&](const std::string &name)
            { return std::stoull("0" + value(run, name + " INTEGER")); };
            EXPECT_GT(count("robot_poses"), 10u);
            EXPECT_EQ(count("robot_poses"), count("certified_free") + count("certified_colliding") + count("asked"));
            // With certificates, too, such short plans may end before there are any.
            if (method == "fcl" || method == "standard")
            {
                EXPECT_EQ(count("certificates"), 0u);
            }
            EXPECT_GT(std::stod(value(run, "time_in_checking REAL")), 0.0);
        }
        if (states.empty())
            states = counts;
        EXPECT_EQ(counts, states);
    }
    // Another seed for each run
    EXPECT_TRUE(states[0] != states[1] || states[1] != states[2]);
}

// Who has read enough closes the pipe.
TEST(BenchmarkTeam, writesLogsThoughNobodyReadsItsTables)
{
    const Folder folder;
    for (const std::string scene : {"a.yaml", "b.yaml"})
        writeFile(folder / scene, easyScene());
    const std::string command = OMPL_CERTIFICATES_BIN_DIR "/benchmark_team " + (folder / "a.yaml") + " " +
                                (folder / "b.yaml") + " --planners RRT --methods shared --runs 1 --time 0.2 --log " +
                                (folder / "log.log") + " 2> " + (folder / "errors") + " | true; exit ${PIPESTATUS[0]}";
    const int status = std::system(("bash -c '" + command + "'").c_str());
    EXPECT_EQ(WEXITSTATUS(status), 2);
    EXPECT_TRUE(std::filesystem::exists(folder / "log_a.log"));
    EXPECT_TRUE(std::filesystem::exists(folder / "log_b.log"));
    EXPECT_NE(contentOf(folder / "errors").find("standard output"), std::string::npos) << contentOf(folder / "errors");
}

TEST(BenchmarkTeam, overwritesNoMeshOfItsScene)
{
    const Folder folder;
    const std::string mesh = "v 4 4 0\nv 6 4 0\nv 5 6 1\nf 1 2 3\n";
    writeFile(folder / "wall.obj", mesh);
    writeFile(folder / "scene.yaml",
              "environment: {min: [0, 0], max: [10, 10], obstacles: [{type: mesh, file: wall.obj, center: [0, 0]}]}\n"
              "robots:\n  - {type: rigid, space: R2, shape: {type: disc, radius: 0.2}, start: [1, 1], goal: [2, 1]}\n");
    Program program("benchmark_team", {folder / "scene.yaml", "--planners", "RRT", "--methods", "shared", "--runs", "1",
                                       "--time", "0.1", "--log", folder / "wall.obj"});
    EXPECT_EQ(program.wait(), 2);
    EXPECT_NE(program.errors().find("would overwrite what is read"), std::string::npos) << program.errors();
    EXPECT_EQ(contentOf(folder / "wall.obj"), mesh);
}

TEST(BenchmarkTeam, keepsCompleteRunsWhenInterrupted)
{
    for (const int signal : {SIGINT, SIGTERM})
    {
        const Folder folder;
        writeFile(folder / "scene.yaml", easyScene());
        // RRTstar takes all of its time, so at most a few of these runs are done when it is interrupted.
        Program program("benchmark_team", {folder / "scene.yaml", "--planners", "RRTstar", "--methods", "shared",
                                           "--runs", "1000", "--time", "0.5", "--log", folder / "teams.log"});
        std::this_thread::sleep_for(std::chrono::seconds(3));
        program.signal(signal);
        EXPECT_EQ(program.wait(), 1) << program.errors();
        EXPECT_NE(program.output().find("interrupted"), std::string::npos) << program.output();
        EXPECT_EQ(folder.list().size(), 2u) << "no temporary file is left";
        std::vector<std::string> names;
        const auto runs = runsOf(contentOf(folder / "teams.log"), "geometric_RRTstar[shared]", names);
        EXPECT_GE(runs.size(), 1u);
        EXPECT_LT(runs.size(), 900u);
        const std::string log = contentOf(folder / "teams.log");
        EXPECT_NE(log.find("\n" + std::to_string(runs.size()) + " runs per planner\n"), std::string::npos) << log;
        const std::size_t spent = log.find(" seconds spent");
        ASSERT_NE(spent, std::string::npos) << log;
        EXPECT_GE(std::stod(log.substr(log.rfind('\n', spent) + 1)), 0.5 * static_cast<double>(runs.size()));
        const auto time = std::find(names.begin(), names.end(), "time REAL");
        ASSERT_NE(time, names.end());
        for (const auto &run : runs)
            EXPECT_GE(std::stod(run.at(static_cast<std::size_t>(time - names.begin()))), 0.5) << "only whole runs";
    }
}

TEST(BenchmarkTeam, endsWithFirstSolutionsAndProvesMotions)
{
    const Folder folder;
    writeFile(folder / "scene.yaml", easyScene());
    Program program("benchmark_team", {folder / "scene.yaml", "--planners", "RRTstar", "--motion", "continuous",
                                       "--first", "--runs", "2", "--time", "20", "--log", folder / "log"});
    ASSERT_EQ(program.wait(), 0) << program.errors();
    const std::string log = contentOf(folder / "log");
    EXPECT_EQ(log.find("[fcl]"), std::string::npos);
    EXPECT_EQ(log.find("[standard]"), std::string::npos);
    std::vector<std::string> lengths;
    for (const std::string method : {"basic", "partial", "shared"})
    {
        SCOPED_TRACE(method);
        std::vector<std::string> names;
        const auto runs = runsOf(log, "geometric_RRTstar[" + method + "]", names);
        ASSERT_EQ(runs.size(), 2u);
        const auto value = [&](const std::string &name)
        { return runs[0].at(static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin())); };
        EXPECT_EQ(value("solved BOOLEAN"), "1");
        EXPECT_LT(std::stod(value("time REAL")), 15.0);
        lengths.push_back(value("solution length REAL"));
    }
    EXPECT_EQ(std::set<std::string>(lengths.begin(), lengths.end()).size(), 1u);

    Program refused("benchmark_team", {folder / "scene.yaml", "--methods", "fcl,shared", "--motion", "continuous"});
    EXPECT_EQ(refused.wait(), 2);
    EXPECT_NE(refused.errors().find("--motion: continuous needs certificates, which method fcl does not make"),
              std::string::npos)
        << refused.errors();
}

TEST(BenchmarkTeam, namesTheLogThatDoesNotFitOnTheDisk)
{
    const Folder folder;
    writeFile(folder / "scene.yaml", easyScene());
    Program program("benchmark_team", {folder / "scene.yaml", "--planners", "RRTConnect", "--methods", "shared",
                                       "--runs", "1", "--time", "0.5", "--log", "/dev/full"});
    EXPECT_EQ(program.wait(), 2);
    EXPECT_NE(program.errors().find("/dev/full"), std::string::npos) << program.errors();
}

TEST(BenchmarkTeam, writesOtherLogsWhereOneFails)
{
    const Folder folder;
    writeFile(folder / "first.yaml", easyScene());
    writeFile(folder / "second.yaml", easyScene());
    const auto before = std::filesystem::last_write_time(folder.path());
    Program program("benchmark_team",
                    {folder / "first.yaml", folder / "second.yaml", "--planners", "RRTstar", "--methods", "shared",
                     "--runs", "1", "--time", "0.7", "--log", folder / "x.log"});
    // Once it has tried whether it can write, a folder takes the first log's place.
    for (int i = 0; i < 30000 && std::filesystem::last_write_time(folder.path()) == before; ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    std::filesystem::create_directory(folder / "x_first.log");
    EXPECT_EQ(program.wait(), 2);
    EXPECT_NE(program.errors().find("x_first.log"), std::string::npos) << program.errors();
    EXPECT_NE(contentOf(folder / "x_second.log").find("geometric_RRTstar[shared]"), std::string::npos);
}

TEST(BenchmarkTeam, saysWhichScenesWouldShareALog)
{
    const Folder folder;
    std::filesystem::create_directories(folder / "other");
    writeFile(folder / "scene.yaml", easyScene());
    writeFile(folder / "other/scene.yaml", easyScene());
    const std::string first = folder / "scene.yaml", second = folder / "other/scene.yaml";
    for (const auto &[log, complaint] : {std::pair<std::string, std::string>{"-", "--log: - is for one scene"},
                                         {folder / "x.log", "the log of " + first + " and of " + second}})
    {
        Program program("benchmark_team", {first, second, "--runs", "1", "--log", log});
        EXPECT_EQ(program.wait(), 2);
        EXPECT_NE(program.errors().find(complaint), std::string::npos) << program.errors();
    }
}

TEST(BenchmarkTeam, blamesTheFileOfABadParameter)
{
    const Folder folder;
    const std::string faces = "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";
    writeFile(folder / "robot.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n" + faces);
    writeFile(folder / "world.obj", "v 20 20 0\nv 30 20 0\nv 20 30 0\nv 20 20 5\n" + faces);
    writeFile(folder / "scene.cfg",
              "[problem]\nname = test\nrobot = robot.obj\nworld = world.obj\nstart.x = 1\nstart.y = 2\n"
              "start.theta = 0\ngoal.x = 35\ngoal.y = 4\ngoal.theta = 0\nvolume.min.x = 0\nvolume.min.y = 0\n"
              "volume.max.x = 40\nvolume.max.y = 40\n[planner]\nrrt=\nrrt.goal_bias=often\n");
    Program program("benchmark_team", {folder / "scene.cfg", "--runs", "1", "--planner-param", "range=5"});
    EXPECT_EQ(program.wait(), 2);
    EXPECT_NE(program.errors().find("scene.cfg: [planner] rrt: "), std::string::npos) << program.errors();
}

TEST(BenchmarkTeam, writesALogToStandardOutput)
{
    const Folder folder;
    writeFile(folder / "scene.yaml", easyScene());
    Program program("benchmark_team", {folder / "scene.yaml", "--planners", "RRTConnect", "--methods", "shared",
                                       "--runs", "1", "--time", "0.5", "--log", "-"});
    ASSERT_EQ(program.wait(), 0) << program.errors();
    EXPECT_NE(program.output().find("geometric_RRTConnect[shared]\n"), std::string::npos) << program.output();
    EXPECT_EQ(program.output().find("medians"), std::string::npos) << program.output();
    EXPECT_NE(program.errors().find("medians"), std::string::npos) << program.errors();
}

TEST(BenchmarkTeam, givesPlannersTheirParametersAndTheObjective)
{
    const Folder folder;
    writeFile(folder / "scene.yaml", easyScene());
    const auto logOf = [&folder](const std::string &objective)
    {
        Program program("benchmark_team", {folder / "scene.yaml", "--planners", "RRT,RRTConnect", "--methods", "shared",
                                           "--first", "--runs", "1", "--planner-param", "range=0.5",
                                           "RRT.goal_bias=0.25", "--objective", objective, "--log", folder / "log"});
        EXPECT_EQ(program.wait(), 0) << program.errors();
        return contentOf(folder / "log");
    };
    const std::string log = logOf("length");
    const std::size_t second = log.find("geometric_RRTConnect[shared]");
    ASSERT_NE(second, std::string::npos);
    for (const std::string &part : {log.substr(0, second), log.substr(second)})
        EXPECT_NE(part.find("\nrange = 0.5\n"), std::string::npos) << part;
    EXPECT_NE(log.substr(0, second).find("\ngoal_bias = 0.25\n"), std::string::npos) << log;

    // The same first path: its makespan is the length of the robot that goes farthest, of two.
    std::vector<std::string> names;
    const auto runs = runsOf(logOf("makespan"), "geometric_RRT[shared]", names);
    const auto value = [&](const std::string &name)
    {
        const auto field = std::find(names.begin(), names.end(), name);
        EXPECT_NE(field, names.end()) << name;
        return std::stod(runs.at(0).at(static_cast<std::size_t>(field - names.begin())));
    };
    const double makespan = value("solution_cost REAL"), length = value("solution length REAL");
    EXPECT_GE(makespan, length / std::sqrt(2.0) - 1e-6);
    EXPECT_LT(makespan, 0.999 * length);
    EXPECT_EQ(log.find("solution_cost"), std::string::npos);
}

TEST(BenchmarkTeam, suggestsWhatWasMeant)
{
    const Folder folder;
    writeFile(folder / "scene.yaml", easyScene());
    for (const auto &[option, word, meant] : {std::tuple{"--planners", "RRTConect", "RRTConnect"},
                                              {"--methods", "standart", "standard"},
                                              {"--plannners", "RRT", "--planners"}})
    {
        Program program("benchmark_team", {folder / "scene.yaml", option, word});
        EXPECT_EQ(program.wait(), 2);
        EXPECT_NE(program.errors().find("did you mean " + std::string(meant) + "?"), std::string::npos)
            << program.errors();
    }
}

TEST(BenchmarkTeam, refusesBadInput)
{
    const Folder folder;
    writeFile(folder / "scene.yaml", easyScene());
    const std::string scene = folder / "scene.yaml", log = folder / "x.log";
    const std::vector<std::vector<std::string>> inputs{{},
                                                       {folder / "missing.yaml", "--log", log},
                                                       {scene, "--planners", "RRT,Walk", "--log", log},
                                                       {scene, "--planners", "RRT,RRT", "--log", log},
                                                       {scene, "--planners", ",", "--log", log},
                                                       {scene, "--planners", "", "--log", log},
                                                       {scene, "--methods", "shared,best", "--log", log},
                                                       {scene, "--runs", "0", "--log", log},
                                                       {scene, "--time", "-1", "--log", log},
                                                       {scene, "--seed", "x", "--log", log},
                                                       {scene, "--objective", "beauty", "--log", log},
                                                       {scene, "--planner-param", "range", "--log", log},
                                                       {scene, "--planner-param", "PRM.range=2", "--log", log},
                                                       {scene, "--planner-param", "rnage=2", "--log", log},
                                                       {scene, scene, "--log", log},
                                                       {scene, "--log", folder / "none/x.log"},
                                                       {scene, "--log", scene}};
    for (const auto &input : inputs)
    {
        Program program("benchmark_team", input);
        EXPECT_EQ(program.wait(), 2);
        const std::string errors = program.errors();
        EXPECT_EQ(std::count(errors.begin(), errors.end(), '\n'), 1) << errors;
        EXPECT_EQ(folder.list().size(), 1u) << errors;
        EXPECT_EQ(contentOf(scene), easyScene());
    }
}

TEST(BenchmarkTeam, takesPlanningScenesOfMoveIt)
{
    const Folder folder;
    const std::string arms = OMPL_CERTIFICATES_SOURCE_DIR "/demos/scenes/arms/";
    for (const char *name : {"one.yaml", "two.yaml"})
        writeFile(folder / name,
                  "world:\n  collision_objects:\n    - {id: ball, primitives: [{type: sphere, dimensions: [0.1]}], "
                  "primitive_poses: [{position: [0, 3, 0]}]}\n");
    std::string request =
        "group_name: arm\nallowed_planning_time: 0.5\n"
        "start_state: {joint_state: {name: [waist, shoulder_lift, elbow, wrist_roll, wrist_bend, flange], "
        "position: [0, -0.6, 1.9, 0, 0.3, 0]}}\ngoal_constraints:\n  - joint_constraints:\n";
    for (const char *joint : {"waist", "shoulder_lift", "elbow", "wrist_roll", "wrist_bend", "flange"})
        request += std::string("      - {joint_name: ") + joint + ", position: 0}\n";
    writeFile(folder / "request.yaml", request);
    std::vector<std::string> arguments{folder / "one.yaml",
                                       folder / "two.yaml",
                                       "--request",
                                       folder / "request.yaml",
                                       "--urdf",
                                       arms + "arm6.urdf",
                                       "--srdf",
                                       arms + "arm6.srdf",
                                       "--runs",
                                       "2",
                                       "--planners",
                                       "RRTConnect",
                                       "--methods",
                                       "standard,shared",
                                       "--log",
                                       folder / "arms.log"};
    Program program("benchmark_team", arguments);
    EXPECT_EQ(program.wait(), 0) << program.errors();
    for (const char *log : {"arms_one.log", "arms_two.log"})
    {
        std::vector<std::string> names;
        EXPECT_EQ(runsOf(contentOf(folder / log), "geometric_RRTConnect[shared]", names).size(), 2u) << log;
    }

    // Not among other scenes
    writeFile(folder / "two.yaml", easyScene());
    Program mixed("benchmark_team", arguments);
    EXPECT_EQ(mixed.wait(), 2);
    EXPECT_NE(mixed.errors().find("--request: is for planning scenes of MoveIt, which " + folder / "two.yaml"),
              std::string::npos)
        << mixed.errors();
    EXPECT_EQ(mixed.output(), "");
}
