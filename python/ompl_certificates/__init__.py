"""Planning for teams of robots with safety certificates, by OMPL's planners.

    import ompl_certificates as oc

    scene = oc.load_scene("demos/scenes/paper_five_discs.yaml")
    plan = oc.plan(scene, time=2.0)
    print(plan.solved, plan.cost, plan.path.shape)

Lengths are in the scene's unit, angles in radians, times in seconds. Errors are exceptions of class Error.
"""

from __future__ import annotations

from typing import Any, Callable, Mapping, Optional, Union

import numpy as np
from numpy.typing import ArrayLike

from ._core import (
    AnyOf,
    ArmFile,
    AttachedBody,
    Body,
    Checker,
    ControlPlan,
    Error,
    LinkPose,
    PassingOrder,
    Plan,
    Proof,
    Robot,
    Scene,
    TouchableObstacle,
    Zone,
    __version__,
    _plan,
    _plan_controls,
    control_planner_names,
    control_planner_parameters,
    load_cloud,
    load_moveit,
    load_scene,
    planner_names,
    planner_parameters,
    scene_from_yaml,
)
from ._view import View

__all__ = [
    "AnyOf",
    "ArmFile",
    "AttachedBody",
    "Body",
    "Checker",
    "ControlPlan",
    "Error",
    "LinkPose",
    "PassingOrder",
    "Plan",
    "Proof",
    "Robot",
    "Scene",
    "TouchableObstacle",
    "View",
    "Zone",
    "__version__",
    "control_planner_names",
    "control_planner_parameters",
    "load_cloud",
    "load_moveit",
    "load_scene",
    "plan",
    "plan_controls",
    "planner_names",
    "planner_parameters",
    "scene_from_yaml",
]

Whole = Union[int, "np.integer[Any]"]
Number = Union[float, "np.floating[Any]", Whole]
Parameter = Union[str, bool, np.bool_, Number]


def _require_range(name: str, number: object, most: Whole) -> None:
    """Raise an Error that names an argument which is no whole number from 1 to most."""
    if isinstance(number, bool) or not isinstance(number, (int, np.integer)):
        raise Error(f"{name}: must be a whole number, not {number!r}")
    if not 1 <= number <= most:
        raise Error(f"{name}: must be from 1 to {most}, not {number}")


def _require_kind(name: str, value: object, kind: Union[type, tuple[type, ...]], what: str) -> None:
    """Raise an Error that names an argument which is not of some kind."""
    if not isinstance(value, kind):
        raise Error(f"{name}: must be {what}, not {value!r}")


def _require_options(
    planner: object, time: object, iterations: Optional[Whole], seed: Whole, parameters: Optional[Mapping[Any, Any]]
) -> None:
    """Raise an Error for what no plan can be made of."""
    # What Python takes for false is no default.
    if planner is not None and (not isinstance(planner, str) or not planner):
        raise Error(f"planner: must be the name of one, not {planner!r}")
    _require_kind("time", time, (int, float, np.integer, np.floating), "a number")
    if iterations is not None:
        _require_range("iterations", iterations, 2**64 - 1)
    _require_kind("seed", seed, (int, np.integer), "a whole number")
    _require_range("seed", seed, 2**32 - 1)
    if parameters is not None:
        _require_kind("parameters", parameters, Mapping, "a dict from names to values")
        for name in parameters:
            _require_kind("parameters", name, str, "a dict from names to values, and names must be texts")


def _require_world(scene: object, method: Optional[str], motion: Optional[str]) -> None:
    """Raise an Error for what cannot be planned in."""
    if not isinstance(scene, (Scene, Checker)):
        raise Error(f"scene: must be a Scene or a Checker, not a {type(scene).__name__}")
    if isinstance(scene, Checker):
        for name, value in (("method", method), ("motion", motion)):
            if value is not None:
                raise Error(f"{name}: a Checker has its own")


