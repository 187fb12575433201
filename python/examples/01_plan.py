"""A scene from a file, a plan for its team, and the path as a numpy array"""

import pathlib

import numpy as np
import ompl_certificates as oc

SCENES = pathlib.Path(__file__).resolve().parents[2] / "demos" / "scenes"

scene = oc.load_scene(str(SCENES / "paper_five_discs.yaml"))
plan = oc.plan(scene, time=2.0, seed=1)
print(f"{scene.name}: {'solved' if plan else 'not solved'}, cost {plan.cost:.4g}, {len(plan.path)} states")
for robot in range(len(scene.robots)):
    positions = plan.path.reshape(-1, len(scene.robots), 2)[:, robot]
    way = np.linalg.norm(np.diff(positions, axis=0), axis=1).sum()
    print(f"  {scene.robots[robot].name} moves {way:.4g}")
checks = plan.report["checks"]
print(f"  {checks['robot_poses']} robot poses checked, {checks['certified_free']} of them by certificates")
