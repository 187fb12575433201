"""Checks in batches, changes of obstacles, certificates"""

import math
import os
import pathlib
import signal
import threading
import time
from typing import Any, Callable, List, Set

import numpy as np
import ompl_certificates as oc
import pytest

METHODS = ("fcl", "standard", "basic", "partial", "shared")


def test_batches_equal_the_geometry_under_all_methods(room: oc.Scene) -> None:
    states = np.random.default_rng(4).uniform(0, 10, (20000, 4))
    corners = np.maximum(np.abs(states.reshape(-1, 2, 2) - 5) - 1, 0)
    free = (np.linalg.norm(corners, axis=2) > 0.5).all(axis=1)
    free &= np.linalg.norm(states[:, :2] - states[:, 2:], axis=1) > 1
    for method in METHODS:
        assert (oc.Checker(room, method).is_valid(states) == free).all(), method


def test_one_state_gives_one_bool(room: oc.Scene) -> None:
    checker = oc.Checker(room)
    assert checker.is_valid(room.start) is True
    assert checker.is_valid([5, 5, 1, 1]) is False
    assert checker.is_valid([math.nan, 5, 1, 1]) is False
    assert checker.describe_collision([5, 5, 1, 1]) == "robot 'left' touches environment.obstacles[0]"
    assert checker.describe_collision([1, 1, 1, 1.5]) == "robots 'left' and 'right' touch each other"
    assert checker.describe_collision(room.start) == ""
    assert checker.describe_collision([math.nan, 5, 1, 1]) == "a number is not finite"


def test_wrong_shapes_are_refused(room: oc.Scene) -> None:
    checker = oc.Checker(room)
    wrongs: List[Any] = [np.zeros((3, 5)), np.zeros(3), np.zeros((2, 2, 4)), 1.0]
    for wrong in wrongs:
        with pytest.raises(oc.Error, match=r"^states: must be an array of shape \(n, 4\)"):
            checker.is_valid(wrong)
    with pytest.raises(oc.Error, match="^ends: must have as many rows as starts"):
        checker.check_motions(np.zeros((3, 4)), np.zeros((2, 4)))
    assert checker.is_valid(np.zeros((0, 4))).shape == (0,)


def test_other_layouts_and_types_are_converted(room: oc.Scene) -> None:
    states = np.random.default_rng(5).integers(0, 10, (500, 4))
    checker = oc.Checker(room)
    wanted = checker.is_valid(states.astype(float))
    assert (checker.is_valid(states) == wanted).all()
    assert (checker.is_valid(np.asfortranarray(states.astype(np.float32))) == wanted).all()
    assert (checker.is_valid(np.repeat(states, 2, axis=0)[::2]) == wanted).all()


def test_motions_equal_their_samples(room: oc.Scene) -> None:
    rng = np.random.default_rng(6)
    checker = oc.Checker(room)
    states = rng.uniform(0, 10, (3000, 4))
    starts = states[checker.is_valid(states)]
    ends = rng.uniform(0, 10, starts.shape)
    motions = checker.check_motions(starts, ends)
    assert 0 < motions.sum() < len(motions)
    for t in np.linspace(0, 1, 11):
        # Valid motions have valid samples, at the resolution of the space and nearly so in between.
        clearances = checker.clearance(starts + t * (ends - starts))
        assert clearances[motions].min() > -0.1
    assert not motions[~checker.is_valid(ends)].any()


