#include "demos/PlanTeam.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <fcntl.h>
#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>
#include <sys/resource.h>
#include <sys/stat.h>
#include <thread>

namespace
{
    /** The numbers of a nonempty table of comma-separated values, without its header */
    std::vector<std::vector<double>> tableOf(std::string text)
    {
        std::replace(text.begin(), text.end(), ',', ' ');
        std::istringstream lines(text);
        std::string line;
        std::getline(lines, line);
        std::vector<std::vector<double>> rows;
        while (std::getline(lines, line))
        {
            std::istringstream numbers(line);
            rows.emplace_back(std::istream_iterator<double>(numbers), std::istream_iterator<double>());
        }
        return rows;
    }
}

TEST_F(PlanTeam, endsWithTheFirstSolution)
{
    for (const std::string planner : {"DRRTstar", "RRTstar"})
    {
        ASSERT_EQ(plan({scene(), "--planner", planner, "--time", "40", "--first"}), 0) << errors_;
        EXPECT_LT(report_.at("seconds").at("total").get<double>(), 20.0) << planner;
    }
}

TEST_F(PlanTeam, writesWhatIsAskedFor)
{
    ASSERT_EQ(plan({scene(), "--path", folder_ / "path.csv", "--picture", folder_ / "plan.svg", "--picture-tree",
                    "--picture-certificates", "--animation", folder_ / "moving.svg"}),
              0)
        << errors_;
    EXPECT_EQ(errors_, "");
    EXPECT_NE(contentOf(folder_ / "plan.svg").find("</svg>"), std::string::npos);
    EXPECT_EQ(contentOf(folder_ / "plan.svg").find("<animate"), std::string::npos);
    EXPECT_NE(contentOf(folder_ / "moving.svg").find("<animate"), std::string::npos);

    const auto path = tableOf(contentOf(folder_ / "path.csv"));
    ASSERT_GE(path.size(), 2u);
    const double last = path.back().back();
    ASSERT_EQ(plan({scene(), "--path", folder_ / "ticks.csv", "--path-step", std::to_string(last / 40.0)}), 0)
        << errors_;
    const auto ticks = tableOf(contentOf(folder_ / "ticks.csv"));
    EXPECT_GE(ticks.size(), path.size() + 38u);
    for (std::size_t i = 1; i < ticks.size(); ++i)
        EXPECT_LE(ticks[i].back() - ticks[i - 1].back(), last / 40.0 * 1.001);
    ASSERT_EQ(path.front().size(), 8u);
    EXPECT_EQ(path.front()[0], 0.0);
    EXPECT_EQ(path.front()[1], 1.0);
    EXPECT_EQ(path.front()[5], 4.0);
    EXPECT_DOUBLE_EQ(path.back()[0], report_.at("cost").get<double>());
    // The length counts both robots, the time the one that moves farther.
    EXPECT_EQ(path.front()[7], 0.0);
    EXPECT_LE(path.back()[7], path.back()[0]);
    EXPECT_GE(path.back()[7], path.back()[0] / std::sqrt(2.0));

    EXPECT_EQ(report_.at("planner"), "RRTConnect");
    EXPECT_EQ(report_.at("method"), "shared");
    EXPECT_EQ(report_.at("motion"), "discrete");
    EXPECT_EQ(report_.at("seed"), 1);
    EXPECT_TRUE(report_.at("solved").get<bool>());
    EXPECT_FALSE(report_.at("approximate").get<bool>());
    EXPECT_GT(report_.at("cost").get<double>(), 11.0);
    EXPECT_TRUE(report_.at("simplified_cost").is_null());
    EXPECT_TRUE(report_.at("seconds").at("simplifying").is_null());
    EXPECT_GT(report_.at("tree").at("states").get<int>(), 2);
    EXPECT_LE(report_.at("seconds").at("checking").get<double>(), report_.at("seconds").at("total").get<double>());
    EXPECT_GT(report_.at("seconds").at("nearest").get<double>(), 0.0);
    EXPECT_LE(report_.at("seconds").at("nearest").get<double>(), report_.at("seconds").at("total").get<double>());
}

