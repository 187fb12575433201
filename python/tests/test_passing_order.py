"""Who passes first, for robots that are late"""

import random

import numpy as np
import ompl_certificates as oc
import pytest


def crossing() -> oc.Scene:
    """Two discs on a floor, the first from left to right, the second from below"""
    scene = oc.Scene([0, 0], [10, 10], "crossing")
    for name, start, goal in (("first", [1, 5], [9, 5]), ("second", [5, 1], [5, 9])):
        scene.add_robot(oc.Robot.rigid(name, oc.Body.disc(0.5), [0, 0], [10, 10], turns=False), start, goal)
    return scene


def is_reached_when_all_heed(plan: oc.Plan, order: oc.PassingOrder, checker: oc.Checker, seed: int) -> bool:
    """Whether late robots reach their goals, and no two of them touch"""
    chance = random.Random(seed)
    stages = len(order.times) - 1
    ended = [0, 0]
    while min(ended) < stages:
        free = [robot for robot in range(2) if order.may_begin(robot, ended)]
        leader = chance.choice(free)
        moving = order.group(leader, ended[leader])
        for part in np.linspace(0, 1, 5):
            state = np.empty(4)
            for robot in range(2):
                stage = ended[robot]
                end = order.times[min(stage + 1, stages)]
                way = part * (end - order.times[stage]) if robot in moving else 0.0
                own = slice(2 * robot, 2 * robot + 2)
                state[own] = plan.at(order.times[stage] + way)[own]
            if not checker.is_valid(state):
                return False
        for robot in moving:
            ended[robot] += 1
    return True


def test_late_robots_keep_the_order() -> None:
    scene = crossing()
    checker = oc.Checker(scene, motion="continuous")
    plan = oc.plan(checker, time=60, iterations=300, seed=1)
    order = plan.passing_order(0.5)
    assert order.times[0] == 0 and order.times[-1] == plan.times[-1]
    assert np.diff(order.times).max() <= 0.5 + 1e-9
    assert order.waits.dtype == np.int64 and order.waits.shape[1] == 4 and len(order.waits) > 0
    assert order.meetings.shape[1] == 3
    for seed in range(20):
        assert is_reached_when_all_heed(plan, order, checker, seed), seed
    meetings = plan.passing_order(5).meetings
    assert len(meetings) > 0
    assert plan.passing_order(5).group(0, meetings[0][2]) == [0, 1]
    robot, stage, other, other_stage = order.waits[-1]
    assert other_stage < stage
    ended = np.array([stage, stage])
    ended[other] = other_stage
    assert not order.may_begin(robot, ended)
    assert repr(order).startswith(f"<PassingOrder: {len(order.times) - 1} stages, {len(order.waits)} waits, ")


def test_what_makes_no_order_is_refused() -> None:
    scene = crossing()
    plan = oc.plan(scene, time=60, iterations=100, seed=1)
    for step in (0, -1, float("nan"), 1e-6):
        with pytest.raises(oc.Error, match="step"):
            plan.passing_order(step)
    order = plan.passing_order(1)
    with pytest.raises(oc.Error, match="2 robots"):
        order.may_begin(0, [0])
    with pytest.raises(oc.Error, match="no robot 2"):
        order.may_begin(2, [0, 0])
    scene.add_obstacle(oc.Body.box(10, 1), (5, 3))
    unsolved = oc.plan(scene, time=0.1)
    with pytest.raises(oc.Error, match="^passing_order: there is no path$"):
        unsolved.passing_order(1)
