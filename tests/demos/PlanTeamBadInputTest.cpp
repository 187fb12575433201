#include "demos/Program.h"

#include <algorithm>

namespace
{
    /** Arguments in which @ stands for the folder, and a word that the error message must contain */
    struct BadInput
    {
        std::vector<std::string> arguments;
        std::string complaint;

        /** Names the case in the tests' output, instead of its bytes. */
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
            {{"@/scene.yaml", "--planner", "Walk"}, "the planners are ABITstar, "},
            {{"@/scene.yaml", "--planner", "RRTConect"}, "'RRTConect'; did you mean RRTConnect?"},
            {{"@/scene.yaml", "--planner", "rrtstar"}, "did you mean RRTstar?"},
            {{"@/scene.yaml", "--planner", "Informed RRT*"}, "did you mean InformedRRTstar?"},
            {{"@/scene.yaml", "--method", "best"}, "--method"},
            {{"@/scene.yaml", "--method", "shraed"}, "did you mean shared?"},
            {{"@/scene.yaml", "--motion", "jumpy"}, "--motion"},
            {{"@/scene.yaml", "--motion", "continous"}, "did you mean continuous?"},
            {{"@/scene.yaml", "--nearest", "kd-tree"}, "did you mean kdtree?"},
            {{"@/scene.yaml", "--motion", "continuous", "--method", "standard"},
             "--motion: continuous needs certificates, which --method standard does not make"},
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
            {{"@/scene.yaml", "--planner", "RRT", "--range", "5", "--planner-param", "range=7"}, "--range gives, too"},
            {{"@/scene.yaml", "--planner-param", "range"}, "--planner-param"},
            {{"@/scene.yaml", "--planner-param", "=1"}, "--planner-param"},
            {{"@/scene.yaml", "--planner-param", "speed=1"}, "speed"},
            {{"@/scene.yaml", "--planner", "RRT", "--planner-param", "gaol_bias=0.1"}, "did you mean goal_bias?"},
            {{"@/scene.yaml", "--planner", "RRT", "--planner-param", "range=far"}, "far"},
            {{"@/scene.yaml", "--planner", "RRT", "--planner-param", "intermediate_states=maybe"}, "maybe"},
            {{"@/scene.yaml", "--planner", "PRM", "--planner-param", "max_nearest_neighbors=8x"}, "8x"},
            {{"@/scene.yaml", "--picture-tree"}, "--picture"},
            {{"@/scene.yaml", "--path-step", "0.1"}, "--path-step requires --path"},
            {{"@/scene.yaml", "--path", "@/p.csv", "--path-step", "0"}, "--path-step"},
            {{"@/scene.yaml", "--path", "@/p.csv", "--path-step", "0.1", "--dynamics"}, "--path-step"},
            {{"@/scene.yaml", "--picture", "@/none/plan.svg"}, "--picture"},
            {{"@/scene.yaml", "--picture", "@/plan.png"}, "--picture: must end in .svg, not .png"},
            {{"@/scene.yaml", "--view", "@/plan.pdf"}, "--view: must end in .html, not .pdf"},
            {{"@/scene.yaml", "--animation", "@/none/plan.svg"}, "--animation"},
            {{"@/scene.yaml", "--view", "@/none/plan.html"}, "/none/plan.html: cannot be written"},
            {{"@/scene.yaml", "--picture", "@/a.svg", "--animation", "@/a.svg"}, "is named by --picture, too"},
            {{"@/scene.yaml", "--path", "@"}, "--path"},
            {{"@/scene.yaml", "--report", "@/scene.yaml"}, "--report"},
            {{"@/scene.yaml", "--report", "@/out", "--path", "@/out"}, "--report"},
            {{"@/scene.yaml", "--report", "-", "--path", "-"}, "- is named by --path, too"},
            {{"@/scene.yaml", "--path", "./none.csv", "--report", "none.csv"}, "none.csv is named by --path, too"},
            {{"@/scene.yaml", "--picture", ""}, "--picture: is empty"},
            {{"@/scene.yaml", "--planner", ""}, "--planner: is empty"},
            {{"@/scene.yaml", "--picture=", "--quiet"}, "--picture: is empty"},
            {{"@/scene.yaml", "--path", "/dev/full", "--time", "300"}, "/dev/full: cannot be written"},
            {{"@/scene.yaml", "--picture", "/proc/plan.svg", "--time", "300"}, "/proc/plan.svg: cannot be written"},
            {{"@/scene.yaml", "--save-certificates", "-"}, "--save-certificates"},
            {{"@/scene.yaml", "--load-certificates", "@/scene.yaml"}, "--load-certificates: "},
            {{"@/scene.yaml", "--load-certificates", "@/broken.yaml", "--path", "@/broken.yaml"},
             "broken.yaml would overwrite what is read"},
            {{"--list-planer"}, "There is no option --list-planer; did you mean --list-planners?"},
            {{"@/scene.yaml", "--velocity", "2"}, "There is no option --velocity"},
            {{"@/scene.yaml", "--planer", "RRT"}, "There is no option --planer; did you mean --planner?"},
            {{"@/scene.yaml", "--pikture=plan.svg"}, "There is no option --pikture; did you mean --picture?"},
            {{"@/scene.yaml", "@/scene.yaml"}, "scene.yaml"},
        };
    }

    class PlanTeamBadInput : public ::testing::TestWithParam<BadInput>
    {
    };
}

TEST_P(PlanTeamBadInput, isOneLineAndExitCodeTwoAndNoFile)
{
    const Folder folder;
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
        if (!argument.empty() && argument[0] == '@')
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
