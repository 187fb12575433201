"""What arguments may be, and which are refused"""

from __future__ import annotations

import types
from pathlib import Path
from typing import Any, Callable, List, Tuple

import numpy as np
import pytest
from conftest import TurnsDuring

import ompl_certificates as oc

ARMS = Path(__file__).parents[2] / "demos" / "scenes" / "arms"
URDF, SRDF = ARMS / "arm6.urdf", ARMS / "arm6.srdf"
of = types.MappingProxyType


def test_mappings_need_not_be_dicts(room: oc.Scene) -> None:
    checker = oc.Checker(room)
    goal = [9, 1, 1, 1]
    plan = oc.plan(checker, "RRTConnect", time=20, first=True, goal=of({"left": goal[:2], "right": goal[2:]}))
    assert plan.solved and np.allclose(plan.path[-1], goal)
    with pytest.raises(oc.Error, match="^goal: there is no robot 'lift'; did you mean left"):
        oc.plan(checker, goal=of({"lift": [1, 1]}))
    checker.change_obstacles(move=of({0: (5, 8)}))
    assert checker.is_valid([5, 5, 1, 1]) and not checker.is_valid([5, 8, 1, 1])
    finger = of({"finger": 0.03})
    arm = oc.Robot.arm(URDF, SRDF, "arm", joint_values=finger, packages=of({}), padding=of({"palm": 0.05}))
    assert [body.padding for body in arm.bodies].count(0.05) == 1
    assert [robot.name for robot in oc.Robot.arms(URDF, SRDF, of({"only": "arm"}))] == ["only"]
    wrong: Any = ["only"]
    with pytest.raises(TypeError, match="groups: must be a dict"):
        oc.Robot.arms(URDF, SRDF, wrong)


def test_goals_are_not_none(room: oc.Scene) -> None:
    goal: Any = {"left": None}
    with pytest.raises(oc.Error, match="^goal of robot 'left': must not be None: leave out robots that keep"):
        oc.plan(room, goal=goal)


def test_a_cloud_that_has_seen_nothing_has_a_radius() -> None:
    scene = oc.Scene([0, 0, 0], [10, 10, 10])
    cloud = scene.add_cloud(np.empty((0, 3)), radius=0.5)
    scene.add_robot(oc.Robot.rigid("ball", oc.Body.sphere(1), [0] * 3, [10] * 3, turns=False), [1, 1, 1], [9, 1, 1])
    checker = oc.Checker(scene)
    checker.change_cloud(cloud, insert=[[5, 5, 5]])
    assert checker.is_valid([[5, 5, 6.49], [5, 5, 6.51]]).tolist() == [False, True]


def test_points_are_of_the_workspace_of_a_body() -> None:
    box, mesh = oc.Body.box(2, 2), oc.Body.mesh([[0, 0, 1], [1, 0, 1], [0, 1, 1]], [[0, 1, 2]], dimension=2)
    assert box.signed_distance([[0, 0], [3, 0]]).tolist() == [-1, 2]
    for body in (box, mesh):
        with pytest.raises(oc.Error, match=r"^points: must be an array of shape \(n, 2\), not \(1, 3\)$"):
            body.signed_distance([[0, 0, 5]])


def test_empty_lists_of_points_have_no_robots(room: oc.Scene) -> None:
    checker = oc.Checker(room)
    assert checker.without_robots([], room.start).shape == (0, 2)
    assert checker.find_robots([], room.start).shape == (0,)
    assert checker.find_robots(np.zeros((0, 2)), room.start).shape == (0,)
    with pytest.raises(oc.Error, match=r"^points: must have the shape \(n, 2\) or \(n, 3\), not \(2,\)$"):
        checker.find_robots([1, 2], room.start)