def test_angles_wrap_and_quaternions_have_length_one() -> None:
    scene = oc.Scene([0, 0], [10, 10])
    scene.add_obstacle(oc.Body.box(1, 8), (5, 5))
    robot = oc.Robot.rigid("bar", oc.Body.box(3, 0.2), [0, 0], [10, 10])
    scene.add_robot(robot, [2, 5, 0], [8, 5, 0])
    states = np.random.default_rng(7).uniform([0, 0, -3], [10, 10, 3], (2000, 3))
    checker = oc.Checker(scene)
    turned = states + [0, 0, 2 * math.pi]
    assert (checker.is_valid(states) == checker.is_valid(turned)).all()
    assert (checker.check_motions(states[:-1], states[1:]) == checker.check_motions(turned[:-1], states[1:])).all()

    nowhere = [[1, 5, math.nan], [math.inf, 5, 0], [1, 5, math.inf]]
    assert not checker.is_valid(nowhere).any()
    assert not checker.check_motions([[2, 5, 0]] * 3, nowhere).any()
    assert not checker.check_motions(nowhere, [[2, 5, 0]] * 3).any()

    space = oc.Scene([0] * 3, [10] * 3)
    box = oc.Robot.rigid("box", oc.Body.box(1, 1, 1), [0] * 3, [10] * 3)
    space.add_robot(box, [1, 1, 1, 0, 0, 0, 1], [9, 9, 9, 0, 0, 0, 1])
    with pytest.raises(oc.Error, match="^states: row 1: a quaternion must have length 1, not 2"):
        oc.Checker(space).is_valid([[1, 1, 1, 0, 0, 0, 1], [1, 1, 1, 0, 0, 0, 2]])
    for part in (math.nan, math.inf, -math.inf):
        lost = [1, 1, 1, 0, 0, 0, part]
        assert not oc.Checker(space).is_valid(lost) and oc.Checker(space).clearance(lost) < 0
        assert oc.Checker(space).describe_collision(lost) == "a number is not finite"
        with pytest.raises(oc.Error, match="^path: row 0: all numbers must be finite$"):
            oc.Checker(space).prove([lost])

    # Starts, goals and states may be rounded, as people write them down.
    for digits in (0.707, 0.7071, 0.70710678):
        written = oc.Scene([0] * 3, [10] * 3)
        written.add_robot(box, [1, 1, 1, 0, 0, digits, digits], [9, 9, 9, digits, 0, 0, digits])
        written.validate()
        plan = oc.plan(written, "RRTConnect", time=5)
        assert plan.solved and abs(np.linalg.norm(plan.path[0][3:]) - 1) < 1e-9
        assert oc.Checker(written).is_valid([1, 1, 1, 0, 0, digits, digits])
    with pytest.raises(oc.Error, match="robot 'box': goal: a quaternion must have length 1, not 1.41"):
        oc.Scene([0] * 3, [10] * 3).add_robot(box, [1, 1, 1, 0, 0, 0, 1], [9, 9, 9, 1, 0, 0, 1])

    # Those of single precision are not quite of length 1, for which OMPL would end the program.
    space.add_obstacle(oc.Body.box(3, 3, 3), (5, 5, 5))
    poses = np.random.default_rng(1).normal(size=(200, 7))
    poses[:, :3] = 5 + 2 * poses[:, :3]
    poses[:, 3:] /= np.linalg.norm(poses[:, 3:], axis=1)[:, None]
    rounded = poses.astype(np.float32).astype(float)
    for motion in ("discrete", "continuous"):
        free = oc.Checker(space, motion=motion).check_motions(rounded[:-1], rounded[1:])
        assert 0 < free.sum() < len(free)


@pytest.mark.parametrize("motion", ["discrete", "continuous"])
def test_arrays_may_be_written_while_they_are_read(motion: str) -> None:
    scene = oc.Scene([0] * 3, [10] * 3)
    scene.add_obstacle(oc.Body.box(1, 1, 1), (5, 5, 5))
    box = oc.Robot.rigid("box", oc.Body.box(1, 1, 1), [0] * 3, [10] * 3)
    scene.add_robot(box, [1, 1, 1, 0, 0, 0, 1], [9, 9, 9, 0, 0, 0, 1])
    checker = oc.Checker(scene, motion=motion)
    states = np.tile(scene.start, (2000, 1))
    done = threading.Event()

    def write() -> None:
        while not done.is_set():
            states[1:, 6] = 2.0
            states[1:, 6] = 1.0

    thread = threading.Thread(target=write)
    thread.start()
    seen: Set[bool] = set()
    begin = time.monotonic()
    while time.monotonic() - begin < 1:
        try:
            # OMPL would end the program for a quaternion whose length is not 1.
            seen.update(checker.check_motions(states, states).tolist())
            seen.update(checker.is_valid(states).tolist())
            checker.clearance(states)
        except oc.Error as error:
            assert "a quaternion must have length 1" in str(error)
    done.set()
    thread.join()
    assert True in seen


