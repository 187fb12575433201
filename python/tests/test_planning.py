"""Plans"""

import json
import math
import os
import pathlib
import re
import signal
import threading
import time
from typing import Dict, List, Tuple

import numpy as np
import ompl_certificates as oc
import pytest
from conftest import TurnsDuring
from ompl_certificates import Parameter

MANY_THREADS = ("AnytimePathShortening", "CForest", "DRRTstar", "PRMstar", "SPARS", "pRRT", "pSBL")


def test_plan_leads_from_start_to_goal(room: oc.Scene) -> None:
    plan = oc.plan(room, time=1.0)
    assert plan.solved and plan
    assert re.fullmatch(r"<Plan: solved, cost [\d.]+, \d+ states, motions checked at samples>", repr(plan))
    assert plan.coordinates == ["left.x", "left.y", "right.x", "right.y"]
    assert (plan.path[0] == room.start).all() and (plan.path[-1] == room.goal).all()
    assert plan.times.shape == (len(plan.path),) and (np.diff(plan.times) >= 0).all()
    checker = oc.Checker(room)
    assert checker.is_valid(plan.path).all()
    assert checker.check_motions(plan.path[:-1], plan.path[1:]).all()
    assert np.isclose(plan.cost, np.linalg.norm(np.diff(plan.path, axis=0), axis=1).sum())


def test_the_team_is_somewhere_at_any_time(room: oc.Scene) -> None:
    robot = oc.Robot.rigid("bar", oc.Body.box(1.0, 0.2), [0, 0], [10, 10])
    room.add_robot(robot, [1, 2, 3], [9, 2, -3])
    plan = oc.plan(room, time=1.0, seed=2, motion="continuous")
    assert repr(plan).endswith(" states, motions proved>")
    assert plan.prove().proved
    assert repr(plan).endswith(" states, proved free>")
    assert (plan.at(plan.times) == plan.path).all()
    middle = (plan.times[:-1] + plan.times[1:]) / 2
    steps = plan.path[1:] - plan.path[:-1]
    turn = (steps[:, 6] + np.pi) % (2 * np.pi) - np.pi
    expected = plan.path[:-1] + np.column_stack([steps[:, :6], turn]) / 2
    there = plan.at(middle)
    assert np.allclose(there[:, :6], expected[:, :6])
    assert np.allclose(np.cos(there[:, 6] - expected[:, 6]), 1)
    assert oc.Checker(room).is_valid(plan.at(np.linspace(0, plan.times[-1], 500))).all()
    # Nobody is faster than 1.
    fine = plan.at(np.linspace(0, plan.times[-1], 2001))
    assert np.linalg.norm(np.diff(fine[:, :2], axis=0), axis=1).max() <= plan.times[-1] / 2000 * (1 + 1e-9)
    assert (plan.at(-5.0) == room.start).all() and (plan.at(np.inf) == room.goal).all()
    assert plan.at([]).shape == (0, 7) and plan.at(1.0).shape == (7,)
    with pytest.raises(oc.Error, match="^times: must be numbers, not nan$"):
        plan.at([0.0, math.nan])


def test_times_go_by_the_speeds_of_robots() -> None:
    scene = oc.Scene([0, 0], [10, 10], "hall")
    disc = oc.Body.disc(0.5)
    for name, y, speed in (("slow", 2.0, 0.5), ("fast", 8.0, 4.0)):
        robot = oc.Robot.rigid(name, disc, [0, 0], [10, 10], turns=False)
        scene.add_robot(robot, [1, y], [9, y], speed=speed)
    slow = oc.plan(scene, iterations=1000, seed=1, objective="makespan")
    assert slow.cost == pytest.approx(16.0)
    assert slow.times[-1] == pytest.approx(16.0)
    both = oc.plan(scene, iterations=1000, seed=1, objective="arrival")
    assert both.cost == pytest.approx(18.0, rel=1e-3)
    there = both.at(2.01)
    assert there[2] == pytest.approx(9.0, abs=0.05) and there[0] == pytest.approx(2.0, abs=0.05)


def test_pictures_are_drawn(room: oc.Scene, tmp_path: pathlib.Path) -> None:
    plan = oc.plan(room, time=0.5)
    room.save_picture(tmp_path / "room.svg")
    sizes = [(tmp_path / "room.svg").stat().st_size]
    for name, tree, certificates in (("path", False, False), ("tree", True, False), ("all", True, True)):
        plan.save_picture(tmp_path / f"{name}.svg", tree=tree, certificates=certificates)
        text = (tmp_path / f"{name}.svg").read_text(encoding="utf-8")
        assert "<svg" in text
        sizes.append(len(text))
    assert sizes == sorted(set(sizes))
    for picture in (room, plan):
        with pytest.raises(oc.Error, match="plan.png: pictures are SVG: the name must end in .svg$"):
            picture.save_picture(tmp_path / "plan.png")  # type: ignore[attr-defined]
    plan.save_animation(tmp_path / "moving.svg")
    assert "<animateTransform" in (tmp_path / "moving.svg").read_text(encoding="utf-8")
    with pytest.raises(oc.Error, match="plan.png: pictures are SVG: the name must end in .svg$"):
        plan.save_animation(tmp_path / "plan.png")
    assert not (tmp_path / "plan.png").exists()
    with pytest.raises(oc.Error, match="nowhere"):
        plan.save_picture(tmp_path / "nowhere" / "plan.svg")


