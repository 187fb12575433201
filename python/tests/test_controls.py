"""Plans by controls"""

import gc
import json
import math
import os
import pathlib
import re
import signal
import threading
import time
from typing import Any, Dict, List

import numpy as np
import ompl_certificates as oc
import pytest
from conftest import TurnsDuring
from test_view import floats, shown_in

LOW, HIGH = [0, 0], [6, 4]


def cart(name: str = "cart") -> oc.Robot:
    return oc.Robot.unicycle(name, oc.Body.box(0.5, 0.25), LOW, HIGH, linear=(-0.2, 1.0), angular=1.5)


@pytest.fixture()
def yard() -> oc.Scene:
    """A cart that drives past a box"""
    scene = oc.Scene(LOW, HIGH, "yard")
    scene.add_obstacle(oc.Body.box(1, 2), (3, 1))
    scene.add_robot(cart(), [1, 1, 0], [5, 1, 0])
    return scene


@pytest.fixture()
def closed() -> oc.Scene:
    """A disc that is pushed, and a wall of 1 mm without a way past it"""
    scene = oc.Scene(LOW, HIGH, "closed")
    scene.add_obstacle(oc.Body.box(0.001, 4.5), (3, 2))
    puck = oc.Robot.integrator("puck", oc.Body.disc(0.05), LOW, HIGH, velocity=3.0)
    scene.add_robot(puck, [1, 2], [5, 2])
    return scene


@pytest.mark.parametrize("motion", ["discrete", "continuous"])
def test_scene_of_a_file_is_solved(scenes: pathlib.Path, motion: str) -> None:
    scene = oc.load_scene(scenes / "controls" / "doorway.yaml", dynamics=True)
    plan = oc.plan_controls(scene, "RRT", motion=motion, goal_tolerance=2.0, time=60, seed=1)
    assert plan.solved and plan and plan.reason is None
    assert re.fullmatch(r"<ControlPlan: solved, [\d.]+ s, \d+ steps>", repr(plan))
    puck = ["puck.pose.x", "puck.pose.y", "puck.velocity.x", "puck.velocity.y"]
    assert plan.coordinates == scene.coordinates == ["cart.x", "cart.y", "cart.yaw"] + puck
    assert plan.control_names == ["cart.linear", "cart.angular", "puck.ax", "puck.ay"]
    steps = len(plan.controls)
    assert plan.path.shape == (steps + 1, 7) and plan.controls.shape == (steps, 4)
    assert np.allclose(plan.times, 0.1 * np.arange(steps + 1)) and np.isclose(plan.cost, plan.times[-1])
    assert (plan.path[0] == scene.start).all()
    assert oc.Checker(scene).is_valid(plan.path).all()
    ends = plan.path[-1] - scene.goal
    turn = abs((ends[2] + np.pi) % (2 * np.pi) - np.pi)
    distances = [np.hypot(ends[0], ends[1]) + turn / 2, np.hypot(ends[3], ends[4]) + np.hypot(ends[5], ends[6]) / 4]
    assert np.hypot(*distances) <= 2.0
    assert plan.report["motion"] == motion and plan.report["objective"] == "duration"
    assert plan.report["cost"] == plan.cost and plan.report["seconds"]["nearest"] > 0


def test_controls_move_a_unicycle_along_the_path(yard: oc.Scene) -> None:
    plan = oc.plan_controls(yard, time=60, seed=2)
    assert plan.solved
    assert plan.controls.min(axis=0)[0] < 0 < plan.controls.max(axis=0)[0]
    assert (plan.controls >= [-0.2, -1.5]).all() and (plan.controls <= [1.0, 1.5]).all()
    state = plan.path[0].copy()
    pieces = 1000
    for row, ((linear, angular), seconds) in enumerate(zip(plan.controls, np.diff(plan.times))):
        for _ in range(pieces):
            middle = state[2] + angular * seconds / pieces / 2
            state += seconds / pieces * np.array([linear * np.cos(middle), linear * np.sin(middle), angular])
        away = state - plan.path[row + 1]
        away[2] = (away[2] + np.pi) % (2 * np.pi) - np.pi
        assert np.abs(away).max() < 1e-6, row


