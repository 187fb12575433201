// Distances that robots keep, in scene files

#include "support/ArmScenes.h"
#include "support/ArmTexts.h"
#include "support/Folder.h"
#include "support/Message.h"

#include "ompl_certificates/control/DynamicRobot.h"
#include "ompl_certificates/scene/ArmFile.h"

#include <gtest/gtest.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;

namespace
{
    const std::string WORLD_WITH_A_BOX =
        "environment:\n  min: [0, 0]\n  max: [10, 10]\n"
        "  obstacles: [{type: box, center: [5, 5], size: [2, 2]}]\nrobots:\n";

    Scene sceneOfPadded(const std::string &robots, bool dynamics = false)
    {
        return sceneFromYaml(WORLD_WITH_A_BOX + robots, "padding", dynamics);
    }
}

TEST(YamlPadding, IsOfAllBodiesOfARobot)
{
    const Scene scene = sceneOfPadded(
        "  - {type: rigid, space: SE2, shape: {type: disc, radius: 0.5}, padding: 0.25, start: [1, 1, 0], "
        "goal: [9, 9, 0]}\n"
        "  - {type: car_with_trailer, car: {type: disc, radius: 0.2}, trailer: {type: disc, radius: 0.1}, "
        "hitch_length: 0.5, self_collision: true, padding: 0.25, start: [1, 4, 0, 0], goal: [9, 4, 0, 0]}\n"
        "  - {type: arm, base: {center: [2, 8]}, links: [{length: 1, width: 0.1}, {length: 1, radius: 0.1}], "
        "padding: 0.25, start: [0, 0], goal: [1, 1]}\n"
        "  - {type: unicycle_first_order, padding: 0.25, start: [8, 1, 0], goal: [1, 9, 0], "
        "keep_out: [{type: box, center: [8, 8], size: [1, 1]}]}\n"
        "  - {type: car_first_order_with_1_trailers, padding: 0.25, start: [8, 5, 0, 0], goal: [3, 3, 0, 0]}\n");
    scene.validate();
    for (const Scene::Member &member : scene.getMembers())
        for (std::size_t body = 0; body < member.robot->getBodies().size(); ++body)
            EXPECT_EQ(member.robot->getBodies()[body].getPadding(), member.robot->isZone(body) ? 0.0 : 0.25)
                << member.robot->getName() << " " << body;
    const Scene moving =
        sceneOfPadded("  - {type: unicycle_first_order, padding: 0.25, start: [8, 1, 0], goal: [1, 9, 0]}\n", true);
    EXPECT_TRUE(dynamic_cast<const DynamicRobot *>(moving.getMembers()[0].robot.get()));
    EXPECT_EQ(moving.getMembers()[0].robot->getBodies()[0].getPadding(), 0.25);
}

TEST(YamlPadding, IsOfTheLinksOfAnArm)
{
    const Scene scene = sceneWithArm(
        "padding: 0.02, link_padding: {palm: 0.05, bar: 0}, attached: [{name: bar, link: palm, "
        "shape: {type: sphere, radius: 0.05}, position: [0, 0, 0.2]}], touchable: [{name: floor, "
        "shape: {type: box, size: [1, 1, 0.1]}, position: [0, 0, -0.1], touch_links: [base]}]");
    const auto arm = armOf(scene);
    for (std::size_t i = 0; i < arm->getBodies().size(); ++i)
    {
        const std::string &link = arm->getLinkOfBody(i);
        EXPECT_EQ(arm->getBodies()[i].getPadding(), link == "palm"                     ? 0.05
                                                    : link == "bar" || link == "floor" ? 0.0
                                                                                       : 0.02)
            << link;
    }
}

/** The links are those of one mechanism, whichever part moves them. */
TEST(YamlPadding, IsOneOfAllPartsOfAMechanism)
{
    const auto sceneOf = [](const std::string &left, const std::string &right)
    {
        const std::string twin = "  - {type: urdf, file: twin.urdf, srdf: twin.srdf, start: ahead, goal: ahead, ";
        return sceneFromYaml("environment: {min: [-1, -1, 0], max: [1, 1, 2]}\nrobots:\n" + twin +
                                 "name: left, group: left" + left + "}\n" + twin + "name: right, group: right" + right +
                                 "}\n",
                             ARMS + "test.yaml");
    };
    const Scene scene = sceneOf(", padding: 0.01, link_padding: {torso: 0.02}", ", padding: 0.01");
    for (const Scene::Member &member : scene.getMembers())
        for (std::size_t body = 0; body < member.robot->getBodies().size(); ++body)
            EXPECT_EQ(member.robot->getBodies()[body].getPadding(),
                      dynamic_cast<const Arm &>(*member.robot).getLinkOfBody(body) == "torso" ? 0.02 : 0.01);
    const auto complaint = [&](const std::string &left, const std::string &right)
    { return messageOf([&] { sceneOf(left, right); }); };
    const std::string text = "the padding must be that of robot 'left', which is of the same mechanism: 0.01";
    EXPECT_NE(complaint(", padding: 0.01", ", padding: 0.02").find("robots[1].padding: " + text), std::string::npos);
    EXPECT_NE(complaint(", padding: 0.01", "").find("robots[1]: " + text), std::string::npos);
    EXPECT_NE(complaint(", link_padding: {torso: 0.01}", ", link_padding: {torso: 0.02}")
                  .find("robots[1].link_padding.torso: must be 0.01, as for another robot of the mechanism"),
              std::string::npos);
}

