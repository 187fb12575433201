"""Robots that move by controls: a cart that steers and a puck that is pushed, past a wall thinner than a step"""

import numpy as np
import ompl_certificates as oc

low, high = [0, 0], [6, 4]
scene = oc.Scene(low, high, "doorway")
for y in (0.5, 3.5):
    scene.add_obstacle(oc.Body.box(0.02, 1), (3, y))

# The cart's controls are its speeds, up to 0.5 m/s and 1 rad/s; the puck's are its accelerations.
cart = oc.Robot.unicycle("cart", oc.Body.box(0.5, 0.25), low, high, linear=0.5, angular=1.0)
puck = oc.Robot.integrator("puck", oc.Body.disc(0.15), low, high, velocity=0.5, acceleration=2.0)
scene.add_robot(cart, start=[2, 2, 0], goal=[4, 2.2, 0])
scene.add_robot(puck, start=[4, 1, 0, 0], goal=[4.5, 3, 0, 0])

plan = oc.plan_controls(scene, motion="continuous", goal_tolerance=1.0, time=20, simplify=True)
print(plan)
print("numbers of a state:", ", ".join(plan.coordinates))
print("controls:", ", ".join(plan.control_names))
if plan:
    for time, state, control in list(zip(plan.times, plan.path, plan.controls))[:3]:
        print(f"  {time:.1f} s: at", np.round(state, 2), "then", np.round(control, 2))
    # Between the steps, too: here 1000 times in a second
    states = plan.at(np.arange(0, plan.cost, 0.001))
    print(oc.Checker(scene).is_valid(states).sum(), "of", len(states), "states on the way are free")
