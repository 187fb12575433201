// Where MoveIt's frames are, and the robot's root in them.

#include "support/MoveItScene.h"

#include <gtest/gtest.h>
#include <memory>
#include <ompl/base/ScopedState.h>
#include <string>
#include <vector>

namespace ompl_certificates
{
    namespace
    {
        using namespace test;

        TEST_F(MoveItScene, TheVirtualJointSaysWhereTheRootCanBe)
        {
            const auto at = [](const std::string &joint, const std::string &position, const std::string &rotation)
            {
                return BALL + "robot_state: {multi_dof_joint_state: {joint_names: [" + joint +
                       "], transforms: [{translation: " + position + ", rotation: " + rotation + "}]}}\n";
            };
            const auto setJoint = [&](const std::string &type)
            {
                std::string srdf = TWO_LINKS_SRDF;
                srdf.replace(srdf.find("floating"), 8, type);
                robot_ = std::make_unique<const ArmFile>(folder_.path() + "/arm.urdf", folder_.write("arm.srdf", srdf));
            };
            const auto rootIn = [&](const SceneFile &file)
            {
                ompl::base::ScopedState<> state(armOf(file).getStateSpace());
                state = std::vector<double>{0.0, 0.0};
                return armOf(file).getLinkPose(state.get(), "base");
            };
            const auto rootOf = [&](const std::string &scene) { return rootIn(read(scene)); };
            const std::string none = "[0, 0, 0, 1]", name = "scene.yaml:4: robot_state.multi_dof_joint_state.";
            EXPECT_EQ(
                messageOf(at("odometry", "[1, 0, 0]", none)),
                name + "joint_names[0]: there is no joint 'odometry'; the SRDF file's virtual joint is 'world_joint'");
            EXPECT_EQ(messageOf(at("odometry", "[0, 0, 0]", none)), "") << "which changes nothing";

            const SceneFile kept =
                read(at("world_joint", "[1, 0, 0]", none),
                     "group_name: arm\nstart_state: {joint_state: {name: [turn, bend], position: "
                     "[0, 0]}, multi_dof_joint_state: {joint_names: [odometry], transforms: [{}]}}\n" +
                         GOAL);
            EXPECT_EQ(rootIn(kept).translation().x(), 1.0) << "the start tells of another joint";

            setJoint("fixed");
            EXPECT_EQ(messageOf(at("world_joint", "[0, 0, 0]", none)), "");
            EXPECT_TRUE(rootOf(at("world_joint", "[0, 0, 1.0e-7]", none)).isApprox(Pose::Identity(), 0.0));
            EXPECT_EQ(messageOf(at("world_joint", "[0, 0, 0.01]", none)),
                      name +
                          "transforms[0]: must be no transform: the SRDF file's virtual joint 'world_joint' is fixed");

            setJoint("planar");
            const std::string complaint =
                name +
                "transforms[0]: must neither lift nor tilt the robot: the SRDF file's virtual joint "
                "'world_joint' is planar";
            EXPECT_EQ(messageOf(at("world_joint", "[1, 2, 0.01]", none)), complaint);
            EXPECT_EQ(messageOf(at("world_joint", "[1, 2, 0]", "[0.1, 0, 0, 0.995]")), complaint);
            const Pose rounded = rootOf(at("world_joint", "[1, 2, 1.0e-4]", "[0.0001, 0, 0.6, 0.8]"));
            EXPECT_TRUE(rounded.isApprox(planarPose(1.0, 2.0, 2.0 * std::asin(0.6)), 1e-6)) << rounded.matrix();
        }

        TEST_F(MoveItScene, LinksAreWhereTheRobotsStateSays)
        {
            const SceneFile file = read(
                "fixed_frame_transforms: [{header: {frame_id: base}, child_frame_id: world, transform: {translation: "
                "[5, 0, 0], rotation: [0, 0, 0, 1]}}]\n" +
                OBJECTS +
                "    - {id: ball, header: {frame_id: base}, primitives: [{type: sphere, dimensions: "
                "[0.1]}], primitive_poses: [{position: [0, 2, 0]}]}\n");
            EXPECT_TRUE(file.scene.getObstacles().at(0).pose.isApprox(poseAt({0, 2, 0})));
        }

