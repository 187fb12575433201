"""Goals that are more than one state"""

from __future__ import annotations

from pathlib import Path
from typing import Any, Dict

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
        (lambda: oc.LinkPose("a", [1]), "position: must have 2 or 3 numbers, not 1"),
        (lambda: oc.LinkPose("a", rotation=[0, 0, 0, 2]), "rotation: a quaternion must have length 1"),
        (lambda: oc.LinkPose("a", rotation=np.zeros((3, 3))), "rotation: the matrix must be a rotation"),
        (lambda: oc.LinkPose("a", rotation=np.zeros(3)), r"rotation: must be \(qx, qy, qz, qw\) or a 3 × 3 matrix"),
        (
            lambda: oc.LinkPose("a", [1, 2, 3], position_tolerance=[1, 2]),
            "position_tolerance: must be one number or three",
        ),
        (lambda: oc.plan(two_arms(), goal=tool([0, 0, 0.5])), "a dict from their names to their goals"),
        (lambda: oc.plan(two_arms(), goal={"middle": tool([0, 0, 0.5])}), "there is no robot 'middle'"),
        (lambda: oc.plan(two_arms(), goal={"left": [1.0]}), "goal of robot 'left': must be an array of shape"),
        (lambda: oc.plan(two_arms(), goal={"left": oc.LinkPose("leg", [0, 0, 1])}), "there is no such link"),
        (lambda: oc.LinkPose("hand"), "a position, a rotation or both"),
        (lambda: oc.plan(two_arms(), goal={"left": tool([5, 0, 0])}), "robots.0..goal: no state of 'left' was found"),
        (
            lambda: oc.plan(two_arms(), goal={"left": tool([-0.1, 0, -0.05])}),
            "goal, where no free state was found: robot 'left'",
        ),
        (lambda: oc.plan(two_arms(), objective="arrival"), "arrival needs one state"),
        (lambda: oc.LinkPose("a", [1, 2, 3], rotation_tolerance=1), "a rotation_tolerance needs a rotation"),
        (lambda: oc.LinkPose("a", rotation=[0, 0, 0, 1], point=[1, 2, 3]), "need a position"),
        (lambda: oc.LinkPose("a", [1, 2, 3], position_tolerance=0), "position_tolerance: must be at least 1e-9"),
        (lambda: oc.LinkPose("a", [1, 2, 3], position_tolerance=1e-10), r"at least 1e-9, not \(1e-10, 1e-10, 1e-10\)"),
        (lambda: oc.LinkPose("a", [1, 2, 3], position_tolerance=True), "position_tolerance: must be a list"),
        (lambda: oc.LinkPose("a", [1, 2, 3], position_tolerance="x"), "position_tolerance: "),
        (lambda: oc.LinkPose("a", [1, 2, np.nan]), r"position: must be finite, not \(1, 2, nan\)"),
        (lambda: oc.AnyOf([0.0, 1.0, 2.0]), "AnyOf: takes a list of goals; a number is none"),
        (lambda: oc.LinkPose("a", rotation="x"), "rotation: "),
        (lambda: oc.LinkPose("a", [1, 2, 3], rotation=0.5), "rotation: must be of space"),
        (lambda: oc.LinkPose("a", [1, 2], point=[1, 2, 3]), "point: must be of the plane"),
        (
            lambda: oc.plan(two_arms(), goal={"left": oc.LinkPose("tool_center", [0.1, 0.2])}),
            "goal of link 'tool_center': points must have 3 numbers",
        ),
        (
            lambda: make_arm("arm", [0, 0, 0]).sample_goal([1.0]),  # type: ignore[arg-type]
            "goal: must be a LinkPose, a Zone or an AnyOf",
        ),
    ],
)
def test_errors_name_what_is_wrong(make: object, message: str) -> None:
    with pytest.raises(oc.Error, match=message):
        make()  # type: ignore[operator]


