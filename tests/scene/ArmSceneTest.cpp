#include "ompl_certificates/robots/Arm.h"
#include "ompl_certificates/robots/LinkPoseGoal.h"
#include "ompl_certificates/scene/ArmFile.h"
#include "ompl_certificates/scene/SceneFile.h"
#include "support/ArmFiles.h"
#include "support/ArmScenes.h"
#include "support/ArmTexts.h"
#include "support/FclVerdicts.h"
#include "support/Folder.h"
#include "support/Message.h"

#include <algorithm>
#include <filesystem>
#include <gtest/gtest.h>
#include <iostream>
#include <ompl/base/SpaceInformation.h>
#include <ompl/util/Exception.h>
#include <set>

namespace ompl_certificates
{
    using namespace test;

    namespace
    {

        /** Where the tip of a finger is at the start */
        Eigen::Vector3d fingerOf(const Scene &scene)
        {
            const auto team = scene.makeTeam();
            return armOf(scene)
                ->getLinkPose(scene.makeStart(team)->as<ompl::base::CompoundState>()->components[0], "left_finger")
                .translation();
        }
    }

    TEST(ArmScene, ReadsStatesByNameListAndMap)
    {
        const Scene scene = sceneWithArm("", "start: ready, goal: [0.1, 0.2, 0.3, 0.4, 0.5, 7]");
        EXPECT_EQ(scene.getMembers()[0].start, (std::vector<double>{0.0, -0.6, 1.9, 0.0, 0.3, 0.0}));
        EXPECT_NEAR(scene.getMembers()[0].goal[5], 7.0 - 2.0 * M_PI, 1e-12) << "a continuous joint";
        const Scene other = sceneWithArm("",
                                         "start: upright, goal: {flange: 1, waist: 2, elbow: 0.5, wrist_roll: 0, "
                                         "wrist_bend: -0.5, shoulder_lift: 0.2}");
        EXPECT_EQ(other.getMembers()[0].goal, (std::vector<double>{2.0, 0.2, 0.5, 0.0, -0.5, 1.0}));
    }

    TEST(ArmScene, ReadsBaseJointsAndAttachedBodies)
    {
        const Eigen::Vector3d closed = fingerOf(sceneWithArm(""));
        const auto open = fingerOf(sceneWithArm("states: {gripper: open}"));
        EXPECT_NEAR((open - closed).norm(), 0.035, 1e-12);
        EXPECT_NEAR((fingerOf(sceneWithArm("joints: {finger: 0.02}")) - closed).norm(), 0.02, 1e-12);
        EXPECT_NEAR((fingerOf(sceneWithArm("states: {gripper: open}, joints: {finger: 0.02}")) - closed).norm(), 0.02,
                    1e-12);
        const Eigen::Vector3d turned = fingerOf(
            sceneWithArm("base: {position: [1, 2, 3], rotation: {axis: [0, 0, 1], angle: 1.5707963267948966}}"));
        EXPECT_TRUE(turned.isApprox(Eigen::Vector3d(1 - closed.y(), 2 + closed.x(), 3 + closed.z()), 1e-9));
        const Scene carrying = sceneWithArm(
            "attached: [{name: bar, link: palm, shape: {type: sphere, radius: 0.05}, "
            "position: [0, 0, 0.2], touch_links: [left_finger, right_finger]}]");
        EXPECT_EQ(armOf(carrying)->getBodies().size(), armOf(sceneWithArm(""))->getBodies().size() + 1);
        const auto team = carrying.makeTeam();
        const auto start = carrying.makeStart(team);
        const auto poseOf = [&](const std::string &link)
        { return armOf(carrying)->getLinkPose(start->as<ompl::base::CompoundState>()->components[0], link); };
        EXPECT_TRUE(poseOf("bar").isApprox(poseOf("palm") * poseAt({0, 0, 0.2}), 1e-9));
    }