def plan(
    scene: Union[Scene, Checker],
    planner: Optional[str] = None,
    method: Optional[str] = None,
    time: Number = 10.0,
    seed: Whole = 1,
    callback: Optional[Callable[[float, float], object]] = None,
    *,
    motion: Optional[str] = None,
    objective: str = "length",
    iterations: Optional[Whole] = None,
    first: bool = False,
    simplify: bool = False,
    parameters: Optional[Mapping[str, Parameter]] = None,
    start: Optional[ArrayLike] = None,
    goal: Union[ArrayLike, AnyOf, LinkPose, Zone, Mapping[str, Union[ArrayLike, AnyOf, LinkPose, Zone]], None] = None,
) -> Plan:
    """Plan for the team of a scene, or of a Checker, which then keeps what is learned for its next plan.

    planner: one of planner_names(); by default DRRTstar for two or more robots, RRTConnect for one
    method: shared, partial, basic, standard or fcl; by default shared. A Checker has its own.
    motion: discrete or continuous; by default discrete. A Checker has its own.
    time: how long to plan at most, in seconds
    seed: of OMPL's random numbers, at least 1; the same seed grows the same tree, but for planners that go by the
        clock or use threads, such as PRM, PRMstar, CForest and pRRT. They are one for the whole process.
    callback: called some 20 times in a second, also while the solution is simplified, with the seconds so far and the
        best cost, which is infinite if the planner does not tell it. The plan ends when it returns what Python takes
        for true; what it raises is raised by plan(), with what was found by then as its attribute plan.
    objective: length, sum, makespan or arrival
    iterations: end after that many evaluations of the termination condition, too; at least 1
    first: end with the first solution, also if the planner could lower its cost
    simplify: shorten the solution, for at most as long again
    parameters: of the planner, such as {"range": 2.0}; planner_parameters() names them
    start, goal: of shape (coordinates,), in place of those of the scene, or of the last plan of the Checker. The goal
        may also be a LinkPose, a Zone or an AnyOf, if there is one robot. Or it is a dict from the names of robots to
        such goals or to their coordinates; robots that it does not name keep their goals.

    Other Python threads run meanwhile. Ctrl-C raises KeyboardInterrupt, once the planner looks at its termination
    condition. Some of OMPL's do not always: AITstar plans on until it has found valid random states. What was found
    by then is not lost: it is the exception's attribute plan.
    """
    _require_options(planner, time, iterations, seed, parameters)
    _require_world(scene, method, motion)
    if isinstance(scene, Checker):
        checker = scene
    else:
        checker = Checker(
            scene,
            "shared" if method is None else method,
            "discrete" if motion is None else motion,
        )
    return _plan(
        checker,
        planner or "",
        time,
        iterations or 0,
        seed,
        callback,
        objective,
        first,
        simplify,
        dict(parameters or {}),
        start,
        goal,
    )


def plan_controls(
    scene: Union[Scene, Checker],
    planner: Optional[str] = None,
    method: Optional[str] = None,
    time: Number = 10.0,
    seed: Whole = 1,
    callback: Optional[Callable[[float, float], object]] = None,
    *,
    motion: Optional[str] = None,
    goal_tolerance: Number = 0.5,
    iterations: Optional[Whole] = None,
    nearest: str = "kdtree",
    parameters: Optional[Mapping[str, Parameter]] = None,
    start: Optional[ArrayLike] = None,
    goal: Optional[ArrayLike] = None,
    step: Number = 0.1,
    min_steps: Whole = 1,
    max_steps: Whole = 10,
    simplify: bool = False,
) -> ControlPlan:
    """Plan by controls for the team of a scene, or of a Checker, which then keeps what is learned for its next plan.

    All robots must have dynamics, such as Robot.unicycle().

    planner: one of control_planner_names(); by default PrioritizedRRT for several robots, which plans robot by robot,
        and RRT for one
    motion: discrete checks the states at the ends of steps, continuous proves each step free between them; limits are
        checked at the ends in both. By default discrete; a Checker has its own.
    goal_tolerance: how far from the goal the team may end, in its space's distance (docs/controls.md)
    nearest: what RRT and SST look for near states in, kdtree or gnat
    parameters: of the planner, such as {"goal_bias": 0.1}; control_planner_parameters() names them
    step: how long a step takes, in seconds
    min_steps, max_steps: for how many steps a control is held
    simplify: shorten the solution's time, robot by robot, for at most as long again; robots then end at the goal itself
        where that is found, not only near it

    start, goal: of shape (coordinates,), in place of those of the scene, also of that of the Checker

    method, time, seed, callback and iterations are as of plan(). So is what it does with threads and Ctrl-C.
    """
    _require_options(planner, time, iterations, seed, parameters)
    _require_world(scene, method, motion)
    # A control is held to its end, whatever the time: more would not end in time, and Ctrl-C would wait.
    _require_range("max_steps", max_steps, 10**6)
    _require_range("min_steps", min_steps, max_steps)
    for name, value in (("goal_tolerance", goal_tolerance), ("step", step)):
        _require_kind(name, value, (int, float, np.integer, np.floating), "a number")
    return _plan_controls(
        scene if isinstance(scene, Scene) else None,
        scene if isinstance(scene, Checker) else None,
        planner or "",
        "shared" if method is None else method,
        time,
        iterations or 0,
        seed,
        callback,
        "discrete" if motion is None else motion,
        goal_tolerance,
        nearest,
        dict(parameters or {}),
        start,
        goal,
        step,
        min_steps,
        max_steps,
        simplify,
    )