def test_changes_reach_the_checker(room: oc.Scene) -> None:
    crates = [(x, y) for x in (1, 3, 7, 9) for y in (1, 3, 7, 9, 5.2)]
    for place in crates:
        room.add_obstacle(oc.Body.box(0.2, 0.2), place)
    checker = oc.Checker(room)
    checker.set_adaptive(False)
    states = np.random.default_rng(8).uniform(0, 10, (20000, 4))
    checker.is_valid(states)
    crate = checker.add_obstacle(oc.Body.disc(1), (2, 2))
    assert not checker.is_valid([2, 2, 5, 9])
    checker.move_obstacle(crate, (8, 8))
    checker.move_obstacle(0, (5, 4, 0.5))
    changed = oc.Scene([0, 0], [10, 10])
    changed.add_obstacle(oc.Body.box(2, 2), (5, 4, 0.5))
    changed.add_obstacle(oc.Body.disc(1), (8, 8))
    for place in crates:
        changed.add_obstacle(oc.Body.box(0.2, 0.2), place)
    for robot in room.robots:
        changed.add_robot(robot, [1, 5], [9, 5])
    assert (checker.is_valid(states) == oc.Checker(changed, "fcl").is_valid(states)).all()
    checker.remove_obstacle(crate)
    assert checker.is_valid([8, 8, 2, 2])
    with pytest.raises(oc.Error):
        checker.remove_obstacle(crate)


def test_many_obstacles_change_at_once(room: oc.Scene) -> None:
    checker, single = oc.Checker(room), oc.Checker(room)
    seed = 9
    rng = np.random.default_rng(seed)
    states = rng.uniform(0, 10, (5000, 4))
    places = [rng.uniform(0, 10, 2) for _ in range(30)]
    numbers = checker.change_obstacles(add=[(oc.Body.box(0.3, 0.3), place) for place in places])
    assert numbers == [single.add_obstacle(oc.Body.box(0.3, 0.3), place) for place in places] == list(range(1, 31))
    moved = {number: (1.0 + 0.3 * number, 2.0, 0.1) for number in numbers[:10]}
    new = checker.change_obstacles(remove=numbers[20:] + [0], move=moved, add=[(oc.Body.disc(0.5), (4, 4))])
    assert new == [31]
    for number, pose in moved.items():
        single.move_obstacle(number, pose)
    for number in numbers[20:] + [0]:
        single.remove_obstacle(number)
    single.add_obstacle(oc.Body.disc(0.5), (4, 4))
    expected = single.is_valid(states)
    assert (checker.is_valid(states) == expected).all(), f"seed {seed}"
    # One that is not there undoes all of the change.
    for change in ({"remove": [1, 1]}, {"remove": [1], "move": {77: (0, 0)}}):
        with pytest.raises(oc.Error, match="^(There is no obstacle 77|remove: obstacle 1 is there twice)$"):
            checker.change_obstacles(**change)  # type: ignore[arg-type]
        assert (checker.is_valid(states) == expected).all()
    with pytest.raises(oc.Error, match="^pose: "):
        checker.change_obstacles(remove=[3], add=[(oc.Body.disc(1), (np.nan, 0))])
    assert checker.change_obstacles() == []
    assert (checker.is_valid(states) == expected).all()
    assert checker.change_obstacles(remove=[3, 4], add=[(oc.Body.disc(0.1), (9, 9))]) == [32]


