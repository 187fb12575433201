#include "demos/Program.h"

TEST(DryRun, tellsWhatWouldBePlannedAndPlansNothing)
{
    const Folder folder;
    Program program("plan_team", {SCENES + "warehouse.yaml", "--dry-run", "--planner", "RRTstar", "--range", "0.5",
                                  "--time", "1000", "--picture", folder / "plan.svg", "--view", folder / "plan.html"});
    EXPECT_EQ(program.wait(), 0) << program.errors();
    const std::string output = program.output();
    for (const std::string part :
         {"start and goal are free", "RRTstar", "range = 0.5", "1000 s", "robot         tug: dimensions 4, bodies 2",
          "method shared", "plan.svg", "plan.html"})
        EXPECT_NE(output.find(part), std::string::npos) << part << " in " << output;
    EXPECT_TRUE(folder.list().empty()) << "nothing is written";
}

TEST(DryRun, printsErrorsOnlyIfThatIsAsked)
{
    Program program("plan_team", {SCENES + "warehouse.yaml", "--dry-run", "--quiet"});
    EXPECT_EQ(program.wait(), 0) << program.errors();
    EXPECT_EQ(program.output(), "");
    Program dynamic("plan_team", {SCENES + "controls/doorway.yaml", "--dry-run", "--dynamics", "--quiet"});
    EXPECT_EQ(dynamic.wait(), 0) << dynamic.errors();
    EXPECT_EQ(dynamic.output(), "");
}

TEST(DryRun, tellsOfControls)
{
    const Folder folder;
    Program program("plan_team",
                    {SCENES + "controls/doorway.yaml", "--dry-run", "--dynamics", "--planner", "SST", "--planner-param",
                     "selection_radius=0.7", "--goal-tolerance", "3", "--path", folder / "path.csv"});
    EXPECT_EQ(program.wait(), 0) << program.errors();
    const std::string output = program.output();
    for (const std::string part : {"start and goal are free", "planner       SST", "objective duration",
                                   "selection_radius = 0.7", "10 s", "steps         checked at their ends",
                                   "robot         cart", "each for 1 to 10 steps of 0.1 s", "within 3", "path.csv"})
        EXPECT_NE(output.find(part), std::string::npos) << part << " in " << output;
    EXPECT_EQ(output.find("resolution"), std::string::npos) << output;
    EXPECT_TRUE(folder.list().empty()) << "nothing is written";
}

TEST(DryRun, findsWhatPlanningWouldFind)
{
    const Folder folder;
    const std::string colliding = folder.write("colliding.yaml",
                                               "environment: {min: [0, 0], max: [9, 9], obstacles: [{type: box, "
                                               "center: [5, 5], size: [1, 1]}]}\n"
                                               "robots: [{type: single_integrator, start: [1, 1], goal: [5, 5]}]\n");
    for (const auto &[arguments, message] : std::vector<std::pair<std::vector<std::string>, std::string>>{
             {{colliding}, "robots[0].goal"},
             {{SCENES + "warehouse.yaml", "--planner", "RRTs"}, "RRTs"},
             {{SCENES + "warehouse.yaml", "--path", folder / "no/plan.csv"}, "no/plan.csv"},
             {{SCENES + "controls/doorway.yaml", "--dynamics", "--planner", "RRTConnect"}, "RRTConnect"},
             {{SCENES + "controls/doorway.yaml", "--dynamics", "--path", folder / "no/plan.csv"}, "no/plan.csv"}})
    {
        std::vector<std::string> all(arguments);
        all.push_back("--dry-run");
        Program program("plan_team", all);
        EXPECT_EQ(program.wait(), 2);
        EXPECT_NE(program.errors().find(message), std::string::npos) << program.errors();
    }
}