def test_planners_name_their_parameters(capfd: pytest.CaptureFixture[str]) -> None:
    for name in oc.planner_names():
        parameters = oc.planner_parameters(name)
        assert all(isinstance(text, str) for pair in parameters.values() for text in pair), name
    assert float(oc.planner_parameters("RRT")["goal_bias"][0]) == 0.05
    assert capfd.readouterr() == ("", "")
    with pytest.raises(oc.Error, match="RRTConect"):
        oc.planner_parameters("RRTConect")


def test_report_is_a_dict(room: oc.Scene, tmp_path: pathlib.Path) -> None:
    plan = oc.plan(room, "RRTConnect", time=5.0, seed=7, simplify=True, parameters={"range": 0.5})
    report = plan.report
    assert (report["scene"], report["planner"], report["method"], report["seed"]) == ("room", "RRTConnect", "shared", 7)
    assert report["solved"] is True and report["simplified_cost"] == plan.cost <= report["cost"]
    assert report["checks"]["robot_poses"] > 0
    plan.save(tmp_path / "path.csv")
    plan.save_report(tmp_path / "report.json")
    assert json.loads((tmp_path / "report.json").read_text(encoding="utf-8")) == report
    assert (room.load_path(tmp_path / "path.csv") == plan.path).all()
    table = np.loadtxt(tmp_path / "path.csv", delimiter=",", skiprows=1)
    assert (table[:, 1:5] == plan.path).all()
    step = plan.times[-1] / 7.5
    plan.save(tmp_path / "ticks.csv", step=step)
    ticks = np.loadtxt(tmp_path / "ticks.csv", delimiter=",", skiprows=1)
    assert set(plan.times) <= set(ticks[:, -1]) and len(ticks) == 7 + len(plan.times)
    assert np.diff(ticks[:, -1]).max() <= step * (1 + 1e-9)
    assert np.allclose(ticks[:, 1:5], plan.at(ticks[:, -1]))
    assert room.load_path(tmp_path / "ticks.csv").shape == (len(ticks), 4)
    with pytest.raises(oc.Error, match="must be positive"):
        plan.save(tmp_path / "ticks.csv", step=0)
    with pytest.raises(oc.Error, match=r"^times: must be one number or an array of shape \(n,\), not \(2, 2\)"):
        plan.at(np.zeros((2, 2)))


@pytest.mark.parametrize("planner", ["RRT", "KPIECE1"])
def test_same_seed_grows_the_same_tree_whatever_the_method(room: oc.Scene, planner: str) -> None:
    digests = {
        (seed, oc.plan(room, planner, method, time=60, iterations=2000, seed=seed).report["tree"]["digest"])
        for seed in (1, 2)
        for method in ("standard", "shared", "shared")
    }
    assert len(digests) == 2


def test_callback_sees_progress_and_ends_the_plan(room: oc.Scene) -> None:
    calls: List[Tuple[float, float]] = []

    def callback(seconds: float, cost: float) -> bool:
        calls.append((seconds, cost))
        return seconds > 0.4

    begin = time.monotonic()
    plan = oc.plan(room, "RRTstar", time=60, callback=callback)
    assert time.monotonic() - begin < 10
    assert len(calls) >= 3
    assert [c[0] for c in calls] == sorted(c[0] for c in calls)
    if plan.solved:
        assert calls[-1][1] < float("inf")


@pytest.mark.parametrize("planner", MANY_THREADS)
def test_callback_and_interrupt_reach_planners_with_threads(room: oc.Scene, planner: str) -> None:
    room.add_obstacle(oc.Body.box(0.5, 20), (5, 5))  # no way, so that it plans on
    checker = oc.Checker(room)
    calls: List[bool] = []

    def callback(seconds: float, cost: float) -> bool:
        calls.append(bool(checker.is_valid(room.start)))
        checker.move_obstacle(0, (5, 5, 0.1 * len(calls)))
        return len(calls) == 4

    begin = time.monotonic()
    assert not oc.plan(checker, planner, time=60, callback=callback)
    assert calls == 4 * [True]

    def interrupt(seconds: float, cost: float) -> None:
        os.kill(os.getpid(), signal.SIGINT)

    with pytest.raises(KeyboardInterrupt):
        oc.plan(checker, planner, time=60, callback=interrupt)
    with pytest.raises(IndexError):
        oc.plan(checker, planner, time=60, callback=lambda *_: calls[99])
    assert time.monotonic() - begin < 20