def test_certificates_are_clearances_and_outlive_the_program(room: oc.Scene, tmp_path: pathlib.Path) -> None:
    # Among few obstacles clearances cost less than certificates, and none are kept.
    crates = np.array([[x, y] for x in (1, 3, 7, 9) for y in (1, 2, 3, 7, 8, 9)], dtype=float)
    for crate in crates:
        room.add_obstacle(oc.Body.box(0.2, 0.2), crate)
    checker = oc.Checker(room)
    checker.set_adaptive(False)
    checker.is_valid(np.random.default_rng(9).uniform(0, 10, (20000, 4)))
    certificates = checker.certificates()
    assert certificates.shape[0] > 10 and certificates.shape[1] == 3
    halves = np.array([1.0] + len(crates) * [0.1])[:, None]
    away = np.abs(certificates[:, None, :2] - np.vstack([[[5, 5]], crates])[None]) - halves
    outside = np.linalg.norm(np.maximum(away, 0), axis=2).min(axis=1)
    free = outside > 0
    assert np.allclose(certificates[free, 2], outside[free], atol=1e-4)
    file = str(tmp_path / "room.certificates")
    checker.save_certificates(file)
    other = oc.Checker(room)
    assert other.load_certificates(file) == len(certificates)
    assert len(other.certificates()) == len(certificates)
    with pytest.raises(oc.Error, match="nowhere"):
        other.load_certificates("nowhere")


def test_statistics_are_a_dict_of_counts(room: oc.Scene) -> None:
    checker = oc.Checker(room)
    checker.is_valid(np.random.default_rng(10).uniform(0, 10, (100, 4)))
    statistics = checker.statistics()
    assert statistics["robot_poses"] > 100
    assert statistics["robot_poses"] == (
        statistics["certified_free"] + statistics["certified_colliding"] + statistics["asked"]
    )
    checker.reset_statistics()
    assert checker.statistics()["robot_poses"] == 0


def test_threads_check_at_once_while_obstacles_change(room: oc.Scene) -> None:
    checker = oc.Checker(room)
    states = np.random.default_rng(11).uniform(0, 10, (20000, 4))
    wanted = checker.is_valid(states)
    failures = []

    def check() -> None:
        for _ in range(5):
            if not (checker.is_valid(states) == wanted).all():
                failures.append(1)

    threads = [threading.Thread(target=check) for _ in range(3)]
    for thread in threads:
        thread.start()
    for i in range(10):
        checker.move_obstacle(0, (5, 5, i * math.pi / 2))
    for thread in threads:
        thread.join()
    # A quarter turn of a square changes nothing, but for rounding at its edges.
    assert not failures


def standstill(call: Callable[[], object]) -> float:
    """The longest time that this thread has to wait, as a part of all that the call takes in another one"""
    thread = threading.Thread(target=call)
    begin = last = time.perf_counter()
    longest = 0.0
    thread.start()
    while thread.is_alive():
        now = time.perf_counter()
        longest, last = max(longest, now - last), now
    return longest / (time.perf_counter() - begin)


def test_python_runs_while_a_batch_is_checked(room: oc.Scene) -> None:
    checker = oc.Checker(room)
    states = np.random.default_rng(12).uniform(0, 10, (1000000, 4))
    # Without the release, Python would stand still for nearly all of the batch.
    assert standstill(lambda: checker.is_valid(states)) < 0.7