def test_the_team_is_somewhere_at_any_time(yard: oc.Scene) -> None:
    pushed = oc.Robot.integrator("puck", oc.Body.disc(0.1), LOW, HIGH, velocity=1.0, acceleration=2.0)
    yard.add_robot(pushed, [1, 3, 0.5, 0], [5, 3, 0, 0])
    # Proofs of parts of a step are not asked for.
    plan = oc.plan_controls(yard, time=60, seed=1, goal_tolerance=1.5, motion="continuous")
    assert plan.solved
    assert np.allclose(plan.at(plan.times), plan.path, atol=1e-12)
    first, since = plan.times[:-1], 0.03
    there, before = plan.at(first + since), plan.path[:-1]
    assert np.allclose(there[:, 5:7], before[:, 5:7] + since * plan.controls[:, 2:])
    assert np.allclose(there[:, 3:5], before[:, 3:5] + since * before[:, 5:7] + since**2 / 2 * plan.controls[:, 2:])
    way = np.hypot(*(there - before)[:, :2].T)
    chord = np.abs(plan.controls[:, 0]) * since * np.sinc(plan.controls[:, 1] * since / 2 / np.pi)
    assert np.allclose(way, chord)
    assert (plan.at(-1.0) == plan.path[0]).all() and (plan.at(np.inf) == plan.path[-1]).all()
    assert plan.at([]).shape == (0, 7) and plan.at(0.05).shape == (7,)
    with pytest.raises(oc.Error, match="^times: must be numbers, not nan$"):
        plan.at([0.0, math.nan])


@pytest.fixture()
def crowd() -> oc.Scene:
    """A cart and a puck among many stones, and a wall without a way past it"""
    scene = oc.Scene(LOW, HIGH, "crowd")
    for x in np.arange(1.5, 5, 0.7):
        for y in np.arange(0.2, 4, 0.9):
            scene.add_obstacle(oc.Body.convex([[-0.2, -0.1], [0.2, -0.15], [0.15, 0.2], [-0.1, 0.15]]), (x, y, x + y))
    scene.add_obstacle(oc.Body.box(0.1, 4.5), (5.3, 2))
    scene.add_robot(oc.Robot.unicycle("cart", oc.Body.box(0.3, 0.2), LOW, HIGH, 1.0, 2.0), [0.7, 1, 0], [5.7, 1, 0])
    puck = oc.Robot.integrator("puck", oc.Body.disc(0.1), LOW, HIGH, velocity=1.0, acceleration=2.0)
    scene.add_robot(puck, [0.7, 3, 0, 0], [0.7, 3.3, 0, 0])
    return scene


@pytest.mark.parametrize("planner", ["RRT", "SST"])
def test_same_seed_grows_the_same_tree_whatever_the_method(crowd: oc.Scene, planner: str) -> None:
    trees: Dict[int, List[str]] = {1: [], 2: []}
    for seed, digests in trees.items():
        for method in ("fcl", "standard", "shared"):
            plan = oc.plan_controls(crowd, planner, method, time=60, iterations=10000, seed=seed, goal_tolerance=0.3)
            assert (plan.report["method"], plan.report["seed"], plan.report["iterations"]) == (method, seed, 10000)
            assert (plan.report["checks"]["certified_free"] > 0) == (method == "shared")
            digests.append(plan.report["tree"]["digest"])
        assert len(set(digests)) == 1
    assert trees[1] != trees[2]


@pytest.mark.parametrize("planner", ["RRT", "PrioritizedRRT"])
@pytest.mark.parametrize("motion, methods", [("discrete", ["fcl", "standard"]), ("continuous", ["partial", "basic"])])
def test_same_seed_finds_the_same_path(scenes: pathlib.Path, motion: str, methods: List[str], planner: str) -> None:
    scene = oc.load_scene(scenes / "controls" / "doorway.yaml", dynamics=True)
    for seed in (1, 2, 3):
        plan = oc.plan_controls(scene, planner, time=60, motion=motion, seed=seed, goal_tolerance=1.0)
        assert plan.solved
        for method in ["shared", *methods]:
            same = oc.plan_controls(scene, planner, method, time=60, motion=motion, seed=seed, goal_tolerance=1.0)
            assert (same.path == plan.path).all() and (same.controls == plan.controls).all()


