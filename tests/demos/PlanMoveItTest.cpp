#include "demos/PlanTeam.h"

TEST_F(PlanTeam, readsPlanningScenesOfMoveIt)
{
    const std::string arms = OMPL_CERTIFICATES_SOURCE_DIR "/demos/scenes/arms/";
    writeFile(folder_ / "moveit.yaml",
              "world:\n  collision_objects:\n    - {id: ball, primitives: [{type: sphere, dimensions: [0.1]}], "
              "primitive_poses: [{position: [0, 3, 0]}]}\n");
    const std::string start =
        "group_name: arm\nallowed_planning_time: 20\n"
        "start_state: {joint_state: {name: [waist, shoulder_lift, elbow, wrist_roll, wrist_bend, flange], "
        "position: [0, -0.6, 1.9, 0, 0.3, 0]}}\n";
    std::string goal = "goal_constraints:\n  - joint_constraints:\n";
    for (const char *joint : {"waist", "shoulder_lift", "elbow", "wrist_roll", "wrist_bend", "flange"})
        goal += std::string("      - {joint_name: ") + joint + ", position: 0}\n";
    writeFile(folder_ / "request.yaml", start + goal);
    const std::vector<std::string> files{"--request", folder_ / "request.yaml", "--urdf", arms + "arm6.urdf",
                                         "--srdf",    arms + "arm6.srdf"};
    const auto planWith = [&](const std::string &scene, std::size_t count)
    {
        std::vector<std::string> arguments{scene};
        arguments.insert(arguments.end(), files.begin(), files.begin() + static_cast<std::ptrdiff_t>(count));
        return plan(arguments);
    };
    EXPECT_EQ(planWith(folder_ / "moveit.yaml", 6), 0) << errors_;
    EXPECT_EQ(report_["planner"], "RRTConnect");
    EXPECT_EQ(report_["solved"], true);
    EXPECT_EQ(planWith(folder_ / "moveit.yaml", 4), 2);
    EXPECT_NE(errors_.find("needs --srdf"), std::string::npos) << errors_;
    EXPECT_EQ(planWith(folder_ / "moveit.yaml", 2), 2);
    EXPECT_NE(errors_.find("needs --urdf"), std::string::npos) << errors_;
    EXPECT_EQ(planWith(folder_ / "moveit.yaml", 0), 2);
    EXPECT_NE(errors_.find("needs --request"), std::string::npos) << errors_;
    EXPECT_EQ(planWith(folder_.write("torn.yaml", "world:\n  collision_objects: [\n"), 2), 2);
    EXPECT_NE(errors_.find("torn.yaml:3: not valid YAML"), std::string::npos) << errors_;
    EXPECT_EQ(planWith(scene(), 2), 2);
    EXPECT_NE(errors_.find("--request: is for planning scenes of MoveIt"), std::string::npos) << errors_;
    // The request in place of the scene
    EXPECT_EQ(planWith(files[1], 6), 2);
    EXPECT_NE(errors_.find("--request: is for planning scenes of MoveIt, which " + files[1] + " is not"),
              std::string::npos)
        << errors_;
    // A mesh in a package that is elsewhere
    std::filesystem::create_directories(folder_ / "parts");
    folder_.write("parts/a.obj", "v 0 0 0\nv 0.1 0 0\nv 0 0.1 0\nf 1 2 3\n");
    const std::string urdf =
        folder_.write("mesh.urdf",
                      "<robot name='arm'><link name='base'/><link name='tip'><collision><geometry><mesh "
                      "filename='package://parts_description/a.obj'/></geometry></collision></link><joint name='j' "
                      "type='revolute'><parent link='base'/><child link='tip'/><limit lower='-1' upper='1' effort='1' "
                      "velocity='1'/></joint></robot>");
    const std::string srdf =
        folder_.write("mesh.srdf", "<robot name='arm'><group name='arm'><joint name='j'/></group></robot>");
    writeFile(folder_ / "mesh.yaml",
              "group_name: arm\nstart_state: {joint_state: {name: [j], position: [0]}}\n"
              "goal_constraints: [{joint_constraints: [{joint_name: j, position: 1}]}]\n");
    const auto planWithPackage = [&](const std::vector<std::string> &option)
    {
        std::vector<std::string> arguments{folder_ / "moveit.yaml",
                                           "--time",
                                           "20",
                                           "--request",
                                           folder_ / "mesh.yaml",
                                           "--urdf",
                                           urdf,
                                           "--srdf",
                                           srdf};
        arguments.insert(arguments.end(), option.begin(), option.end());
        return plan(arguments);
    };
    EXPECT_EQ(planWithPackage({"--package", "parts_description=" + (folder_ / "parts")}), 0) << errors_;
    EXPECT_EQ(planWithPackage({}), 2);
    EXPECT_NE(errors_.find("tell where package 'parts_description' is"), std::string::npos) << errors_;
    for (const char *const option : {"parts_description", "=parts", "parts_description="})
    {
        EXPECT_EQ(planWithPackage({"--package", option}), 2);
        EXPECT_NE(errors_.find("--package: must be NAME=FOLDER"), std::string::npos) << errors_;
    }
    EXPECT_EQ(plan({scene(), "--package", "a=b"}), 2);
    EXPECT_NE(errors_.find("--package: is for planning scenes of MoveIt"), std::string::npos) << errors_;
    writeFile(folder_ / "request.yaml", start);
    EXPECT_EQ(planWith(folder_ / "moveit.yaml", 6), 2);
    EXPECT_NE(errors_.find("request.yaml:1: goal_constraints: missing"), std::string::npos) << errors_;
}
