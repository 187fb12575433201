#!/usr/bin/python3
"""Makes a planar scene whose checks are expensive from one whose checks are cheap: discs and convex polygons become upright
meshes of the same outlines, finely triangulated, with as many triangles as asked for.

    certificates generate --obstacles 40 --output polygons.yaml
    make_expensive_scene.py polygons.yaml --triangles 100000 --output expensive.yaml

All obstacles together are one mesh of so many triangles, and each robot is one.
"""

import argparse
import math
from pathlib import Path

import trials
import yaml

HEIGHT = 1.0  # of the walls

# Robots reach below the obstacles' floors: no lids lie in one plane, and a robot within an obstacle crosses its floor.
ROBOTS_FLOOR = -0.4


def circle(radius, sides=48):
    # Around the disc, so that the mesh is never smaller.
    radius /= math.cos(math.pi / sides)
    return [(radius * math.cos(2 * math.pi * i / sides), radius * math.sin(2 * math.pi * i / sides))
            for i in range(sides)]


def resampled(outline, points):
    """The outline with about so many points, the corners among them"""
    sides = list(zip(outline, outline[1:] + outline[:1]))
    length = sum(math.dist(a, b) for a, b in sides)
    fine = []
    for a, b in sides:
        pieces = max(1, round(points * math.dist(a, b) / length))
        fine += [(a[0] + (b[0] - a[0]) * i / pieces, a[1] + (b[1] - a[1]) * i / pieces) for i in range(pieces)]
    return fine


class Mesh:
    """Triangles over a grid of points for each outline: up the wall, and over the lid and the floor to the middle"""

    def __init__(self):
        self.vertices, self.triangles = [], []

    def add(self, outline, triangles, floor=0.0):
        around = max(len(outline), round(math.sqrt(triangles)))
        outline = resampled(outline, around)
        around = len(outline)
        across = max(3, round(triangles / (2 * around) / 3))  # rows of each of the three parts
        middle = (sum(x for x, _ in outline) / around, sum(y for _, y in outline) / around)
        rings = [(i / across, 0.0) for i in range(across)]
        rings += [(1.0, HEIGHT * i / across) for i in range(across)]
        rings += [(1.0 - i / across, HEIGHT) for i in range(across + 1)]
        rings = [(scale, z + floor) for scale, z in rings]
        rings[0], rings[-1] = (1e-3, floor), (1e-3, HEIGHT + floor)
        start = len(self.vertices)
        for scale, z in rings:
            self.vertices += [(middle[0] + scale * (x - middle[0]), middle[1] + scale * (y - middle[1]), z)
                              for x, y in outline]
        for ring in range(len(rings) - 1):
            for i in range(around):
                a, b = start + ring * around + i, start + ring * around + (i + 1) % around
                self.triangles += [(a, b, b + around), (a, b + around, a + around)]

    def write(self, file):
        with open(file, "w") as out:
            out.writelines(f"v {x:.9g} {y:.9g} {z:.9g}\n" for x, y, z in self.vertices)
            out.writelines(f"f {a + 1} {b + 1} {c + 1}\n" for a, b, c in self.triangles)
        return {"type": "mesh", "file": Path(file).name}


def placed(shape, file):
    x, y = shape.get("center", (0.0, 0.0))
    if shape.get("angle"):
        raise trials.BadResults(f"{file}: shapes that are turned are not handled")
    if shape["type"] == "disc":
        outline = circle(shape["radius"])
    elif shape["type"] == "polygon":
        outline = shape["vertices"]
    else:
        raise trials.BadResults(f"{file}: only discs and polygons are handled, not {shape['type']}")
    return [(x + px, y + py) for px, py in outline]


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("scene", help="a planar scene of discs and polygons (YAML)")
    parser.add_argument("--triangles", type=int, default=100000, help="of the obstacles, and of each robot (%(default)s)")
    parser.add_argument("--output", required=True, help="the scene to write; its meshes are written next to it")
    arguments = parser.parse_args()
    scene = yaml.safe_load(Path(arguments.scene).read_text())
    output = Path(arguments.output)
    outlines = [placed(shape, arguments.scene) for shape in scene["environment"]["obstacles"]]
    obstacles = Mesh()
    for outline in outlines:
        obstacles.add(outline, arguments.triangles / len(outlines))
    scene["environment"]["obstacles"] = [obstacles.write(output.with_name(output.stem + "_obstacles.obj"))]
    robots = {}
    for robot in scene["robots"]:
        outline = tuple(placed(robot["shape"], arguments.scene))
        if outline not in robots:
            mesh = Mesh()
            mesh.add(list(outline), arguments.triangles, ROBOTS_FLOOR)
            robots[outline] = mesh.write(output.with_name(f"{output.stem}_robot{len(robots) + 1}.obj"))
        robot["shape"] = dict(robots[outline])
    output.write_text(yaml.safe_dump(scene, sort_keys=False, default_flow_style=None))
    print(f"{output}: {len(obstacles.triangles)} triangles of obstacles")


if __name__ == "__main__":
    trials.run_tool(main)