def test_steps_proved_free_do_not_jump_through_walls(closed: oc.Scene) -> None:
    def crosses(plan: oc.ControlPlan) -> bool:
        plan_x = plan.path[:, 0]
        return bool(len(plan_x)) and bool((plan_x[-1] > 3) != (plan_x[0] > 3))

    discrete = oc.plan_controls(closed, time=60, seed=1)
    assert discrete.solved and crosses(discrete)
    assert oc.Checker(closed).is_valid(discrete.path).all()
    assert not oc.Checker(closed).is_valid(discrete.at(np.linspace(0, discrete.cost, 20000))).all()
    proof = discrete.prove()
    assert not proof and set(proof.unproved) < set(range(len(discrete.path) - 1))
    assert proof.collision is not None and not oc.Checker(closed).is_valid(proof.collision)
    assert proof.reason and proof.reason.startswith(f"robot '{closed.robots[0].name}' ")
    assert discrete.report["unproved_motions"] == len(proof.unproved)
    proved = oc.plan_controls(closed, time=60, iterations=5000, seed=1, motion="continuous")
    assert not proved.solved and proved.report["motion"] == "continuous"
    with pytest.raises(oc.Error, match="^prove: there is no path$"):
        proved.prove()
    # With a door there is a way.
    scene = oc.Scene(LOW, HIGH, "door")
    scene.add_obstacle(oc.Body.box(0.001, 2.5), (3, 1.25))
    scene.add_robot(closed.robots[0], [1, 2], [5, 2])
    for seed in (1, 2, 3):
        proved = oc.plan_controls(scene, time=60, seed=seed, motion="continuous")
        assert proved.solved and crosses(proved) and proved.prove()
        assert oc.Checker(scene).is_valid(proved.at(np.linspace(0, proved.cost, 20000))).all()


