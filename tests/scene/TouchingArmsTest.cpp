// What links, attached bodies and obstacles of scene files may touch

#include "support/ArmScenes.h"

#include <gtest/gtest.h>

namespace ompl_certificates
{
    using namespace test;

    TEST(TouchingArms, LinksMayTouchObstacles)
    {
        const auto isFree = [](const std::string &keys)
        {
            Scene scene = sceneWithArm(keys);
            scene.addObstacle({Body::box(2.0, 2.0, 0.1), poseAt({0.0, 0.0, 0.0})}, "bench");
            const auto team = scene.makeTeam();
            return scene.describeCollision(team, scene.makeStart(team).get()).empty();
        };
        EXPECT_FALSE(isFree(""));
        EXPECT_TRUE(isFree("may_touch_obstacles: [base]"));
        EXPECT_FALSE(isFree("may_touch_obstacles: [palm]"));
    }

    TEST(TouchingArms, SomeLinksMayTouchAnObstacle)
    {
        const auto tellOf = [](const std::string &obstacle)
        {
            const Scene scene = sceneWithArm(
                "attached: [{name: rod, link: palm, shape: {type: box, size: [0.02, 0.02, 0.3]}, "
                "position: [0, 0, 0.2], "
                "touch_links: [left_finger, right_finger]}]" +
                obstacle);
            const auto team = scene.makeTeam();
            return scene.describeCollision(team, scene.makeStart(team).get());
        };
        EXPECT_EQ(tellOf(""), "");
        // A block about the rod's far end, and one about the wrist
        const Scene scene = sceneWithArm("");
        const auto poseOf = [&](const std::string &link)
        {
            const auto start = scene.makeStart(scene.makeTeam());
            return armOf(scene)->getLinkPose(start->as<ompl::base::CompoundState>()->components[0], link);
        };
        const auto block = [](const Eigen::Vector3d &at, const std::string &links)
        {
            return ", touchable: [{name: block, shape: {type: sphere, radius: 0.03}, position: [" +
                   std::to_string(at.x()) + ", " + std::to_string(at.y()) + ", " + std::to_string(at.z()) +
                   "], touch_links: [" + links + "]}]";
        };
        const Eigen::Vector3d end = poseOf("palm") * Eigen::Vector3d(0.0, 0.0, 0.34);
        EXPECT_EQ(tellOf(block(end, "")), "robot 'robot_0' touches obstacle 'block' with link 'rod'");
        EXPECT_EQ(tellOf(block(end, "rod")), "");
        EXPECT_EQ(
            tellOf(block(poseOf("wrist").translation(), "rod")).rfind("robot 'robot_0' touches obstacle 'block'", 0),
            0U);
        EXPECT_NE(
            messageAboutArm("touchable: [{name: block, shape: {type: sphere, radius: 0.03}, touch_links: [rood]}]")
                .find("touch links of obstacle 'block': there is no link 'rood'"),
            std::string::npos);
    }

    TEST(TouchingArms, ArmsHeedTheirOwnTouchableObstacles)
    {
        const auto tellOf = [](const std::string &ofSecond)
        {
            const std::string block =
                "touchable: [{name: block, shape: {type: box, size: [0.3, 0.3, 0.3]}, position: [0.5, 0, 0.15], "
                "touch_links: [palm]}]";
            const std::string arm =
                "type: urdf, file: arm6.urdf, srdf: arm6.srdf, group: arm, start: upright, goal: "
                "upright, ";
            const Scene scene =
                sceneFromYaml("environment: {min: [-1, -1, 0], max: [1, 1, 2]}\nrobots:\n  - {name: first, " + arm +
                                  block + "}\n  - {name: second, " + arm + "base: {position: [0.5, 0, 0]}" +
                                  (ofSecond.empty() ? "" : ", " + (ofSecond == "same" ? block : ofSecond)) + "}\n",
                              ARMS + "test.yaml");
            const auto team = scene.makeTeam();
            return scene.describeCollision(team, scene.makeStart(team).get());
        };
        // The second arm stands in the block.
        EXPECT_EQ(
            tellOf("").rfind("robots 'first' and 'second' touch each other: obstacle 'block' of 'first' and link ", 0),
            0U)
            << tellOf("");
        EXPECT_EQ(tellOf("same").rfind("robot 'second' touches obstacle 'block' with link ", 0), 0U) << tellOf("same");
        EXPECT_EQ(tellOf("touchable: [{name: block, shape: {type: sphere, radius: 0.01}, "
                         "position: [0, 0.9, 0.1]}]"),
                  "")
            << "each has its own";
    }

    TEST(TouchingArms, ObstaclesMakeArmsUnlike)
    {
        const auto with = [](const std::string &name, const std::string &links)
        {
            return armOf(sceneWithArm("touchable: [{name: " + name +
                                      ", shape: {type: sphere, radius: 0.01}, position: "
                                      "[0, 0.9, 0.1], touch_links: [" +
                                      links + "]}]"));
        };
        EXPECT_TRUE(with("bench", "palm")->isLike(*with("bench", "palm")));
        EXPECT_FALSE(with("bench", "palm")->isLike(*with("table", "palm")));
        EXPECT_FALSE(with("bench", "palm")->isLike(*with("bench", "")));
        EXPECT_FALSE(with("bench", "palm")->isLike(*armOf(sceneWithArm(""))));
    }

    TEST(TouchingArms, BodiesMayTouchTheLinksThatAreNamed)
    {
        EXPECT_NO_THROW(
            sceneWithArm("attached: [{name: a, link: palm, shape: {type: sphere, radius: 0.01}, "
                         "touch_links: [lid]}, {name: lid, link: palm, shape: {type: sphere, radius: 0.01}}]"))
            << "in any order";
        EXPECT_NE(messageAboutArm("attached: [{name: a, link: palm, shape: {type: sphere, radius: 0.01}, "
                                  "touch_links: [ldi]}]")
                      .find("touch links of attached body 'a': there is no link 'ldi'"),
                  std::string::npos);

        const auto notesOf = [](const std::string &touching)
        {
            const Scene scene = sceneWithArm("attached: [{name: ball, link: palm, shape: {type: sphere, radius: 0.2}" +
                                             touching + "}]");
            std::string text;
            for (const std::string &note : scene.getNotes())
                text += note;
            return text;
        };
        EXPECT_NE(notesOf("").find("left_finger and ball"), std::string::npos);
        EXPECT_EQ(notesOf(", touch_links: [left_finger]").find("left_finger and ball"), std::string::npos);
    }
}
