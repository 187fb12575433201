// The program certificates, most of whose commands are also programs of their own names.

#include "demos/Program.h"

#include <set>
#include <sstream>

namespace
{
    const std::vector<std::pair<std::string, std::string>> COMMANDS{{"plan", "plan_team"},
                                                                    {"benchmark", "benchmark_team"},
                                                                    {"generate", "generate_scene"},
                                                                    {"compare", "compare_with_ompl"},
                                                                    {"moving-world", "moving_world"},
                                                                    {"experiment", "certificate_experiment"}};

    /** Commands that are no programs of their own */
    const std::set<std::string> NEW_COMMANDS{"check"};

    /** What the program writes, from \e heading on */
    std::string helpAfter(const std::string &heading, Program &program)
    {
        EXPECT_EQ(program.wait(), 0) << program.errors();
        const std::string output = program.output();
        return output.substr(std::min(output.size(), output.find(heading)));
    }
}

TEST(Commands, failIfWhatTheyPrintIsLost)
{
    for (const std::string argument : {"--list-planners", "--help", "--version"})
    {
        const std::string command = OMPL_CERTIFICATES_BIN_DIR "/plan_team " + argument + " 2>/dev/null >";
        EXPECT_EQ(WEXITSTATUS(std::system((command + "/dev/null").c_str())), 0) << argument;
        EXPECT_EQ(WEXITSTATUS(std::system((command + "/dev/full").c_str())), 2) << argument;
        EXPECT_EQ(WEXITSTATUS(std::system((command + "&-").c_str())), 2) << argument;
    }
}

TEST(Commands, areThoseOfTheHelp)
{
    Program program("certificates", {"--help"});
    std::istringstream lines(helpAfter("Commands:\n", program));
    std::set<std::string> told, known = NEW_COMMANDS;
    std::string line;
    for (std::getline(lines, line); std::getline(lines, line) && !line.empty();)
        told.insert(line.substr(2, line.find(' ', 2) - 2));
    for (const auto &[name, link] : COMMANDS)
        known.insert(name);
    EXPECT_EQ(told, known);
}

TEST(Commands, areWhatTheirLinksAre)
{
    for (const auto &[name, link] : COMMANDS)
    {
        Program command("certificates", {name, "--help"}), alone(link, {"--help"}), version(link, {"--version"});
        const std::string help = helpAfter("  -h,--help", command);
        EXPECT_GT(help.size(), 100u);
        EXPECT_NE(command.output().find("Usage: certificates " + name + " "), std::string::npos) << command.output();
        EXPECT_EQ(alone.wait(), 0);
        EXPECT_NE(alone.output().find("Usage: " + link + " "), std::string::npos) << alone.output();
        // A program has its version besides.
        std::istringstream lines(help);
        for (std::string line; std::getline(lines, line);)
            EXPECT_NE(alone.output().find(line), std::string::npos) << line;
        EXPECT_EQ(version.wait(), 0);
        EXPECT_EQ(version.output().compare(0, link.size() + 3, link + " of"), 0) << version.output();
    }
}

TEST(Commands, planAsTheirLinksDo)
{
    const Folder folder;
    const std::string scene = folder.write("scene.yaml", easyScene());
    const std::vector<std::string> arguments{scene, "--iterations", "1000", "--seed", "3", "--quiet", "--path", "-"};
    std::vector<std::string> words{"plan"};
    words.insert(words.end(), arguments.begin(), arguments.end());
    Program command("certificates", words), alone("plan_team", arguments);
    EXPECT_EQ(command.wait(), 0) << command.errors();
    EXPECT_EQ(alone.wait(), 0) << alone.errors();
    EXPECT_GT(command.output().size(), 50u);
    EXPECT_EQ(command.output(), alone.output());
}

TEST(Commands, refuseWhatIsNone)
{
    const std::vector<std::pair<std::vector<std::string>, std::string>> cases{
        {{}, "certificates: needs a command; certificates --help lists them\n"},
        {{"plon", "scene.yaml", "extra"}, "certificates: There is no command plon; did you mean plan?\n"},
        {{"qqqqqq"}, "certificates: There is no command qqqqqq\n"},
        {{"--hlep"}, "certificates: There is no option --hlep; did you mean --help?\n"},
        {{"plan"}, "certificates plan: SCENE is required\n"},
        {{"plan", "scene.yaml", "--tiem", "2"}, "certificates plan: There is no option --tiem; did you mean --time?\n"},
        {{"plan", "plan", "benchmark"}, "certificates plan: The following argument was not expected: benchmark\n"},
        {{"generate", "--kind", "mazes"}, "did you mean maze?\n"},
        {{"plan", "nowhere.yaml"}, "certificates plan: nowhere.yaml: cannot be read: No such file or directory\n"}};
    for (const auto &[arguments, complaint] : cases)
    {
        Program program("certificates", arguments);
        EXPECT_EQ(program.wait(), 2) << complaint;
        EXPECT_NE(program.errors().find(complaint), std::string::npos) << program.errors();
        EXPECT_EQ(program.output(), "");
    }
}
