#!/usr/bin/env python3
"""Looks for includes that point up or sideways: rooms.py FOLDER, where FOLDER holds src/ and include/.

DEPTHS lists the rooms, the lowest first. A room may include itself and the rooms of lower lines."""
import pathlib
import re
import sys

DEPTHS = [
    ["files"],
    ["geometry"],
    ["neighbors", "robots", "obstacles"],
    ["certificates", "team"],
    ["validity"],
    ["control", "planning", "octomap"],
    ["scene"],
    ["pictures"],
]
DEPTH_OF = {room: depth for depth, rooms in enumerate(DEPTHS) for room in rooms}


def complaints(root, file, room):
    """The forbidden includes of a file of that room"""
    for number, line in enumerate(file.read_text(encoding="utf-8").splitlines(), 1):
        include = re.match(r'\s*#\s*include\s*[<"](?:ompl_certificates/)?(\w+)/\w+\.h[>"]', line)
        if not include or include[1] not in DEPTH_OF or include[1] == room:
            continue
        if DEPTH_OF[include[1]] >= DEPTH_OF[room]:
            where = "above" if DEPTH_OF[include[1]] > DEPTH_OF[room] else "beside"
            yield f"{file.relative_to(root)}:{number}: {room} includes {include[1]}, which is {where} it"


def main():
    root = pathlib.Path(sys.argv[1]).resolve()
    found, files = [], 0
    for top in (root / "src", root / "include" / "ompl_certificates"):
        for file in sorted(top.rglob("*")):
            if not file.is_file():
                continue
            room = file.relative_to(top).parts[0]
            if room not in DEPTH_OF:
                found.append(f"{file.relative_to(root)}: is in no room")
                continue
            files += 1
            found += complaints(root, file, room)
    print("\n".join(found + [f"{files} files, {len(found)} faults"]))
    return 1 if found or files == 0 else 0


sys.exit(main())
