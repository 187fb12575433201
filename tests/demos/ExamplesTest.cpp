#include "demos/Program.h"

TEST(Examples, solve)
{
    for (const std::string name : {"01_team_of_discs", "02_mixed_shapes", "03_own_obstacles", "04_own_robot",
                                   "05_benchmarking", "07_changing_obstacles"})
    {
        Program program(name, {});
        EXPECT_EQ(program.wait(), 0) << name << "\n" << program.errors();
        EXPECT_NE(program.output(), "") << name;
    }
}
