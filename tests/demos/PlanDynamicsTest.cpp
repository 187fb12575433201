#include "demos/Program.h"

#include <chrono>
#include <csignal>
#include <nlohmann/json.hpp>
#include <sstream>
#include <sys/resource.h>
#include <thread>

namespace
{
    const std::string DOORWAY = OMPL_CERTIFICATES_SOURCE_DIR "/demos/scenes/controls/doorway.yaml";

    std::vector<std::string> linesOf(const std::string &file)
    {
        std::istringstream stream(contentOf(file));
        std::vector<std::string> lines;
        for (std::string line; std::getline(stream, line);)
            lines.push_back(line);
        return lines;
    }
}

TEST(PlanDynamicsTest, WritesTimesAndControls)
{
    const Folder folder;
    for (const char *motion : {"discrete", "continuous"})
    {
        Program program("plan_team",
                        {DOORWAY, "--dynamics", "--goal-tolerance", "1", "--motion", motion, "--time", "30", "--path",
                         folder / "path.csv", "--picture", folder / "plan.svg", "--animation", folder / "moving.svg",
                         "--view", folder / "plan.html", "--picture-tree", "--report", folder / "report.json"});
        EXPECT_EQ(program.wait(), 0) << program.errors();
        const auto lines = linesOf(folder / "path.csv");
        ASSERT_GT(lines.size(), 3u);
        EXPECT_EQ(lines[0],
                  "time,cart.x,cart.y,cart.yaw,puck.pose.x,puck.pose.y,puck.velocity.x,puck.velocity.y,"
                  "cart.linear,cart.angular,puck.ax,puck.ay");
        EXPECT_EQ(lines[1].substr(0, 16), "0,2,2,0,4,1,0,0,");
        EXPECT_EQ(lines[2].substr(0, 4), "0.1,");
        EXPECT_EQ(lines[4].substr(0, 4), "0.3,");
        EXPECT_EQ(lines.back().substr(lines.back().size() - 4), ",,,,");
        EXPECT_NE(contentOf(folder / "plan.svg").find("</svg>"), std::string::npos);
        EXPECT_NE(contentOf(folder / "moving.svg").find("<animateTransform"), std::string::npos);
        EXPECT_NE(contentOf(folder / "plan.html").find("</html>"), std::string::npos);
        const auto report = nlohmann::json::parse(contentOf(folder / "report.json"));
        EXPECT_EQ(report.at("motion"), motion);
        const auto unproved = report.at("unproved_motions").get<std::int64_t>();
        EXPECT_TRUE(unproved == 0 || std::string(motion) == "discrete") << unproved;
        const std::string line =
            unproved == 0 ? "\n  proved        free throughout\n"
                          : "\n  not proved    " + std::to_string(unproved) + " of " + std::to_string(lines.size() - 2);
        EXPECT_NE(program.output().find(line), std::string::npos) << program.output();
    }
}

TEST(PlanDynamicsTest, WritesTheShortenedPath)
{
    const Folder folder;
    Program program("plan_team", {DOORWAY, "--dynamics", "--simplify", "--time", "30", "--motion", "continuous",
                                  "--path", folder / "path.csv", "--report", folder / "report.json"});
    EXPECT_EQ(program.wait(), 0) << program.errors();
    const auto report = nlohmann::json::parse(contentOf(folder / "report.json"));
    const double before = report.at("cost").get<double>(), after = report.at("simplified_cost").get<double>();
    EXPECT_LT(after, 0.9 * before);
    EXPECT_EQ(report.at("unproved_motions"), 0);
    EXPECT_NE(program.output().find(" s, simplified "), std::string::npos) << program.output();
    const auto lines = linesOf(folder / "path.csv");
    EXPECT_NEAR(std::stod(lines.back()), after, 1e-6);
}

/** SST goes on to improve what it has found. */
TEST(PlanDynamicsTest, ProvesWhatWasFoundWhenInterrupted)
{
    const Folder folder;
    Program program("plan_team", {DOORWAY, "--dynamics", "--planner", "SST", "--goal-tolerance", "3", "--motion",
                                  "continuous", "--time", "300", "--report", folder / "report.json"});
    std::this_thread::sleep_for(std::chrono::seconds(3));
    program.signal(SIGINT);
    EXPECT_EQ(program.wait(), 0) << program.errors();
    EXPECT_NE(program.output().find("interrupted: this is what was found so far"), std::string::npos);
    EXPECT_NE(program.output().find("\n  proved        free throughout\n"), std::string::npos) << program.output();
    const auto report = nlohmann::json::parse(contentOf(folder / "report.json"));
    EXPECT_EQ(report.at("unproved_motions"), 0);
    EXPECT_LT(report.at("seconds").at("total").get<double>(), 200.0);
}

TEST(PlanDynamicsTest, TellsOfAllFilesThatCannotBeWritten)
{
    // A limit on the size of files acts like a full disk, and the program inherits it.
    const Folder folder;
    rlimit before;
    ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
    const rlimit small{1024, before.rlim_max};
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
    Program program("plan_team",
                    {DOORWAY, "--dynamics", "--planner", "RRT", "--goal-tolerance", "3", "--time", "30", "--path",
                     folder / "path.csv", "--picture", folder / "plan.svg", "--view", folder / "plan.html"});
    setrlimit(RLIMIT_FSIZE, &before);
    std::signal(SIGXFSZ, handler);
    EXPECT_EQ(program.wait(), 2);
    const std::string errors = program.errors();
    for (const char *file : {"plan.svg", "plan.html"})
        EXPECT_NE(errors.find(folder / file + ": cannot be written"), std::string::npos) << errors;
    EXPECT_GE(linesOf(folder / "path.csv").size(), 3u);
}

TEST(PlanDynamicsTest, RefusesBadInput)
{
    const std::string maze = OMPL_CERTIFICATES_SOURCE_DIR "/demos/scenes/maze.yaml";
    const std::pair<std::vector<std::string>, std::string> inputs[]{
        {{maze, "--dynamics"}, "maze.yaml:9: robots[0].type: 'rigid' has no dynamics"},
        {{DOORWAY, "--dynamics", "--planner", "RRTConnect"}, "known are: EST, KPIECE1, PDST, PrioritizedRRT, RRT, SST"},
        {{DOORWAY, "--dynamics", "--first"}, "--first excludes --dynamics"},
        {{DOORWAY, "--dynamics", "--goal-tolerance", "0"}, "--goal-tolerance"},
        {{DOORWAY, "--goal-tolerance", "1"}, "--dynamics"},
        {{DOORWAY, "--dynamics", "--motion", "continuous", "--method", "fcl"},
         "--motion: continuous needs certificates, which --method fcl does not make"},
        {{"any.cfg", "--dynamics"}, "any.cfg"}};
    for (const auto &[arguments, complaint] : inputs)
    {
        Program program("plan_team", arguments);
        EXPECT_EQ(program.wait(), 2) << complaint;
        EXPECT_NE(program.errors().find(complaint), std::string::npos) << program.errors();
    }
}