    TEST(ArmScene, NotesTellWhatMaySurprise)
    {
        const auto notesOf = [](const std::string &keys)
        {
            const Scene scene = sceneWithArm(keys);
            std::string text;
            for (const std::string &note : scene.getNotes())
                text += note + '\n';
            return text;
        };
        EXPECT_NE(notesOf("base: {rotation: {axis: [0, 0, 1], angle: 90}}")
                      .find("robots[0].base.rotation.angle: an angle is more than a whole turn; angles are in radians"),
                  std::string::npos);
        EXPECT_EQ(notesOf("base: {rotation: {axis: [0, 0, 1], angle: 90}}").find("angle is more"),
                  notesOf("base: {rotation: {axis: [0, 0, 1], angle: 90}}").rfind("angle is more"))
            << "once";
        EXPECT_EQ(notesOf("base: {rotation: {axis: [0, 0, 1], angle: 6.2}}").find("angle"), std::string::npos);
        const test::Folder folder;
        folder.write("a.urdf",
                     test::robot(test::link("base") + test::link("tip") + test::link("finger") +
                                 test::joint("turn", "revolute", "base", "tip", "<axis xyz='0 0 1'/>" + test::LIMIT) +
                                 test::joint("grip", "fixed", "tip", "finger", "")));
        folder.write("a.srdf", test::robot("<group name='arm'><joint name='turn'/></group>"
                                           "<group name='hand'><joint name='grip'/></group>"
                                           "<group_state name='shut' group='hand'><joint name='grip' value='0.1'/>"
                                           "</group_state>"));
        const Scene scene = sceneFromYaml(
            "environment: {min: [-1, -2, 0], max: [1, 2, 3]}\nrobots:\n  - {type: urdf, "
            "file: a.urdf, srdf: a.srdf, group: arm, states: {hand: shut}, start: [0], "
            "goal: [1]}\n",
            folder / "scene.yaml");
        const auto &notes = scene.getNotes();
        EXPECT_NE(std::find(notes.begin(), notes.end(),
                            "robots[0].states.hand: the value of joint 'grip' has no effect: the URDF file fixes it"),
                  notes.end());
    }

    TEST(ArmScene, OneFileServesWithAndWithoutGroups)
    {
        const std::string arm = "  - {type: urdf, file: arm6.urdf, ",
                          ready = "group: arm, start: ready, goal: ready}\n";
        const Scene scene =
            sceneFromYaml("environment: {min: [-1, -1, 0], max: [1, 1, 2]}\nrobots:\n" + arm + "srdf: arm6.srdf, " +
                              ready + arm + "start: [0, 0, 0, 0, 0, 0, 0], goal: [0, 0, 0, 0, 0, 0, 0]}\n",
                          ARMS + "test.yaml");
        EXPECT_EQ(scene.getMembers()[0].start.size(), 6u);
        EXPECT_EQ(scene.getMembers()[1].start.size(), 7u);
    }

