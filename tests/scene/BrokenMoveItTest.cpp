#include "support/MoveItScene.h"

#include <gtest/gtest.h>
#include <ompl/util/Exception.h>

namespace ompl_certificates
{
    namespace
    {
        using namespace test;

        struct BrokenProblem
        {
            std::string text, message;
        };

        TEST_F(MoveItScene, BrokenScenesAreRefused)
        {
            const std::string pose = "primitive_poses: [{}]";
            const auto object = [](const std::string &keys) { return OBJECTS + "    - {id: a, " + keys + "}\n"; };
            const auto primitive = [&](const std::string &keys)
            { return object("primitives: [{" + keys + "}], primitive_poses: [{}]"); };
            const std::string place = "scene.yaml:3: world.collision_objects[0]";
            const BrokenProblem all[]{
                {"world: [", "scene.yaml:1: not valid YAML"},
                {"name: none\n", "scene.yaml:1: world: missing"},
                {"scene: {world: {}}\n",
                 "scene.yaml:1: scene: is what is wanted, but it is a part of a larger message"},
                {object("meshes: [{vertices: '...', triangles: []}], mesh_poses: [{}]"),
                 place + ".meshes[0].vertices: must be a list, not '...': was it cut when it was printed? ros2 topic"},
                {BALL + "wrold: 1\n", "scene.yaml:4: wrold: unknown key"},
                {BALL + "    - {id: ball, primitives: [{type: sphere, dimensions: [1]}]}\n",
                 "scene.yaml:4: world.collision_objects[1].id: there is an object 'ball' already"},
                {object("primitives: []"), place + ": object 'a' has no shape"},
                {OBJECTS + "    - {primitives: []}\n", place + ".id: missing"},
                {object("colour: red"), place + ".colour: unknown key"},
                {object("operation: remove"), place + ".operation: must be add or 0, not remove"},
                {object("operation: \"\\x01\""), place + ".operation: must be add or 0, not "},
                {object("primitives: [{type: 1, dimensions: [1, 2, 3], polygon: {points: [[0, 0]]}}]"),
                 place + ".primitives[0].polygon: not supported"},
                {object("planes: [{coef: [0, 0, 1]}]"),
                 place + ".planes[0].coef: must be a list of 4 numbers, not of 3"},
                {object("planes: [{coef: [0, 0, 0, 1]}]"),
                 place + ".planes[0].coef: the normal, the first three numbers, must not be zero"},
                {object("planes: [{coef: [0, 0, 1, 0]}], plane_poses: [{}, {}]"),
                 place + ".plane_poses: must have as many items as planes, 1, not 2"},
                {object("planes: [{normal: [0, 0, 1]}]"), place + ".planes[0].normal: unknown key"},
                {BALL + "robot_state: {attached_collision_objects: [{link_name: tip, object: {id: a, header: "
                        "{frame_id: tip}, planes: [{coef: [0, 0, 1, 0]}]}}]}\n",
                 "scene.yaml:4: robot_state.attached_collision_objects[0].object.planes: not supported"},
                {object("header: {frame_id: moon}, primitives: [{type: box, dimensions: [1, 1, 1]}]"),
                 place + ".header: there is no fixed frame 'moon'"},
                {primitive("type: torus, dimensions: [1, 1]"),
                 place + ".primitives[0].type: must be one of box, sphere, cylinder, cone, not 'torus'"},
                {primitive("type: cone, dimensions: [1]"),
                 place + ".primitives[0].dimensions: must be a list of 2 numbers, not of 1"},
                {primitive("type: box, dimensions: [1, 1]"),
                 place + ".primitives[0].dimensions: must be a list of 3 numbers, not of 2"},
                {primitive("type: sphere, dimensions: [0]"),
                 place + ".primitives[0].dimensions[0]: must be positive, not 0"},
                {primitive("type: sphere, dimensions: [.nan]"),
                 place + ".primitives[0].dimensions[0]: must be a finite number of at most 1000000000, not .nan"},
                {object("primitives: [{type: sphere, dimensions: [1]}], primitive_poses: [{}, {}]"),
                 place + ".primitive_poses: must have as many items as primitives, 1, not 2"},
                {object(
                     "primitives: [{type: sphere, dimensions: [1]}], primitive_poses: [{orientation: [0, 0, 0, 1e-12]}]"),
                 place + ".primitive_poses[0].orientation: must not be zero"},
                {object("primitives: [{type: sphere, dimensions: [1]}], primitive_poses: [{position: [0, x, 0]}]"),
                 place + ".primitive_poses[0].position[1]: must be a number, not x"},
                {object("meshes: [{resource: absent.stl}]"), place + ".meshes[0].resource: "},
                {object("meshes: [{resource: package://a/b.stl}]"),
                 place + ".meshes[0].resource: package:// is not supported in scenes; give a path"},
                {object("meshes: [{vertices: [[0, 0, 0], [1, 0, 0], [0, 1, 0]], triangles: [[0, 1, 3]]}]"),
                 place + ".meshes[0].triangles[0][2]: must be the number of a vertex, below 3, not 3"},
                {object("meshes: [{vertices: [[0, 0, 0], [0, 0, 0], [0, 0, 0]], triangles: [[0, 1, 2]]}]"),
                 place + ".meshes[0]: "},
                {"world: {octomap: {octomap: {data: [1]}}}\n", "scene.yaml:1: world.octomap.octomap.binary: missing"},
                {BALL + "allowed_collision_matrix: {entry_names: [base, tip], entry_values: [[false, false], [true, "
                        "false]]}\n",
                 "scene.yaml:4: allowed_collision_matrix.entry_values[1][0]: must be as for 'base' and 'tip': the matrix "
                 "must be symmetric"},
                {BALL + "link_padding: [{link_name: tip, padding: -0.01}]\n",
                 "scene.yaml:4: link_padding[0].padding: must not be negative, not -0.01"},
                {BALL + "link_padding: [{link_name: tip, padding: 0.1}, {link_name: tip, padding: 0.2}]\n",
                 "scene.yaml:4: link_padding[1].link_name: has a padding already"},
                {BALL + "link_padding: [{link_name: tpi, padding: 0.01}]\n",
                 "scene.yaml:4: link_padding[0].link_name: there is no link 'tpi'; did you mean tip?"},
                {BALL + "link_scale: [{link_name: tip, scale: 1}, {link_name: tip, scale: 0}]\n",
                 "scene.yaml:4: link_scale[1].scale: is not supported but as 1"},
                {BALL + "robot_state: {joint_state: {name: [turn, knee], position: [0, 0]}}\n",
                 "scene.yaml:4: robot_state.joint_state.name[1]: there is no joint 'knee'"},
                {BALL + "robot_state: {joint_state: {name: [turn, turn], position: [0, 0]}}\n",
                 "scene.yaml:4: robot_state.joint_state.name[1]: 'turn' is given twice"},
                {BALL + "robot_state: {joint_state: {name: [turn], position: [0, 0]}}\n",
                 "scene.yaml:4: robot_state.joint_state.position: must be a list of 1 number, not of 2"},
                {BALL + "robot_state: {joint_state: {name: [turn]}}\n",
                 "scene.yaml:4: robot_state.joint_state.position: missing"},
                {BALL + "robot_state: {attached_collision_objects: [{link_name: hand, object: {}}]}\n",
                 "scene.yaml:4: robot_state.attached_collision_objects[0].link_name: there is no link 'hand'"},
                {BALL + "robot_state: {attached_collision_objects: [{link_name: tip, object: {id: a, "
                        "primitives: [{type: sphere, dimensions: [1]}]}}]}\n",
                 "scene.yaml:4: robot_state.attached_collision_objects[0].object: must be in the frame of its link, 'tip': it has no "
                 "header.frame_id"},
                {BALL + "robot_state: {attached_collision_objects: [{link_name: tip, object: {id: lower, header: "
                        "{frame_id: tip}, primitives: [{type: sphere, dimensions: [1]}]}}]}\n",
                 "scene.yaml:4: robot_state.attached_collision_objects[0].object.id: there is a link 'lower' already"},
                {BALL + "allowed_collision_matrix: {entry_names: [base, tip], entry_values: [[true]]}\n",
                 "scene.yaml:4: allowed_collision_matrix.entry_values: must have 2 items, not 1"},
                {BALL + "allowed_collision_matrix: {entry_names: [base], entry_values: [[1]]}\n",
                 "scene.yaml:4: allowed_collision_matrix.entry_values[0][0]: must be true or false, not 1"},
                {BALL + "allowed_collision_matrix: {entry_names: [], entry_values: [], default_entry_names: [tip]}\n",
                 "scene.yaml:4: allowed_collision_matrix: must have as many default_entry_values as "
                 "default_entry_names, 1, not 0"},
                {BALL +
                     "fixed_frame_transforms: [{header: {frame_id: world}, child_frame_id: camera_stand, transform: {}}]\n",
                 "scene.yaml:4: fixed_frame_transforms[0].child_frame_id: must be the frame that MoveIt plans in, "
                 "'world', not 'camera_stand'; the header names"},
                {BALL + "fixed_frame_transforms: [{header: {frame_id: world}, child_frame_id: world, transform: "
                        "{translation: [1, 0, 0], rotation: [0, 0, 0, 1]}}]\n",
                 "scene.yaml:4: fixed_frame_transforms[0].transform: must be the identity: MoveIt plans in the frame "
                 "'world'"},
                {BALL + "fixed_frame_transforms: [{header: {frame_id: a}, child_frame_id: base, transform: {}}]\n",
                 "scene.yaml:4: fixed_frame_transforms[0].child_frame_id: must be the frame that MoveIt plans in, "
                 "'world', not 'base'"},
                {BALL +
                     "fixed_frame_transforms: [{child_frame_id: world, transform: {translation: [1, 0, 0], rotation: "
                     "[0, 0, 0, 1]}}]\n",
                 "scene.yaml:4: fixed_frame_transforms[0].transform: must be the identity: the header names no frame"},
                {BALL + "fixed_frame_transforms: [{header: {frame_id: a}, transform: {}}]\n",
                 "scene.yaml:4: fixed_frame_transforms[0].child_frame_id: missing"},
                {BALL + "fixed_frame_transforms: [{header: {frame_id: a}, child_frame_id: world, transform: {}}, "
                        "{header: {frame_id: /a}, child_frame_id: world, transform: {}}]\n",
                 "scene.yaml:4: fixed_frame_transforms[1]: there is a transform of the frame 'a' already"},
            };
            for (const BrokenProblem &broken : all)
            {
                SCOPED_TRACE(broken.text);
                EXPECT_EQ(messageOf(broken.text).substr(0, broken.message.size()), broken.message);
            }
        }

