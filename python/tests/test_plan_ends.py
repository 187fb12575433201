"""When plans end, and what is kept of them"""

import gc
import os
import pathlib
import signal
import subprocess
import sys
import textwrap
import time
from typing import Any, List, Tuple

import numpy as np
import ompl_certificates as oc
import pytest


@pytest.fixture()
def closed() -> oc.Scene:
    """A disc and a wall without a way past it"""
    scene = oc.Scene([0, 0], [10, 4], "closed")
    scene.add_obstacle(oc.Body.box(1, 4.2), (5, 2))
    scene.add_robot(oc.Robot.rigid("disc", oc.Body.disc(0.3), [0, 0], [10, 4], turns=False), [1, 2], [9, 2])
    return scene


def test_time_is_at_most(closed: oc.Scene) -> None:
    """The planner's tree is copied when it is asked for: for PRM that takes twice as long as to grow it."""
    begin = time.monotonic()
    plan = oc.plan(closed, "PRM", time=1.0)
    planned = time.monotonic()
    report = plan.report
    copied = time.monotonic()
    assert report["tree"]["states"] > 1000
    assert planned - begin - report["seconds"]["total"] < (copied - planned) / 2
    assert plan.report == report and time.monotonic() - copied < (copied - planned) / 2


def test_trees_outlive_later_plans_and_their_checker(room: oc.Scene, tmp_path: pathlib.Path) -> None:
    def plan(checker: oc.Checker, planner: str = "RRT") -> oc.Plan:
        return oc.plan(checker, planner, time=60, iterations=300, start=[1, 1, 9, 9], goal=[9, 9, 1, 1])

    expected = plan(oc.Checker(room)).report["tree"]
    checker = oc.Checker(room)
    kept = plan(checker)
    oc.plan(checker, "RRTstar", time=0.1, start=[1, 2, 9, 9], goal=[9, 9, 2, 1])
    checker.move_obstacle(0, (5, 8))
    del checker, room
    gc.collect()
    kept.save_picture(tmp_path / "tree.svg", tree=True)
    assert kept.report["tree"] == expected


def test_iterations_are_at_least_one(closed: oc.Scene) -> None:
    with pytest.raises(oc.Error, match="^iterations: must be from 1 to 18446744073709551615, not 0$"):
        oc.plan(closed, time=1, iterations=0)
    begin = time.monotonic()
    assert not oc.plan(closed, time=20, iterations=1)
    assert time.monotonic() - begin < 10


@pytest.mark.parametrize("planner", ["DRRTstar", "RRTstar", "BITstar"])
def test_the_first_solution_is_enough(room: oc.Scene, planner: str) -> None:
    begin = time.monotonic()
    assert oc.plan(room, planner, time=40, first=True, start=[1, 1, 9, 9], goal=[9, 9, 1, 1])
    assert time.monotonic() - begin < 20


def test_why_there_is_no_solution(closed: oc.Scene, room: oc.Scene) -> None:
    plan = oc.plan(closed, "RRTstar", time=0.2)
    assert plan.reason == plan.report["reason"]
    assert plan.reason and plan.reason.startswith("an approximate solution ends ")
    assert oc.plan(room, "PRMstar", time=0.5).report["seconds"]["first_solution"] is None
    seconds = oc.plan(room, "RRTConnect", time=5.0, first=True).report["seconds"]
    assert 0 < seconds["first_solution"] <= seconds["total"]
    plan = oc.plan(closed, "PRMstar", time=0.2)
    assert repr(plan) == f"<Plan: not solved: {plan.reason}>"
    closed.add_robot(oc.Robot.rigid("lost", oc.Body.disc(0.3), [0, 0], [10, 4], turns=False), [1, 3], [9, 3])
    plan = oc.plan(closed, "DRRTstar", time=3, parameters={"max_roadmap_size": 500})
    assert plan.reason == "robot 'disc' found no way from its start to its goal even alone"
    plan = oc.plan(room, "RRTConnect", time=20)
    assert plan.reason is None and plan.report["reason"] is None
    assert np.isfinite(plan.cost)