TEST_F(PlanTeam, simplifiesTheSolution)
{
    const std::vector<std::string> arguments{scene(),  "--planner",         "RRT", "--iterations", "100000",
                                             "--path", folder_ / "path.csv"};
    ASSERT_EQ(plan(arguments), 0) << errors_;
    const double cost = report_.at("cost");
    const std::string digest = report_.at("tree").at("digest"), plain = contentOf(folder_ / "path.csv");
    std::vector<std::string> simplifying = arguments;
    simplifying.emplace_back("--simplify");
    ASSERT_EQ(plan(simplifying), 0) << errors_;
    EXPECT_EQ(report_.at("cost").get<double>(), cost);
    EXPECT_EQ(report_.at("tree").at("digest"), digest);
    EXPECT_LT(report_.at("simplified_cost").get<double>(), 0.9 * cost);
    EXPECT_GT(report_.at("seconds").at("simplifying").get<double>(), 0.0);
    const auto path = tableOf(contentOf(folder_ / "path.csv"));
    EXPECT_DOUBLE_EQ(path.back()[0], report_.at("simplified_cost").get<double>());
    EXPECT_EQ(path.front(), tableOf(plain).front());

    // An approximate solution has nothing to simplify.
    ASSERT_EQ(plan({scene(), "--planner", "RRT", "--iterations", "3", "--simplify"}), 1) << errors_;
    EXPECT_TRUE(report_.at("simplified_cost").is_null());
}

TEST_F(PlanTeam, plansForTeamsByDRRTstarAndForAnyObjective)
{
    double length = 0.0, makespan = 0.0;
    for (const std::string objective : {"length", "makespan"})
    {
        Program program("plan_team",
                        {scene(), "--time", "0.5", "--objective", objective, "--report", folder_ / "report.json"});
        ASSERT_EQ(program.wait(), 0) << program.errors();
        const auto report = nlohmann::json::parse(contentOf(folder_ / "report.json"));
        EXPECT_EQ(report.at("planner"), "DRRTstar");
        EXPECT_EQ(report.at("objective"), objective);
        EXPECT_LE(report.at("seconds").at("first_solution").get<double>(), 0.6);
        EXPECT_NE(program.output().find("  first         after "), std::string::npos) << program.output();
        (objective == "length" ? length : makespan) = report.at("cost").get<double>();
    }
    // Of two robots, the one that goes farther
    EXPECT_LT(makespan, length);
    EXPECT_GT(makespan, length / 2.0);
}

TEST_F(PlanTeam, tellsBothCosts)
{
    Program program("plan_team",
                    {scene(), "--planner", "RRTConnect", "--simplify", "--report", folder_ / "report.json"});
    ASSERT_EQ(program.wait(), 0) << program.errors();
    const auto report = nlohmann::json::parse(contentOf(folder_ / "report.json"));
    char costs[80];
    std::snprintf(costs, sizeof(costs), "cost %.6g, simplified %.6g in", report.at("cost").get<double>(),
                  report.at("simplified_cost").get<double>());
    EXPECT_NE(program.output().find(costs), std::string::npos) << program.output();
}

TEST_F(PlanTeam, writesOneFileToStandardOutput)
{
    Program path("plan_team", {scene(), "--planner", "RRTConnect", "--path", "-", "--report", folder_ / "report.json"});
    ASSERT_EQ(path.wait(), 0) << path.errors();
    const std::string names = path.output().substr(0, path.output().find('\n'));
    EXPECT_EQ(names.find("length,"), 0u) << names;
    EXPECT_EQ(std::count(names.begin(), names.end(), ','), 7) << names;
    const auto rows = tableOf(path.output());
    ASSERT_GE(rows.size(), 2u);
    for (const auto &row : rows)
        EXPECT_EQ(row.size(), 8u);
    // The summary
    EXPECT_NE(path.errors().find("solved"), std::string::npos) << path.errors();
    EXPECT_EQ(folder_.list().size(), 2u) << "there is no file named -";

    Program report("plan_team", {scene(), "--planner", "RRTConnect", "--report", "-", "--quiet"});
    ASSERT_EQ(report.wait(), 0);
    EXPECT_EQ(report.errors(), "");
    EXPECT_TRUE(nlohmann::json::parse(report.output()).at("solved").get<bool>());

    for (const std::string option : {"--picture", "--animation"})
    {
        Program picture("plan_team", {scene(), "--planner", "RRTConnect", option, "-", "--quiet"});
        ASSERT_EQ(picture.wait(), 0);
        EXPECT_NE(picture.output().find("</svg>"), std::string::npos) << option;
    }
    Program view("plan_team", {scene(), "--planner", "RRTConnect", "--view", "-", "--quiet"});
    ASSERT_EQ(view.wait(), 0);
    EXPECT_NE(view.output().find("</html>"), std::string::npos);
}

