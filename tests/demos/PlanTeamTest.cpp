#include "demos/Program.h"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <nlohmann/json.hpp>
#include <sstream>
#include <thread>

namespace
{
    /** Plans in a folder that has scene.yaml, and reads the report */
    class PlanTeam : public ::testing::Test
    {
    protected:
        void SetUp() override
        {
            writeFile(folder_ / "scene.yaml", easyScene());
        }

        int plan(std::vector<std::string> arguments)
        {
            arguments.insert(arguments.end(), {"--report", folder_ / "report.json", "--quiet"});
            Program program("plan_team", arguments);
            const int code = program.wait();
            errors_ = program.errors();
            if (std::filesystem::exists(folder_ / "report.json"))
                report_ = nlohmann::json::parse(contentOf(folder_ / "report.json"));
            return code;
        }

        std::string scene() const
        {
            return folder_ / "scene.yaml";
        }

        TemporaryFolder folder_;
        std::string errors_;
        nlohmann::json report_;
    };
}

TEST_F(PlanTeam, writesWhatIsAskedFor)
{
    ASSERT_EQ(plan({scene(), "--path", folder_ / "path.txt", "--picture", folder_ / "plan.svg", "--picture-tree",
                    "--picture-certificates"}),
              0)
        << errors_;
    EXPECT_EQ(errors_, "");
    EXPECT_NE(contentOf(folder_ / "plan.svg").find("</svg>"), std::string::npos);

    std::istringstream path(contentOf(folder_ / "path.txt"));
    std::vector<double> first;
    std::string line;
    std::getline(path, line);
    std::istringstream numbers(line);
    for (double number; numbers >> number;)
        first.push_back(number);
    ASSERT_EQ(first.size(), 6u);
    EXPECT_EQ(first[0], 1.0);
    EXPECT_EQ(first[4], 4.0);

    EXPECT_EQ(report_.at("planner"), "RRTConnect");
    EXPECT_EQ(report_.at("method"), "shared");
    EXPECT_EQ(report_.at("motion"), "discrete");
    EXPECT_EQ(report_.at("seed"), 1);
    EXPECT_TRUE(report_.at("solved").get<bool>());
    EXPECT_FALSE(report_.at("approximate").get<bool>());
    EXPECT_GT(report_.at("cost").get<double>(), 11.0);
    EXPECT_GT(report_.at("tree").at("states").get<int>(), 2);
    EXPECT_LE(report_.at("seconds").at("checking").get<double>(), report_.at("seconds").at("total").get<double>());
    EXPECT_GT(report_.at("seconds").at("nearest").get<double>(), 0.0);
    EXPECT_LE(report_.at("seconds").at("nearest").get<double>(), report_.at("seconds").at("total").get<double>());
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
            EXPECT_EQ(count("robot_poses"), count("certified_free") + count("certified_colliding") + count("exact"));
            EXPECT_LE(count("exact_colliding"), count("exact"));
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
    EXPECT_EQ(plan({scene(), "--planner", "RRT", "--iterations", "3", "--path", folder_ / "path.txt"}), 1);
    EXPECT_FALSE(report_.at("solved").get<bool>());
    EXPECT_TRUE(report_.at("approximate").get<bool>());
    EXPECT_TRUE(report_.at("cost").is_null());
    EXPECT_FALSE(std::filesystem::exists(folder_ / "path.txt"));
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
        Program program("plan_team", {scene(), "--planner", "RRTstar", "--time", "300", "--report",
                                      folder_ / "report.json", "--picture", folder_ / "plan.svg"});
        std::this_thread::sleep_for(std::chrono::seconds(2));
        program.signal(signal);
        EXPECT_EQ(program.wait(), 0) << program.errors();
        EXPECT_NE(program.output().find("interrupted"), std::string::npos);
        const auto report = nlohmann::json::parse(contentOf(folder_ / "report.json"));
        EXPECT_TRUE(report.at("solved").get<bool>());
        EXPECT_LT(report.at("seconds").at("total").get<double>(), 200.0);
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

namespace
{
    /** Arguments in which @ stands for the folder, and a word that the complaint must contain */
    struct BadInput
    {
        std::vector<std::string> arguments;
        std::string complaint;

        /** Names the case in the output of the tests; else its bytes would. */
        friend std::ostream &operator<<(std::ostream &out, const BadInput &input)
        {
            for (const auto &argument : input.arguments)
                out << argument << ' ';
            return out;
        }
    };

    std::vector<BadInput> badInputs()
    {
        return {
            {{}, "SCENE"},
            {{"@/missing.yaml"}, "missing.yaml"},
            {{"@"}, "directory"},
            {{"@/broken.yaml"}, "broken.yaml"},
            {{"@/unknown_robot.yaml"}, "submarine"},
            {{"@/start_in_wall.yaml"}, "robots[0].start"},
            {{"@/scene.yaml", "--planner", "RRTConect"}, "RRTConect"},
            {{"@/scene.yaml", "--method", "best"}, "--method"},
            {{"@/scene.yaml", "--motion", "jumpy"}, "--motion"},
            {{"@/scene.yaml", "--motion", "continuous", "--method", "standard"}, "standard"},
            {{"@/scene.yaml", "--time", "0"}, "--time"},
            {{"@/scene.yaml", "--time", "nan"}, "--time"},
            {{"@/scene.yaml", "--time", "inf"}, "--time"},
            {{"@/scene.yaml", "--time", "soon"}, "--time"},
            {{"@/scene.yaml", "--iterations", "-1"}, "--iterations"},
            {{"@/scene.yaml", "--iterations", "1.5"}, "--iterations"},
            {{"@/scene.yaml", "--iterations", "10", "--time", "1"}, "--time"},
            {{"@/scene.yaml", "--seed", "0"}, "--seed"},
            {{"@/scene.yaml", "--seed", "99999999999"}, "--seed"},
            {{"@/scene.yaml", "--range", "-2"}, "--range"},
            {{"@/scene.yaml", "--planner", "PRM", "--range", "1"}, "--range"},
            {{"@/scene.yaml", "--planner-param", "range"}, "--planner-param"},
            {{"@/scene.yaml", "--planner-param", "=1"}, "--planner-param"},
            {{"@/scene.yaml", "--planner-param", "speed=1"}, "speed"},
            {{"@/scene.yaml", "--planner-param", "range=far"}, "far"},
            {{"@/scene.yaml", "--planner", "RRT", "--planner-param", "intermediate_states=maybe"}, "maybe"},
            {{"@/scene.yaml", "--planner", "PRM", "--planner-param", "max_nearest_neighbors=8x"}, "8x"},
            {{"@/scene.yaml", "--picture-tree"}, "--picture"},
            {{"@/scene.yaml", "--picture", "@/none/plan.svg"}, "--picture"},
            {{"@/scene.yaml", "--path", "@"}, "--path"},
            {{"@/scene.yaml", "--report", "@/scene.yaml"}, "--report"},
            {{"@/scene.yaml", "--report", "@/out", "--path", "@/out"}, "--report"},
            {{"@/scene.yaml", "--speed", "2"}, "--speed"},
            {{"@/scene.yaml", "@/scene.yaml"}, "scene.yaml"},
        };
    }

    class PlanTeamBadInput : public ::testing::TestWithParam<BadInput>
    {
    };
}

TEST_P(PlanTeamBadInput, isOneLineAndExitCodeTwoAndNoFile)
{
    const TemporaryFolder folder;
    std::string wall = easyScene(), robot = easyScene();
    wall.replace(wall.find("start: [1, 5"), 12, "start: [5, 5");
    robot.replace(robot.find("unicycle"), 8, "submarine_");
    writeFile(folder / "scene.yaml", easyScene());
    writeFile(folder / "broken.yaml", "environment: {min: [0, 0");
    writeFile(folder / "start_in_wall.yaml", wall);
    writeFile(folder / "unknown_robot.yaml", robot);
    const std::size_t files = folder.list().size();

    std::vector<std::string> arguments;
    bool report = false;
    for (std::string argument : GetParam().arguments)
    {
        report = report || argument == "--report";
        if (argument[0] == '@')
            argument = (folder / "") + argument.substr(std::min<std::size_t>(2, argument.size()));
        arguments.push_back(argument);
    }
    if (!report)
        arguments.insert(arguments.end(), {"--report", folder / "report.json"});

    Program program("plan_team", arguments);
    EXPECT_EQ(program.wait(), 2);
    const std::string errors = program.errors();
    EXPECT_EQ(std::count(errors.begin(), errors.end(), '\n'), 1) << errors;
    EXPECT_EQ(errors.compare(0, 11, "plan_team: "), 0) << errors;
    EXPECT_NE(errors.find(GetParam().complaint), std::string::npos) << errors;
    EXPECT_EQ(program.output(), "");
    EXPECT_EQ(folder.list().size(), files);
    EXPECT_EQ(contentOf(folder / "scene.yaml"), easyScene());
}

INSTANTIATE_TEST_SUITE_P(All, PlanTeamBadInput, ::testing::ValuesIn(badInputs()));
