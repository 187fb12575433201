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
        for (const std::string line :
             {"\n  starts        0 from the scene's start\n", "\n  ends          at the goal, ",
              "\n  bounds        kept\n", "\n  free          throughout\n"})
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
    EXPECT_TRUE(has(outside.output(), "\n  ends          not at the goal, ")) << outside.output();
    EXPECT_TRUE(has(outside.output(),
                    "\n  bounds        state 1: robot 'a' is outside the bounds: y is 10.5, not from 0 to 10\n"))
        << outside.output();

    Program broken("certificates", {"check", scene, folder.write("broken.csv", "a.x,a.y\n1,five\n")});
    EXPECT_EQ(broken.wait(), 2);
    EXPECT_TRUE(has(broken.errors(), "broken.csv:2: 'a.y' must be a finite number, not 'five'")) << broken.errors();
}
