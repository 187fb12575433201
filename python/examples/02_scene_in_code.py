"""A scene built in code: a box, a mesh and a point cloud from arrays, a drone and a ball"""

import numpy as np
import ompl_certificates as oc

scene = oc.Scene([0, 0, 0], [10, 10, 5], "yard")
scene.add_obstacle(oc.Body.box(2, 2, 4), (5, 5, 2))

# A roof: two triangles
corners = np.array([[2, 0, 4], [8, 0, 4], [8, 3, 3], [2, 3, 3]], dtype=float)
scene.add_obstacle(oc.Body.mesh(corners, [[0, 1, 2], [0, 2, 3]]))

# What a sensor saw of a bush, in meters
points = np.random.default_rng(1).normal([3, 7, 1], 0.4, (5000, 3))
scene.add_cloud(points, radius=0.05, cell=0.1)

low, high = [0, 0, 0], [10, 10, 5]
drone = oc.Robot.rigid("drone", oc.Body.cylinder(0.4, 0.2), low, high)
ball = oc.Robot.rigid("ball", oc.Body.sphere(0.3), low, high, turns=False)
scene.add_robot(drone, start=[1, 1, 1, 0, 0, 0, 1], goal=[9, 9, 1, 0, 0, 0, 1])
scene.add_robot(ball, start=[9, 9, 3], goal=[1, 1, 3])
scene.validate()


def progress(seconds: float, cost: float) -> bool:
    """Print how far the plan is; end it after two seconds."""
    print(f"  {seconds:.2f} s, cost {cost:.4g}")
    return seconds > 2.0


plan = oc.plan(scene, "RRTConnect", time=20, callback=progress, simplify=True)
print("numbers of a state:", ", ".join(plan.coordinates))
print("solved" if plan else "not solved", plan.path.shape, f"cost {plan.cost:.4g}")
