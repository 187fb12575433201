// That the trees are equal is shown by scripts/demo.sh itself, which fails if one is not.

#include "Program.h"

#include <chrono>
#include <thread>

TEST(CompareWithOmpl, refusesBadOptions)
{
    const Folder folder;
    writeFile(folder / "file", "");
    const std::vector<std::pair<std::vector<std::string>, std::string>> cases{
        {{"--sedes", "1"}, "did you mean --seeds"},
        {{"--seeds", "0"}, "--seeds"},
        {{"--scenes", folder / "nowhere"}, "paper_five_discs.yaml"},
        {{"--scenes", SCENES, "--out", folder / "file"}, "--out"}};
    for (const auto &[arguments, complaint] : cases)
    {
        Program program("compare_with_ompl", arguments);
        EXPECT_EQ(program.wait(), 2);
        EXPECT_NE(program.errors().find(complaint), std::string::npos) << program.errors();
        EXPECT_EQ(program.output(), "");
    }
}

TEST(CompareWithOmpl, looksAtAllFilesBeforeItPlans)
{
    const Folder folder;
    std::filesystem::create_directories(folder / "half");
    std::filesystem::copy(SCENES + "paper_five_discs.yaml", folder / "half");
    std::filesystem::create_directories(folder / "out/sixteen_robots.svg");
    const std::vector<std::pair<std::vector<std::string>, std::string>> cases{
        {{"--scenes", folder / "half", "--out", folder / "pictures"}, "half/maze.yaml"},
        {{"--scenes", SCENES, "--out", folder / "out"}, "--out: " + (folder / "out/sixteen_robots.svg")}};
    for (const auto &[arguments, complaint] : cases)
    {
        Program program("compare_with_ompl", arguments);
        EXPECT_EQ(program.wait(), 2);
        EXPECT_NE(program.errors().find(complaint), std::string::npos) << program.errors();
        EXPECT_EQ(program.output(), "");
    }
}

TEST(CompareWithOmpl, endsWhenInterrupted)
{
    for (const int signal : {SIGINT, SIGTERM})
    {
        const Folder folder;
        Program program("compare_with_ompl", {"--scenes", SCENES, "--out", folder / "out", "--seeds", "1000"});
        while (!std::filesystem::exists(folder / "out"))
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        program.signal(signal);
        EXPECT_EQ(program.wait(), 1);
        EXPECT_NE(program.output().find("interrupted"), std::string::npos) << program.output();
    }
}
