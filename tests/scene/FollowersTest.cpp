#include "ompl_certificates/scene/ArmFile.h"
#include "ompl_certificates/scene/SceneFile.h"
#include "support/ArmTexts.h"
#include "support/Folder.h"
#include "support/Message.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <ompl/base/ScopedState.h>

namespace ompl_certificates
{
    using namespace test;

    TEST(Followers, ReadsMimicsTurnsAndTheOrderOfJoints)
    {
        const test::Folder folder;
        const std::string up = "<origin xyz='0 0 0.3'/><axis xyz='0 1 0'/>";
        const ArmFile file(folder.write(
            "a.urdf",
            robot(
                link("base") + link("a") + link("b") + link("c") + link("d") +
                joint("j", "revolute", "base", "a", up + LIMIT) +
                joint("k", "revolute", "a", "b", up + LIMIT + "<mimic joint='j' multiplier='2' offset='0.1'/>") +
                joint("l", "fixed", "b", "c", "<origin xyz='0 0 0.3'/><mimic joint='gone'/>") +
                joint("m", "continuous", "c", "d", "<origin rpy='1 2 3'/><dynamics damping='x'/><safety_controller/>") +
                link("e") + link("f") + joint("n", "continuous", "e", "f") + joint("o", "continuous", "a", "e"))));
        EXPECT_EQ(file.getJoints(""), (std::vector<std::string>{"j", "m", "o", "n"})) << "depth first, as MoveIt";
        const auto arm = file.makeArm("arm", "", {});
        arm->getStateSpace()->setup();
        ompl::base::ScopedState<> state(arm->getStateSpace());
        state = std::vector<double>{0.5, 0.0, 0.0, 0.0};
        const auto reach = [](double angle)
        { return Eigen::Vector3d(0.3 * std::sin(angle), 0, 0.3 * std::cos(angle)); };
        const Pose pose = arm->getLinkPose(state.get(), "d");
        EXPECT_LT((pose.translation() - (Eigen::Vector3d(0, 0, 0.3) + reach(0.5) + reach(1.6))).norm(), 1e-12);
        const auto about = [](double angle, const Eigen::Vector3d &axis) { return Eigen::AngleAxisd(angle, axis); };
        using Axis = Eigen::Vector3d;
        const Eigen::Matrix3d turn =
            (about(1.6, Axis::UnitY()) * about(3, Axis::UnitZ()) * about(2, Axis::UnitY()) * about(1, Axis::UnitX()))
                .toRotationMatrix();
        EXPECT_TRUE(pose.linear().isApprox(turn, 1e-9)) << pose.linear();
    }

    TEST(Followers, FollowsWhomTheFollowedOneFollowsAndNobodyWhoIsNotThere)
    {
        const test::Folder folder;
        const std::string about = "<axis xyz='0 0 1'/>" + LIMIT;
        const ArmFile file(folder.write(
            "a.urdf",
            robot(
                "<xacro:sensor name='eye'><xacro:pose/></xacro:sensor><gazebo><plugin name='${later}'/></gazebo>" +
                link("base") + link("a") + link("b") + link("c") + link("d") + link("e") +
                joint("last", "revolute", "base", "a", about + "<mimic joint='middle' multiplier='2' offset='0.1'/>") +
                joint("middle", "revolute", "base", "b",
                      about + "<mimic joint='first' multiplier='-1' offset='0.3'/>") +
                joint("first", "revolute", "base", "c", about) +
                joint("alone", "revolute", "base", "d", about + "<mimic joint='gone'/>") +
                joint("after", "revolute", "d", "e", about + "<mimic joint='alone' multiplier='-2'/>") + link("f") +
                link("g") + joint("still", "fixed", "base", "f") +
                joint("free", "revolute", "base", "g", about + "<mimic joint='still'/>"))));
        EXPECT_EQ(file.getJoints(""), (std::vector<std::string>{"alone", "first", "free"}));
        std::vector<std::string> notes;
        const auto arm = file.makeArm("arm", "", {}, &notes);
        const auto hasNote = [&](const std::string &text)
        {
            return std::any_of(notes.begin(), notes.end(),
                               [&](const std::string &note) { return note.find(text) != std::string::npos; });
        };
        EXPECT_TRUE(hasNote("joint 'alone' mimics joint 'gone', but there is none: it moves by itself"));
        EXPECT_TRUE(hasNote("joint 'free' mimics joint 'still', which is fixed: it moves by itself"));
        EXPECT_TRUE(hasNote("<xacro:sensor>: is left over from a xacro file, and ignored"));
        arm->getStateSpace()->setup();
        ompl::base::ScopedState<> state(arm->getStateSpace());
        state = std::vector<double>{0.4, 0.2, 0.7};
        const auto angleOf = [&](const std::string &link)
        {
            const Eigen::Matrix3d turn = arm->getLinkPose(state.get(), link).linear();
            return std::atan2(turn(1, 0), turn(0, 0));
        };
        EXPECT_NEAR(angleOf("b"), 0.1, 1e-12);
        EXPECT_NEAR(angleOf("a"), 0.3, 1e-12);
        EXPECT_NEAR(angleOf("d"), 0.4, 1e-12);
        EXPECT_NEAR(angleOf("g"), 0.7, 1e-12);
        EXPECT_NEAR(angleOf("e"), 0.4 - 2.0 * 0.4, 1e-12);  // on top of d
    }

