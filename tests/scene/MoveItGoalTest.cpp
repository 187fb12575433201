#include "support/MoveItScene.h"
#include "support/Random.h"

#include "ompl_certificates/robots/LinkPoseGoal.h"

#include <gtest/gtest.h>

namespace ompl_certificates
{
    namespace
    {
        using namespace test;

        TEST_F(MoveItScene, StartAndGoalAreThoseOfTheRequest)
        {
            const SceneFile file = read(BALL + "robot_model_name: other\n", REQUEST + "allowed_planning_time: 7\n");
            const Scene::Member &member = file.scene.getMembers().front();
            EXPECT_EQ(member.start, (std::vector<double>{1.0, 0.5}));
            ASSERT_EQ(member.goal.size(), 2u);
            EXPECT_EQ(member.goal[0], -1.0);
            EXPECT_NEAR(member.goal[1], 4.0 - 2.0 * M_PI, 1e-12);
            EXPECT_EQ(file.timeLimit, 7.0);
            EXPECT_EQ(file.scene.getResolution(), 0.005);
            EXPECT_EQ(file.scene.getName(), "scene");
            ASSERT_EQ(file.scene.getNotes().size(), 1u);
            EXPECT_EQ(file.scene.getNotes().front(), "robot_model_name is other; the robot is two_links");
            EXPECT_NO_THROW(file.scene.validate());
        }

        TEST_F(MoveItScene, GoalsCanBePosesOfLinks)
        {
            const std::string frames =
                "fixed_frame_transforms:\n"
                "  - {header: {frame_id: table}, child_frame_id: world, transform: {translation: [0.3, 0, 0.3], "
                "rotation: [0, 0, 1, 1]}}\n";
            const SceneFile file =
                read(frames + BALL,
                     "group_name: arm\n" + START +
                         "goal_constraints:\n"
                         "  - joint_constraints: []\n"
                         "    position_constraints:\n"
                         "      - header: {frame_id: table}\n"
                         "        link_name: tip\n"
                         "        target_point_offset: {x: 0.1, y: 0, z: 0}\n"
                         "        constraint_region:\n"
                         "          primitives: [{type: box, dimensions: [0.2, 0.1, 0.06]}]\n"
                         "          primitive_poses: [{position: [0.5, 0.1, 0.02], orientation: [0, 0, 1, 0]}]\n"
                         "        weight: 1\n"
                         "    orientation_constraints:\n"
                         "      - {header: {frame_id: world}, orientation: {x: 0, y: 0, z: 1, w: 1}, link_name: tip, "
                         "absolute_x_axis_tolerance: 0.1, absolute_y_axis_tolerance: 0.2, "
                         "absolute_z_axis_tolerance: 1.5, weight: 1}\n");
            const Scene::Member &member = file.scene.getMembers().front();
            const LinkPose &pose = dynamic_cast<const LinkPoseGoal &>(*member.region).getLinkPose();
            EXPECT_EQ(pose.link, "tip");
            EXPECT_EQ(pose.point, Eigen::Vector3d(0.1, 0, 0));
            // The frame is turned by a quarter, the box by a half further.
            EXPECT_TRUE(pose.position->point.isApprox(Eigen::Vector3d(0.2, 0.5, 0.32)));
            EXPECT_TRUE(pose.position->axes.col(0).isApprox(Eigen::Vector3d(0, -1, 0)));
            EXPECT_TRUE(pose.position->tolerance.isApprox(Eigen::Vector3d(0.1, 0.05, 0.03)));
            EXPECT_TRUE(pose.rotation->rotation.col(0).isApprox(Eigen::Vector3d(0, 1, 0)));
            EXPECT_EQ(pose.rotation->tolerance, Eigen::Vector3d(0.1, 0.2, 1.5));
            EXPECT_NO_THROW(file.scene.validate());
            ompl::base::ScopedState<> state(member.robot->getStateSpace());
            state = member.goal;
            const Pose tip = armOf(file).getLinkPose(state.get(), "tip");
            EXPECT_LE(
                ((tip * pose.point - pose.position->point).cwiseAbs() - Eigen::Vector3d(0.05, 0.1, 0.03)).maxCoeff(),
                0.0);
            EXPECT_LE(std::abs(Eigen::AngleAxisd(pose.rotation->rotation.transpose() * tip.linear()).angle()), 1.5);

            // In a sphere fits a cube; a rotation vector counts by half.
            const SceneFile round =
                read(BALL, "group_name: arm\n" + START +
                               "goal_constraints: [{position_constraints: [{link_name: tip, constraint_region: "
                               "{primitives: [{type: sphere, dimensions: [0.3]}], primitive_poses: [{position: [0.4, "
                               "0.5, 0.32]}]}}], orientation_constraints: [{orientation: [0, 0, 0, 1], link_name: tip, "
                               "parameterization: 1, absolute_x_axis_tolerance: 0.1, absolute_y_axis_tolerance: 0.1, "
                               "absolute_z_axis_tolerance: 0.5}]}]\n");
            const LinkPose &other =
                dynamic_cast<const LinkPoseGoal &>(*round.scene.getMembers().front().region).getLinkPose();
            EXPECT_NEAR(other.position->tolerance.norm(), 0.3, 1e-12);
            EXPECT_EQ(other.rotation->tolerance, Eigen::Vector3d(0.05, 0.05, 0.25));
        }

