#include "demos/Program.h"

#include "ompl_certificates/control/ControlPlanners.h"
#include "ompl_certificates/planning/Planners.h"

#include <map>
#include <sstream>

TEST(ListPlanners, tellsOfEachAndItsParametersInALine)
{
    for (const std::string name : {"plan_team", "benchmark_team"})
    {
        Program program(name, {"--list-planners"});
        EXPECT_EQ(program.wait(), 0);
        EXPECT_EQ(program.errors(), "");
        std::istringstream lines(program.output());
        std::vector<std::string> names;
        std::map<std::string, std::vector<std::string>> parameters;
        for (std::string line; std::getline(lines, line);)
        {
            if (line.front() == ' ')
            {
                parameters[names.back()].push_back(line);
                continue;
            }
            names.push_back(line.substr(0, line.find(' ')));
            EXPECT_GT(line.size(), 45u) << line;
            const bool optimizing = line.find(" optimizing ") != std::string::npos;
            EXPECT_TRUE(names.back() != "RRTstar" || optimizing) << line;
            EXPECT_TRUE(names.back() != "RRTConnect" || !optimizing) << line;
        }
        std::vector<std::string> expected = ompl_certificates::plannerNames();
        if (name == "plan_team")
            for (const std::string &planner : ompl_certificates::controlPlannerNames())
            {
                expected.push_back(planner);
                EXPECT_EQ(parameters.count(planner), 1U);
            }
        EXPECT_EQ(names, expected);
        const auto &ofConnect = parameters["RRTConnect"];
        ASSERT_EQ(ofConnect.size(), 2u) << "intermediate_states and range";
        EXPECT_EQ(ofConnect[1], "    range                                      0           0.:1.:10000.");
        EXPECT_GT(parameters["RRTstar"].size(), 10u);
    }
}
