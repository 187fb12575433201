"""Robots that drive while a sensor sees new points: each frame asks whether their path is still free, and plans anew"""

import numpy as np
import ompl_certificates as oc

low, high = [0, 0], [8, 5]
scene = oc.Scene(low, high, "yard")
scene.add_obstacle(oc.Body.box(0.5, 2), (4, 2.5))
scan = scene.add_cloud(np.empty((0, 2)), radius=0.05)
for name, y in (("first", 1.0), ("second", 4.0)):
    cart = oc.Robot.unicycle(name, oc.Body.box(0.5, 0.3), low, high, linear=(-0.2, 0.5), angular=1.0)
    scene.add_robot(cart, start=[1, y, 0], goal=[7, y, 0])

checker = oc.Checker(scene, motion="continuous")
plan = oc.plan_controls(checker, time=20, simplify=True)
print(plan)
driven = 0.0  # for how many seconds of this plan
for frame in range(1, 100):
    if not plan or driven >= plan.cost:
        break
    driven = min(driven + 1.0, plan.cost)
    state = plan.at(driven)
    if frame in (2, 4):  # somebody puts a fence into the first cart's way: points a meter ahead of it
        ahead = state[0] + 1.0
        fence = [[ahead, y] for y in np.arange(state[1] - 0.5, state[1] + 0.5, 0.05)]
        checker.change_cloud(scan, insert=checker.without_robots(fence, state, padding=0.1))
    # What is behind them does not matter.
    if any(plan.times[step + 1] > driven for step in plan.prove(checker).unproved):
        plan = oc.plan_controls(checker, start=state, time=20, simplify=True)
        driven = 0.0
        print(f"frame {frame}: in the way; from here {plan}")
if plan:
    print("there after", frame, "frames, at", np.round(plan.path[-1], 2))