        TEST_F(MoveItScene, BrokenRequestsAreRefused)
        {
            const std::string group = "group_name: arm\n";
            const std::string BALL_REGION =
                "constraint_region: {primitives: [{type: sphere, dimensions: [0.01]}], primitive_poses: [{position: "
                "[0.4, 0.5, 0.32]}]}";
            const auto pose = [&](const std::string &position, const std::string &orientation)
            {
                const auto list = [](const std::string &item) { return item.empty() ? "[]" : "[{" + item + "}]"; };
                return group + START + "goal_constraints: [{position_constraints: " + list(position) +
                       ", orientation_constraints: " + list(orientation) + "}]\n";
            };
            const BrokenProblem all[]{
                {START + GOAL, "request.yaml:1: group_name: missing"},
                {"group_name: leg\n" + START + GOAL, "request.yaml:1: group_name: "},
                {group + START, "request.yaml:1: goal_constraints: missing"},
                {REQUEST + "group: arm\n", "request.yaml:7: group: unknown key"},
                {REQUEST + "path_constraints: {name: upright}\n", "request.yaml:7: path_constraints: not supported"},
                {REQUEST + "allowed_planning_time: -1\n",
                 "request.yaml:7: allowed_planning_time: must be positive, not -1"},
                {REQUEST + "workspace_parameters: {min_corner: [0, 0, 0], max_corner: [1, -1, 1]}\n",
                 "request.yaml:7: workspace_parameters.max_corner: must be above min_corner"},
                {group + START + "goal_constraints: []\n", "request.yaml:3: goal_constraints: must have from 1"},
                {REQUEST + "  - joint_constraints: []\n",
                 "request.yaml:7: goal_constraints[1].joint_constraints: must have from 1"},
                {group + START + "goal_constraints: [{joint_constraints: [{joint_name: turn, position: 0}]}]\n",
                 "request.yaml:3: goal_constraints[0]: has no position of joint 'bend'"},
                {group + START + "goal_constraints: [{joint_constraints: [{joint_name: slide, position: 0.3}]}]\n",
                 "request.yaml:3: goal_constraints[0].joint_constraints[0].position: 'slide' is not a joint of the group: "
                 "it stays at 0.100000, not 0.3"},
                {"request: {group_name: arm}\n",
                 "request.yaml:1: request: is what is wanted, but it is a part of a larger"},
                {group + START +
                     "goal_constraints: [{joint_constraints: [{joint_name: turn, position: 0, tolerance_below: -0.1}]}]\n",
                 "request.yaml:3: goal_constraints[0].joint_constraints[0].tolerance_below: must not be negative, but is "
                 "-0.1"},
                {pose("link_name: tip", ""),
                 "request.yaml:3: goal_constraints[0].position_constraints[0].constraint_region: missing"},
                {pose("link_name: nose, " + BALL_REGION, ""),
                 "request.yaml:3: goal_constraints[0].position_constraints[0].link_name: there is no link 'nose'"},
                {pose("", "link_name: tpi, orientation: [0, 0, 0, 1]"),
                 "request.yaml:3: goal_constraints[0].orientation_constraints[0].link_name: there is no link 'tpi'; did "
                 "you mean tip?"},
                {pose("link_name: tip, header: {frame_id: lower}, " + BALL_REGION, ""),
                 "request.yaml:3: goal_constraints[0].position_constraints[0].header: the group moves link 'lower', so "
                 "that no goal can be in its frame"},
                {pose("link_name: base, " + BALL_REGION, ""),
                 "request.yaml:3: goal_constraints[0]: two_links: goal of link 'base': the arm does not move this"},
                {pose("link_name: tip, header: {frame_id: moon}, " + BALL_REGION, ""),
                 "request.yaml:3: goal_constraints[0].position_constraints[0].header: there is no fixed frame 'moon'"},
                {pose("link_name: tip, constraint_region: {primitives: [{type: 2, dimensions: [0.01]}]}", ""),
                 "request.yaml:3: goal_constraints[0].position_constraints[0].constraint_region.primitive_poses: "
                 "missing"},
                {pose("link_name: tip, constraint_region: {primitives: []}", ""),
                 "request.yaml:3: goal_constraints[0].position_constraints[0].constraint_region: must have one"},
                {pose(
                     "link_name: tip, constraint_region: {primitives: [{type: 3, dimensions: [1, 1]}], primitive_poses: [{}]}",
                     ""),
                 "request.yaml:3: goal_constraints[0].position_constraints[0].constraint_region.primitives: must be a "
                 "box or a sphere"},
                {pose("link_name: tip, constraint_region: {primitives: [{type: 2, dimensions: [0.01]}], "
                      "primitive_poses: [{position: [9, 0, 0]}]}",
                      ""),
                 "request.yaml:3: goal_constraints[0]: no state of 'two_links' was found that reaches link 'tip' at [9, 0, 0]"},
                {pose("link_name: tip, " + BALL_REGION, "link_name: lower, orientation: [0, 0, 0, 1]"),
                 "request.yaml:3: goal_constraints[0].orientation_constraints[0].link_name: must be that of the "
                 "position, 'tip'"},
                {pose("", "link_name: tip, orientation: [0, 0, 0, 1], absolute_x_axis_tolerance: 0"),
                 "request.yaml:3: goal_constraints[0].orientation_constraints[0].absolute_x_axis_tolerance: must be "
                 "positive, not 0"},
                {pose("", "link_name: tip, orientation: [0, 0, 0, 1], parameterization: 2"),
                 "request.yaml:3: goal_constraints[0].orientation_constraints[0].parameterization: must be 0 or 1, "
                 "not 2"},
                {pose("",
                      "link_name: tip, orientation: [0, 0, 0, 1], parameterization: 1, absolute_x_axis_tolerance: "
                      "1"),
                 "request.yaml:3: goal_constraints[0].orientation_constraints[0].absolute_x_axis_tolerance: must be at "
                 "most 0.5"},
                {group + START +
                     "goal_constraints: [{joint_constraints: [{joint_name: turn, position: 0}], "
                     "position_constraints: [{link_name: tip, " +
                     BALL_REGION + "}]}]\n",
                 "request.yaml:3: goal_constraints[0].joint_constraints: joints beside the pose of a link are not"},
                {group + START + "goal_constraints: [{position_constraints: [{link_name: tip, " + BALL_REGION +
                     "}, {link_name: tip}]}]\n",
                 "request.yaml:3: goal_constraints[0].position_constraints[1]: a second one is not supported"},
                {REQUEST + "      - {joint_name: bend, position: 4}\n",
                 "request.yaml:7: goal_constraints[0].joint_constraints[2].joint_name: 'bend' is given twice"},
                {group + "start_state: {joint_state: {name: [turn], position: [0]}}\n" + GOAL,
                 "request.yaml:2: start_state: has no position of joint 'bend'"},
            };
            for (const BrokenProblem &broken : all)
            {
                SCOPED_TRACE(broken.text);
                EXPECT_EQ(messageOf(BALL, broken.text).substr(0, broken.message.size()), broken.message);
            }
        }