def test_goals_that_are_refused_are_not_remembered() -> None:
    scene = two_arms()
    checker = oc.Checker(scene)
    before = tool_positions(scene, oc.plan(checker, time=10, first=True).path[-1])
    with pytest.raises(oc.Error, match="where no free state was found"):
        oc.plan(checker, goal={"left": tool([-0.1, 0, -0.05])}, start=scene.start + 0.01)
    plan = oc.plan(checker, time=10, first=True)
    assert np.allclose(plan.path[0], scene.start)
    assert np.abs(tool_positions(scene, plan.path[-1]) - before).max() <= 2e-3


@pytest.mark.parametrize("option", [{"objective": "nothing"}, {"callback": 3}])
def test_a_problem_is_remembered_only_if_it_is_planned(room: oc.Scene, option: Dict[str, Any]) -> None:
    checker = oc.Checker(room)
    with pytest.raises((oc.Error, TypeError)):
        oc.plan(checker, start=room.goal, goal=room.start, **option)
    assert (oc.plan(checker, time=10, first=True).path[0] == room.start).all()


def test_an_arm_that_is_there_stays() -> None:
    scene = two_arms()
    checker = oc.Checker(scene)
    end = oc.plan(checker, time=10, first=True).path[-1]
    plan = oc.plan(checker, time=1, start=end)
    assert plan.cost == 0
    assert np.allclose(plan.path, end)


@pytest.mark.parametrize("planner", ["AITstar", "BFMT", "LazyLBTRRT", "pSBL"])
def test_planners_for_one_goal_alone_say_so(planner: str) -> None:
    plan = oc.plan(two_arms(), planner, time=1)
    assert not plan.solved
    assert plan.reason == planner + " plans for a goal of one state alone"


def test_arms_in_the_plane_have_poses_of_two_numbers() -> None:
    scene = oc.scene_from_yaml("""
environment: {min: [-4, -4], max: [4, 4]}
robots:
  - {type: arm, self_collision: false, links: [{length: 1.5, width: 0.1}, {length: 1, width: 0.1}],
     start: [0, 0], goal: [1, 1]}
""")
    checker = oc.Checker(scene)
    goal = oc.LinkPose("link_2", [1, 1], 0.5, point=[1, 0], rotation_tolerance=3.2)
    pose = scene.robots[0].link_pose(oc.plan(checker, time=5, first=True, goal=goal).path[-1], "link_2")
    assert np.abs(pose[:3, :3] @ [1, 0, 0] + pose[:3, 3] - [1, 1, 0]).max() <= 1e-3 + 1e-9
    turned = oc.LinkPose("link_2", rotation=0.5)
    pose = scene.robots[0].link_pose(oc.plan(checker, time=5, first=True, goal=turned).path[-1], "link_2")
    assert abs(np.arctan2(pose[1, 0], pose[0, 0]) - 0.5) <= 0.01 + 1e-9


def test_only_arms_have_links() -> None:
    scene = oc.Scene([0, 0], [1, 1])
    disc = oc.Robot.rigid("disc", oc.Body.disc(0.1), [0, 0], [1, 1], turns=False)
    with pytest.raises(oc.Error, match="robot 'disc': a LinkPose is a goal of arms"):
        scene.add_robot(disc, [0.5, 0.5], tool([0, 0, 1]))


