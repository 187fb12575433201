#include "demos/Program.h"

#include <algorithm>
#include <set>
#include <sstream>

namespace
{
    using Words = std::set<std::string>;

    /** The words that bash suggests when \e line is to be completed */
    Words suggested(const std::string &program, const std::vector<std::string> &line)
    {
        const Folder folder;
        Program writer(program, {"--bash-completion"});
        EXPECT_EQ(writer.wait(), 0);
        std::string words = program;
        for (const std::string &word : line)
            words += " '" + word + "'";
        const std::string script = folder.write(
            "complete.sh", writer.output() + "COMP_WORDS=(" + words + ")\nCOMP_CWORD=" + std::to_string(line.size()) +
                               "\n_" + program + "\nprintf '%s\\n' \"${COMPREPLY[@]}\"\n");
        const std::string output = folder / "words";
        EXPECT_EQ(std::system(("bash -eu " + script + " > " + output).c_str()), 0);
        std::istringstream lines(contentOf(output));
        Words result;
        for (std::string word; std::getline(lines, word);)
            if (!word.empty())
                result.insert(word);
        return result;
    }

    /** The options that --help tells of */
    Words optionsOf(const std::string &program, const std::vector<std::string> &arguments = {"--help"})
    {
        Program help(program, arguments);
        EXPECT_EQ(help.wait(), 0);
        std::istringstream lines(help.output());
        Words options;
        for (std::string line; std::getline(lines, line);)
            if (const std::size_t begin = line.find("--"); begin != std::string::npos && begin < 6 && line[0] == ' ')
                options.insert(line.substr(begin, line.find_first_of(" =,[", begin) - begin));
        return options;
    }
}

TEST(Completion, suggestsAllOptionsOfHelp)
{
    for (const std::string program : {"plan_team", "benchmark_team", "generate_scene", "certificate_experiment",
                                      "compare_with_ompl", "moving_world"})
    {
        const Words options = optionsOf(program);
        EXPECT_GT(options.size(), 4u) << program;
        EXPECT_EQ(suggested(program, {"--"}), options) << program;
        // What the build has made for installation is what the program says now.
        Program writer(program, {"--bash-completion"});
        EXPECT_EQ(writer.wait(), 0);
        EXPECT_EQ(contentOf(OMPL_CERTIFICATES_BIN_DIR "/../completions/" + program), writer.output());
    }
}

TEST(Completion, suggestsTheWordsOfAnOption)
{
    EXPECT_EQ(suggested("plan_team", {"--method", ""}), (Words{"fcl", "standard", "basic", "partial", "shared"}));
    EXPECT_EQ(suggested("plan_team", {"--quiet", "--planner", "DRRT"}), (Words{"DRRTstar"}));
    EXPECT_EQ(suggested("plan_team", {"--picture-t"}), (Words{"--picture-tree"}));
    EXPECT_EQ(suggested("benchmark_team", {"--methods", "fcl,s"}), (Words{"fcl,standard", "fcl,shared"}));
    EXPECT_EQ(suggested("benchmark_team", {"--planners", "RRT,BIT*,DRRT"}), (Words{"RRT,BIT*,DRRTstar"}));
    EXPECT_TRUE(suggested("plan_team", {"--picture", "pl"}).empty()) << "bash completes files then";
}

TEST(Completion, suggestsCommandsAndWhatTheyTake)
{
    EXPECT_EQ(suggested("certificates", {""}),
              (Words{"plan", "check", "benchmark", "generate", "experiment", "compare", "moving-world"}));
    EXPECT_EQ(suggested("certificates", {"pl"}), Words{"plan"});
    EXPECT_EQ(suggested("certificates", {"--"}), (Words{"--help", "--version"}));
    for (const std::string command : {"plan", "generate", "moving-world"})
        EXPECT_EQ(suggested("certificates", {command, "--"}), optionsOf("certificates", {command, "--help"}))
            << command;
    EXPECT_EQ(suggested("certificates", {"plan", "--planner", "DRRT"}), Words{"DRRTstar"});
    EXPECT_TRUE(suggested("certificates", {"plan", "pl"}).empty()) << "bash completes files then";
}