def test_a_plan_tells_what_happens_between_its_samples() -> None:
    def floor() -> oc.Scene:
        scene = oc.Scene([0, 0], [10, 10], "floor")
        scene.add_robot(oc.Robot.rigid("disc", oc.Body.disc(0.1), [0, 0], [10, 10], turns=False), [1, 5], [9, 5])
        scene.resolution = 0.1  # a step of 1.4
        return scene

    plan = oc.plan(floor(), planner="RRTConnect", time=5.0, seed=1)
    # The report proves the path; nobody needs to ask for that first.
    assert plan.report["unproved_motions"] == 0 and plan.report["collision"] is None
    assert plan.report["seconds"]["first_solution"] == plan.report["seconds"]["total"]
    proof = plan.prove()
    assert proof and proof.proved and proof.unproved == [] and proof.collision is None and proof.reason is None
    assert repr(proof) == "<Proof: free throughout>"
    assert plan.report["unproved_motions"] == 0 and plan.report["collision"] is None

    walled = floor()
    walled.add_obstacle(oc.Body.box(0.05, 10), (4.3, 5))
    plan = oc.plan(walled, planner="RRTConnect", time=5.0, seed=1)
    assert plan.solved
    proof = plan.prove()
    assert not proof and not proof.proved
    assert proof.unproved and set(proof.unproved) <= set(range(len(plan.path) - 1))
    assert proof.collision is not None and proof.collision.shape == (2,) and abs(proof.collision[0] - 4.3) < 0.13
    assert not oc.Checker(walled).is_valid(proof.collision)
    assert proof.reason and proof.reason.startswith("robot 'disc' ")
    assert repr(proof) == f"<Proof: {len(proof.unproved)} motions are not proved, {proof.reason}>"
    assert plan.report["unproved_motions"] == len(proof.unproved) and plan.report["collision"] == proof.reason
    again = oc.plan(walled, planner="RRTConnect", time=5.0, seed=1)
    assert again.report["unproved_motions"] == len(proof.unproved) and again.report["collision"] == proof.reason

    with pytest.raises(oc.Error, match="^prove: there is no path$"):
        oc.plan(walled, planner="RRTConnect", motion="continuous", time=0.1).prove()
    assert oc.plan(floor(), planner="RRTConnect", method="fcl", time=5.0).prove()


def test_an_interrupt_keeps_the_plan(room: oc.Scene, closed: oc.Scene) -> None:
    def interrupt(seconds: float, cost: float) -> None:
        os.kill(os.getpid(), signal.SIGINT)

    with pytest.raises(KeyboardInterrupt) as end:
        oc.plan(room, "DRRTstar", time=60, callback=lambda _, cost: interrupt(_, cost) if cost < 100 else None)
    plan = end.value.plan  # type: ignore[attr-defined]
    assert isinstance(plan, oc.Plan) and plan.solved and plan.cost < 100
    assert plan.report["seconds"]["total"] < 20 and plan.prove().unproved is not None

    class Frozen(Exception):
        def __setattr__(self, name: str, value: object) -> None:
            raise TypeError("no attributes")

    def fail(seconds: float, cost: float) -> None:
        raise Frozen("mine")

    with pytest.raises(Frozen, match="mine"):
        oc.plan(closed, "RRTConnect", time=60, callback=fail)
    with pytest.raises(ZeroDivisionError) as end_of_callback:
        oc.plan(closed, "RRTConnect", time=60, callback=lambda *_: 1 / 0)
    assert not end_of_callback.value.plan.solved  # type: ignore[attr-defined]

    pushed = oc.Scene([0, 0], [10, 4], "pushed")
    pushed.add_obstacle(oc.Body.box(1, 4.2), (5, 2))
    puck = oc.Robot.integrator("puck", oc.Body.disc(0.3), [0, 0], [10, 4], velocity=1.0)
    pushed.add_robot(puck, [1, 2], [9, 2])
    with pytest.raises(KeyboardInterrupt) as end:
        oc.plan_controls(pushed, "RRT", time=60, callback=interrupt)
    controlled = end.value.plan  # type: ignore[attr-defined]
    assert isinstance(controlled, oc.ControlPlan) and not controlled.solved
    assert controlled.report["tree"]["states"] >= 1


def test_a_path_of_ones_own_is_proved(closed: oc.Scene) -> None:
    checker = oc.Checker(closed)
    assert checker.prove([[1, 2], [4, 2], [4, 3]])
    assert checker.prove([[1, 2]])
    proof = checker.prove([[1, 2], [4, 2], [6, 2], [7, 2]])
    assert proof.unproved == [1] and proof.collision is not None and 4 < proof.collision[0] < 6
    assert proof.reason == "robot 'disc' touches environment.obstacles[0]"
    checker.remove_obstacle(0)
    assert checker.prove([[1, 2], [4, 2], [6, 2], [7, 2]])
    cases: List[Tuple[Any, str]] = [
        (np.zeros((0, 2)), "path: must have a state at least"),
        ([[1, 2], [np.nan, 2]], "path: row 1: all numbers must be finite"),
        ([[1, 2, 3]], r"path: must be an array of shape \(n, 2\)"),
    ]
    for path, message in cases:
        with pytest.raises(oc.Error, match=message):
            checker.prove(path)