def test_zones_hold_the_position_alone() -> None:
    scene = oc.Scene([0, 0], [10, 10])
    cart = oc.Robot.rigid("cart", oc.Body.box(0.6, 0.3), [0, 0], [10, 10])
    disc = oc.Robot.rigid("disc", oc.Body.disc(0.3), [0, 0], [10, 10], turns=False)
    scene.add_robot(cart, [1, 1, 0], oc.Zone([7, 1], [9, 2]))
    scene.add_robot(disc, [8, 1.5], [1, 1])
    checker = oc.Checker(scene)
    end = oc.plan(checker, time=10, first=True).path[-1]
    assert (end[:2] >= [7, 1]).all() and (end[:2] <= [9, 2]).all()
    assert np.allclose(end[3:], [1, 1])
    # Coordinates and zones in one dict
    end = oc.plan(checker, time=10, first=True, goal={"cart": [2, 2, 1], "disc": oc.Zone([8, 8], [9, 9])}).path[-1]
    assert np.allclose(end[:3], [2, 2, 1])
    assert (end[3:] >= 8).all() and (end[3:] <= 9).all()
    with pytest.raises(oc.Error, match="goal of robot 'cart': must be an array of shape"):
        oc.plan(checker, goal={"cart": [2, 2]})
    with pytest.raises(oc.Error, match="disc: goal: the box must have 2 dimensions"):
        oc.plan(checker, goal={"disc": oc.Zone([1, 1, 1], [2, 2, 2])})
    with pytest.raises(oc.Error, match="arm: goal: the state of an arm is no position"):
        oc.Scene([-2, -2, 0], [2, 2, 2]).add_robot(make_arm("arm", [0, 0, 0]), home(), oc.Zone([0, 0, 0], [1, 1, 1]))
    with pytest.raises(oc.Error, match=r"Zone: must be finite .* not from \(1, 1\) to \(0, 0\)"):
        oc.Zone([1, 1], [0, 0])
    line = oc.Zone([7, 1], (7, 9.5))
    assert (line.low, line.high, repr(line)) == ([7, 1], [7, 9.5], "<Zone from (7, 1) to (7, 9.5)>")
    end = oc.plan(checker, time=10, first=True, goal={"disc": line}).path[-1]
    assert end[3] == 7
    # A zone that is open to one side, as far as the floor goes
    end = oc.plan(checker, time=10, first=True, goal={"disc": oc.Zone([8, -100], [100, 100])}).path[-1]
    assert end[3] >= 8


def test_states_of_a_goal_are_the_inverse_kinematics() -> None:
    arm = make_arm("arm", [0.1, 0, 0])
    goal = oc.LinkPose("tool_center", [0.4, 0.2, 0.5], DOWN, position_tolerance=np.float32(0.01))
    states = arm.sample_goal(goal, count=20, seed=3)
    assert states.shape == (20, 6)
    assert np.array_equal(states, arm.sample_goal(goal, count=20, seed=3))
    assert len(np.unique(states, axis=0)) == 20
    for state in states:
        assert arm.goal_distance(goal, state) == 0
        assert np.abs(arm.link_pose(state, "tool_center")[:3, 3] - [0.4, 0.2, 0.5]).max() <= 0.01
    assert arm.sample_goal(oc.LinkPose("tool_center", [4, 0, 0])).shape == (0, 6)
    away = oc.LinkPose("tool_center", arm.link_pose(states[0], "tool_center")[:3, 3] + [0, 0, 0.3])
    assert arm.goal_distance(away, states[0]) == pytest.approx(0.3 - 0.001)
    assert repr(goal) == "<LinkPose of 'tool_center' at (0.4, 0.2, 0.5), turned>"
    assert goal.link == "tool_center"


def test_a_tool_moves_along_a_line() -> None:
    arm = make_arm("arm", [0.1, 0, 0])
    state = arm.sample_goal(oc.LinkPose("tool_center", [0.4, 0.2, 0.5], DOWN, position_tolerance=1e-5), seed=3)[0]
    for height in np.linspace(0.5, 0.4, 21):
        goal = oc.LinkPose("tool_center", [0.4, 0.2, height], DOWN, position_tolerance=1e-5, rotation_tolerance=1e-4)
        reached = arm.reach(goal, state)
        assert reached is not None and reached.shape == (6,) and arm.goal_distance(goal, reached) == 0
        assert np.abs(reached - state).max() < 0.1
        assert np.abs(arm.link_pose(reached, "tool_center")[:3, 3] - [0.4, 0.2, height]).max() <= 1e-5
        state = reached
    assert arm.reach(oc.LinkPose("tool_center", [4, 0, 0]), state) is None
    with pytest.raises(oc.Error, match="^goal: must be a LinkPose: of others, take sample_goal"):
        arm.reach(oc.AnyOf([state]), state)  # type: ignore[arg-type]
    with pytest.raises(oc.Error, match="^state: must have 6 numbers, not 5$"):
        arm.reach(goal, state[:5])


