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
    AttachedBody,
    Body,
    Checker,
    Error,
    Plan,
    Proof,
    Robot,
    Scene,
    __version__,
    _plan,
    load_moveit,
    load_scene,
    planner_names,
    planner_parameters,
    scene_from_yaml,
)
from ._view import View

__all__ = [
    "AttachedBody",
    "Body",
    "Checker",
    "Error",
    "Plan",
    "Proof",
    "Robot",
    "Scene",
    "View",
    "__version__",
    "load_moveit",
    "load_scene",
    "plan",
    "planner_names",
    "planner_parameters",
    "scene_from_yaml",
]

Parameter = Union[str, int, float, bool, "np.integer[Any]", "np.floating[Any]", np.bool_]


def plan(
    scene: Union[Scene, Checker],
    planner: Optional[str] = None,
    method: Optional[str] = None,
    time: float = 10.0,
    seed: int = 1,
    callback: Optional[Callable[[float, float], object]] = None,
    *,
    motion: Optional[str] = None,
    objective: str = "length",
    iterations: Optional[int] = None,
    first: bool = False,
    simplify: bool = False,
    parameters: Optional[Mapping[str, Parameter]] = None,
    start: Optional[ArrayLike] = None,
    goal: Optional[ArrayLike] = None,
) -> Plan:
    """Plan for the team of a scene, or of a Checker, which then keeps what is learned for its next plan.

    planner: one of planner_names(); by default DRRTstar for two or more robots, RRTConnect for one
    method: shared, partial, basic, standard or fcl; by default shared. A Checker has its own.
    motion: discrete or continuous; by default discrete. A Checker has its own.
    time: how long to plan at most, in seconds
    seed: of OMPL's random numbers; the same seed grows the same tree. They are one for the whole process.
    callback: called some 20 times in a second with the seconds so far and the best cost, which is infinite if
        the planner does not tell it. The plan ends when it returns what Python takes for true; what it raises is
        raised by plan().
    objective: length, sum, makespan or arrival
    iterations: end after that many evaluations of the termination condition, too; at least 1
    first: end with the first solution, also if the planner could lower its cost
    simplify: shorten the solution, for at most as long again
    parameters: of the planner, such as {"range": 2.0}; planner_parameters() names them
    start, goal: of shape (coordinates,), in place of those of the scene, or of the last plan of the Checker

    Other Python threads run meanwhile. Ctrl-C raises KeyboardInterrupt, once the planner looks at its termination
    condition. Some of OMPL's do not always: AITstar plans on until it has found valid random states.
    """
    for name, number, most in (("iterations", iterations, 2**64 - 1), ("seed", seed, 2**32 - 1)):
        if number is not None and not 1 <= number <= most:
            raise Error(f"{name}: must be from 1 to {most}, not {number}")
    if isinstance(scene, Checker):
        for name, value in (("method", method), ("motion", motion)):
            if value is not None:
                raise Error(f"{name}: a Checker has its own")
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