        TEST_F(MoveItScene, AnyOfSeveralGoalsWillDo)
        {
            // The first one is in the ball.
            const std::string ball = OBJECTS +
                                     "    - {id: ball, primitives: [{type: sphere, dimensions: [0.2]}], "
                                     "primitive_poses: [{position: [0.5, -0.5, 0.3]}]}\n",
                              second =
                                  "  - joint_constraints:\n      - {joint_name: turn, position: 2}\n"
                                  "      - {joint_name: bend, position: 0.5}\n",
                              pose =
                                  "  - position_constraints: [{link_name: tip, constraint_region: {primitives: "
                                  "[{type: sphere, dimensions: [0.1]}], primitive_poses: [{position: [-0.4, 0.5, "
                                  "0.32]}]}}]\n";
            const std::string blocked = "group_name: arm\n" + START +
                                        "goal_constraints:\n  - joint_constraints:\n      - {joint_name: turn, "
                                        "position: -0.8}\n      - {joint_name: bend, position: 0}\n";
            EXPECT_THROW(read(ball, blocked).scene.validate(), ompl::Exception);
            const SceneFile file = read(ball, blocked + second + pose);
            EXPECT_NO_THROW(file.scene.validate());
            const Scene::Member &member = file.scene.getMembers().front();
            ASSERT_TRUE(member.region);
            EXPECT_EQ(member.region->describe(), "any of its 3 goals");
            ompl::base::ScopedState<> state(member.robot->getStateSpace());
            for (const std::vector<double> &goal : {std::vector<double>{2.0, 0.5}, {-0.8, 0.0}})
            {
                state = goal;
                EXPECT_EQ(member.region->distance(state.get()), 0.0);
            }
            const auto setup = file.scene.makeSetup();
            ASSERT_EQ(setup->solve(10.0), ompl::base::PlannerStatus::EXACT_SOLUTION);
            EXPECT_TRUE(setup->getGoal()->isSatisfied(setup->getSolutionPath().getStates().back()));
        }