@pytest.mark.parametrize("answer", [np.bool_(True), 1, "enough"])
def test_callback_may_answer_what_is_true(room: oc.Scene, answer: object) -> None:
    begin = time.monotonic()
    oc.plan(room, "RRTstar", time=20, callback=lambda *_: answer)
    assert time.monotonic() - begin < 10
    falses: List[object] = [None, np.bool_(False), 0]
    calls = iter(falses + [answer])
    oc.plan(room, "RRTstar", time=20, callback=lambda *_: next(calls))
    assert not list(calls)

    class Undecided:
        def __bool__(self) -> bool:
            raise KeyError("undecided")

    for unclear, error in ((Undecided(), KeyError), (np.zeros(2), ValueError)):
        with pytest.raises(error):
            oc.plan(room, "RRTstar", time=20, callback=lambda *_, answer=unclear: answer)


def test_parameters_may_be_of_numpy(room: oc.Scene) -> None:
    values: Dict[str, Parameter] = {"range": np.float32(0.5), "intermediate_states": np.bool_(True)}
    plain: Dict[str, Parameter] = {"range": 0.5, "intermediate_states": True}
    trees = {
        oc.plan(room, "RRT", time=60, iterations=500, parameters=parameters).report["tree"]["digest"]
        for parameters in (values, plain)
    }
    assert len(trees) == 1
    oc.plan(room, "RRT", time=20, iterations=5, parameters={"goal_bias": np.float64(0.1), "range": np.int64(1)})


def test_what_the_callback_raises_is_raised(room: oc.Scene) -> None:
    def callback(seconds: float, cost: float) -> None:
        raise KeyError("mine")

    with pytest.raises(KeyError, match="mine"):
        oc.plan(room, "RRTstar", time=60, callback=callback)


@pytest.mark.parametrize("planner", ["RRTstar", "RRT", "DRRTstar", "PRMstar"])
def test_interrupt_ends_the_plan(room: oc.Scene, planner: str) -> None:
    if planner == "RRT":
        room.add_obstacle(oc.Body.box(0.5, 20), (5, 5))  # no way, so that it plans on
    timer = threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT))
    begin = time.monotonic()
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        oc.plan(room, planner, time=60)
    assert time.monotonic() - begin < 10
    timer.join()


def test_python_runs_while_it_is_planned(room: oc.Scene, turns_during: TurnsDuring) -> None:
    assert turns_during(lambda: oc.plan(room, "RRTstar", time=0.5)) > 50


def test_plans_in_threads_stay_quiet(capfd: pytest.CaptureFixture[str]) -> None:
    def work(seconds: float, delay: float) -> None:
        scene = oc.Scene([0, 0], [10, 10])
        scene.add_robot(oc.Robot.rigid("disc", oc.Body.disc(0.5), [0, 0], [10, 10], turns=False), [1, 5], [9, 5])
        time.sleep(delay)
        oc.plan(scene, "RRTstar", time=seconds)

    # The first one ends while the second one plans, and the third one plans once the second one has ended.
    threads = [threading.Thread(target=work, args=times) for times in ((0.3, 0), (0.6, 0.1), (0.3, 0.8))]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    out, err = capfd.readouterr()
    assert not out and not err


def test_bad_problems_are_told_before_planning(room: oc.Scene) -> None:
    for kwargs, message in (
        ({"planner": "RTT"}, "RTT"),
        ({"method": "best"}, "best"),
        ({"motion": "jumpy"}, "^motion: "),
        ({"time": -1.0}, "^time: "),
        ({"time": "1"}, "^time: must be a number, not '1'$"),
        ({"seed": 0}, "^seed: must be from 1 to 4294967295, not 0$"),
        ({"seed": None}, "^seed: must be a whole number, not None$"),
        ({"parameters": "range"}, "^parameters: must be a dict from names to values, not 'range'$"),
        ({"planner": "RRTstar", "parameters": {"goal_bias": 2}}, "'goal_bias': must be at most 1$"),
        ({"iterations": -5}, "^iterations: .*not -5$"),
        ({"objective": "beauty"}, "beauty"),
        ({"planner": "RRT", "parameters": {"speed": 1}}, "speed"),
        ({"start": [5, 5, 1, 1]}, r"^room: start: robot 'left' touches environment.obstacles\[0\]$"),
        ({"goal": [1, 9, 50, 1]}, "^room: goal: robot 'right' is outside the bounds: x is 50, not from 0 to 10$"),
        ({"goal": [5, 5]}, r"^goal: must be an array of shape \(4,\), not \(2,\)$"),
        ({"start": [[1, 1, 9, 9], [1, 1, 9, 9]]}, r"^start: must be an array of shape \(4,\), not \(2, 4\)$"),
        ({"start": 1.0}, r"^start: must be an array of shape \(4,\), not \(\)$"),
        ({"start": "abc"}, "^start: must be numbers$"),
        ({"goal": [[1, 2], [3]]}, "^goal: must be numbers: "),
        ({"goal": [1, 1, math.nan, 1]}, "^goal: all numbers must be finite$"),
    ):
        begin = time.monotonic()
        with pytest.raises(oc.Error, match=message):
            oc.plan(room, **kwargs)  # type: ignore[arg-type]
        assert time.monotonic() - begin < 3
    with pytest.raises(oc.Error, match="needs at least one robot"):
        oc.plan(oc.Scene([0, 0], [1, 1]))
    with pytest.raises(oc.Error, match="^scene: must be a Scene or a Checker, not a str$"):
        oc.plan("room.yaml")  # type: ignore[arg-type]