/** Two spheres of one mechanism, 0.15 apart: each keeps 0.1 from others, but not from the other one. */
TEST(YamlPadding, IsNotBetweenPartsOfAMechanism)
{
    const Folder folder;
    const auto side = [](const std::string &name, const std::string &child, const std::string &place)
    { return joint(name, "revolute", "base", child, "<origin xyz='" + place + "'/><axis xyz='0 0 1'/>" + LIMIT); };
    folder.write("t.urdf", robot(link("base", std::string()) + link("a") + link("b") + side("left", "a", "0 0.175 0") +
                                 side("right", "b", "0 -0.175 0")));
    folder.write("t.srdf", robot("<group name='l'><joint name='left'/></group>"
                                 "<group name='r'><joint name='right'/></group>"));
    const auto complaint = [&](const std::string &secondBase)
    {
        const std::string arm = "  - {type: urdf, file: t.urdf, srdf: t.srdf, padding: 0.1, start: [0], goal: [0], ";
        const Scene scene = sceneFromYaml("environment: {min: [-1, -1, -1], max: [1, 1, 1]}\nrobots:\n" + arm +
                                              "group: l}\n" + arm + "group: r" + secondBase + "}\n",
                                          folder / "scene.yaml");
        return messageOf([&] { scene.validate(); });
    };
    EXPECT_EQ(complaint(""), "");
    EXPECT_NE(complaint(", base: {position: [0, 0, 0.01]}").find("with their padding of 0.2"), std::string::npos);
}

/** A distance that robots keep from what keeps one, too, would have two meanings. */
TEST(YamlPadding, IsNotOfObstacles)
{
    const Body box = Body::box(0.1, 0.1, 0.1);
    Scene scene = sceneWithArm("");
    EXPECT_NO_THROW(scene.addObstacle({box}));
    EXPECT_NE(messageOf([&] { scene.addObstacle({box.padded(0.1)}, "box"); }).find("box: has a padding"),
              std::string::npos);
    const ArmFile file(ARMS + "arm6.urdf", ARMS + "arm6.srdf");
    ArmFile::ArmSettings settings;
    settings.touchable.push_back({"box", box, Pose(Eigen::Translation3d(0.0, 0.0, 9.0)), {}});
    EXPECT_NO_THROW(file.makeArm("arm", "arm", settings));
    settings.touchable.front().body = box.padded(0.1);
    EXPECT_NE(messageOf([&] { file.makeArm("arm", "arm", settings); }).find("obstacle 'box': has a padding"),
              std::string::npos);
}

TEST(YamlPadding, IsToldInMessages)
{
    const auto messageOf = [](const std::string &robots)
    { return test::messageOf([&] { sceneOfPadded(robots).validate(); }); };
    const std::string robot = "  - {type: rigid, space: R2, shape: {type: disc, radius: 0.5}, padding: ";
    EXPECT_EQ(
        messageOf(robot + "0.25, start: [3.3, 5], goal: [1, 9]}\n"),
        "padding: robots[0].start [3.3, 5] of 'robot_0' touches environment.obstacles[0], with its padding of 0.25");
    EXPECT_EQ(messageOf(robot + "0.2, start: [3.3, 5], goal: [1, 9]}\n"), "");
    EXPECT_NE(
        messageOf(robot + "0.25, start: [1, 1], goal: [1, 9]}\n" + robot + "0.5, start: [1, 2.7], goal: [3, 9]}\n")
            .find("with their padding of 0.75"),
        std::string::npos);
    EXPECT_NE(messageOf(robot + "-1, start: [1, 1], goal: [1, 9]}\n").find("robots[0].padding: must not be negative"),
              std::string::npos);
}