def test_angles_that_count_turns_are_not_turned_the_shorter_way() -> None:
    scene = oc.Scene([0, 0], [10, 4], "turns")
    arm = oc.Body.join([(oc.Body.box(1, 0.2), (0.5, 0))])
    scene.add_robot(oc.Robot.rigid("bar", arm, [0, 0], [10, 4]), [2, 2, 0], [2, 2, 1])
    # In the way of the turn by more than half of one, and not in that of the shorter one
    scene.add_obstacle(oc.Body.disc(0.1), (2, 2.8))
    checker = oc.Checker(scene, motion="continuous")
    assert checker.prove([[2, 2, 1.9], [2, 2, 3.0], [2, 2, -2.9], [2, 2, -1.6]])
    assert not checker.prove([[2, 2, 1.2], [2, 2, 2.0]])
    assert checker.prove([[2, 2, 1.2], [2, 2, -1.78]])
    assert not checker.prove([[2, 2, 1.2], [2, 2, 3.0], [2, 2, 4.5]])
    with pytest.raises(oc.Error, match="^path: row 1: 'bar.yaw' turns by 3.3.* more than half a turn; add a row"):
        checker.prove([[2, 2, 1.2], [2, 2, 4.5]])


@pytest.mark.parametrize("kind", [oc.Body, oc.Robot, oc.Plan, oc.ControlPlan, oc.Proof])
def test_nothing_is_made_of_nothing(kind: Any) -> None:
    for make in (kind, lambda: kind.__new__(kind), lambda: object.__new__(kind)):
        with pytest.raises(TypeError):
            make()


@pytest.mark.parametrize(
    "work",
    [
        "oc.plan(checker, 'RRT', time=60)",
        "oc.plan(oc.Checker(scene), 'RRT', time=60, callback=lambda *_: sum(range(3000)) < 0)",
        "checker.is_valid(states)",
        "[checker.is_valid(states[:5]) for _ in range(10**7)]",
    ],
)
def test_programs_end_while_daemon_threads_work(work: str) -> None:
    """What Python destroys at the end takes a while, in which the threads ask for its lock."""
    program = """
        import threading, time
        import numpy as np, ompl_certificates as oc
        scene = oc.Scene([0, 0], [10, 10])
        scene.add_obstacle(oc.Body.box(1, 11), (5, 5))
        scene.add_robot(oc.Robot.rigid("disc", oc.Body.disc(0.5), [0, 0], [10, 10], turns=False), [1, 1], [9, 1])
        checker = oc.Checker(scene)
        states = np.random.default_rng(1).uniform(0, 10, (5000000, 2))
        class Junk: pass
        junk = Junk()
        junk.items, junk.junk = [[i] for i in range(300000)], junk
        threading.Thread(target=lambda: WORK, daemon=True).start()
        time.sleep(0.3)
        """
    text = textwrap.dedent(program).replace("WORK", work)
    ended = subprocess.run([sys.executable, "-c", text], capture_output=True, text=True, timeout=100)
    assert (ended.returncode, ended.stderr) == (0, "")


def test_callbacks_are_called_while_the_path_is_simplified(scenes: pathlib.Path) -> None:
    """Its plan takes some hundredths of a second, and more than a second to be simplified."""
    scene = oc.load_scene(scenes / "sixteen_robots.yaml")
    told: List[Any] = []
    plan = oc.plan(
        scene, "DRRTstar", first=True, time=60, seed=2, simplify=True, callback=lambda *now: told.append(now)
    )
    assert told and told == sorted(told) and told[-1][1] == pytest.approx(plan.report["cost"], 1e-3)
    whole = plan.report["seconds"]["simplifying"]
    plan = oc.plan(
        scene, "DRRTstar", first=True, time=60, seed=2, simplify=True, callback=lambda _, cost: np.isfinite(cost)
    )
    assert plan.solved and plan.report["seconds"]["simplifying"] < 0.8 * whole


def test_planners_are_quiet_about_their_trees(room: oc.Scene, capfd: pytest.CaptureFixture[str]) -> None:
    assert oc.plan(room, "AnytimePathShortening", time=0.3, start=[1, 1, 9, 9], goal=[9, 9, 1, 1]).report
    assert capfd.readouterr().err == ""