    TEST(Followers, FollowsHalfOfAnAngleThatStandsStill)
    {
        const test::Folder folder;
        folder.write("a.urdf", robot(link("base") + link("wheel") + link("half") + link("arm") +
                                     joint("turn", "continuous", "base", "wheel", "<origin xyz='1 0 0'/>") +
                                     joint("follow", "continuous", "base", "half",
                                           "<origin xyz='2 0 0'/><mimic joint='turn' multiplier='0.5'/>") +
                                     joint("lift", "revolute", "base", "arm", "<origin xyz='0 1 0'/>" + LIMIT)));
        folder.write("a.srdf",
                     "<robot name='test'><group name='arm'><joint name='lift'/></group>"
                     "<group name='wheel'><joint name='turn'/></group></robot>");
        const auto read = [&](const std::string &keys)
        {
            return sceneFromYaml(
                "environment: {min: [-3, -3, -3], max: [3, 3, 3]}\nrobots: [{type: urdf, file: a.urdf, "
                "srdf: a.srdf, start: [0], goal: [1], " +
                    keys + "}]",
                folder.path() + "/a.yaml");
        };
        // Brought into [-pi, pi) first, it would be another half.
        const Scene scene = read("group: arm, joints: {turn: 4}");
        const auto &arm = dynamic_cast<const Arm &>(*scene.getMembers().front().robot);
        arm.getStateSpace()->setup();
        ompl::base::ScopedState<> state(arm.getStateSpace());
        state = std::vector<double>{0.0};
        const Eigen::Matrix3d turn = Eigen::AngleAxisd(2.0, Eigen::Vector3d::UnitX()).toRotationMatrix();
        EXPECT_TRUE(arm.getLinkPose(state.get(), "half").linear().isApprox(turn, 1e-12));
        folder.write("b.urdf",
                     robot(link("base") + link("wheel") + link("screw") + joint("turn", "continuous", "base", "wheel") +
                           joint("rise", "prismatic", "base", "screw", LIMIT + "<mimic joint='turn'/>")));
        EXPECT_NE(messageOf([&] { ArmFile(folder.path() + "/b.urdf").makeArm("arm", "", {}); })
                      .find("joint 'rise': mimics the continuous joint 'turn', so it must turn, but it is prismatic"),
                  std::string::npos);
        const std::string message = messageOf([&] { read("group: wheel"); });
        EXPECT_NE(message.find("joint 'follow': mimics the continuous joint 'turn', so it must turn, by a "
                               "whole multiple and not by 0.5"),
                  std::string::npos)
            << message;
    }

    TEST(Followers, TellsOfValuesThatDoNotCount)
    {
        const test::Folder folder;
        const ArmFile file(
            folder.write("a.urdf", robot(link("base") + link("a") + link("b") + link("c") +
                                         joint("arm", "revolute", "base", "a", LIMIT) +
                                         joint("left", "revolute", "a", "b", LIMIT) +
                                         joint("right", "revolute", "a", "c",
                                               LIMIT + "<mimic joint='left' multiplier='2' offset='0.1'/>"))),
            folder.write("a.srdf",
                         "<robot name='r'><group name='arm'><joint name='arm'/></group><group name='both'>"
                         "<joint name='arm'/><joint name='left'/></group></robot>"));
        const auto notesOf = [&](const std::string &group, const std::map<std::string, double> &values)
        {
            ArmFile::ArmSettings settings;
            settings.jointValues = values;
            std::vector<std::string> notes;
            file.makeArm("arm", group, settings, &notes);
            // Others are of the file.
            const auto isOther = [](const std::string &note) { return note.rfind("joint '", 0) != 0; };
            notes.erase(std::remove_if(notes.begin(), notes.end(), isOther), notes.end());
            return notes;
        };
        const std::vector<std::string> told{
            "joint 'right' follows joint 'left', whose value counts in place of 0.600000"};
        EXPECT_EQ(notesOf("arm", {{"right", 0.6}}), told);
        EXPECT_EQ(notesOf("arm", {{"left", 0.2}, {"right", 0.6}}), told);
        EXPECT_EQ(notesOf("arm", {{"left", 0.25}, {"right", 0.6}}), std::vector<std::string>());
        EXPECT_EQ(notesOf("both", {{"right", 0.6}}),
                  std::vector<std::string>{
                      "joint 'right' follows joint 'left', which moves: the value 0.600000 does not count"});
        // Whoever writes millimeters is told.
        EXPECT_EQ(notesOf("arm", {{"left", 35.0}}),
                  std::vector<std::string>{"joint 'left' is at 35.000000, beyond its limits -1.000000 and 2.000000"});
    }
}