        TEST_F(MoveItScene, ObstaclesCanBeInTheFrameOfALinkThatMoves)
        {
            const SceneFile file = read(
                "robot_state: {joint_state: {name: [turn, slide], position: [1.5707963267948966, 0.1]}, "
                "multi_dof_joint_state: {joint_names: [world_joint], transforms: [{translation: [5, 0, 0]}]}}\n" +
                OBJECTS +
                "    - {id: ball, header: {frame_id: camera}, primitives: [{type: sphere, dimensions: "
                "[0.1]}], primitive_poses: [{position: [1, 0, 0]}]}\n");
            EXPECT_TRUE(file.scene.getObstacles().at(0).pose.translation().isApprox(Eigen::Vector3d(5, 2, 0.32)))
                << file.scene.getObstacles().at(0).pose.translation();
        }

        /** The rod follows joint "turn". Of the drawer nothing is told: it is in the middle of its limits, beyond 0. */
        TEST_F(MoveItScene, ObstaclesCanBeInTheFrameOfALinkThatFollowsOrIsNotTold)
        {
            const auto slide = [](const std::string &name, const std::string &child, const std::string &more)
            {
                return "<link name='" + child + "'/><joint name='" + name +
                       "' type='prismatic'><parent link='base'/><child link='" + child + "'/><axis xyz='1 0 0'/>" +
                       more + "</joint>";
            };
            std::string urdf = TWO_LINKS_URDF;
            urdf.insert(urdf.find("</robot>"),
                        slide("follow", "rod",
                              "<limit lower='-9' upper='9' effort='1' velocity='1'/>"
                              "<mimic joint='turn' multiplier='2' offset='0.3'/>") +
                            slide("pull", "drawer", "<limit lower='-2' upper='-1' effort='1' velocity='1'/>"));
            robot_ = std::make_unique<const ArmFile>(folder_.write("arm.urdf", urdf),
                                                     folder_.write("arm.srdf", TWO_LINKS_SRDF));
            const auto ballIn = [](const std::string &frame)
            {
                return "    - {id: in_" + frame + ", header: {frame_id: " + frame +
                       "}, primitives: [{type: sphere, dimensions: [0.1]}], "
                       "primitive_poses: [{position: [0, 3, 0]}]}\n";
            };
            const SceneFile file = read("robot_state: {joint_state: {name: [turn], position: [0.5]}}\n" + OBJECTS +
                                        ballIn("rod") + ballIn("drawer"));
            EXPECT_TRUE(file.scene.getObstacles().at(0).pose.isApprox(poseAt({1.3, 3, 0})));
            EXPECT_TRUE(file.scene.getObstacles().at(1).pose.isApprox(poseAt({-1.5, 3, 0})));
        }

