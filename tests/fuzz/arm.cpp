// Arms: the first byte chooses which file of an arm's problem the rest is, the URDF file, the SRDF file, or MoveIt's
// scene or request. The other files are in order.
#include "FuzzFile.h"

#include "ompl_certificates/scene/MoveItFiles.h"

using namespace ompl_certificates;

namespace
{
    const char *const URDF = R"(<robot name="two_links">
  <link name="base"><collision><geometry><box size="0.1 0.1 0.1"/></geometry></collision></link>
  <link name="upper"><collision><origin xyz="0.25 0 0"/><geometry><box size="0.5 0.1 0.1"/></geometry></collision></link>
  <link name="lower"><collision><origin xyz="0.2 0 0"/><geometry><mesh filename="mesh.obj"/></geometry></collision></link>
  <link name="tip"><collision><geometry><sphere radius="0.03"/></geometry></collision></link>
  <joint name="turn" type="revolute"><parent link="base"/><child link="upper"/><origin xyz="0 0 0.2"/>
    <axis xyz="0 0 1"/><limit lower="-3" upper="3" effort="1" velocity="1"/></joint>
  <joint name="bend" type="continuous"><parent link="upper"/><child link="lower"/><origin xyz="0.5 0 0.12"/></joint>
  <joint name="slide" type="prismatic"><parent link="lower"/><child link="tip"/><origin xyz="0.4 0 0"/>
    <limit lower="0" upper="0.2" effort="1" velocity="1"/></joint>
</robot>)";

    const char *const SRDF =
        R"(<robot name="two_links"><group name="arm"><joint name="turn"/><joint name="bend"/></group>
  <disable_collisions link1="base" link2="upper"/><disable_collisions link1="upper" link2="lower"/></robot>)";

    const char *const SCENE =
        "world:\n  collision_objects:\n    - {id: ball, primitives: [{type: sphere, dimensions: [0.1]}]"
        ", primitive_poses: [{position: [0, 2, 0]}]}\n";

    const char *const REQUEST =
        "group_name: arm\nstart_state: {joint_state: {name: [turn, bend], position: [1, 0]}}\n"
        "goal_constraints:\n  - joint_constraints: [{joint_name: turn, position: 0}, "
        "{joint_name: bend, position: 0}]\n";

    void makeArms(const ArmFile &file)
    {
        ArmFile::ArmSettings settings;
        settings.bounds = ompl::base::RealVectorBounds(3);
        settings.bounds->setLow(-1.0);
        settings.bounds->setHigh(1.0);
        for (const std::string &group : file.getGroups())
        {
            for (const std::string &state : file.getStates(group))
                file.getState(group, state);
            file.makeArm("arm", group, settings);
        }
    }
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    static const bool filesAreThere = []
    {
        fuzz::folder().write("mesh.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 2 4\nf 1 3 4\nf 2 3 4\n");
        fuzz::folder().write("arm.urdf", URDF);
        fuzz::folder().write("arm.srdf", SRDF);
        fuzz::folder().write("scene.yaml", SCENE);
        fuzz::folder().write("request.yaml", REQUEST);
        return true;
    }();
    if (size == 0 || !filesAreThere)
        return 0;
    const std::string urdf = fuzz::folder() / "arm.urdf", srdf = fuzz::folder() / "arm.srdf";
    static const ArmFile arm(urdf, srdf);
    const int kind = data[0] % 4;
    static const char *const names[] = {"f.urdf", "f.srdf", "f_scene.yaml", "f_request.yaml"};
    const std::string file = fuzz::folder().write(names[kind], fuzz::textOf(data + 1, size - 1));
    return fuzz::run(
        [&]
        {
            if (kind == 0)
                makeArms(ArmFile(file));
            else if (kind == 1)
                makeArms(ArmFile(urdf, file));
            else if (isMoveItScene(file) || kind == 3)
                readMoveItFiles(kind == 2 ? file : fuzz::folder() / "scene.yaml",
                                kind == 3 ? file : fuzz::folder() / "request.yaml", arm)
                    .scene.validate();
        });
}