    TEST(ArmScene, MovesBasesWithinItsBoundsAndFindsPackages)
    {
        const test::Folder folder;
        folder.write("mesh.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        folder.write("a.urdf", test::robot(test::link("base",
                                                      "<collision><geometry><mesh filename='package://far/mesh.obj'/>"
                                                      "</geometry></collision>")));
        for (const std::string type : {"planar", "floating"})
            folder.write(type + ".srdf", test::robot("<virtual_joint name='v' type='" + type +
                                                     "' parent_frame='floor' child_link='base'/>"
                                                     "<group name='all'><joint name='v'/></group>"));
        const auto read = [&](const std::string &type, const std::string &state, const std::string &keys = "")
        {
            return sceneFromYaml(
                "environment: {min: [-1, -2, 0], max: [1, 2, 3]}\nrobots:\n  - {type: urdf, file: "
                "a.urdf, packages: {far: .}, group: all, srdf: " +
                    type + ".srdf, start: " + state + ", goal: " + state + keys + "}\n",
                folder / "scene.yaml");
        };
        const Scene planar = read("planar", "[1, 2, 7]");
        EXPECT_NEAR(planar.getMembers()[0].start[2], 7.0 - 2.0 * M_PI, 1e-12);
        EXPECT_NO_THROW(planar.validate());
        EXPECT_THROW(read("planar", "[1, 2.1, 0]").validate(), ompl::Exception);
        EXPECT_EQ(read("floating", "[0, 0, 3, 0, 0, 0, 2]").getMembers()[0].start,
                  (std::vector<double>{0, 0, 3, 0, 0, 0, 1}));
        // A position in the plane has two bounds.
        const std::string flat = ", bounds: {min: [-3, -3], max: [3, 3]}";
        EXPECT_NO_THROW(read("planar", "[2, 2.1, 0]", flat).validate());
        EXPECT_THROW(read("planar", "[2, 3.1, 0]", flat).validate(), ompl::Exception);
        EXPECT_NE(messageOf([&] { read("floating", "[0, 0, 3, 0, 0, 0, 2]", flat); }).find("3 dimensions"),
                  std::string::npos);
    }

    TEST(ArmScene, NamesWhatIsWrong)
    {
        const std::string states = "start: ready, goal: ";
        const std::vector<std::array<std::string, 4>> cases{
            {"", states + "nowhere", "robots[0].goal", "'nowhere'"},
            {"", states + "[0, 0, 0]", "robots[0].goal", "6 numbers"},
            {"", states + "[0, 9, 0, 0, 0, 0]", "robots[0].goal[1]", "'shoulder_lift'"},
            {"", states + "{waist: 0}", "robots[0].goal", "no value of joint"},
            {"", states + "{waist: 0, knee: 0}", "robots[0].goal", "'knee'"},
            {"joints: {waist: 0}", states + "ready", "robots[0].joints.waist", "'waist'"},
            {"joints: {finger: 1}", states + "ready", "robots[0].joints.finger", "'finger'"},
            {"joints: {other_finger: 0}", states + "ready", "robots[0].joints.other_finger", "follows"},
            {"joints: {none: 1}", states + "ready", "robots[0].joints", "'none'"},
            {"joints: {finger: 0.03500000000000001}", states + "ready", "robots[0].joints.finger",
             "must be from 0 to 0.035, not 0.03500000000000001"},
            {"states: {gripper: shut}", states + "ready", "robots[0].states.gripper", "'shut'"},
            {"states: {griper: open}", states + "ready", "robots[0].states.griper",
             "there is no group 'griper'; there are 'arm', 'gripper'; did you mean gripper?"},
            {"bsae: {}", states + "ready", "robots[0].bsae: unknown key", "; did you mean base?"},
            {"joints: {fingr: 1}", states + "ready",
             "robots[0].joints: there is no joint 'fingr'; did you mean finger?", ""},
            {"", states + "{link: hnad, position: [0, 0, 1]}", "robots[0].goal", "; did you mean hand?"},
            {"base: {position: [0, 0]}", states + "ready", "robots[0].base.position", "3 numbers"},
            {"base: {center: [0, 0, 0]}", states + "ready", "robots[0].base.center", "unknown key"},
            {"shape: {}", states + "ready", "robots[0].shape", "unknown key"},
            {"attached: [{name: a, link: b, shape: {type: sphere, radius: 1}}]", states + "ready", "robots[0]", "'b'"},
            {"may_touch_obstacles: [none]", states + "ready", "robots[0]", "'none'"},
            {"padding: -1", states + "ready", "robots[0].padding", "must not be negative, not -1"},
            {"link_padding: {palm: -1}", states + "ready", "robots[0].link_padding.palm", "must not be negative"},
            {"link_padding: {plam: 1}", states + "ready", "robots[0].link_padding.plam", "there is no link 'plam'"},
            {"visuals: maybe", states + "ready", "robots[0].visuals", "maybe"},
            {"", states + "{link: leg, position: [0, 0, 1]}", "robots[0].goal", "'leg': there is no such link"},
            {"", states + "{position: [0, 0, 1]}", "robots[0].goal.link", "missing"},
            {"", states + "{link: leg, position: [0, 0, 1]}", "robots[0].goal", "it moves 'shoulder', 'upper_arm'"},
            {"", states + "{link: base, position: [0, 0, 1]}", "robots[0].goal", "does not move this link"},
            {"", states + "{link: hand}", "robots[0].goal", "must have a position, a rotation or both"},
            {"", states + "{link: hand, position: [0, 1]}", "robots[0].goal.position", "3 numbers"},
            {"", states + "{link: hand, position: [0, 0, 1], angle: 1}", "robots[0].goal.angle", "unknown key"},
            {"", states + "{link: hand, position: [0, 0, 1], position_tolerance: 0}",
             "robots[0].goal.position_tolerance", "must be positive, not 0"},
            {"", states + "{link: hand, position: [0, 0, 1], position_tolerance: [1, 1]}",
             "robots[0].goal.position_tolerance", "3 numbers"},
            {"", states + "{link: hand, position: [0, 0, 1], rotation_tolerance: 1}",
             "robots[0].goal.rotation_tolerance", "needs a rotation or a quaternion"},
            {"", states + "{link: hand, quaternion: [0, 0, 0, 1], point: [0, 0, 0]}", "robots[0].goal.point",
             "needs a position"},
        };
        for (const auto &[keys, end, place, part] : cases)
        {
            const std::string message = messageAboutArm(keys, end);
            EXPECT_NE(message.find("test.yaml:3: " + place), std::string::npos) << message << " " << place;
            EXPECT_NE(message.find(part), std::string::npos) << message << " " << part;
        }
        const auto failure =
            [](const std::string &robot, const std::string &bounds = "min: [-1, -1, 0], max: [1, 1, 2]")
        {
            try
            {
                sceneFromYaml("environment: {" + bounds + "}\nrobots:\n  - {type: urdf, " + robot + "}\n",
                              ARMS + "test.yaml");
            }
            catch (const ompl::Exception &exception)
            {
                return std::string(exception.what());
            }
            return std::string();
        };
        EXPECT_NE(failure("file: none.urdf, start: [], goal: []").find("robots[0].file: "), std::string::npos);
        EXPECT_NE(failure("file: arm6.urdf, srdf: none.srdf, start: [], goal: []").find("robots[0].srdf: "),
                  std::string::npos);
        EXPECT_NE(failure("file: arm6.urdf, srdf: arm6.srdf, group: leg, start: [], goal: []").find("'leg'"),
                  std::string::npos);
        EXPECT_NE(failure("file: arm6.urdf, start: [], goal: []", "min: [0, 0], max: [1, 1]").find("2 dimensions"),
                  std::string::npos);
    }

    TEST(ArmScene, GoalsCanBePosesOfLinks)
    {
        const std::string position = "start: ready, goal: {link: tool_center, position: [0.4, 0.1, 0.6]";
        const Scene scene = sceneWithArm("", position +
                                                 ", position_tolerance: [0.01, 0.02, 0.03], quaternion: [0, 1, 0, 0], "
                                                 "rotation_tolerance: [0.1, 0.2, 4]}");
        EXPECT_TRUE(scene.hasRegions());
        EXPECT_NO_THROW(scene.validate());
        const auto &region = dynamic_cast<const LinkPoseGoal &>(*scene.getMembers().front().region);
        const LinkPose &pose = region.getLinkPose();
        EXPECT_EQ(pose.link, "tool_center");
        EXPECT_EQ(pose.position->point, Eigen::Vector3d(0.4, 0.1, 0.6));
        EXPECT_EQ(pose.position->tolerance, Eigen::Vector3d(0.01, 0.02, 0.03));
        EXPECT_EQ(pose.rotation->tolerance, Eigen::Vector3d(0.1, 0.2, 4.0));
        EXPECT_TRUE(pose.rotation->rotation.isApprox(Eigen::Vector3d(-1, 1, -1).asDiagonal().toDenseMatrix()));
        const auto team = scene.makeTeam();
        const auto goal = scene.makeGoal(team);
        EXPECT_EQ(region.distance(goal->as<ompl::base::CompoundState>()->components[0]), 0.0);
        EXPECT_EQ(scene.getMembers().front().goal,
                  sceneWithArm("", position + ", position_tolerance: [0.01, 0.02, 0.03], quaternion: [0, 1, 0, 0], "
                                              "rotation_tolerance: [0.1, 0.2, 4]}")
                      .getMembers()
                      .front()
                      .goal)
            << "a file has one goal";

        const auto setup = scene.makeSetup();
        ASSERT_EQ(setup->solve(10.0), ompl::base::PlannerStatus::EXACT_SOLUTION);
        const auto *last = setup->getSolutionPath().getStates().back();
        EXPECT_EQ(region.distance(last->as<ompl::base::CompoundState>()->components[0]), 0.0);
        const Scene ended = scene.endingAt(last);
        EXPECT_FALSE(ended.hasRegions());
        EXPECT_TRUE(team->equalStates(ended.makeGoal(team).get(), last));

        // The goal that is chosen is a free one, though many with this position touch the wall.
        const auto sceneWithBox = [&](const std::string &center, const std::string &size)
        {
            return sceneFromYaml("environment: {min: [-1, -1, 0], max: [1, 1, 2], obstacles: [{type: box, center: " +
                                     center + ", size: " + size +
                                     "}]}\nrobots:\n  - {type: urdf, file: arm6.urdf, srdf: "
                                     "arm6.srdf, group: arm, " +
                                     position + "}}\n",
                                 ARMS + "test.yaml");
        };
        const Scene walled = sceneWithBox("[0.4, 0.25, 0.6]", "[0.6, 0.1, 1]");
        EXPECT_NO_THROW(walled.validate());
        const TeamValidityChecker checker(std::make_shared<ompl::base::SpaceInformation>(walled.makeTeam()),
                                          walled.makeObstacles());
        ompl::RNG random(1);
        int valid = 0;
        ompl::base::ScopedState<> state(walled.getMembers().front().robot->getStateSpace());
        for (int i = 0; i < 100; ++i)
            if (walled.getMembers().front().region->sample(random, state.get()))
                valid += checker.isRobotFree(0, state.get()) ? 1 : 0;
        EXPECT_LT(valid, 80);
        EXPECT_GT(valid, 0);
        const std::string far = messageAboutArm("", "start: ready, goal: {link: hand, position: [5, 0, 0]}");
        EXPECT_EQ(far.substr(far.find("test.yaml")),
                  "test.yaml:3: robots[0].goal: no state of 'robot_0' was found that reaches link 'hand' at [5, 0, 0]");
        const std::string buried = messageOf([&] { sceneWithBox("[0.4, 0.1, 0.6]", "[0.1, 0.1, 0.1]").validate(); });
        EXPECT_NE(buried.find("robots[0].goal, where no free state was found: ["), std::string::npos) << buried;
    }

    TEST(ArmScene, StatesOfOtherGroupsKeepTheLimits)
    {
        const Folder folder;
        folder.write("a.urdf", chain());
        folder.write("a.srdf",
                     "<robot name='test'><group name='arm'><joint name='second'/></group><group name='lift'><joint "
                     "name='first'/></group><group_state name='high' group='lift'><joint name='first' "
                     "value='2.5'/></group_state></robot>");
        const std::string scene =
            "environment: {min: [-1, -1, -1], max: [1, 1, 1]}\nrobots:\n  - {type: urdf, file: a.urdf, "
            "srdf: a.srdf, group: arm, states: {lift: high}, start: [0], goal: [1]}\n";
        const std::string message = test::messageOf([&] { sceneFromYaml(scene, folder / "scene.yaml"); });
        EXPECT_NE(message.find("robots[0].states.lift"), std::string::npos) << message;
        EXPECT_NE(message.find("'first'"), std::string::npos) << message;
    }

    TEST(ArmScene, FilesMayHaveLongPaths)
    {
        const Folder folder;
        const std::string deep(120, 'd');
        std::filesystem::create_directory(folder / deep);
        folder.write(deep + "/a.urdf", chain());
        const Scene scene =
            sceneFromYaml("environment: {min: [-1, -1, -1], max: [1, 1, 1]}\nrobots:\n  - {type: urdf, file: " + deep +
                              "/a.urdf, start: [0, 0], goal: [1, 1]}\n",
                          folder / "scene.yaml");
        EXPECT_EQ(armOf(scene)->getBodies().size(), 3u);
    }

    TEST(ArmScene, StatesInCollisionWithItselfAreRefused)
    {
        const Scene scene = sceneWithArm("", "start: ready, goal: [0, 1.9, 2.5, 0, 1.8, 0]");
        try
        {
            scene.validate();
            FAIL() << "the arm's hand is in its base";
        }
        catch (const ompl::Exception &exception)
        {
            EXPECT_NE(std::string(exception.what()).find("goal [0, 1.9, 2.5, 0, 1.8, 0] of 'robot_0' touches itself"),
                      std::string::npos)
                << exception.what();
        }
    }

    TEST(ArmScene, TwoArmsOfOneRobotAreOneRobot)
    {
        const Scene scene = loadScene(ARMS + "twin.yaml");
        EXPECT_NO_THROW(scene.validate());
        const auto arm = armOf(scene);
        EXPECT_EQ(arm->getGroup().size(), 6u);
        // The arms are checked against each other, but not in the pair that the SRDF file leaves out.
        std::set<std::pair<std::string, std::string>> pairs;
        for (const BodyPair &pair : arm->getBodyPairs())
            pairs.emplace(arm->getLinkOfBody(pair.first), arm->getLinkOfBody(pair.second));
        EXPECT_EQ(pairs.size(), 14u);
        EXPECT_EQ(pairs.count({"left_forearm", "right_forearm"}), 1u);
        EXPECT_EQ(pairs.count({"left_shoulder", "right_shoulder"}), 0u);
        EXPECT_EQ(pairs.count({"torso", "right_shoulder"}), 0u);

        const std::string robot = "  - {type: urdf, file: twin.urdf, srdf: twin.srdf, start: ahead, goal: ahead, ";
        try
        {
            sceneFromYaml("environment: {min: [-1, -1, 0], max: [1, 1, 2]}\nrobots:\n" + robot +
                              "group: left, joints: {right_lift: -1}}\n" + robot +
                              "group: right, packages: {none: .}}\n",
                          ARMS + "test.yaml")
                .validate();
            FAIL() << "what is read in two ways are two mechanisms, and both have the torso";
        }
        catch (const ompl::Exception &exception)
        {
            EXPECT_NE(std::string(exception.what()).find("both have link 'torso' there; to be parts"), std::string::npos)
                << exception.what();
        }
    }

    TEST(ArmScene, VerdictsAreThoseOfFcl)
    {
        ompl::RNG::setSeed(6);
        test::expectFclsVerdicts(loadScene(ARMS + "shelf.yaml"), 3000);
        test::expectFclsVerdicts(loadScene(ARMS + "two_arms.yaml"), 3000);
        test::expectFclsVerdicts(loadScene(ARMS + "twin.yaml"), 3000);
    }

    TEST(ArmScene, VerdictsOfMeshesAreThoseOfFcl)
    {
        const auto expectVerdicts = [](const std::string &robot, const std::string &keys)
        {
            test::expectFclsVerdicts(
                sceneFromYaml("environment:\n  min: [-1, -1, 0]\n  max: [1, 1, 2]\n  obstacles:\n"
                              "    - {type: box, center: [0.5, 0, 0.4], size: [0.4, 1, 0.02]}\n"
                              "    - {type: box, center: [0.5, 0.5, 0.6], size: [0.4, 0.02, 0.6]}\n"
                              "    - {type: cylinder, center: [-0.4, 0.4, 0.5], radius: 0.1, length: 1}\n"
                              "robots:\n  - {type: urdf, file: " +
                                  robot + ".urdf, srdf: " + robot + ".srdf, " + keys + "}\n",
                              ROBOTS + robot + "/test.yaml"),
                2000);
        };
        if (!std::filesystem::exists(ROBOTS + "panda/panda.urdf") || !std::filesystem::exists(ROBOTS + "ur5/ur5.urdf"))
            GTEST_SKIP() << ROBOTS + "panda or ur5 is not there";
        ompl::RNG::setSeed(7);
        expectVerdicts("panda", "group: panda_arm, start: ready, goal: extended");
        expectVerdicts("ur5", "group: manipulator, start: home, goal: home");
    }
}