def test_plans_are_asked_about_in_a_world_that_changed(yard: oc.Scene) -> None:
    plan = oc.plan_controls(yard, motion="continuous", goal_tolerance=1.0, time=60, seed=1)
    assert plan.solved
    checker = oc.Checker(yard)
    assert plan.prove(checker).proved
    middle = plan.path[len(plan.path) // 2]
    box = checker.add_obstacle(oc.Body.disc(0.3), middle[:2])
    proof = plan.prove(checker)
    assert not proof.proved and proof.collision is not None
    assert len(plan.path) // 2 in proof.unproved or len(plan.path) // 2 - 1 in proof.unproved
    assert proof.reason is not None and f"added obstacle {box}" in proof.reason
    # The report is about the world of the plan.
    assert plan.prove().proved and plan.report["unproved_motions"] == 0
    checker.remove_obstacle(box)
    assert plan.prove(checker).proved
    with pytest.raises(TypeError):
        plan.prove(yard)  # type: ignore[arg-type]


def test_plans_with_a_checker_are_of_its_world(yard: oc.Scene) -> None:
    options: Dict[str, Any] = {"goal_tolerance": 1.0, "time": 60, "iterations": 20000, "seed": 1}
    checker = oc.Checker(yard, motion="continuous")
    alone = oc.plan_controls(yard, motion="continuous", **options)
    plan = oc.plan_controls(checker, **options)
    assert plan.solved and plan.report["motion"] == "continuous" and plan.report["method"] == "shared"
    assert np.array_equal(plan.path, alone.path)
    # What it learned serves the next one, which finds the same.
    known = checker.statistics()
    again = oc.plan_controls(checker, **options)
    assert np.array_equal(again.path, alone.path)
    assert checker.statistics()["asked"] < known["asked"]
    # A box in the way
    at = len(plan.path) // 2
    box = checker.add_obstacle(oc.Body.disc(0.3), plan.path[at][:2])
    assert not plan.prove().proved
    around = oc.plan_controls(checker, start=plan.path[0], **options)
    assert around.solved and around.prove().proved
    assert not np.array_equal(around.path, plan.path)
    with pytest.raises(oc.Error, match=f"start.*added obstacle {box}"):
        oc.plan_controls(checker, start=plan.path[at], **options)
    assert oc.plan_controls(yard, motion="continuous", start=plan.path[at], **options).solved
    with pytest.raises(oc.Error, match="^motion: a Checker has its own$"):
        oc.plan_controls(checker, motion="discrete")


def test_plans_with_a_checker_keep_it(yard: oc.Scene) -> None:
    plan = oc.plan_controls(oc.Checker(yard), goal_tolerance=1.0, time=60, seed=1)
    gc.collect()
    assert plan.solved and np.allclose(plan.at(plan.cost), plan.path[-1])
    assert plan.report["solved"] and len(plan.prove().unproved) == plan.report["unproved_motions"]


def test_steps_are_as_long_as_asked_for(yard: oc.Scene) -> None:
    plan = oc.plan_controls(yard, time=60, seed=1, step=0.05, min_steps=4, max_steps=6)
    assert plan.solved
    assert np.allclose(np.diff(plan.times), 0.05)
    changes = np.flatnonzero((np.diff(plan.controls, axis=0) != 0).any(axis=1)) + 1
    held = np.diff([0, *changes, len(plan.controls)])
    assert held[:-1].min() >= 4 and held.max() <= 6


def test_start_and_goal_may_be_others(yard: oc.Scene) -> None:
    start, goal = [5, 3, 7.0], np.array([1, 3, -np.pi])
    plan = oc.plan_controls(yard, time=60, start=start, goal=goal, goal_tolerance=0.7)
    assert plan.solved
    assert np.allclose(plan.path[0], [5, 3, 7.0 - 2 * np.pi]) and np.hypot(*(plan.path[-1] - goal)[:2]) < 0.7
    assert (yard.start == [1, 1, 0]).all()
    origin = shown_in(plan.view().html)["bounds"]["origin"]
    assert np.allclose(floats(shown_in(plan.view().html)["robots"][0]["goal"])[:2] + origin[:2], [1, 3])


def test_paths_pages_and_pictures_are_written(yard: oc.Scene, tmp_path: pathlib.Path) -> None:
    plan = oc.plan_controls(yard, time=60, seed=3)
    plan.save(tmp_path / "path.csv")
    text = (tmp_path / "path.csv").read_text(encoding="utf-8")
    lines = text.splitlines()
    assert lines[0].split(",") == ["time", *plan.coordinates, *plan.control_names]
    table = np.array([[float(field) for field in line.split(",")] for line in lines[1:-1]])
    assert (table[:, 0] == plan.times[:-1]).all()
    assert (table[:, 1:4] == plan.path[:-1]).all() and (table[:, 4:] == plan.controls).all()
    plan.save_report(tmp_path / "report.json")
    assert json.loads((tmp_path / "report.json").read_text(encoding="utf-8")) == plan.report
    assert plan.report["tree"]["states"] > 10 and plan.report["planner"] == "RRT"
    shown = shown_in(plan.view(tmp_path / "plan.html").html)
    assert (tmp_path / "plan.html").exists()
    assert np.isclose(shown["end"], plan.times[-1]) and shown["report"] == plan.report
    sizes = []
    for name, tree in (("path", False), ("tree", True)):
        plan.save_picture(tmp_path / f"{name}.svg", tree=tree)
        sizes.append((tmp_path / f"{name}.svg").stat().st_size)
    plan.save_animation(tmp_path / "moving.svg")
    assert "<animateTransform" in (tmp_path / "moving.svg").read_text(encoding="utf-8")
    yard.save_picture(tmp_path / "yard.svg")
    assert (tmp_path / "yard.svg").stat().st_size < sizes[0] < sizes[1]
    with pytest.raises(oc.Error, match="plan.png: pictures are SVG"):
        plan.save_picture(tmp_path / "plan.png")


def test_several_robots_are_planned_for_one_by_one(scenes: pathlib.Path) -> None:
    scene = oc.load_scene(scenes / "controls" / "doorway.yaml", dynamics=True)
    plan = oc.plan_controls(scene, time=60, motion="continuous")
    assert plan.solved and plan.report["planner"] == "PrioritizedRRT" and plan.report["unproved_motions"] == 0
    assert np.allclose(plan.path[-1, 5:], 0.0)  # It ends at rest.


def test_simplified_plans_are_shorter_and_end_at_the_goal(scenes: pathlib.Path) -> None:
    scene = oc.load_scene(scenes / "controls" / "doorway.yaml", dynamics=True)
    for planner in (None, "RRT"):
        first = oc.plan_controls(scene, planner, time=60, goal_tolerance=2.0, seed=2)
        plan = oc.plan_controls(scene, planner, time=60, goal_tolerance=2.0, seed=2, simplify=True)
        assert plan.report["cost"] == first.cost and plan.report["simplified_cost"] == plan.cost
        assert plan.cost < 0.9 * first.cost
        assert plan.times[-1] == plan.cost and len(plan.controls) == len(plan.path) - 1
        assert oc.Checker(scene).is_valid(plan.path).all()
        assert np.allclose(plan.path[0], scene.start)
        if planner is None:  # Those of RRT need not be at rest, so they cannot wait for each other at the goal.
            assert np.allclose(plan.path[-1], scene.goal, atol=1e-3)
    assert oc.plan_controls(scene, time=60).report["simplified_cost"] is None


def test_planners_have_names_and_parameters(yard: oc.Scene, capfd: pytest.CaptureFixture[str]) -> None:
    assert {"EST", "KPIECE1", "PDST", "PrioritizedRRT", "RRT", "SST"} <= set(oc.control_planner_names())
    for name in oc.control_planner_names():
        assert oc.control_planner_parameters(name)["goal_bias"][0]
        plan = oc.plan_controls(yard, name, time=60, iterations=200, parameters={"goal_bias": 0.2})
        assert plan.report["planner"] == name
        # PrioritizedRRT has trees of single robots: it tells of its path alone.
        assert plan.report["tree"]["states"] > 1 or (name == "PrioritizedRRT" and not plan.solved)

    def tree(**kwargs: Any) -> str:
        return str(oc.plan_controls(yard, time=60, iterations=200, **kwargs).report["tree"]["digest"])

    others: List[Dict[str, Any]] = [{"parameters": {"goal_bias": 0.9}}, {"seed": 5}, {"step": 0.2}, {"max_steps": 1}]
    assert len({tree(), *(tree(**other) for other in others)}) == 5
    assert tree(nearest="gnat") == tree()
    assert capfd.readouterr() == ("", "")
    with pytest.raises(oc.Error, match="RRTConnect.*known are: EST, KPIECE1"):
        oc.control_planner_parameters("RRTConnect")


def test_bad_problems_are_told_before_planning(yard: oc.Scene) -> None:
    for kwargs, message in (
        ({"planner": "RTT"}, "RTT.*known are.*did you mean RRT"),
        ({"method": "best"}, "best"),
        ({"motion": "jumpy"}, "^motion: must be discrete or continuous, not 'jumpy'$"),
        ({"motion": "continuous", "method": "fcl"}, "^motion: .*certificates, which method fcl does not"),
        ({"nearest": "far"}, "'far'"),
        ({"goal_tolerance": 0}, "^goal_tolerance: must be positive and finite, not 0.0$"),
        ({"goal_tolerance": math.nan}, "^goal_tolerance: must be positive and finite, not nan$"),
        ({"time": -1.5}, "^time: must be positive, not -1.5$"),
        ({"step": math.inf}, "^step: must be positive and finite, not inf$"),
        ({"min_steps": 0}, "^min_steps: must be from 1 to 10, not 0$"),
        ({"min_steps": 5, "max_steps": 4}, "^min_steps: must be from 1 to 4, not 5$"),
        ({"max_steps": 10**6 + 1}, "^max_steps: must be from 1 to 1000000, not 1000001$"),
        ({"seed": 0}, "^seed: must be from 1 to 4294967295, not 0$"),
        ({"iterations": -5}, "^iterations: .*not -5$"),
        ({"parameters": {"speed": 1}}, "speed"),
        ({"start": [3, 1, 0]}, r"^yard: robots\[0\].start .*'cart' touches environment.obstacles\[0\]$"),
        ({"goal": [1, 9, 0]}, r"^yard: robots\[0\].goal .*'cart' is outside the bounds: y is 9, not from "),
        ({"goal": [5, 5]}, r"^goal: must be an array of shape \(3,\), not \(2,\)$"),
        ({"start": [[1, 1, 9], [1, 1, 9]]}, r"^start: must be an array of shape \(3,\), not \(2, 3\)$"),
        ({"start": "abc"}, "^start: must be numbers$"),
        ({"goal": {"cart": [5, 5, 0]}}, "^goal: .* plans by controls take no dict$"),
        ({"step": 1e-17}, "^step: must be at least 2.3e-16, not 1e-17$"),
        ({"max_steps": "a"}, "^max_steps: must be a whole number, not 'a'$"),
        ({"goal": [1, math.nan, 1]}, "^goal: all numbers must be finite$"),
        ({"start": [1, 1, math.inf]}, "^start: all numbers must be finite$"),
    ):
        begin = time.monotonic()
        with pytest.raises(oc.Error, match=message):
            oc.plan_controls(yard, **kwargs)  # type: ignore[arg-type]
        assert time.monotonic() - begin < 3
    with pytest.raises(oc.Error, match="needs at least one robot"):
        oc.plan_controls(oc.Scene(LOW, HIGH))


def test_controls_are_planned_in_worlds_alone() -> None:
    with pytest.raises(oc.Error, match="^scene: must be a Scene or a Checker, not a Body$"):
        oc.plan_controls(oc.Body.disc(1))  # type: ignore[arg-type]


def test_robots_need_dynamics_for_one_and_none_for_the_other(yard: oc.Scene, scenes: pathlib.Path) -> None:
    yard.add_robot(oc.Robot.rigid("stone", oc.Body.disc(0.1), LOW, HIGH, turns=False), [1, 3], [5, 3])
    assert yard.robots[1].control_names == []
    with pytest.raises(oc.Error, match=r"^yard: these robots have no controls: 'stone'\. "):
        oc.plan_controls(yard)
    with pytest.raises(oc.Error, match=r"no controls: 'cart', 'puck'\. .*dynamics=True"):
        oc.plan_controls(oc.load_scene(scenes / "controls" / "doorway.yaml"))
    with pytest.raises(oc.Error, match=r"^yard: robot 'cart' moves by controls: plan_controls\(\) plans"):
        oc.plan(yard)
    with pytest.raises(oc.Error, match="paper_one_disc.yaml"):
        oc.load_scene(scenes / "paper_one_disc.yaml", dynamics=True)
    text = "environment: {min: [0, 0], max: [4, 4], obstacles: []}\nrobots:\n"
    text += "  - {type: unicycle_second_order_0, start: [1, 1, 0, 0.3, 0.4], goal: [3, 3, 0, 0, 0]}\n"
    assert oc.scene_from_yaml(text, dynamics=True).start.tolist() == [1, 1, 0, 0.3, 0.4]
    assert oc.scene_from_yaml(text).start.tolist() == [1, 1, 0]


def test_no_solution_is_no_path(closed: oc.Scene) -> None:
    plan = oc.plan_controls(closed, time=0.2, motion="continuous")
    assert not plan.solved and not plan and plan.cost == float("inf")
    assert plan.path.shape == (0, 2) and plan.controls.shape == (0, 2) and plan.times.shape == (0,)
    assert plan.reason and plan.reason == plan.report["reason"]
    assert repr(plan) == f"<ControlPlan: not solved: {plan.reason}>"
    with pytest.raises(oc.Error, match="no path"):
        plan.save("nothing.csv")
    with pytest.raises(oc.Error, match="^at: there is no path$"):
        plan.at(0.0)
    assert shown_in(plan.view().html)["end"] == 0


def test_callback_and_interrupt_end_the_plan(closed: oc.Scene) -> None:
    calls: List[float] = []

    def callback(seconds: float, cost: float) -> bool:
        calls.append(seconds)
        return len(calls) == 4

    def plan(callback: Any) -> oc.ControlPlan:
        return oc.plan_controls(closed, time=60, motion="continuous", callback=callback)

    begin = time.monotonic()
    assert not plan(callback)
    assert len(calls) == 4 and calls == sorted(calls)
    with pytest.raises(KeyboardInterrupt):
        plan(lambda *_: os.kill(os.getpid(), signal.SIGINT))
    with pytest.raises(IndexError):
        plan(lambda *_: calls[99])
    timer = threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT))
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        plan(None)
    timer.join()
    assert time.monotonic() - begin < 20


def test_python_runs_while_it_is_planned(closed: oc.Scene, turns_during: TurnsDuring) -> None:
    assert turns_during(lambda: oc.plan_controls(closed, time=0.5, motion="continuous")) > 50
