#include "demos/Program.h"

#include "ompl_certificates/planning/Planners.h"

#include <sstream>

TEST(ListPlanners, tellsOfEachInALine)
{
    for (const std::string name : {"plan_team", "benchmark_team"})
    {
        Program program(name, {"--list-planners"});
        EXPECT_EQ(program.wait(), 0);
        EXPECT_EQ(program.errors(), "");
        std::istringstream lines(program.output());
        std::vector<std::string> names;
        for (std::string line; std::getline(lines, line);)
        {
            names.push_back(line.substr(0, line.find(' ')));
            EXPECT_GT(line.size(), 45u) << line;
            const bool optimizing = line.find(" optimizing ") != std::string::npos;
            EXPECT_TRUE(names.back() != "RRTstar" || optimizing) << line;
            EXPECT_TRUE(names.back() != "RRTConnect" || !optimizing) << line;
        }
        EXPECT_EQ(names, ompl_certificates::plannerNames());
    }
}
