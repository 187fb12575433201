#!/usr/bin/env python3
"""Prints a URDF file with the collision spheres of another one: with_spheres.py robot.urdf robot_spherized.urdf"""

import sys
import xml.etree.ElementTree as ElementTree


def main() -> None:
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    robot, spheres = (ElementTree.parse(file) for file in sys.argv[1:])
    spheres_of = {link.get("name"): link.findall("collision") for link in spheres.iter("link")}
    for link in robot.iter("link"):
        for collision in link.findall("collision"):
            link.remove(collision)
        link.extend(spheres_of.get(link.get("name"), []))
    print(ElementTree.tostring(robot.getroot(), encoding="unicode"))


if __name__ == "__main__":
    main()
