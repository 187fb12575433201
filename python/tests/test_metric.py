"""The distances and motions of a team, for planners of one's own"""

from __future__ import annotations

import math

import numpy as np
import pytest

import ompl_certificates as oc

HALF = math.sqrt(0.5)


@pytest.fixture()
def mixed() -> oc.Checker:
    """A disc, whose distances count twice, and a bar that turns"""
    scene = oc.Scene([0, 0], [10, 10], "mixed")
    disc = oc.Robot.rigid("disc", oc.Body.disc(0.5), [0, 0], [10, 10], turns=False)
    scene.add_robot(disc, [1, 1], [9, 1], weight=2.0)
    scene.add_robot(oc.Robot.rigid("bar", oc.Body.box(1, 0.2), [0, 0], [10, 10]), [1, 5, 0], [9, 5, 0])
    return oc.Checker(scene)


def test_distances_are_those_of_the_team(mixed: oc.Checker) -> None:
    start, end = [1, 1, 1, 5, 0], [4, 5, 4, 9, 0]
    # The team's is the root of the sum of squares.
    length = math.hypot(2 * 5, 5)
    assert math.isclose(mixed.distance(start, end), length)
    ends = np.array([end, start, [1, 1, 1, 5, 2 * math.pi]])
    assert np.allclose(mixed.distance(start, ends), [length, 0, 0])
    assert np.allclose(mixed.distance(ends, start), mixed.distance([start] * 3, ends))
    plan = oc.plan(mixed, "RRTConnect", time=20, first=True)
    assert math.isclose(plan.cost, mixed.distance(plan.path[:-1], plan.path[1:]).sum())
    turned = mixed.distance([[5, 5, 5, 5, 3.0]], [[5, 5, 5, 5, -3.0]])
    assert turned.shape == (1,) and turned[0] < 0.2, "the shorter way"


def test_states_are_on_the_way(mixed: oc.Checker) -> None:
    start, end = [1, 1, 1, 5, 3.0], [3, 1, 1, 7, -3.0]
    middle = mixed.interpolate(start, end, 0.5)
    assert np.allclose(np.abs(middle), [2, 1, 1, 6, math.pi])
    rows = mixed.interpolate(start, end, np.linspace(0, 1, 11))
    assert rows.shape == (11, 5) and np.allclose(rows[[0, -1]], [start, end])
    assert (np.abs(rows[:, 4]) <= math.pi).all()
    assert np.allclose(mixed.distance(start, rows), np.linspace(0, 1, 11) * mixed.distance(start, end))
    each = mixed.interpolate([start, end], [end, start], [0.25, 0.75])
    assert np.allclose(each[0], each[1])
    assert mixed.interpolate([start, end], end, 0.5).shape == (2, 5)
    assert mixed.interpolate([start], [end], 0.5).shape == (1, 5)


def test_quaternions_turn_along_the_shortest_way() -> None:
    scene = oc.Scene([0] * 3, [9] * 3)
    box = oc.Robot.rigid("box", oc.Body.box(1, 1, 1), [0] * 3, [9] * 3)
    scene.add_robot(box, [1, 1, 1, 0, 0, 0, 1], [2, 2, 2, 0, 0, 0, 1])
    checker = oc.Checker(scene)
    half = checker.interpolate([1, 1, 1, 0, 0, 0, 1], [3, 1, 1, 0, 0, 1, 0], 0.5)
    assert np.allclose(half, [2, 1, 1, 0, 0, HALF, HALF])
    with pytest.raises(oc.Error, match="^ends: a quaternion must have length 1, not 2.0"):
        checker.distance([1, 1, 1, 0, 0, 0, 1], [1, 1, 1, 0, 0, 0, 2])


def test_states_that_are_nowhere_have_no_distance(mixed: oc.Checker) -> None:
    start = [1.0, 1.0, 1.0, 5.0, 0.0]
    ends = np.array([start, [math.nan, 1, 1, 5, 0], [1, 1, 1, 5, math.inf]])
    assert np.isnan(mixed.distance(start, ends)).tolist() == [False, True, True]
    assert np.isnan(mixed.interpolate(start, ends, 0.5)).all(axis=1).tolist() == [False, True, True]


def test_wrong_shapes_and_fractions_are_refused(mixed: oc.Checker) -> None:
    states = np.ones((3, 5))
    with pytest.raises(oc.Error, match=r"^starts: must be an array of shape \(n, 5\)"):
        mixed.distance(np.ones(4), states)
    with pytest.raises(oc.Error, match="^ends: must be one, or as many as starts: 3, not 2$"):
        mixed.distance(states, states[:2])
    with pytest.raises(oc.Error, match="^t: must be one, or as many as starts: 3, not 2$"):
        mixed.interpolate(states, states, [0.0, 1.0])
    for wrong in (-0.1, 1.1, math.nan):
        with pytest.raises(oc.Error, match="^t: must be from 0 to 1, not "):
            mixed.interpolate(states, states, wrong)
    with pytest.raises(oc.Error, match=r"^t: must be a number or an array of shape \(n,\), not \(1, 1\)$"):
        mixed.interpolate(states, states, [[0.5]])
