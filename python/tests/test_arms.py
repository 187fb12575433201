"""Arms from URDF files"""

import pathlib
import re
from typing import Any, List

import numpy as np
import ompl_certificates as oc
import pytest


def test_arm_comes_from_urdf(scenes: pathlib.Path) -> None:
    arm = oc.Robot.arm(str(scenes / "arms" / "arm6.urdf"), str(scenes / "arms" / "arm6.srdf"), "arm")
    assert len(arm.coordinates) == 6
    poses = arm.poses([0] * 6)
    assert poses.shape == (len(arm.bodies), 4, 4)
    assert np.allclose(poses[:, 3], [0, 0, 0, 1])
    scene = oc.Scene([-2] * 3, [2] * 3, "cell")
    scene.add_robot(arm, [0] * 6, [0.5] * 6)
    assert oc.plan(scene, time=5).solved
    scene.add_obstacle(oc.Body.sphere(0.1), poses[-1])
    with pytest.raises(oc.Error, match="^cell: robots"):
        scene.validate()
    assert not oc.Checker(scene).is_valid([0] * 6)


def test_arms_have_states_with_names(scenes: pathlib.Path) -> None:
    urdf, srdf = (scenes / "arms" / f"arm6.{ending}" for ending in ("urdf", "srdf"))
    states = oc.Robot.arm_states(urdf, srdf, "arm")
    text = srdf.read_text()
    assert set(states) == set(re.findall(r'<group_state name="(\w+)" group="arm"', text)) and len(states) > 1
    scene = oc.Scene([-2] * 3, [2] * 3, "cell")
    arm = oc.Robot.arm(urdf, srdf, "arm")
    for name, state in states.items():
        assert state.shape == (6,)
        described = re.search(rf'name="{name}" group="arm".*?</group_state>', text, re.S)
        assert described
        values = dict(re.findall(r'<joint name="(\w+)" value="([^"]+)"', described[0]))
        assert [float(values[joint]) for joint in arm.coordinates] == state.tolist()
    first, second = list(states.values())[:2]
    scene.add_robot(arm, first, second)
    scene.validate()
    with pytest.raises(oc.Error, match="group"):
        oc.Robot.arm_states(urdf, srdf, "leg")


def test_arms_carry_bodies(scenes: pathlib.Path) -> None:
    urdf, srdf = (scenes / "arms" / f"arm6.{ending}" for ending in ("urdf", "srdf"))
    bar = oc.AttachedBody("bar", "palm", oc.Body.sphere(0.05), (0, 0, 0.3), touch_links=["left_finger"])
    assert repr(bar) == "<AttachedBody 'bar' on 'palm'>"
    with pytest.raises(oc.Error, match="^bounds: the group has no planar or floating joint"):
        oc.Robot.arm(urdf, srdf, "arm", bounds=([0, 0, 0], [1, 1, 1]))
    bare = oc.Robot.arm(urdf, srdf, "arm")
    arm = oc.Robot.arm(urdf, srdf, "arm", attached=[bar])
    assert arm.links == bare.links + ["bar"]
    state = [0.1] * 6
    assert np.allclose(arm.poses(state)[-1], arm.link_pose(state, "palm") @ np.array(
        [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0.3], [0, 0, 0, 1]]))
    with pytest.raises(oc.Error, match="'tool'"):
        arm.link_pose(state, "tool")
    with pytest.raises(oc.Error, match="'none'"):
        oc.Robot.arm(urdf, srdf, "arm", attached=[oc.AttachedBody("bar", "none", oc.Body.sphere(0.05))])
    with pytest.raises(oc.Error, match="space"):
        oc.AttachedBody("bar", "palm", oc.Body.disc(0.05))
    disc = oc.Robot.rigid("disc", oc.Body.disc(0.1), [0, 0], [1, 1])
    with pytest.raises(oc.Error, match="'disc'"):
        disc.links


