#include "support/MeshTexts.h"
#include "support/MoveItScene.h"
#include "support/Random.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <ompl/util/Exception.h>

namespace ompl_certificates
{
    namespace
    {
        using namespace test;

        TEST_F(MoveItScene, PosesAreComposed)
        {
            const SceneFile file = read(
                "fixed_frame_transforms:\n"
                "  - {header: {frame_id: world}, child_frame_id: world, transform: {rotation: [0, 0, 0, 1]}}\n"
                "  - header: {frame_id: /table}\n"
                "    child_frame_id: /world\n"
                "    transform: {translation: [0, 0, 1], rotation: [0, 0, 0.7071067811865476, 0.7071067811865476]}\n" +
                OBJECTS +
                "    - id: stack\n"
                "      header: {frame_id: table}\n"
                "      pose: {position: {x: 2, y: 0, z: 0}, orientation: {x: 0, y: 0, z: 2, w: 0}}\n"
                "      primitives:\n"
                "        - {type: box, dimensions: [0.1, 0.2, 0.3]}\n"
                "        - {type: cylinder, dimensions: [0.4, 0.05]}\n"
                "      primitive_poses: [{position: [0.5, 0, 0]}, {orientation: [1, 0, 0, 0]}]\n"
                "    - id: mesh\n"
                "      header: {frame_id: world}\n"
                "      meshes: [{vertices: [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]],"
                " triangles: [[0, 1, 2], {vertex_indices: [0, 1, 3]}]}]\n"
                "      mesh_poses: [{position: [3, 0, 0], orientation: {x: 0, y: 0, z: 0, w: 0}}]\n");
            const auto &obstacles = file.scene.getObstacles();
            ASSERT_EQ(obstacles.size(), 3u);
            // (0.5, 0) turned by pi is (-0.5, 0); with (2, 0) that is (1.5, 0), and turned by pi / 2 (0, 1.5).
            EXPECT_LT((obstacles[0].pose.translation() - Eigen::Vector3d(0, 1.5, 1)).norm(), 1e-12);
            EXPECT_LT((obstacles[0].pose.linear().col(0) - Eigen::Vector3d(0, -1, 0)).norm(), 1e-12);
            EXPECT_LT((obstacles[1].pose.translation() - Eigen::Vector3d(0, 2, 1)).norm(), 1e-12);
            EXPECT_LT((obstacles[1].pose.linear().col(2) - Eigen::Vector3d(0, 0, -1)).norm(), 1e-12);
            // An orientation that nobody filled in is none.
            EXPECT_TRUE(obstacles[2].pose.isApprox(Pose(Eigen::Translation3d(3, 0, 0))));
            EXPECT_EQ(obstacles[0].body, Body::box(0.1, 0.2, 0.3));
            EXPECT_EQ(obstacles[1].body, Body::cylinder(0.05, 0.4));
            const auto &bounds = file.scene.getBounds();
            EXPECT_LT(bounds.low[0], -0.1);
            EXPECT_GT(bounds.high[0], 3.9);
        }

        TEST_F(MoveItScene, LinksKeepTheirPadding)
        {
            const SceneFile file = read(BALL +
                                        "link_padding: [{link_name: tip, padding: 0.25}, {link_name: base, padding: "
                                        "0}, {link_name: camera, padding: 0.1}]\n");
            const Arm &arm = armOf(file);
            for (std::size_t i = 0; i < arm.getBodies().size(); ++i)
                EXPECT_EQ(arm.getBodies()[i].getPadding(), arm.getLinkOfBody(i) == "tip" ? 0.25 : 0.0);
        }