def test_masked_faces_and_missing_counts_are_refused() -> None:
    vertices = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]
    faces: Any = np.ma.array([[0, 1, 2], [0, 1, 3]], mask=[[0, 0, 0], [1, 1, 1]])  # type: ignore[no-untyped-call]
    pushed = oc.Scene([0, 0], [10, 4], "pushed")
    puck = oc.Robot.integrator("puck", oc.Body.disc(0.3), [0, 0], [10, 4], velocity=1.0)
    pushed.add_robot(puck, [1, 2], [9, 2])
    none: Any = None
    cases: List[Tuple[Callable[[], object], str]] = [
        (lambda: oc.Body.mesh(vertices, faces), "^faces: must not be a masked array"),
        (lambda: oc.plan_controls(pushed, max_steps=none), "^max_steps: must be a whole number, not None$"),
        (lambda: oc.plan_controls(pushed, min_steps=none), "^min_steps: must be a whole number, not None$"),
    ]
    for call, message in cases:
        with pytest.raises(oc.Error, match=message):
            call()


def test_python_runs_while_a_cloud_is_read(tmp_path: Path, turns_during: TurnsDuring) -> None:
    file = tmp_path / "cloud.xyz"
    np.savetxt(file, np.random.default_rng(1).uniform(0, 10, (150000, 3)), fmt="%.9f")
    scene = oc.Scene([0] * 3, [10] * 3)
    # Beside the file, the cloud is made: that never kept Python from running.
    assert turns_during(lambda: scene.add_cloud_file(file, 0.01, cell=9.0)) > 0.5 * turns_during(
        lambda: oc.load_cloud(file)
    )


class Lazy:
    """Raises something when an array is made of it, as tensors that are not in this computer's memory do"""

    def __init__(self, error: BaseException) -> None:
        self.error = error

    def __array__(self, *args: Any, **options: Any) -> np.ndarray[Any, Any]:
        raise self.error


def test_what_is_raised_while_arrays_are_made_is_told(room: oc.Scene) -> None:
    checker = oc.Checker(room)
    calls: List[Callable[[Any], object]] = [
        checker.is_valid,
        lambda array: checker.add_cloud(array, 0.1),
        lambda array: checker.add_grid(array, 0.1),
        lambda array: oc.Body.mesh(np.eye(3), array),
        lambda array: room.add_obstacle(oc.Body.disc(1), array),
        lambda array: oc.Scene(array, [1, 1]),
        lambda array: oc.Robot.rigid("disc", oc.Body.disc(1), [0, 0], array),
        lambda array: oc.LinkPose("hand", array),
        lambda array: oc.LinkPose("hand", rotation=array),
        lambda array: oc.plan(checker, start=array),
    ]
    for call in calls:
        for kind in (KeyboardInterrupt, MemoryError, SystemExit, RuntimeError):
            with pytest.raises(kind, match="^why$") as raised:
                call(Lazy(kind("why")))
            assert raised.type is kind
        with pytest.raises(oc.Error, match="^[a-z]+: must be .*: can't convert a device's tensor$"):
            call(Lazy(TypeError("can't convert a device's tensor\nSee there.")))
    with pytest.raises(oc.Error, match="^states: must be numbers: .* not 'object'$"):
        checker.is_valid(np.array([1, object(), 1, 1]))


def test_empty_lists_of_states_have_empty_answers(room: oc.Scene) -> None:
    checker = oc.Checker(room)
    assert checker.is_valid([]).shape == checker.clearance([]).shape == checker.check_motions([], []).shape == (0,)
    assert checker.is_valid([]).dtype == bool
    assert checker.distance([], []).shape == (0,) and checker.interpolate([], [], []).shape == (0, 4)
    for call in (checker.prove, checker.describe_collision):
        with pytest.raises(oc.Error):
            call([])