        /** Two turns one after another turn about the third axis, too. */
        TEST_F(MoveItScene, TurnsStayWithinTheTolerancesOfARotationVector)
        {
            Random random(1);
            for (unsigned int i = 0; i < scaled(30); ++i)
            {
                Eigen::Vector3d asked;
                std::string request = "group_name: arm\n" + START +
                                      "goal_constraints: [{orientation_constraints: [{orientation: [0, 0, 0, 1], "
                                      "link_name: tip, parameterization: 1";
                for (Eigen::Index axis = 0; axis < 3; ++axis)
                {
                    asked[axis] = i == 0 && axis < 2 ? 0.5 : random.logUniform(0.001, 0.5);
                    request +=
                        std::string(", absolute_") + "xyz"[axis] + "_axis_tolerance: " + std::to_string(asked[axis]);
                }
                const SceneFile file = read(BALL, request + "}]}]\n");
                const Eigen::Vector3d turns =
                    dynamic_cast<const LinkPoseGoal &>(*file.scene.getMembers().front().region)
                        .getLinkPose()
                        .rotation->tolerance;
                EXPECT_GE(turns.minCoeff(), 0.2 * asked.minCoeff());
                for (int k = 0; k < 200; ++k)
                {
                    Eigen::Vector3d angles;
                    for (Eigen::Index axis = 0; axis < 3; ++axis)
                        angles[axis] = random.chance(0.5) ? random.sign() * turns[axis]
                                                          : random.uniform(-turns[axis], turns[axis]);
                    const Eigen::AngleAxisd turn(Eigen::AngleAxisd(angles.x(), Eigen::Vector3d::UnitX()) *
                                                 Eigen::AngleAxisd(angles.y(), Eigen::Vector3d::UnitY()) *
                                                 Eigen::AngleAxisd(angles.z(), Eigen::Vector3d::UnitZ()));
                    ASSERT_LE(((turn.angle() * turn.axis()).cwiseAbs() - asked).maxCoeff(), 1e-6) << asked.transpose();
                }
            }
        }

        /** MoveIt writes a constraint for each joint of its group. */
        TEST_F(MoveItScene, GoalsMayTellOfJointsThatStayWhereTheyAre)
        {
            std::string srdf = TWO_LINKS_SRDF;
            srdf.replace(srdf.find("<group"), 0, "<passive_joint name=\"bend\"/>");
            robot_ = std::make_unique<const ArmFile>(folder_.write("arm.urdf", TWO_LINKS_URDF),
                                                     folder_.write("passive.srdf", srdf));
            const auto request = [](const std::string &joint, const std::string &position)
            {
                return "group_name: arm\n" + START +
                       "goal_constraints: [{joint_constraints: [{joint_name: turn, position: -1}, {joint_name: " +
                       joint + ", position: " + position + "}]}]\n";
            };
            EXPECT_EQ(read(BALL, request("bend", "0.5")).scene.getMembers().front().goal, std::vector<double>{-1.0});
            EXPECT_EQ(read(BALL, request("slide", "0.15, tolerance_below: 0.06")).scene.getMembers().front().goal,
                      std::vector<double>{-1.0});
            EXPECT_NE(messageOf(BALL, request("slide", "0.15, tolerance_above: 0.06")).find("it stays at 0.1"),
                      std::string::npos);
            EXPECT_EQ(read(BALL, request("bend", "6.783185307179586")).scene.getMembers().front().goal,
                      std::vector<double>{-1.0});
            EXPECT_EQ(read(BALL, request("slide", "0.1")).scene.getMembers().front().goal, std::vector<double>{-1.0});
            EXPECT_NE(
                messageOf(BALL, request("bend", "4")).find("the SRDF file says that it is passive: it stays at 0.5"),
                std::string::npos)
                << messageOf(BALL, request("bend", "4"));
            EXPECT_NE(messageOf(BALL, request("mount", "0")).find("'mount' is not a joint of the group"),
                      std::string::npos);
        }

        TEST_F(MoveItScene, GoalsMayTellOfJointsThatFollow)
        {
            std::string urdf = TWO_LINKS_URDF;
            urdf.replace(urdf.find("<limit lower=\"0\""), 0,
                         "<mimic joint=\"turn\" multiplier=\"0.02\" offset=\"0.1\"/>");
            robot_ = std::make_unique<const ArmFile>(folder_.write("follows.urdf", urdf),
                                                     folder_.write("arm.srdf", TWO_LINKS_SRDF));
            const auto slideAt = [](const std::string &position)
            { return REQUEST + "      - {joint_name: slide, position: " + position + "}\n"; };
            EXPECT_EQ(read(BALL, slideAt("0.08")).scene.getMembers().front().goal,
                      read(BALL).scene.getMembers().front().goal);
            EXPECT_NE(messageOf(BALL, slideAt("0.1")).find("must be 0.080000, where the joint follows joint 'turn'"),
                      std::string::npos)
                << messageOf(BALL, slideAt("0.1"));
        }
    }
}