def test_a_path_is_read_only(room: oc.Scene) -> None:
    plan = oc.plan(room, "RRTConnect")
    for array in (plan.path, plan.times):
        with pytest.raises(ValueError, match="read-only"):
            array[0] = 7.0


@pytest.mark.parametrize("question", ["is_valid", "check_motions", "describe_collision", "new_checker", "picture"])
def test_threads_ask_while_others_plan(question: str, tmp_path: pathlib.Path) -> None:
    """Each plan sets OMPL's spaces up, which the checks of other threads read."""
    scene = oc.Scene([0] * 3, [10] * 3)
    scene.add_obstacle(oc.Body.box(1, 1, 1), (5, 5, 5))
    for i in range(2):
        robot = oc.Robot.rigid(f"drone{i}", oc.Body.box(0.3, 0.2, 0.1), [0] * 3, [10] * 3)
        scene.add_robot(robot, [0.5 + i, 0.5, 0.5, 0, 0, 0, 1], [9.5 - i, 9.5, 9.5, 0, 0, 0, 1])
    checker = oc.Checker(scene)
    bad = scene.start.copy()
    bad[:3] = 5
    wrong: List[str] = []

    def ask() -> None:
        while not done.is_set():
            if question == "is_valid":
                right = checker.is_valid(scene.start) and not checker.is_valid(bad)
            elif question == "check_motions":
                right = bool(checker.check_motions(scene.start, scene.start).all())
            elif question == "describe_collision":
                right = "touches" in checker.describe_collision(bad)
            elif question == "new_checker":
                right = oc.Checker(scene).is_valid(scene.start) is True
            else:
                scene.save_picture(tmp_path / "scene.svg")
                right = True
            if not right:
                wrong.append(question)

    done = threading.Event()
    thread = threading.Thread(target=ask)
    thread.start()
    end = time.monotonic() + 1.5
    while time.monotonic() < end:
        oc.plan(checker, "RRTConnect", iterations=1)
        oc.plan(checker, iterations=1)
    done.set()
    thread.join()
    assert not wrong


def test_no_solution_is_no_path() -> None:
    scene = oc.Scene([0, 0], [10, 10])
    scene.add_obstacle(oc.Body.box(1, 20), (5, 5))
    scene.add_robot(oc.Robot.rigid("disc", oc.Body.disc(0.5), [0, 0], [10, 10], turns=False), [1, 5], [9, 5])
    plan = oc.plan(scene, time=0.2)
    assert not plan.solved and plan.path.shape == (0, 2) and plan.cost == float("inf")
    assert repr(plan).startswith("<Plan: not solved: ")
    with pytest.raises(oc.Error, match="no path"):
        plan.save("nothing.csv")
    with pytest.raises(oc.Error, match="^at: there is no path$"):
        plan.at(0.0)
    assert "DRRTstar" in oc.planner_names()


@pytest.mark.parametrize("planner", ["RRTConnect", "RRTstar", "KPIECE1", "PRM", "DRRTstar"])
def test_who_is_at_the_goal_stays(planner: str) -> None:
    scene = oc.Scene([0, 0], [10, 10])
    scene.add_robot(oc.Robot.rigid("disc", oc.Body.disc(0.3), [0, 0], [10, 10], turns=False), [1, 1], [1, 1])
    plan = oc.plan(scene, planner, time=5)
    assert plan.solved and plan.cost == 0
    assert (plan.path == [1, 1]).all()


def test_callbacks_can_be_called() -> None:
    scene = oc.Scene([0, 0], [10, 10])
    scene.add_robot(oc.Robot.rigid("disc", oc.Body.disc(0.3), [0, 0], [10, 10], turns=False), [1, 1], [2, 1])
    with pytest.raises(TypeError, match="callback must be callable"):
        oc.plan(scene, time=1, callback=3)  # type: ignore[arg-type]
