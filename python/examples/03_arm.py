"""An arm from URDF and SRDF files, checked in batches"""

import pathlib
import time

import numpy as np
import ompl_certificates as oc

ARMS = pathlib.Path(__file__).resolve().parents[2] / "demos" / "scenes" / "arms"

arm = oc.Robot.arm(str(ARMS / "arm6.urdf"), str(ARMS / "arm6.srdf"), "arm")
scene = oc.Scene([-2, -2, -2], [2, 2, 2], "cell")
scene.add_obstacle(oc.Body.box(0.3, 0.3, 0.3), (0.6, 0.4, 0.5))
scene.add_robot(arm, start=[0] * 6, goal=[0.4] * 6)
print(arm.name, "moves", ", ".join(arm.coordinates))

checker = oc.Checker(scene)
states = np.random.default_rng(1).uniform(-1.5, 1.5, (100000, 6))
begin = time.perf_counter()
valid = checker.is_valid(states)
seconds = time.perf_counter() - begin
print(f"{valid.sum()} of {len(states)} random states are valid, {1e6 * seconds / len(states):.2f} µs each")
motions = checker.check_motions(states[valid][:1000], states[valid][1000:2000])
print(f"{motions.sum()} of {len(motions)} motions between them are")
print("one that is not:", checker.describe_collision(states[~valid][0]))
