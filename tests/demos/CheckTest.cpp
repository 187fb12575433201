// certificates check

#include "demos/Program.h"

namespace
{
    const std::string DISCS = SCENES + "paper_five_discs.yaml", DOORS = SCENES + "controls/doorway.yaml";

    bool has(const std::string &text, const std::string &part)
    {
        return text.find(part) != std::string::npos;
    }
}

TEST(CheckTest, takesWhatPlanWrites)
{
    const Folder folder;
    for (const std::vector<std::string> &kind : {std::vector<std::string>{DISCS}, {DOORS, "--dynamics"}})
    {
        std::vector<std::string> plan{"plan"}, check{"check", kind[0], folder / "path.csv"};
        plan.insert(plan.end(), kind.begin(), kind.end());
        plan.insert(plan.end(), {"--motion", "continuous", "--path", folder / "path.csv", "--time", "30"});
        if (kind.size() == 1)
            plan.push_back("--first");
        check.insert(check.end(), kind.begin() + 1, kind.end());
        Program planning("certificates", plan);
        ASSERT_EQ(planning.wait(), 0) << planning.errors();
        Program checking("certificates", check);
        EXPECT_EQ(checking.wait(), 0) << checking.errors() << checking.output();
        for (const std::string line : {"\n  starts        0 from the scene's start\n", "\n  ends          ",
                                       "\n  bounds        kept ", "\n  free          throughout\n"})
            EXPECT_TRUE(has(checking.output(), line)) << line << checking.output();
    }
}

TEST(CheckTest, tellsWhatIsWrong)
{
    const Folder folder;
    const std::string scene = folder.write("post.yaml",
                                           "environment: {min: [0, 0], max: [10, 10], obstacles: "
                                           "[{type: box, center: [5, 5], size: [0.01, 1]}]}\n"
                                           "robots: [{type: rigid, name: a, space: R2, shape: {type: disc, radius: "
                                           "0.001}, start: [1, 5], goal: [9, 5]}]\n");
    Program through("certificates", {"check", scene, folder.write("through.csv", "a.x,a.y\n1,5\n9,5\n")});
    EXPECT_EQ(through.wait(), 1);
    EXPECT_TRUE(has(through.output(), "\n  not free      robot 'a' touches environment.obstacles[0]"))
        << through.output();
    EXPECT_TRUE(has(through.output(), "\n  not proved    1 of 1 motions, the first is number 0\n")) << through.output();

    Program outside("certificates", {"check", scene, folder.write("out.csv", "a.x,a.y\n1,5\n1,10.5\n")});
    EXPECT_EQ(outside.wait(), 1);
    EXPECT_TRUE(has(outside.output(), "\n  ends          9.70824 from the goal\n")) << outside.output();
    EXPECT_TRUE(has(outside.output(),
                    "\n  bounds        state 1: robot 'a' is outside the bounds: y is 10.5, not from 0 to 10\n"))
        << outside.output();

    Program broken("certificates", {"check", scene, folder.write("broken.csv", "a.x,a.y\n1,five\n")});
    EXPECT_EQ(broken.wait(), 2);
    EXPECT_TRUE(has(broken.errors(), "broken.csv:2: 'a.y' must be a finite number, not 'five'")) << broken.errors();
}

/** What OMPL and planners would refuse: limits of controls and of robots, bounds at the ends of steps, leaps. */
TEST(CheckTest, looksAtTheLimitsOfRobotsThatMoveByControls)
{
    const Folder folder;
    const std::string scene =
        folder.write("train.yaml",
                     "environment: {min: [0, 0], max: [10, 10]}\nrobots:\n"
                     "  - {type: unicycle_first_order_0, name: u, start: [2, 2, 0], goal: [8, 8, 0]}\n"
                     "  - {type: car_first_order_with_1_trailers_0, name: c, start: [6, 6, 0, 0], "
                     "goal: [7, 7, 0, 0]}\n");
    const std::string names =
        "time,u.x,u.y,u.yaw,c.car.x,c.car.y,c.car.yaw,c.trailer.yaw,u.linear,u.angular,c.speed,"
        "c.steering\n";
    const auto outputOf = [&](const std::string &lines)
    {
        Program program("certificates", {"check", scene, folder.write("path.csv", names + lines), "--dynamics"});
        EXPECT_EQ(program.wait(), 1) << program.errors() << program.output();
        return program.output();
    };
    const std::string rest = "6,6,0,0,";
    EXPECT_TRUE(has(outputOf("0,2,2,0," + rest + "5,0,0,0\n0.1,2.5,2,0," + rest + ",,,\n"),
                    "\n  controls      after state 0: u.linear is 5, not from -0.5 to 0.5\n"));
    EXPECT_TRUE(has(outputOf("0,2,2,0," + rest + "0.5,0,0,0\n0.1,2.5,2,0," + rest + ",,,\n"),
                    "\n  steps         step 0 ends 0.45 from the next state"));
    EXPECT_TRUE(has(outputOf("0,0.02,2,0," + rest + "-0.5,0,0,0\n0.4,-0.18,2,0," + rest + ",,,\n"),
                    "\n  bounds        state 1: robot 'u' is outside the bounds: x is -0.03"));
    EXPECT_TRUE(has(outputOf("0,2,2,0,6,6,0,2.9,0,0,0,0\n0.1,2,2,0,6,6,0,2.9,,,,\n"),
                    "\n  bounds        state 0: robot 'c' is beyond its limits\n"));
}