TEST_F(PlanTeam, readsASceneFromAPipe)
{
    const std::string pipe = folder_ / "pipe";
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    Program program("plan_team", {pipe, "--planner", "RRTConnect"});
    int end = -1;
    for (int i = 0; i < 1000 && end < 0; ++i)
    {
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
        end = open(pipe.c_str(), O_WRONLY | O_NONBLOCK | O_CLOEXEC);  // once the program reads
    }
    ASSERT_GE(end, 0);
    const std::string text = easyScene();
    EXPECT_EQ(write(end, text.data(), text.size()), static_cast<ssize_t>(text.size()));
    close(end);
    EXPECT_EQ(program.wait(), 0) << program.errors();
}

TEST_F(PlanTeam, drawsThePathOfAForest)
{
    ASSERT_EQ(plan({scene(), "--planner", "CForest", "--time", "0.5", "--path", folder_ / "path.csv", "--picture",
                    folder_ / "plan.svg", "--picture-tree", "--view", folder_ / "plan.html"}),
              0)
        << errors_;
    const std::string forest = contentOf(folder_ / "path.csv");
    ASSERT_EQ(plan({scene(), "--path", folder_ / "path.csv"}), 0) << errors_;
    const std::string other = contentOf(folder_ / "path.csv");
    EXPECT_EQ(forest.substr(0, forest.find('\n')), other.substr(0, other.find('\n')));
}

TEST_F(PlanTeam, namesTheFileThatDidNotFitOnTheDiskAndWritesTheOthers)
{
    // A limit on the size of files acts like a full disk, and the program inherits it.
    rlimit before;
    ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
    const rlimit small{4096, before.rlim_max};
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
    Program program("plan_team", {scene(), "--planner", "RRTConnect", "--report", folder_ / "report.json", "--picture",
                                  folder_ / "plan.svg", "--picture-tree", "--path", folder_ / "path.csv"});
    setrlimit(RLIMIT_FSIZE, &before);
    std::signal(SIGXFSZ, handler);
    EXPECT_EQ(program.wait(), 2);
    const std::string errors = program.errors();
    EXPECT_NE(errors.find(folder_ / "plan.svg: cannot be written"), std::string::npos) << errors;
    EXPECT_EQ(std::count(errors.begin(), errors.end(), '\n'), 1) << errors;
    EXPECT_NE(program.output().find("solved"), std::string::npos);
    EXPECT_TRUE(std::filesystem::exists(folder_ / "report.json"));
    EXPECT_TRUE(std::filesystem::exists(folder_ / "path.csv"));
    EXPECT_EQ(folder_.list().size(), 3u) << "no part of a file is left";
}

TEST_F(PlanTeam, countsAddUpUnderEveryMethodAndMotionCheck)
{
    for (const std::string method : {"standard", "basic", "partial", "shared"})
        for (const std::string motion : {"discrete", "continuous"})
        {
            if (method == "standard" && motion == "continuous")
                continue;
            SCOPED_TRACE(method + " " + motion);
            ASSERT_EQ(plan({scene(), "--method", method, "--motion", motion, "--planner", "RRT", "--iterations", "3000",
                            "--range", "1.5"}),
                      0)
                << errors_;
            const auto &checks = report_.at("checks");
            const auto count = [&checks](const char *key) { return checks.at(key).get<std::uint64_t>(); };
            EXPECT_GT(count("robot_poses"), 0u);
            EXPECT_EQ(count("robot_poses"), count("certified_free") + count("certified_colliding") + count("asked"));
            EXPECT_EQ(count("asked"), count("by_clearances") + count("by_contact") + count("exact"));
            EXPECT_LE(count("asked_colliding"), count("asked"));
            EXPECT_LE(count("pair_exact"), count("pair_poses"));
            EXPECT_LE(count("motion_samples_skipped"), count("motion_samples"));
            EXPECT_GT(count("motions"), 0u);
            EXPECT_EQ(count("certificates") > 0, method != "standard");
            EXPECT_LE(report_.at("iterations").get<std::uint64_t>(), 3000u);
        }
}

TEST_F(PlanTeam, growsTheSameTreeUnderEveryMethod)
{
    const std::string paper = OMPL_CERTIFICATES_SOURCE_DIR "/demos/scenes/paper_three_discs.yaml";
    for (const std::string &file : {scene(), paper})
        for (const std::string planner : {"RRT", "RRTConnect", "RRTstar", "EST", "KPIECE1", "BITstar"})
        {
            SCOPED_TRACE(file + " " + planner);
            std::string digest;
            for (const std::string method : {"standard", "basic", "partial", "shared"})
            {
                ASSERT_NE(plan({file, "--method", method, "--planner", planner, "--iterations", "1500", "--seed", "5"}),
                          2)
                    << errors_;
                if (digest.empty())
                    digest = report_.at("tree").at("digest");
                EXPECT_EQ(report_.at("tree").at("digest"), digest) << method;
            }
        }
}