        TEST_F(MoveItScene, GoalsCanBeInTheFrameOfALinkThatTheGroupDoesNotMove)
        {
            // The pointer follows joint "turn", which is not of the group, and the wheel one that is.
            std::string urdf = TWO_LINKS_URDF;
            urdf.replace(urdf.find("</robot>"), 8,
                         "<link name='pointer'/><link name='wheel'/><joint name='follow' type='revolute'>"
                         "<parent link='base'/><child link='pointer'/><axis xyz='0 0 1'/><limit lower='-9' upper='9' "
                         "effort='1' velocity='1'/><mimic joint='turn' multiplier='2'/></joint>"
                         "<joint name='roll' type='continuous'><parent link='base'/><child link='wheel'/>"
                         "<axis xyz='0 0 1'/><mimic joint='bend'/></joint></robot>");
            std::string srdf = TWO_LINKS_SRDF;
            srdf.replace(srdf.find("<joint name=\"turn\"/>"), 20, "");
            robot_ = std::make_unique<const ArmFile>(folder_.write("arm.urdf", urdf), folder_.write("arm.srdf", srdf));
            const auto request = [](const std::string &frame, const std::string &position)
            {
                return "group_name: arm\n" + START +
                       "goal_constraints:\n  - position_constraints:\n      - {header: {frame_id: " + frame +
                       "}, link_name: tip, constraint_region: {primitives: [{type: box, dimensions: [0.02, 0.02, "
                       "0.02]}], primitive_poses: [{position: " +
                       position + "}]}}\n";
            };
            const auto tipOf = [&](const SceneFile &file) -> Eigen::Vector3d
            {
                ompl::base::ScopedState<> goal(armOf(file).getStateSpace());
                goal = file.scene.getMembers().front().goal;
                return armOf(file).getLinkPose(goal.get(), "tip").translation();
            };
            // At the start joint "turn" is at 1 and "slide" at 0.1.
            const Eigen::Vector3d inUpper(0.5, 0.5, 0.12);
            const auto turned = [](double angle, const Eigen::Vector3d &point) -> Eigen::Vector3d
            { return Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()) * point; };
            const Eigen::Vector3d expected = turned(1.0, inUpper) + Eigen::Vector3d(0, 0, 0.2);
            const Eigen::Vector3d inPointer = turned(-2.0, expected);
            EXPECT_LT((tipOf(read(BALL, request("upper", "[0.5, 0.5, 0.12]"))) - expected).norm(), 0.02);
            std::ostringstream position;
            position << '[' << inPointer.x() << ", " << inPointer.y() << ", " << inPointer.z() << ']';
            EXPECT_LT((tipOf(read(BALL, request("pointer", position.str()))) - expected).norm(), 0.02);
            for (const std::string moving : {"lower", "wheel"})
                EXPECT_NE(messageOf(BALL, request(moving, "[0, 0, 0]")).find("the group moves link '" + moving),
                          std::string::npos);
        }

        /** Obstacles stay where the scene's state of the robot has its root. */
        TEST_F(MoveItScene, GoalsAreSeenFromWhereTheRobotStarts)
        {
            const SceneFile file =
                read(BALL,
                     "group_name: arm\nstart_state: {joint_state: {name: [turn, bend], position: [0, 0]}, "
                     "multi_dof_joint_state: {joint_names: [world_joint], transforms: [{translation: [5, 0, 0]}]}}\n"
                     "goal_constraints:\n  - position_constraints:\n      - {header: {frame_id: base}, link_name: tip, "
                     "constraint_region: {primitives: [{type: box, dimensions: [0.02, 0.02, 0.02]}], primitive_poses: "
                     "[{position: [0.6, 0.4, 0.32]}]}}\n");
            ompl::base::ScopedState<> goal(armOf(file).getStateSpace());
            goal = file.scene.getMembers().front().goal;
            const Eigen::Vector3d tip = armOf(file).getLinkPose(goal.get(), "tip").translation();
            EXPECT_LT((tip - Eigen::Vector3d(5.6, 0.4, 0.32)).norm(), 0.02) << tip.transpose();
        }

        TEST_F(MoveItScene, JointsThatNobodyNamesAreInTheMiddleOfLimitsWithoutZero)
        {
            std::string urdf = TWO_LINKS_URDF;
            urdf.replace(urdf.find("lower=\"0\""), 9, "lower=\"0.1\"");
            robot_ = std::make_unique<const ArmFile>(folder_.write("arm.urdf", urdf), folder_.path() + "/arm.srdf");
            const auto tipOf = [&](const std::string &joints)
            {
                const SceneFile file =
                    read(BALL, "group_name: arm\nstart_state: {joint_state: " + joints + "}\n" + GOAL);
                ompl::base::ScopedState<> state(armOf(file).getStateSpace());
                state = std::vector<double>{0.0, 0.0};
                return armOf(file).getLinkPose(state.get(), "tip").translation().x();
            };
            EXPECT_NEAR(tipOf("{name: [turn, bend], position: [0, 0]}"), 0.5 + 0.4 + 0.15, 1e-9);
            EXPECT_NEAR(tipOf("{name: [turn, bend, slide], position: [0, 0, 0.2]}"), 0.5 + 0.4 + 0.2, 1e-9);
        }