def test_numbers_of_numpy_are_numbers(room: oc.Scene) -> None:
    half, two = np.float32(0.5), np.int64(2)
    box = oc.Body.box(two, half).padded(np.float16(0.25))
    assert box.padding == 0.25 and oc.Body.disc(np.int32(1)).bounding_radius == 1
    many: Tuple[Any, ...] = (two, (-1, half), [-1, 1], np.array([-1.0, 2.0]))
    for limits in many:
        assert oc.Robot.unicycle("cart", box, [0, 0], [1, 1], limits, 1.0).control_names
    checker = oc.Checker(room)
    checker.change_obstacles(move={np.int64(0): (5, 8)})
    checker.change_obstacles(remove=np.array([0]))
    checker.change_cloud(checker.add_cloud([[5, 5]], half), clear=np.array([[0, 0], [9, 9]]))
    assert oc.plan(checker, "RRTConnect", time=np.float32(20), seed=two, iterations=np.int64(10000)).solved


def test_bools_are_no_numbers_of_obstacles(room: oc.Scene) -> None:
    checker = oc.Checker(room)
    cloud = checker.add_cloud([[1, 9]], 0.1)
    calls: List[Callable[[Any], object]] = [
        checker.remove_obstacle,
        lambda number: checker.move_obstacle(number, (5, 8)),
        lambda number: checker.change_obstacles(move={number: (5, 8)}),
        lambda number: checker.change_obstacles(remove=[number]),
        lambda number: checker.change_cloud(number, insert=[[5, 8]]),
        checker.cloud_points,
    ]
    for call in calls:
        for wrong in (False, True, np.bool_(False), -1):
            with pytest.raises(TypeError):
                call(wrong)
    counts: List[Callable[[Any], object]] = [
        room.first_robots,
        checker.set_max_certificates,
        lambda count: room.robots[0].sample_goal(oc.Zone([1, 1], [2, 2]), count),
    ]
    for count in counts:
        for wrong in (True, np.bool_(True), -1):
            with pytest.raises(TypeError):
                count(wrong)
    for name in ("seed", "iterations"):
        for wrong in (True, np.bool_(True)):
            with pytest.raises(oc.Error, match=f"^{name}: must be a whole number, not "):
                oc.plan(room, time=1, **{name: wrong})  # type: ignore[arg-type]
    assert cloud == 0 and not checker.is_valid([5, 5, 1, 1])
    with pytest.raises(oc.Error, match="^remove: obstacle 0 is there twice$"):
        checker.change_obstacles(remove=[0, 0])


def test_wrong_arguments_are_called_by_their_names(room: oc.Scene, tmp_path: Path) -> None:
    none: Any
    for none in (False, 0, [], {}, "", 5):
        with pytest.raises(oc.Error, match="^planner: must be the name of one, not "):
            oc.plan(room, none, time=0.1)
        with pytest.raises(oc.Error, match="^planner: must be the name of one, not "):
            oc.plan_controls(room, none, time=0.1)
    wrong: Any = {1: 1}
    with pytest.raises(oc.Error, match="^parameters: must be a dict .*, and names must be texts, not 1$"):
        oc.plan(room, time=0.1, parameters=wrong)
    far = np.array([[0, 1, 2**64 - 1]], dtype=np.uint64)
    with pytest.raises(oc.Error, match="^faces: there is no vertex 18446744073709551615$"):
        oc.Body.mesh(np.eye(3), far)
    with pytest.raises(oc.Error, match="cells of size 1e-12 to the origin$"):
        room.add_cloud([[1, 1], [9, 1]], 0.1, cell=1e-12)
    assert repr(oc.AnyOf([[1, 2]])) == "<AnyOf 1 goal>" and repr(oc.AnyOf([[1, 2]] * 2)) == "<AnyOf 2 goals>"
    checker = oc.Checker(room)
    checker.save_certificates(tmp_path / "known.bin")
    checker.add_obstacle(oc.Body.disc(0.1), (1, 9))
    with pytest.raises(oc.Error, match="of other obstacles. If these have changed since, load it before they do$"):
        checker.load_certificates(tmp_path / "known.bin")