def test_python_runs_while_a_path_is_read_and_a_mesh_is_made(room: oc.Scene) -> None:
    # To read the path is all that is done before its last row is refused.
    path = np.tile(room.start, (300000, 1))
    path[-1, 0] = math.nan
    corners = np.random.default_rng(15).uniform(0, 9, (900000, 3))
    faces = np.arange(len(corners)).reshape(-1, 3)
    checker = oc.Checker(room)

    def read_path() -> None:
        with pytest.raises(oc.Error, match="^path: row 299999: all numbers must be finite$"):
            checker.prove(path)

    for call in (read_path, lambda: oc.Body.mesh(corners, faces)):
        # Other programs stop this one, too, but not each time.
        assert min(standstill(call) for _ in range(5)) < 0.7


@pytest.mark.parametrize("question", ["is_valid", "clearance", "check_motions"])
def test_interrupt_ends_a_batch(room: oc.Scene, question: str) -> None:
    for place in np.random.default_rng(14).uniform(0, 10, (200, 2)):
        room.add_obstacle(oc.Body.box(0.1, 0.1), place)
    checker = oc.Checker(room)
    states = np.random.default_rng(13).uniform(0, 10, (3000000, 4))
    arguments = (states, states[::-1].copy()) if question == "check_motions" else (states,)
    sent = math.inf

    def interrupt() -> None:
        nonlocal sent
        sent = time.monotonic()
        os.kill(os.getpid(), signal.SIGINT)

    timer = threading.Timer(0.2, interrupt)
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        getattr(checker, question)(*arguments)
    # All of the batch takes more than a second.
    assert time.monotonic() - sent < 0.5
    timer.join()
    assert len(getattr(checker, question)(*(argument[:5] for argument in arguments))) == 5


def test_collisions_name_what_is_added_and_what_is_left(room: oc.Scene) -> None:
    room.add_grid(np.ones((1, 1), dtype=bool), size=1.0, first=(8, 8))
    checker = oc.Checker(room)
    assert checker.describe_collision([8.5, 8.5, 1, 1]) == "robot 'left' touches grids[0]"
    disc = checker.add_obstacle(oc.Body.disc(0.5), (2, 8))
    checker.remove_obstacle(0)
    assert checker.describe_collision([5, 5, 1, 1]) == ""
    assert checker.describe_collision([2, 8, 1, 1]) == f"robot 'left' touches added obstacle {disc}"
    checker.move_obstacle(disc, (2, 6))
    other = checker.add_obstacle(oc.Body.disc(0.5), (2, 8))
    assert checker.describe_collision([1, 1, 2, 8]) == f"robot 'right' touches added obstacle {other}"
    cloud = checker.add_cloud([[5, 8]], radius=0.1)
    assert checker.describe_collision([5, 8, 1, 1]) == f"robot 'left' touches added cloud {cloud}"
    grid = checker.add_grid(np.ones((1, 1), dtype=bool), size=1.0, first=(8, 1))
    with pytest.raises(oc.Error, match=f"^room: goal: robot 'right' touches added grid {grid}$"):
        oc.plan(checker, time=1, goal=[1, 1, 8.5, 1.5])


def test_certificates_are_forgotten_while_others_check(room: oc.Scene) -> None:
    checker = oc.Checker(room)
    checker.set_adaptive(False)
    states = np.random.default_rng(14).uniform(0, 10, (2000, 4))
    valid = checker.is_valid(states)
    done = threading.Event()
    wrong: List[int] = []

    def check() -> None:
        while not done.is_set():
            if not (checker.is_valid(states) == valid).all():
                wrong.append(1)

    threads = [threading.Thread(target=check) for _ in range(3)]
    for thread in threads:
        thread.start()
    for _ in range(60):
        checker.clear_certificates()
        time.sleep(0.001)
    done.set()
    for thread in threads:
        thread.join()
    assert not wrong

    calls = 0

    def forget(seconds: float, cost: float) -> None:
        nonlocal calls
        calls += 1
        checker.clear_certificates()

    assert oc.plan(checker, "RRTstar", time=0.5, callback=forget, start=[1, 1, 9, 9], goal=[9, 9, 1, 1]).report
    assert calls > 2