def test_two_arms_of_a_torso_are_two_robots(scenes: pathlib.Path) -> None:
    files = scenes / "arms" / "twin.urdf", scenes / "arms" / "twin.srdf"
    told = oc.load_scene(scenes / "arms" / "twin_team.yaml")
    scene = oc.Scene([-0.6, -1, -0.1], [1, 1, 1.4], "twin")
    arms = oc.Robot.arms(*files, {"left": "left", "right": "right"})
    assert [arm.name for arm in arms] == ["left", "right"]
    for arm, part in zip(arms, (slice(0, 3), slice(3, 6))):
        scene.add_robot(arm, told.start[part], told.goal[part])
    assert scene.coordinates == told.coordinates
    scene.validate()
    # Their verdicts are those of the one robot that they are, both arms and the torso checked against each other.
    both = oc.Scene([-0.6, -1, -0.1], [1, 1, 1.4], "both")
    both.add_robot(oc.Robot.arm(*files, "both"), told.start, told.goal)
    low, high = scene.state_bounds
    states = np.random.default_rng(1).uniform(low, high, (2000, 6))
    order = [[name.split(".")[1] for name in scene.coordinates].index(name) for name in both.robots[0].coordinates]
    valid = oc.Checker(scene).is_valid(states)
    assert 0 < valid.sum() < len(states)
    assert (valid == oc.Checker(both).is_valid(states[:, order])).all()
    with pytest.raises(oc.Error, match="'middle'"):
        oc.Robot.arms(*files, {"left": "left", "right": "middle"})
    with pytest.raises(oc.Error, match="left"):
        oc.Robot.arms(*files, {"left": "left", "right": "left"})


def test_links_may_touch_obstacles(scenes: pathlib.Path) -> None:
    urdf, srdf = (scenes / "arms" / f"arm6.{ending}" for ending in ("urdf", "srdf"))
    states = oc.Robot.arm_states(urdf, srdf, "arm")

    def checker(**settings: Any) -> oc.Checker:
        scene = oc.Scene([-1, -1, 0], [1, 1, 2])
        scene.add_obstacle(oc.Body.box(2, 2, 0.1))
        scene.add_robot(oc.Robot.arm(urdf, srdf, "arm", **settings), states["ready"], states["upright"])
        return oc.Checker(scene)

    assert not checker().is_valid(states["ready"])
    assert checker(may_touch_obstacles=["base"]).is_valid(states["ready"])
    with pytest.raises(oc.Error, match="'none'"):
        checker(may_touch_obstacles=["none"])


