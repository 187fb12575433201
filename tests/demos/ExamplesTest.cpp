#include "demos/Program.h"
#include "support/Folder.h"

#include <filesystem>
#include <map>
#include <sstream>

TEST(Examples, solve)
{
    for (const std::string name : {"01_team_of_discs", "02_mixed_shapes", "03_own_obstacles", "04_own_robot",
                                   "05_benchmarking", "06_mesh_team", "07_changing_obstacles", "10_controls"})
    {
        // Only one of them reads files; the others take no arguments.
        const std::vector<std::string> arguments(name == "06_mesh_team" ? 1 : 0,
                                                 OMPL_CERTIFICATES_SOURCE_DIR "/demos/scenes");
        Program program(name, arguments);
        EXPECT_EQ(program.wait(), 0) << name << "\n" << program.errors();
        EXPECT_NE(program.output(), "") << name;
    }
}

TEST(Examples, BenchmarkGrowsTheSameTreesWithAllMethods)
{
    Program program("05_benchmarking", {});
    ASSERT_EQ(program.wait(), 0) << program.errors();
    std::istringstream lines(program.output());
    std::map<std::string, std::string> states;
    for (std::string line; std::getline(lines, line);)
        if (const std::size_t at = line.find(", states "); at != std::string::npos)
            states[line.substr(0, line.find(':'))] += line.substr(at, line.find(", time") - at);
    EXPECT_EQ(states.size(), 5u) << program.output();
    for (const auto &[method, counts] : states)
        EXPECT_EQ(counts, states.begin()->second) << method;
}

TEST(Examples, PlanAmongAnOctomapThatTheyWrite)
{
    if (!std::filesystem::exists(OMPL_CERTIFICATES_BIN_DIR "/09_octomap"))
        GTEST_SKIP() << "built without octomap";
    const ompl_certificates::test::Folder folder;
    Program program("09_octomap", {OMPL_CERTIFICATES_SOURCE_DIR "/demos/scenes/drones_3d.yaml", folder / "map.bt"});
    EXPECT_EQ(program.wait(), 0) << program.errors();
    EXPECT_NE(program.output().find("boxes of occupied cells"), std::string::npos);
    // The map of the scene with cells is the one that the example writes.
    std::ifstream kept(OMPL_CERTIFICATES_SOURCE_DIR "/demos/scenes/drones_octomap.bt", std::ios::binary);
    EXPECT_EQ(folder.read("map.bt"), std::string(std::istreambuf_iterator<char>(kept), {}));
}