TEST_F(PlanTeam, anotherSeedGrowsAnotherTree)
{
    ASSERT_EQ(plan({scene(), "--seed", "1"}), 0);
    const std::string digest = report_.at("tree").at("digest");
    ASSERT_EQ(plan({scene(), "--seed", "2"}), 0);
    EXPECT_NE(report_.at("tree").at("digest"), digest);
}

TEST_F(PlanTeam, returnsOneIfNothingIsFound)
{
    EXPECT_EQ(plan({scene(), "--planner", "RRT", "--iterations", "3", "--path", folder_ / "path.csv", "--animation",
                    folder_ / "plan.svg"}),
              1);
    EXPECT_FALSE(report_.at("solved").get<bool>());
    EXPECT_TRUE(report_.at("approximate").get<bool>());
    EXPECT_TRUE(report_.at("cost").is_null());
    EXPECT_FALSE(std::filesystem::exists(folder_ / "path.csv"));
    EXPECT_FALSE(std::filesystem::exists(folder_ / "plan.svg"));
}

TEST_F(PlanTeam, copiesTheTreeOnlyForAFileThatShowsIt)
{
    // Copying the roadmap of a PRM may take longer than planning.
    const std::vector<std::string> arguments{scene(), "--planner", "PRM", "--iterations", "200"};
    for (const std::string option : {"", "--path", "--picture", "--report", "--view"})
    {
        std::vector<std::string> all = arguments;
        if (!option.empty())
            all.insert(all.end(), {option, folder_ / "file"});
        Program program("plan_team", all);
        program.wait();
        const std::string output = program.output();
        EXPECT_NE(output.find("  iterations    "), std::string::npos) << output;
        EXPECT_EQ(output.find("  tree          ") != std::string::npos, option == "--report" || option == "--view")
            << option << output;
    }
}

TEST_F(PlanTeam, tellsWhyNothingWasFound)
{
    ASSERT_EQ(plan({scene(), "--planner", "RRT", "--iterations", "3"}), 1) << errors_;
    const std::string reason = report_.at("reason");
    EXPECT_EQ(reason.find("an approximate solution ends "), 0u) << reason;
    ASSERT_EQ(plan({scene()}), 0) << errors_;
    EXPECT_TRUE(report_.at("reason").is_null());
}

TEST_F(PlanTeam, setsParametersOfThePlanner)
{
    EXPECT_EQ(plan({scene(), "--planner", "RRT", "--planner-param", "range=1.5", "goal_bias=0.2"}), 0) << errors_;
    const std::string digest = report_.at("tree").at("digest");
    EXPECT_EQ(plan({scene(), "--planner", "RRT", "--range", "1.5", "--planner-param", "goal_bias=0.2"}), 0) << errors_;
    EXPECT_EQ(report_.at("tree").at("digest"), digest);
}

TEST_F(PlanTeam, endsTidilyWhenInterrupted)
{
    for (const int signal : {SIGINT, SIGTERM})
    {
        std::filesystem::remove(folder_ / "report.json");
        std::filesystem::remove(folder_ / "plan.svg");
        Program program("plan_team", {scene(), "--planner", "RRTstar", "--time", "300", "--simplify", "--report",
                                      folder_ / "report.json", "--picture", folder_ / "plan.svg"});
        std::this_thread::sleep_for(std::chrono::seconds(2));
        program.signal(signal);
        EXPECT_EQ(program.wait(), 0) << program.errors();
        EXPECT_NE(program.output().find("interrupted"), std::string::npos);
        const auto report = nlohmann::json::parse(contentOf(folder_ / "report.json"));
        EXPECT_TRUE(report.at("solved").get<bool>());
        EXPECT_LT(report.at("seconds").at("total").get<double>(), 200.0);
        EXPECT_LE(report.at("simplified_cost").get<double>(), report.at("cost").get<double>());
        EXPECT_TRUE(std::filesystem::exists(folder_ / "plan.svg"));
    }
}

TEST_F(PlanTeam, recognizesASceneWithoutSolution)
{
    const std::string file = OMPL_CERTIFICATES_SHARED_DIR "/scenes/db-cbs/infeasible_0.yaml";
    if (!std::filesystem::exists(file))
        GTEST_SKIP() << "there is no " << file;
    EXPECT_EQ(plan({file}), 2);
    EXPECT_NE(errors_.find("overlap"), std::string::npos) << errors_;
}
