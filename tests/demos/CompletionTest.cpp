#include "demos/Program.h"

#include <algorithm>
#include <set>
#include <sstream>

namespace
{
    /** The words that bash suggests when \e line is to be completed */
    std::set<std::string> suggested(const std::string &program, const std::vector<std::string> &line)
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
        std::set<std::string> result;
        for (std::string word; std::getline(lines, word);)
            if (!word.empty())
                result.insert(word);
        return result;
    }

    /** The options that --help tells of */
    std::set<std::string> optionsOf(const std::string &program)
    {
        Program help(program, {"--help"});
        EXPECT_EQ(help.wait(), 0);
        std::istringstream lines(help.output());
        std::set<std::string> options;
        for (std::string line; std::getline(lines, line);)
            if (const std::size_t begin = line.find("--"); begin != std::string::npos && begin < 6 && line[0] == ' ')
                options.insert(line.substr(begin, line.find_first_of(" =,[", begin) - begin));
        return options;
    }
}

TEST(Completion, suggestsAllOptionsOfHelp)
{
    for (const std::string program : {"plan_team", "benchmark_team", "generate_scene", "certificate_experiment"})
    {
        const std::set<std::string> options = optionsOf(program);
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
    EXPECT_EQ(suggested("plan_team", {"--method", ""}),
              (std::set<std::string>{"fcl", "standard", "basic", "partial", "shared"}));
    EXPECT_EQ(suggested("plan_team", {"--quiet", "--planner", "DRRT"}), (std::set<std::string>{"DRRTstar"}));
    EXPECT_EQ(suggested("plan_team", {"--picture-t"}), (std::set<std::string>{"--picture-tree"}));
    EXPECT_TRUE(suggested("plan_team", {"--picture", "pl"}).empty()) << "bash completes files then";
}
