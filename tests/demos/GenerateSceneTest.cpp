#include "demos/Program.h"

TEST(GenerateScene, WritesEachKind)
{
    const Folder folder;
    const std::vector<std::pair<std::string, std::vector<std::string>>> cases{
        {"paper_three_discs.yaml", {"--robots", "3"}},
        {"maze.yaml", {"--kind", "maze"}},
        {"cloud.yaml", {"--kind", "cloud"}},
        {"teams/boxes_16.yaml", {"--kind", "boxes", "--robots", "16", "--obstacles", "10"}},
        {"teams/discs_50.yaml", {"--kind", "discs", "--robots", "50", "--size", "40"}},
        {"teams/drones_30.yaml", {"--kind", "drones", "--seed", "1"}},
        {"teams/mixed_8.yaml", {"--kind", "mixed"}}};
    for (auto [file, arguments] : cases)
    {
        const std::string made = folder / std::filesystem::path(file).filename().string();
        arguments.insert(arguments.end(), {"--output", made});
        Program program("generate_scene", arguments);
        EXPECT_EQ(program.wait(), 0) << program.errors();
        EXPECT_EQ(contentOf(made), contentOf(SCENES + file)) << file;
    }
    EXPECT_EQ(contentOf(folder / "mixed_8_gear.obj"), contentOf(SCENES + "teams/mixed_8_gear.obj"));

    EXPECT_EQ(contentOf(folder / "cloud_cloud.xyz"), contentOf(SCENES + "cloud_cloud.xyz"));

    Program program("generate_scene", {"--kind", "window"});
    EXPECT_EQ(program.wait(), 0) << program.errors();
    EXPECT_EQ(program.output(), contentOf(SCENES + "teams/window_8.yaml"));
}

TEST(GenerateScene, WritesScenesOfAnyName)
{
    const Folder folder;
    for (const std::string name : {"@maze", "a, b", "my: maze", "it's", "{x} #1"})
        for (const std::string kind : {"maze", "cloud"})
        {
            const std::string file = folder / (name + " " + kind + ".yaml");
            Program program("generate_scene", {"--kind", kind, "--output", file});
            EXPECT_EQ(program.wait(), 0) << program.errors();
            Program reader("plan_team", {file, "--dry-run"});
            EXPECT_EQ(reader.wait(), 0) << reader.errors();
        }
}

TEST(GenerateScene, RefusesOptionsOfOtherKinds)
{
    const std::vector<std::pair<std::vector<std::string>, std::string>> cases{
        {{"--kind", "boxez"}, "did you mean boxes?"},
        {{"--kind", "maze", "--size", "3", "--output", "maze.yaml"}, "--size: is not for --kind maze"},
        {{"--kind", "boxes", "--radius", "1"}, "--radius: is not for --kind boxes"},
        {{"--kind", "discs", "--obstacles", "1"}, "--obstacles: is not for --kind discs"},
        {{"--kind", "warehouse", "--obstacles", "1"}, "--obstacles: is not for --kind warehouse"},
        {{"--kind", "window", "--obstacles", "1"}, "--obstacles: is not for --kind window"},
        {{"--kind", "maze", "--points", "9", "--output", "maze.yaml"}, "--points: is not for --kind maze"},
        {{"--kind", "cloud", "--points", "9", "--output", "cloud.yaml"}, "points: must be from 100 to 1000000, not 9"},
        {{"--kind", "cloud", "--robots", "7", "--output", "cloud.yaml"}, "robots: must be from 1 to 6, not 7"},
        {{"--robots", "-1"}, "--robots: must be a whole number from 0 to 1000000000, not '-1'"},
        {{"--size", "1e300"}, "size: must be from 0.001 to 1000000, not 1e+300"},
        {{"--size", "nan"}, "--size: must be a number above 0, not 'nan'"},
        {{"--kind", "drones", "--robots", "0"}, "robots: must be from 1 to 1000, not 0"},
        {{"--kind", "drones", "--size", "1"}, "size: must be from 5 to 1000 in drones, not 1"},
        {{"--kind", "discs", "--robots", "100", "--size", "5"}, "no place was found for disc_"},
        {{"--kind", "mixed"}, "--output: must name a file"}};
    for (const auto &[arguments, complaint] : cases)
    {
        Program program("generate_scene", arguments);
        EXPECT_EQ(program.wait(), 2) << complaint;
        EXPECT_NE(program.errors().find(complaint), std::string::npos) << program.errors();
        EXPECT_EQ(program.output(), "");
    }
}