        TEST_F(MoveItScene, ErrorsNameTheFileThatTellsTheValue)
        {
            const std::string scene = BALL + "robot_state:\n  joint_state:\n    name: [turn, bend]\n    position:\n",
                              beyond = scene + "      - 0\n      - 0\n", turned = scene + "      - 3.5\n      - 0\n",
                              lacking = BALL + "robot_state: {joint_state: {name: [turn], position: [0]}}\n";
            const std::string slide = "group_name: arm\nstart_state: {joint_state: {name: [slide], position: [0.1]}}\n",
                              none = "group_name: arm\nstart_state: {is_diff: true}\n", absent = "group_name: arm\n";
            for (const std::string &start : {slide, none, absent})
            {
                EXPECT_EQ(messageOf(beyond, start + GOAL), "");
                EXPECT_EQ(
                    messageOf(turned, start + GOAL),
                    "scene.yaml:8: robot_state.joint_state.position[0]: joint 'turn' must be from -3 to 3, not 3.5");
            }
            EXPECT_EQ(messageOf(lacking, slide + GOAL), "request.yaml:2: start_state: has no position of joint 'bend'");
            EXPECT_EQ(messageOf(lacking, none + GOAL), "scene.yaml:4: robot_state: has no position of joint 'bend'");
            EXPECT_EQ(messageOf(lacking, absent + GOAL), "scene.yaml:4: robot_state: has no position of joint 'bend'");
            EXPECT_EQ(messageOf(BALL, absent + GOAL), "request.yaml:1: has no position of joint 'turn'");
            std::string far = REQUEST;
            far.replace(far.find("position: -1"), 12, "position: -9");
            EXPECT_EQ(messageOf(beyond, far),
                      "request.yaml:5: goal_constraints[0].joint_constraints[0].position: joint "
                      "'turn' must be from -3 to 3, not -9");
        }