        TEST_F(MoveItScene, MeshesOfFilesAreScaled)
        {
            folder_.write("ramp.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
            const SceneFile file =
                read(OBJECTS +
                     "    - {id: ramp, meshes: [{resource: ramp.obj, dimensions: [2, 3, 1]}], mesh_poses: [{}]}\n");
            const Body &ramp = file.scene.getObstacles().front().body;
            EXPECT_NEAR(ramp.getBoundingRadius(), 3.0, 1e-9);
        }

        TEST_F(MoveItScene, MeshesOfFilesKeepTheirAxes)
        {
            const std::string file =
                folder_.write("a.dae", test::collada("<node><instance_geometry url=\"#g\"/></node>", "Z_UP"));
            for (const std::string &name : {std::string("a.dae"), "file://" + file})
            {
                const SceneFile scene = read(OBJECTS + "    - {id: a, meshes: [{resource: '" + name + "'}]}\n");
                const Shape &shape = scene.scene.getObstacles().front().body.getParts().front().shape;
                EXPECT_TRUE(shape.getBounds().max().isApprox(Eigen::Vector3d(1, 2, 0))) << name;
            }
        }

        /** A message that a program prints has all its fields. */
        TEST_F(MoveItScene, FieldsMayBeEmpty)
        {
            const std::string constraints =
                "{name: '', joint_constraints: [], position_constraints: [], "
                "orientation_constraints: [], visibility_constraints: []}";
            for (const char *operation : {"0", "\"\\0\"", "!!binary AA==", "0x00", "''", "add"})
            {
                const SceneFile file = read(OBJECTS + "    - {id: a, operation: " + operation +
                                                ", primitives: [{type: 1, dimensions: [1, 2, 3], "
                                                "polygon: {points: []}}], primitive_poses: [{position: [9, 0, 0]}]}\n",
                                            REQUEST + "path_constraints: " + constraints +
                                                "\ntrajectory_constraints: {constraints: []}\n");
                ASSERT_EQ(file.scene.getObstacles().size(), 1u) << operation;
                EXPECT_EQ(file.scene.getObstacles()[0].body, Body::box(1, 2, 3));
            }
            // A block of binary text, as YAML writers print it
            EXPECT_NO_THROW(read(OBJECTS + "    - id: a\n      operation: !!binary |\n        AA==\n"
                                           "      primitives: [{type: 2, dimensions: [1]}]\n"));
            // A scene need not have a world.
            EXPECT_TRUE(read("robot_model_name: arm\n").scene.getObstacles().empty());
        }

        TEST_F(MoveItScene, LinksThatAreFixedToTheRootAreFrames)
        {
            robot_ = std::make_unique<const ArmFile>(
                folder_.write("arm.urdf", with(TWO_LINKS_URDF, "</robot>",
                                               "<link name='foot'/><link name='toe'/>"
                                               "<joint name='a' type='fixed'><parent link='base'/><child link='foot'/>"
                                               "<origin xyz='0 0 1' rpy='0 0 1.5707963267948966'/></joint>"
                                               "<joint name='b' type='fixed'><parent link='foot'/><child link='toe'/>"
                                               "<origin xyz='2 0 0'/></joint></robot>")),
                folder_.write("arm.srdf", TWO_LINKS_SRDF));
            const auto ballIn = [](const std::string &frame)
            {
                return OBJECTS + "    - {id: ball, header: {frame_id: " + frame +
                       "}, primitives: [{type: sphere, dimensions: [0.1]}], primitive_poses: [{position: [0, 3, 0]}]}\n";
            };
            EXPECT_TRUE(read(ballIn("toe"))
                            .scene.getObstacles()
                            .front()
                            .pose.translation()
                            .isApprox(Eigen::Vector3d(-3.0, 2.0, 1.0)));
            EXPECT_EQ(
                messageOf(ballIn("tow")),
                "scene.yaml:3: world.collision_objects[0].header: there is no fixed frame 'tow'; there are 'base', "
                "'camera', 'foot', 'lower', 'tip', 'toe', 'upper', 'world'; did you mean toe?");
        }

        TEST_F(MoveItScene, JointsThatCannotMoveAreWhereTheyAre)
        {
            robot_ = std::make_unique<const ArmFile>(
                folder_.write("arm.urdf", with(TWO_LINKS_URDF, "lower=\"-3\" upper=\"3\"", "lower=\"1\" upper=\"1\"")),
                folder_.write("arm.srdf", TWO_LINKS_SRDF));
            const auto request = [](const std::string &value)
            { return with("group_name: arm\n" + START + GOAL, "position: -1", "position: " + value); };
            EXPECT_EQ(read(BALL, request("1.0004")).scene.getMembers().front().goal.size(), 1u);
            EXPECT_NE(messageOf(BALL, request("-1")).find("'turn' is not a joint of the group"), std::string::npos);
        }

        TEST_F(MoveItScene, StartsBeyondALimitAreRefusedByTheJoint)
        {
            const std::string message = messageOf(BALL, with(REQUEST, "position: [1, ", "position: [3.5, "));
            EXPECT_NE(message.find("joint 'turn' must be from -3 to 3, not 3.5"), std::string::npos) << message;
        }

        TEST_F(MoveItScene, ShapesAndOperationsMayBeNumbers)
        {
            const SceneFile file = read(OBJECTS +
                                        "    - {id: a, operation: 0, primitives: [{type: 1, dimensions: [1, 2, 3]}, "
                                        "{type: 2, dimensions: [4]}, {type: 3, dimensions: [5, 6]}]}\n");
            const auto &obstacles = file.scene.getObstacles();
            ASSERT_EQ(obstacles.size(), 3u);
            EXPECT_EQ(obstacles[0].body, Body::box(1, 2, 3));
            EXPECT_EQ(obstacles[1].body, Body::sphere(4));
            EXPECT_EQ(obstacles[2].body, Body::cylinder(6, 5));
        }

        TEST_F(MoveItScene, TheBoundsHoldTheArmAndTheWorkspace)
        {
            // The arm is on the other side of the ball at its goal.
            const SceneFile file = read(BALL), wide = read(BALL, REQUEST +
                                                                     "workspace_parameters: {min_corner: [-9, -8, -7], "
                                                                     "max_corner: [7, 8, 9]}\n");
            EXPECT_LT(file.scene.getBounds().low[1], -0.4);
            EXPECT_EQ(wide.scene.getBounds().low, (std::vector<double>{-9, -8, -7}));
            EXPECT_EQ(wide.scene.getBounds().high, (std::vector<double>{7, 8, 9}));
        }

        TEST_F(MoveItScene, ObstaclesCanBeInTheFrameOfTheRoot)
        {
            const auto base = [](const std::string &height)
            {
                return "multi_dof_joint_state: {joint_names: [world_joint], transforms: [{translation: [0, 0, " +
                       height + "], rotation: [0, 0, 0, 1]}]}";
            };
            const std::string scene =
                OBJECTS + "    - {id: a, header: {frame_id: base}, primitives: [{type: sphere, dimensions: [0.1]}]}\n" +
                "robot_state: {" + base("3") + "}\n";
            const SceneFile file = read(scene);
            EXPECT_EQ(file.scene.getObstacles().front().pose.translation(), Eigen::Vector3d(0, 0, 3));
            const SceneFile moved = read(scene,
                                         "group_name: arm\nstart_state: {joint_state: {name: [turn, bend], "
                                         "position: [0, 0]}, " +
                                             base("5") + "}\n" + GOAL);
            ompl::base::ScopedState<> state(armOf(moved).getStateSpace());
            state = std::vector<double>{0.0, 0.0};
            EXPECT_EQ(armOf(moved).getLinkPose(state.get(), "base").translation(), Eigen::Vector3d(0, 0, 5));
        }

        TEST_F(MoveItScene, OrientationsOfZerosAreNoRotationAndNoted)
        {
            const std::string zeros = "orientation: [0, 0, 0, 0]", world = "world.collision_objects",
                              counts = "orientation: all numbers are 0, which counts as no rotation";
            const auto at = [&](const std::string &y) { return "{position: [0, " + y + ", 0], " + zeros + "}"; };
            const auto ball = [](const std::string &id, const std::string &keys)
            { return "    - {id: " + id + ", primitives: [{type: sphere, dimensions: [0.1]}], " + keys + "}\n"; };
            // The third pose is nowhere filled in: that of the shape counts.
            const std::string objects = OBJECTS + ball("a", "pose: " + at("2")) +
                                        ball("b", "primitive_poses: [" + at("2") + "]") +
                                        ball("c", "pose: " + at("0") + ", primitive_poses: [{position: [0, 2, 0]}]");
            const std::string held =
                "robot_state: {attached_collision_objects: [{link_name: tip, object: {id: d, header: "
                "{frame_id: tip}, primitives: [{type: sphere, dimensions: [0.01]}], "
                "primitive_poses: [" +
                at("0") + "]}}]}\n";
            const std::string goal = "group_name: arm\n" + START +
                                     "goal_constraints: [{orientation_constraints: [{link_name: tip, " + zeros +
                                     ", absolute_x_axis_tolerance: 4, absolute_y_axis_tolerance: 4, "
                                     "absolute_z_axis_tolerance: 4}]}]\n";
            const SceneFile file = read(objects + held, goal);
            EXPECT_EQ(file.scene.getNotes(),
                      (std::vector<std::string>{
                          world + "[0].pose." + counts, world + "[1].primitive_poses[0]." + counts,
                          "robot_state.attached_collision_objects[0].object.primitive_poses[0]." + counts,
                          "goal_constraints[0].orientation_constraints[0]." + counts}));
            for (const PlacedBody &obstacle : file.scene.getObstacles())
                EXPECT_EQ(obstacle.pose.linear(), Eigen::Matrix3d::Identity());
        }

        TEST_F(MoveItScene, JointsThatTheGroupDoesNotMoveKeepTheirValues)
        {
            const std::string state =
                BALL +
                "robot_state:\n"
                "  joint_state: {name: [mount, turn, bend, slide], position: [0, 0.25, 0, 0.15]}\n"
                "  multi_dof_joint_state:\n"
                "    joint_names: [world_joint]\n"
                "    transforms: [{translation: [0, 0, 3], rotation: [0, 0, 0, 1]}]\n";
            // The request's start tells of all joints but turn.
            const SceneFile file =
                read(state,
                     "group_name: arm\nstart_state: {joint_state: {name: [bend, slide], position: [0, 0.1]}}\n" + GOAL);
            const Arm &arm = armOf(file);
            EXPECT_EQ(file.scene.getMembers().front().start, (std::vector<double>{0.25, 0.0}));
            ompl::base::ScopedState<> state0(arm.getStateSpace());
            state0 = std::vector<double>{0.0, 0.0};
            EXPECT_LT((arm.getLinkPose(state0.get(), "tip").translation() - Eigen::Vector3d(1.0, 0.0, 3.32)).norm(),
                      1e-12);
            const SceneFile second = read(state, "group_name: arm\nstart_state: {}\n" + GOAL);
            EXPECT_LT((armOf(second).getLinkPose(state0.get(), "tip").translation() - Eigen::Vector3d(1.05, 0.0, 3.32))
                          .norm(),
                      1e-12);
        }

        TEST_F(MoveItScene, MayBeAsProgramsPrintThem)
        {
            // The frame that MoveIt plans in is that of the virtual joint, also with a slash; Python writes True, and
            // rostopic a line behind each message.
            const SceneFile file = read("is_diff: False\n" + OBJECTS +
                                        "    - {id: ball, header: {frame_id: /world}, primitives: [{type: sphere, "
                                        "dimensions: [0.1]}], primitive_poses: [{position: [0, 2, 0]}]}\n---\n");
            EXPECT_TRUE(file.scene.getObstacles().at(0).pose.isApprox(poseAt({0, 2, 0})));
        }

        TEST_F(MoveItScene, AnEmptyMatrixOfADifferenceChangesNothing)
        {
            const std::string empty = "allowed_collision_matrix: {entry_names: [], entry_values: []}\n";
            const auto before = pairsOf(armOf(read(BALL)));
            EXPECT_EQ(pairsOf(armOf(read(BALL + "is_diff: true\n" + empty))), before);
            EXPECT_NE(pairsOf(armOf(read(BALL + empty))), before);
        }

        TEST_F(MoveItScene, TellsThatADifferenceIsNotAllThereIs)
        {
            const auto tells = [&](const std::string &isDiff)
            {
                const SceneFile file = read(BALL + isDiff);
                const auto &notes = file.scene.getNotes();
                return std::any_of(notes.begin(), notes.end(),
                                   [](const std::string &note)
                                   { return note.find("is_diff is true") != std::string::npos; });
            };
            EXPECT_TRUE(tells("is_diff: true\n"));
            EXPECT_FALSE(tells("is_diff: false\n"));
            EXPECT_FALSE(tells(""));
        }

        TEST_F(MoveItScene, TheMatrixReplacesTheSrdfFilesPairs)
        {
            using Pairs = std::vector<std::string>;
            EXPECT_EQ(pairsOf(armOf(read(BALL))), (Pairs{"base lower", "base tip", "upper tip"}));
            // Pairs that stay apart are not checked again and again, hence none of lower and tip.
            const SceneFile file = read(BALL +
                                        "allowed_collision_matrix:\n"
                                        "  entry_names: [base, tip, ball, ghost]\n"
                                        "  entry_values: [[false, true, false, true], {enabled: [true, false, false, "
                                        "false]}, [false, false, true, true], [true, false, true, true]]\n");
            EXPECT_EQ(pairsOf(armOf(file)), (Pairs{"base upper", "base lower", "upper lower", "upper tip"}));
            // One that is empty replaces nothing.
            EXPECT_EQ(pairsOf(armOf(read(BALL + "allowed_collision_matrix: {}\n"))),
                      (Pairs{"base lower", "base tip", "upper tip"}));
        }

        TEST_F(MoveItScene, IsKnownByItsKeys)
        {
            const auto isScene = [this](const std::string &text) { return isMoveItScene(folder_.write("f", text)); };
            EXPECT_TRUE(isScene(BALL));
            EXPECT_TRUE(isScene("robot_model_name: arm\n"));
            EXPECT_FALSE(isScene("environment: {}\nrobots: []\n"));
            EXPECT_FALSE(isScene("world: {}\nenvironment: {}\n"));
            EXPECT_FALSE(isScene(REQUEST));
            // The answer of a service: reading it tells what is wrong.
            EXPECT_TRUE(isScene("scene: {world: {}}\n"));
            EXPECT_FALSE(isScene("scene: office\n"));
            EXPECT_FALSE(isScene("[world]"));
            EXPECT_THROW(isScene("world: ["), ompl::Exception);
            EXPECT_THROW(isScene(""), ompl::Exception);
            EXPECT_THROW(isMoveItScene(folder_ / "absent.yaml"), ompl::Exception);
        }

        TEST_F(MoveItScene, ConesAreConesToAFractionOfTheirRadius)
        {
            constexpr double height = 0.8, radius = 0.3, ball = 1e-4;
            const auto obstacles =
                read(OBJECTS +
                     "    - {id: a, primitives: [{type: cone, dimensions: [0.8, 0.3]}], primitive_poses: "
                     "[{position: [2, 0, 0]}]}\n")
                    .scene.makeObstacles();
            // The distance to the solid cone, in the half plane of the distance from the axis and the height
            const auto distance = [&](const Eigen::Vector2d &point)
            {
                const Eigen::Vector2d tip(0.0, 0.5 * height), rim(radius, -0.5 * height), middle(0.0, -0.5 * height);
                const Eigen::Vector2d out = Eigen::Vector2d(height, radius).normalized();
                if (point.y() > middle.y() && out.dot(point - tip) < 0.0)
                    return -1.0;
                const auto toSegment = [&](const Eigen::Vector2d &from, const Eigen::Vector2d &to)
                {
                    const double t = (point - from).dot(to - from) / (to - from).squaredNorm();
                    return (from + std::clamp(t, 0.0, 1.0) * (to - from) - point).norm();
                };
                return std::min(toSegment(tip, rim), toSegment(middle, rim));
            };
            test::Random random(1);
            int touching = 0, apart = 0;
            for (int i = 0; i < 20000; ++i)
            {
                // Most points are near the side or the rim.
                const double z = random.uniform(-0.41, 0.41), turn = random.uniform(-M_PI, M_PI);
                const double r =
                    std::max(0.0, radius * (0.5 - z / height) + random.sign() * random.logUniform(1e-6, 0.02));
                const double gap = distance({r, z});
                const bool collides =
                    obstacles->collides(Body::sphere(ball), poseAt({2.0 + r * std::cos(turn), r * std::sin(turn), z}));
                ASSERT_TRUE(collides || gap > ball - 1e-7) << i << " " << gap;
                ASSERT_FALSE(collides && gap > ball + 3.1e-4 * radius) << i << " " << gap;
                ++(collides ? touching : apart);
            }
            EXPECT_GT(touching, 5000);
            EXPECT_GT(apart, 5000);
        }
    }
}
