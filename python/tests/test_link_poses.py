"""Goals that are poses of links of arms"""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

import ompl_certificates as oc

ARMS = Path(__file__).parents[2] / "demos" / "scenes" / "arms"
URDF, SRDF = ARMS / "arm6.urdf", ARMS / "arm6.srdf"
DOWN = [0.0, 1.0, 0.0, 0.0]


def make_arm(name: str, base: list[float]) -> oc.Robot:
    return oc.Robot.arm(URDF, SRDF, "arm", name=name, base=base)


def home() -> NDArray[np.float64]:
    return oc.Robot.arm_states(URDF, SRDF, "arm")["ready"]


def tool(position: list[float]) -> oc.LinkPose:
    return oc.LinkPose("tool_center", position, DOWN, rotation_tolerance=[0.05, 0.05, 4.0])


def two_arms() -> oc.Scene:
    scene = oc.Scene([-2, -2, 0], [2, 2, 2])
    scene.add_robot(make_arm("left", [-0.6, 0, 0]), home(), tool([-0.1, 0.2, 0.5]))
    scene.add_robot(make_arm("right", [0.6, 0, 0, 0, 0, 1, 0]), home(), tool([0.1, -0.2, 0.5]))
    scene.add_obstacle(oc.Body.box(3, 3, 0.1), [0, 0, -0.06])
    return scene


def tool_poses(scene: oc.Scene, state: NDArray[np.float64]) -> NDArray[np.float64]:
    joints = np.reshape(state, (-1, 6))
    return np.array([robot.link_pose(values, "tool_center") for robot, values in zip(scene.robots, joints)])


def tool_positions(scene: oc.Scene, state: NDArray[np.float64]) -> NDArray[np.float64]:
    return tool_poses(scene, state)[:, :3, 3]


def test_plans_end_with_the_tools_where_they_shall_be() -> None:
    scene = two_arms()
    scene.validate()
    plan = oc.plan(scene, time=10, first=True)
    assert plan.solved
    assert np.abs(tool_positions(scene, plan.path[-1]) - [[-0.1, 0.2, 0.5], [0.1, -0.2, 0.5]]).max() <= 1e-3 + 1e-9
    # The tools point down.
    assert tool_poses(scene, plan.path[-1])[:, 2, 2].max() < -np.cos(0.08)


def test_one_checker_plans_to_one_pose_after_another() -> None:
    scene = two_arms()
    checker = oc.Checker(scene)
    plan = oc.plan(checker, time=10, first=True)
    before = tool_positions(scene, plan.path[-1])
    goal = oc.LinkPose("tool_center", [-0.3, -0.3, 0.4], position_tolerance=0.01)
    plan = oc.plan(checker, time=10, first=True, start=plan.path[-1], goal={"left": goal})
    after = tool_positions(scene, plan.path[-1])
    assert np.abs(after[0] - [-0.3, -0.3, 0.4]).max() <= 0.01 + 1e-9
    assert np.abs(after[1] - before[1]).max() <= 2e-3, "the other one keeps its goal"
    plan = oc.plan(checker, time=10, first=True, goal=scene.start)
    assert np.allclose(plan.path[-1], scene.start)
    # States are goals again; the last one is remembered.
    plan = oc.plan(checker, time=10, first=True, start=scene.goal)
    assert np.allclose(plan.path[-1], scene.start)


def test_a_single_arm_needs_no_dict() -> None:
    scene = two_arms().first_robots(1)
    checker = oc.Checker(scene)
    tip = np.array([0.0, 0.0, 0.05])
    goal = oc.LinkPose("tool_center", [-0.2, 0.1, 0.6], point=tip)
    plan = oc.plan(checker, time=10, first=True, goal=goal)
    pose = scene.robots[0].link_pose(plan.path[-1], "tool_center")
    assert np.abs(pose[:3, :3] @ tip + pose[:3, 3] - [-0.2, 0.1, 0.6]).max() <= 1e-3 + 1e-9
    turned = oc.LinkPose("tool_center", rotation=np.diag([1.0, -1.0, -1.0]))
    plan = oc.plan(checker, time=10, first=True, goal=turned)
    rotation = scene.robots[0].link_pose(plan.path[-1], "tool_center")[:3, :3]
    assert np.abs(rotation - np.diag([1.0, -1.0, -1.0])).max() <= 0.02


@pytest.mark.parametrize(
    "make, message",
    [
        (lambda: oc.LinkPose("a", [1, 2]), "position: must have 3 numbers, not 2"),
        (lambda: oc.LinkPose("a", rotation=[0, 0, 0, 2]), "rotation: a quaternion must have length 1"),
        (lambda: oc.LinkPose("a", rotation=np.zeros((3, 3))), "rotation: the matrix must be a rotation"),
        (lambda: oc.LinkPose("a", rotation=np.zeros(3)), r"rotation: must be \(qx, qy, qz, qw\) or a 3 × 3 matrix"),
        (lambda: oc.LinkPose("a", [1, 2, 3], position_tolerance=[1, 2]), "position_tolerance: must have 3 numbers"),
        (lambda: oc.plan(two_arms(), goal=tool([0, 0, 0.5])), "a dict from their names to LinkPoses"),
        (lambda: oc.plan(two_arms(), goal={"middle": tool([0, 0, 0.5])}), "there is no robot 'middle'"),
        (
            lambda: oc.plan(two_arms(), goal={"left": home()}),  # type: ignore[dict-item]
            "of robot 'left' must be a LinkPose",
        ),
        (lambda: oc.plan(two_arms(), goal={"left": oc.LinkPose("leg", [0, 0, 1])}), "there is no such link"),
        (lambda: oc.plan(two_arms(), goal={"left": oc.LinkPose("hand")}), "a position, a rotation or both"),
        (lambda: oc.plan(two_arms(), goal={"left": tool([5, 0, 0])}), "robots.0..goal: no state of 'left' was found"),
        (lambda: oc.plan(two_arms(), goal={"left": tool([-0.1, 0, -0.05])}), "goal: no free state was found; in one"),
        (lambda: oc.plan(two_arms(), objective="arrival"), "arrival needs one state"),
    ],
)
def test_errors_name_what_is_wrong(make: object, message: str) -> None:
    with pytest.raises(oc.Error, match=message):
        make()  # type: ignore[operator]


def test_only_arms_have_links() -> None:
    scene = oc.Scene([0, 0], [1, 1])
    disc = oc.Robot.rigid("disc", oc.Body.disc(0.1), [0, 0], [1, 1], turns=False)
    with pytest.raises(oc.Error, match="robot 'disc': a LinkPose is a goal of arms"):
        scene.add_robot(disc, [0.5, 0.5], tool([0, 0, 1]))
