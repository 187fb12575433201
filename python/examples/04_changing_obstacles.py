"""Obstacles move between plans: a Checker keeps what is known of the others, also in a file"""

import pathlib
import tempfile

import numpy as np
import ompl_certificates as oc

scene = oc.Scene([0, 0], [40, 40], "crates")
for i in range(81):
    scene.add_obstacle(oc.Body.box(1.4, 1.4), (4 + 4 * (i % 9), 4 + 4 * (i // 9), 0.3 * i))
crate = scene.add_obstacle(oc.Body.box(3, 3), (10, 10))
for name, start, goal in (("first", [2, 2], [38, 38]), ("second", [38, 38], [2, 2]), ("third", [2, 38], [38, 2])):
    disc = oc.Robot.rigid(name, oc.Body.disc(0.5), [0, 0], [40, 40], turns=False)
    scene.add_robot(disc, start, goal)

checker = oc.Checker(scene)
checker.set_adaptive(False)  # the same counts each time
for step in range(4):
    if step > 0:
        checker.move_obstacle(crate, (10 + 2 * step, 10 + step, 0.2 * step))
    plan = oc.plan(checker, "RRTConnect", time=20)
    print("solved" if plan else "not solved", "after", plan.report["checks"]["asked"], "questions to the obstacles")

certificates = checker.certificates()
print(len(certificates), "certificates: points x, y and their clearance; the largest", certificates[:, 2].max())
with tempfile.TemporaryDirectory() as folder:
    file = str(pathlib.Path(folder) / "crates.certificates")
    checker.save_certificates(file)
    print(checker.load_certificates(file), "certificates were read again")
assert np.isfinite(certificates).all()
