// What certificates plan tells of a solution between the samples at which its motions were checked

#include "demos/Program.h"

#include <nlohmann/json.hpp>

namespace
{
    class PlanProof : public ::testing::Test
    {
    protected:
        /** A disc that passes a wall, whose step between samples is 1.4 */
        std::string scene(const std::string &name, const std::string &wall) const
        {
            writeFile(folder_ / name,
                      "resolution: 0.1\nenvironment:\n  min: [0, 0]\n  max: [10, 10]\n  obstacles:\n    - " + wall +
                          "\nrobots:\n  - {name: disc, type: rigid, space: R2, shape: {type: disc, radius: 0.1}, "
                          "start: [1, 5], goal: [9, 5]}\n");
            return folder_ / name;
        }

        int plan(std::vector<std::string> arguments)
        {
            arguments.insert(arguments.end(), {"--planner", "RRTConnect", "--report", folder_ / "report.json"});
            Program program("plan_team", arguments);
            const int code = program.wait();
            EXPECT_NE(code, 2) << program.errors();
            text_ = program.output();
            report_ = nlohmann::json::parse(contentOf(folder_ / "report.json"));
            return code;
        }

        const Folder folder_;
        std::string text_;
        nlohmann::json report_;
    };
}

TEST_F(PlanProof, IsThereWhereAllIsFree)
{
    ASSERT_EQ(plan({scene("open.yaml", "{type: box, center: [5, 1], size: [0.05, 0.05]}")}), 0);
    EXPECT_EQ(report_.at("unproved_motions"), 0);
    EXPECT_TRUE(report_.at("collision").is_null());
    EXPECT_NE(text_.find("\n  proved        free throughout\n"), std::string::npos) << text_;
}

/** The wall is thinner than a step: a plan in discrete mode goes through it, and says so. */
TEST_F(PlanProof, NamesWhatCollidesBetweenTheSamples)
{
    const std::string walled = scene("walled.yaml", "{type: box, center: [4.3, 5], size: [0.05, 10]}");
    ASSERT_EQ(plan({walled}), 0);
    EXPECT_GT(report_.at("unproved_motions"), 0);
    EXPECT_EQ(report_.at("collision").get<std::string>().substr(0, 13), "robot 'disc' ");
    EXPECT_NE(text_.find("\n  not proved    "), std::string::npos) << text_;
    EXPECT_NE(text_.find("; between samples, robot 'disc' "), std::string::npos) << text_;
    EXPECT_NE(text_.find("; --motion continuous proves"), std::string::npos) << text_;

    for (const char *method : {"standard", "fcl"})
    {
        ASSERT_EQ(plan({walled, "--method", method}), 0);
        EXPECT_GT(report_.at("unproved_motions"), 0);
        EXPECT_EQ(report_.at("collision").get<std::string>().substr(0, 13), "robot 'disc' ");
    }
    EXPECT_EQ(plan({walled, "--motion", "continuous", "--time", "0.2"}), 1);
    EXPECT_TRUE(report_.at("unproved_motions").is_null());
}
