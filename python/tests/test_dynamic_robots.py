"""Robots that move by controls"""

import math
from typing import Any, Dict, List, Tuple

import numpy as np
import ompl_certificates as oc
import pytest

LOW, HIGH = [0, 0], [6, 4]

# How each is made; what its coordinates and controls are called; the limits of these
ROBOTS: Dict[str, Tuple[Any, List[str], List[str], List[List[float]]]] = {
    "integrator": (
        lambda: oc.Robot.integrator("one", oc.Body.disc(0.1), LOW, HIGH, velocity=[[-1, 2], [-3, 4]]),
        ["x", "y"],
        ["vx", "vy"],
        [[-1, -3], [2, 4]],
    ),
    "unicycle": (
        lambda: oc.Robot.unicycle("one", oc.Body.box(0.5, 0.25), LOW, HIGH, 0.5, 1.0, 0.25, (-0.1, 0.2)),
        ["pose.x", "pose.y", "pose.yaw", "velocity.linear", "velocity.angular"],
        ["linear_acceleration", "angular_acceleration"],
        [[-0.25, -0.1], [0.25, 0.2]],
    ),
    "car": (
        lambda: oc.Robot.car("one", oc.Body.box(0.5, 0.25), LOW, HIGH, 0.7, steering=1.0, wheelbase=0.3),
        ["x", "y", "yaw"],
        ["speed", "steering"],
        [[-0.7, -1.0], [0.7, 1.0]],
    ),
    "trailer": (
        lambda: oc.Robot.car(
            "one",
            oc.Body.box(0.5, 0.25),
            LOW,
            HIGH,
            speed=(-0.1, 0.5),
            steering=1.0,
            wheelbase=0.25,
            trailer=oc.Body.box(0.3, 0.25),
            hitch_length=0.5,
            max_hinge_angle=0.8,
        ),
        ["car.x", "car.y", "car.yaw", "trailer.yaw"],
        ["speed", "steering"],
        [[-0.1, -1.0], [0.5, 1.0]],
    ),
}


@pytest.mark.parametrize("kind", ROBOTS)
def test_robots_in_code(kind: str) -> None:
    make, coordinates, controls, limits = ROBOTS[kind]
    low, high = np.array(limits)
    robot = make()
    assert (robot.coordinates, robot.control_names) == (coordinates, controls)
    scene = oc.Scene(LOW, HIGH, "floor")
    scene.add_obstacle(oc.Body.box(0.5, 0.5), (3, 3.5))
    rest = [0.0] * (len(coordinates) - 2)
    scene.add_robot(robot, [1, 1, *rest], [3.5, 2, *rest])
    checker = oc.Checker(scene)
    assert checker.is_valid(np.array([[1, 1, *rest], [3, 3.5, *rest]])).tolist() == [True, False]
    assert checker.clearance([1, 1, *rest]) > 1
    plans = []
    for seed in (1, 2, 3):
        for start, goal in ((scene.start, scene.goal), (scene.goal, scene.start)):
            plan = oc.plan_controls(scene, time=60, seed=seed, start=start, goal=goal, goal_tolerance=1.0)
            assert plan.solved and checker.is_valid(plan.path).all()
            assert plan.control_names == ["one." + name for name in controls]
            plans.append(plan)
    all_controls = np.concatenate([plan.controls for plan in plans])
    assert (all_controls >= low).all() and (all_controls <= high).all()
    assert (all_controls.min(axis=0) < low / 2).all() and (all_controls.max(axis=0) > high / 2).all()
    if kind == "trailer":
        hinge = np.concatenate([plan.path[:, 2] - plan.path[:, 3] for plan in plans])
        assert 0.6 < np.abs((hinge + np.pi) % (2 * np.pi) - np.pi).max() <= 0.8
        with pytest.raises(oc.Error, match="turns the hinge too far$"):
            oc.plan_controls(scene, start=[1, 1, 0, 0.9])


def test_integrators_move_in_space() -> None:
    low, high = [0, 0, 0], [4, 4, 4]
    scene = oc.Scene(low, high, "hall")
    drone = oc.Robot.integrator("drone", oc.Body.sphere(0.2), low, high, velocity=(-1, 2), acceleration=2)
    assert drone.control_names == ["ax", "ay", "az"]
    scene.add_robot(drone, [1, 1, 1, 0, 0, 0], [3, 3, 3, 0, 0, 0])
    plan = oc.plan_controls(scene, time=60, goal_tolerance=0.8)
    assert plan.solved and plan.controls.shape[1] == 3 and plan.path.shape[1] == 6
    assert plan.path[:, 3:].min() >= -1 and plan.path[:, 3:].max() <= 2


def test_bad_robots_are_refused() -> None:
    disc, box = oc.Body.disc(0.1), oc.Body.box(0.5, 0.25)
    trailer: Dict[str, Any] = {"trailer": box, "hitch_length": 0.5, "max_hinge_angle": 0.8}
    wrongs: List[Tuple[Any, Tuple[Any, ...], Dict[str, Any], str]] = [
        (oc.Robot.integrator, (disc,), {"velocity": -1}, "^velocity: must be positive, not -1$"),
        (oc.Robot.integrator, (disc,), {"velocity": math.nan}, "^velocity: must be finite, not nan$"),
        (oc.Robot.integrator, (disc,), {"velocity": [1, 2, 3]}, r"^velocity: .* \(2, 2\), not of shape \(3,\)$"),
        (oc.Robot.integrator, (disc,), {"velocity": 1, "acceleration": (1, -1)}, "^acceleration: low must be below"),
        (oc.Robot.integrator, (disc,), {"velocity": "fast"}, "^velocity: must be numbers$"),
        (oc.Robot.unicycle, (oc.Body.sphere(1),), {"linear": 1, "angular": 1}, "^body: must be a body in the plane"),
        (oc.Robot.unicycle, (box,), {"linear": 1, "angular": 0}, "^angular: must be positive, not 0$"),
        (oc.Robot.unicycle, (box,), {"linear": [1], "angular": 1}, r"^linear: .*number or \(low, high\), not of"),
        (oc.Robot.unicycle, (box,), {"linear": 1, "angular": 1, "linear_acceleration": 1}, "^angular_acceleration: "),
        (oc.Robot.car, (box,), {"speed": 1, "steering": 1.6, "wheelbase": 1}, "steering angle must stay below"),
        (oc.Robot.car, (box,), {"speed": 1, "steering": 1, "wheelbase": 0}, "wheelbase must be positive, not 0"),
        (oc.Robot.car, (box,), {"speed": 1, "steering": 1, "wheelbase": 1, "trailer": box}, "^hitch_length: must be g"),
        (oc.Robot.car, (box,), {"speed": 1, "steering": 1, "wheelbase": 1, **trailer, "hitch_length": -1}, "-1"),
    ]
    for make, bodies, limits, message in wrongs:
        with pytest.raises(oc.Error, match=message):
            make("one", *bodies, LOW, HIGH, **limits)