def test_arms_find_packages_and_warn(tmp_path: pathlib.Path) -> None:
    (tmp_path / "far").mkdir()
    (tmp_path / "far" / "mesh.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
    (tmp_path / "near").mkdir()
    urdf, srdf = tmp_path / "near" / "a.urdf", tmp_path / "near" / "a.srdf"
    mesh = "<geometry><mesh filename='package://far_parts/mesh.obj'/></geometry>"
    urdf.write_text(
        f"<robot name='a'><link name='base'/><link name='b'><collision>{mesh}</collision>"
        "<visual><geometry><sphere radius='1'/></geometry></visual></link>"
        "<joint name='j' type='revolute'><parent link='base'/><child link='b'/><axis xyz='0 0 1'/>"
        "<limit lower='-1' upper='1' effort='1' velocity='1'/></joint></robot>")
    srdf.write_text("<robot name='a'><group name='g'><joint name='j'/><joint name='typo'/></group></robot>")
    packages = {"far_parts": tmp_path / "far"}
    with pytest.warns(UserWarning, match="'typo'"):
        arm = oc.Robot.arm(urdf, srdf, "g", packages=packages)
    assert arm.links == ["b"]
    with pytest.raises(oc.Error, match="package 'far_parts'"):
        oc.Robot.arm(urdf, srdf, "g")
    with pytest.warns(UserWarning):
        ball = oc.Robot.arm(urdf, srdf, "g", packages=packages, visuals=True)
    assert ball.bodies[0].bounding_radius == pytest.approx(1)


def test_arms_refuse_what_they_would_ignore(scenes: pathlib.Path) -> None:
    urdf, srdf = (scenes / "arms" / f"arm6.{ending}" for ending in ("urdf", "srdf"))
    with pytest.raises(oc.Error, match="joint 'elbow' is in the group, so states tell its value; it cannot be fixed$"):
        oc.Robot.arm(urdf, srdf, "arm", joint_values={"elbow": 9})
    with pytest.raises(oc.Error, match="arm6.srdf: the group is missing; there are .*'arm'"):
        oc.Robot.arm(urdf, srdf)


def test_links_keep_a_distance(scenes: pathlib.Path) -> None:
    file = oc.ArmFile(scenes / "arms/arm6.urdf", scenes / "arms/arm6.srdf")
    assert {body.padding for body in file.arm("arm").bodies} == {0.0}
    assert {body.padding for body in file.arm("arm", padding=0.02).bodies} == {0.02}
    paddings = [body.padding for body in file.arm("arm", padding={"palm": 0.05}).bodies]
    assert sorted(set(paddings)) == [0.0, 0.05] and paddings.count(0.05) == 1
    cup = oc.AttachedBody("cup", "palm", oc.Body.sphere(0.03).padded(0.04), (0, 0, 0.2))
    assert sorted({body.padding for body in file.arm("arm", attached=[cup]).bodies}) == [0.0, 0.04]
    # More for the others is not less for the cup.
    assert sorted({body.padding for body in file.arm("arm", attached=[cup], padding=0.02).bodies}) == [0.02, 0.04]
    for none in (-0.05, float("nan"), float("inf")):
        with pytest.raises(oc.Error, match="must be finite and not negative"):
            file.arm("arm", padding=none)
    with pytest.raises(oc.Error, match="padding: there is no link 'plam'; did you mean palm"):
        file.arm("arm", padding={"plam": 0.05})


def test_arms_of_one_file_share_its_meshes(scenes: pathlib.Path) -> None:
    arms = scenes / "arms"
    file = oc.ArmFile(arms / "arm6.urdf", arms / "arm6.srdf")
    assert file.groups == ["arm", "gripper"] and len(file.joints("arm")) == 6
    ready = file.states("arm")["ready"]
    known = oc.Robot.arm_states(arms / "arm6.urdf", arms / "arm6.srdf", "arm")
    assert set(file.states("arm")) == set(known) and (known["ready"] == ready).all()
    arm, same = file.arm("arm", name="picker"), oc.Robot.arm(arms / "arm6.urdf", arms / "arm6.srdf", "arm")
    assert arm.name == "picker" and same.name == file.name
    assert np.array_equal(arm.poses(ready), same.poses(ready)) and arm.links == same.links
    (alone,) = file.arms({"one": "arm"}, base=[1, 0, 0])
    assert np.allclose(alone.link_pose(ready, "palm")[:3, 3], arm.link_pose(ready, "palm")[:3, 3] + [1, 0, 0])
    with pytest.raises(oc.Error, match="there is no group 'leg'"):
        file.arm("leg")


def test_some_links_may_touch_an_obstacle(scenes: pathlib.Path) -> None:
    file = oc.ArmFile(scenes / "arms" / "arm6.urdf", scenes / "arms" / "arm6.srdf")
    ready = file.states("arm")["ready"]
    hold = np.eye(4)
    hold[2, 3] = 0.2
    rod = oc.AttachedBody("rod", "palm", oc.Body.box(0.02, 0.02, 0.3), hold, ["left_finger", "right_finger"])
    end = file.arm("arm").link_pose(ready, "palm") @ [0, 0, 0.34, 1]

    def told(touch_links: List[str], names: List[str]) -> str:
        block = oc.TouchableObstacle("block", oc.Body.sphere(0.03), end[:3], touch_links)
        assert repr(block) == "<TouchableObstacle 'block'>"
        scene = oc.Scene([-2, -2, -2], [2, 2, 2])
        for i, name in enumerate(names):
            arm = file.arm("arm", name=name, base=[0, -1.5 * i, 0], attached=[rod], touchable=[block])
            scene.add_robot(arm, ready, ready)
        return oc.Checker(scene).describe_collision(scene.start)

    assert told([], ["a"]) == "robot 'a' touches obstacle 'block' with link 'rod'"
    assert told(["rod"], ["a"]) == told(["rod"], ["a", "b"]) == ""
    with pytest.raises(oc.Error, match="touch links of obstacle 'block': there is no link 'rood'; did you mean rod"):
        told(["rood"], ["a"])
    with pytest.raises(oc.Error, match="^body: must be a body in space"):
        oc.TouchableObstacle("flat", oc.Body.disc(1))