        /** MoveIt plans in the root link unless a virtual joint moves. */
        TEST_F(MoveItScene, FixedFramesAreInTheFrameThatMoveItPlansIn)
        {
            const std::string joint =
                "  <virtual_joint name=\"world_joint\" type=\"floating\" parent_frame=\"world\" "
                "child_link=\"base\"/>\n";
            std::string none = TWO_LINKS_SRDF;
            ASSERT_NE(none.find(joint), std::string::npos);
            none.erase(none.find(joint), joint.size());
            std::string fixed = TWO_LINKS_SRDF;
            fixed.replace(fixed.find("floating"), 8, "fixed");
            const auto transform = [](const std::string &frame, const std::string &child, int x)
            {
                return "  - {header: {frame_id: " + frame + "}, child_frame_id: " + child +
                       ", transform: {translation: [" + std::to_string(x) + ", 0, 0], rotation: [0, 0, 0, 1]}}\n";
            };
            const std::string ball =
                "    - {id: ball, header: {frame_id: table}, primitives: [{type: sphere, "
                "dimensions: [0.1]}], primitive_poses: [{position: [0, 2, 0]}]}\n";
            const auto poseOf = [&](const std::string &srdf, const std::string &transforms)
            {
                robot_ = std::make_unique<const ArmFile>(folder_.write("arm.urdf", TWO_LINKS_URDF),
                                                         folder_.write("arm.srdf", srdf));
                const SceneFile file = read("fixed_frame_transforms:\n" + transforms + OBJECTS + ball);
                return Eigen::Vector3d(file.scene.getObstacles().at(0).pose.translation());
            };
            for (const std::string &srdf : {fixed, none})
                EXPECT_EQ(poseOf(srdf, transform("base", "base", 0) + transform("table", "base", 1)),
                          Eigen::Vector3d(1, 2, 0));
            EXPECT_EQ(poseOf(fixed, transform("table", "world", 1)), Eigen::Vector3d(1, 2, 0));
            // The file names the parent of a virtual joint that the SRDF file lacks.
            EXPECT_EQ(poseOf(none, transform("table", "world", 1) + transform("world", "world", 0)),
                      Eigen::Vector3d(1, 2, 0));
            // As of tf
            const std::string asOfTf = transform("world", "table", 1);
            EXPECT_EQ(messageOf("fixed_frame_transforms:\n" + asOfTf + OBJECTS + ball),
                      "scene.yaml:2: fixed_frame_transforms[0].child_frame_id: must be the frame that MoveIt plans in, "
                      "'base', not 'table'; the header names the frame whose pose there the transform is");
        }

        /** Without a virtual joint only the scene says where the root is. */
        TEST_F(MoveItScene, FixedFramesMoveWithTheRootThatTheyAreIn)
        {
            std::string srdf = TWO_LINKS_SRDF;
            srdf.erase(srdf.find("  <virtual_joint"), srdf.find("  <group") - srdf.find("  <virtual_joint"));
            robot_ = std::make_unique<const ArmFile>(folder_.path() + "/arm.urdf", folder_.write("arm.srdf", srdf));
            const SceneFile file = read(
                "robot_state: {multi_dof_joint_state: {joint_names: [to_world], transforms: [{translation: [5, 0, "
                "0]}]}}\n"
                "fixed_frame_transforms: [{header: {frame_id: table}, child_frame_id: base, transform: {translation: "
                "[1, 0, 0], rotation: [0, 0, 0, 1]}}]\n" +
                OBJECTS +
                "    - {id: ball, header: {frame_id: table}, primitives: [{type: sphere, dimensions: [0.1]}], "
                "primitive_poses: [{position: [0, 2, 0]}]}\n");
            EXPECT_EQ(Eigen::Vector3d(file.scene.getObstacles().at(0).pose.translation()), Eigen::Vector3d(6, 2, 0));
        }
    }
}
