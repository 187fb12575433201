#ifndef OMPL_CERTIFICATES_TESTS_DEMOS_PLAN_TEAM_
#define OMPL_CERTIFICATES_TESTS_DEMOS_PLAN_TEAM_

#include "demos/Program.h"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

/** \brief Plans in a folder that contains scene.yaml, and reads the report */
class PlanTeam : public ::testing::Test
{
protected:
    void SetUp() override
    {
        writeFile(folder_ / "scene.yaml", easyScene());
    }

    /** \brief With RRTConnect, unless there is another planner: it ends with its first solution */
    int plan(std::vector<std::string> arguments)
    {
        if (std::find(arguments.begin(), arguments.end(), "--planner") == arguments.end())
            arguments.insert(arguments.end(), {"--planner", "RRTConnect"});
        arguments.insert(arguments.end(), {"--report", folder_ / "report.json", "--quiet"});
        Program program("plan_team", arguments);
        const int code = program.wait();
        errors_ = program.errors();
        if (std::filesystem::exists(folder_ / "report.json"))
            report_ = nlohmann::json::parse(contentOf(folder_ / "report.json"));
        return code;
    }

    std::string scene() const
    {
        return folder_ / "scene.yaml";
    }

    Folder folder_;
    std::string errors_;
    nlohmann::json report_;
};

#endif