        TEST_F(MoveItScene, ErrorsTellWhatOfTheSrdfFileIsIgnored)
        {
            struct
            {
                std::string text, replacement, scene, message, note;
            } const all[]{
                {"joint name=\"bend\"", "joint name=\"bnd\"", BALL,
                 "request.yaml:6: goal_constraints[0].joint_constraints[1].position: 'bend' is not a joint of the group: it stays at 0.500000, not 4; ",
                 "broken.srdf:3: <joint>: there is no joint 'bnd'; ignored"},
                {"<group name=\"arm\">", "<group name=\"arm\"><chain base_link=\"bse\" tip_link=\"tip\"/>",
                 OBJECTS + "    - {id: a, header: {frame_id: moon}, planes: [{coef: [0, 0, 1, 0]}]}\n",
                 "scene.yaml:3: world.collision_objects[0].header: there is no fixed frame 'moon'; ",
                 "broken.srdf:3: <chain>: base_link: there is no link 'bse'; ignored"},
                {"child_link=\"base\"", "child_link=\"bse\"",
                 OBJECTS + "    - {id: a, header: {frame_id: world}, planes: [{coef: [0, 0, 1, 0]}]}\n",
                 "scene.yaml:3: world.collision_objects[0].header: there is no fixed frame 'world'; ",
                 "virtual joint 'world_joint' is ignored: its child is not the root link 'base'"},
                {"<group name=\"arm\">", "<passive_joint name=\"bend\"/><group name=\"arm\">", BALL,
                 "request.yaml:6: goal_constraints[0].joint_constraints[1].position: 'bend' is not a joint of the group, ",
                 "since the SRDF file says that it is passive"},
                {"<joint name=\"turn\"/><joint name=\"bend\"/>", "<joint name=\"trn\"/>", BALL,
                 "request.yaml:1: group_name: ", "broken.srdf:3: <joint>: there is no joint 'trn'; ignored"},
            };
            for (const auto &broken : all)
            {
                SCOPED_TRACE(broken.replacement);
                std::string srdf = TWO_LINKS_SRDF;
                srdf.replace(srdf.find(broken.text), broken.text.size(), broken.replacement);
                robot_ = std::make_unique<const ArmFile>(folder_.write("arm.urdf", TWO_LINKS_URDF),
                                                         folder_.write("broken.srdf", srdf));
                const std::string message = messageOf(broken.scene);
                EXPECT_EQ(message.substr(0, broken.message.size()), broken.message);
                const std::size_t note = message.find(broken.note);
                ASSERT_NE(note, std::string::npos) << message;
                EXPECT_EQ(message.find(broken.note, note + 1), std::string::npos) << "told twice: " << message;
            }
        }
    }
}
