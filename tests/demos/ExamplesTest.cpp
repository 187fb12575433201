#include "demos/Program.h"

TEST(Examples, solve)
{
    for (const std::string name : {"01_team_of_discs", "02_mixed_shapes", "03_own_obstacles", "04_own_robot",
                                   "05_benchmarking", "06_mesh_team", "07_changing_obstacles"})
    {
        // Only one of them reads files; the others take no arguments.
        const std::vector<std::string> arguments(name == "06_mesh_team" ? 1 : 0,
                                                 OMPL_CERTIFICATES_SOURCE_DIR "/demos/scenes");
        Program program(name, arguments);
        EXPECT_EQ(program.wait(), 0) << name << "\n" << program.errors();
        EXPECT_NE(program.output(), "") << name;
    }
}