def test_plans_by_controls_go_to_one_state() -> None:
    scene = oc.Scene([0, 0], [10, 10])
    cart = oc.Robot.unicycle("cart", oc.Body.disc(0.2), [0, 0], [10, 10], 1, 1)
    with pytest.raises(oc.Error, match="robot 'cart': goal must be one state, as the robot has dynamics"):
        scene.add_robot(cart, [1, 1, 0], oc.Zone([7, 7], [9, 9]))
    scene.add_robot(cart, [1, 1, 0], [8, 8, 0])
    with pytest.raises(oc.Error, match="goal: must be one state: plans by controls take no Zone"):
        oc.plan_controls(scene, goal=oc.Zone([7, 7], [9, 9]))  # type: ignore[arg-type]


def test_any_of_several_goals_will_do() -> None:
    scene = oc.Scene([0, 0], [10, 10], "docks")
    scene.add_obstacle(oc.Body.box(2, 2), (8, 8))
    docks = oc.AnyOf([[8, 8, 0], [9, 1, 2 * np.pi + 1], oc.Zone([1, 8], [2, 9])])
    assert repr(docks) == "<AnyOf 3 goals>" and len(docks.goals) == 3
    for name, start in (("a", [1, 1, 0]), ("b", [1, 3, 0])):
        scene.add_robot(oc.Robot.rigid(name, oc.Body.box(0.8, 0.4), [0, 0], [10, 10]), start, docks)
    scene.validate()
    checker = oc.Checker(scene)
    for _ in range(3):
        plan = oc.plan(checker, time=10, first=True)
        for x, y, yaw in plan.path[-1].reshape(2, 3):
            assert np.allclose((x, y, yaw), (9, 1, 1)) or (1 <= x <= 2 and 8 <= y <= 9)
        assert not np.allclose(plan.path[-1][:3], plan.path[-1][3:]), "they take different ones"
    plan = oc.plan(checker, time=10, first=True, goal={"a": oc.AnyOf([[5, 1, 0], [5, 2, 0]])})
    assert plan.path[-1][0] == 5 and plan.path[-1][1] in (1, 2)
    robot = scene.robots[0]
    assert robot.goal_distance(docks, [9, 1, 1]) == 0 and robot.goal_distance(docks, [9, 1.5, 1]) == 0.5
    assert robot.goal_distance(docks, [9, 1, 1 - 2 * np.pi]) == pytest.approx(0, abs=1e-12)
    with pytest.raises(oc.Error, match="^state: all numbers must be finite$"):
        robot.goal_distance(docks, [9, np.nan, 1])
    samples = robot.sample_goal(oc.AnyOf([[5, 1, 0], [7, 2, 0]]), 20)
    assert {tuple(row[:2]) for row in samples} == {(5, 1), (7, 2)}
    wrong: list[tuple[Any, str]] = [
        ([], "^AnyOf: must have one goal at least$"),
        ([[5, 1]], "^a: goal: state 0 must have 3 coordinates, not 2$"),
        ([[5, 1, 0], [5, 11, 0]], "^a: goal: state 1 is outside the bounds$"),
        ([[5, 1, np.nan]], "^a: goal: state 0 must be finite$"),
        ([oc.LinkPose("hand", [1, 1])], "a LinkPose is a goal of arms"),
    ]
    for goals, message in wrong:
        with pytest.raises(oc.Error, match=message):
            robot.sample_goal(oc.AnyOf(goals), 1)
    with pytest.raises(TypeError):
        oc.AnyOf(3)  # type: ignore[arg-type]
