#!/usr/bin/env python3
"""Compares two reports of plan_team: was it the same tree, and how much less time went into checking?

Exits with 1 if the runs were to be equal (same scene, planner, seed and iterations) and the trees differ.
"""

import json
import sys

ROWS = [
    ("method", "method"),
    ("solved", "solved"),
    ("cost", "cost"),
    ("iterations", "iterations"),
    ("states in the tree", "tree.states"),
    ("digest of the tree", "tree.digest"),
    ("robot poses checked", "checks.robot_poses"),
    ("  the obstacles asked", "checks.asked"),
    ("  by clearances", "checks.by_clearances"),
    ("  by the contact test", "checks.by_contact"),
    ("  by FCL", "checks.exact"),
    ("calls of FCL", "checks.exact_calls"),
    ("motions checked", "checks.motions"),
    ("certificates", "checks.certificates"),
    ("seconds, total", "seconds.total"),
    ("seconds, checking", "seconds.checking"),
    ("seconds, nearest", "seconds.nearest"),
]


def value(report, key):
    for part in key.split("."):
        report = report.get(part) if isinstance(report, dict) else None
    return report


def text(item):
    if item is None:
        return "-"
    if isinstance(item, bool):
        return "yes" if item else "no"
    if isinstance(item, float):
        return f"{item:.6g}"
    return str(item)


def ratio(a, b):
    if not isinstance(a, (int, float)) or not isinstance(b, (int, float)) or b <= 0:
        return "-"
    return f"{a / b:.2f}"


def main():
    if len(sys.argv) != 3:
        sys.exit("usage: compare_reports.py A.json B.json")
    reports = []
    for name in sys.argv[1:]:
        with open(name, encoding="utf-8") as file:
            reports.append(json.load(file))

    for label, key in ROWS:
        a, b = (text(value(report, key)) for report in reports)
        print(f"{label:<22}{a:>22}{b:>22}")

    digests = [value(report, "tree.digest") for report in reports]
    same_tree = digests[0] is not None and digests[0] == digests[1]
    same_run = all(
        value(reports[0], key) == value(reports[1], key) for key in ("scene", "planner", "seed", "iterations")
    )

    a, b = (value(report, "method") for report in reports)
    print()
    print("The trees are equal, node for node." if same_tree else "The trees DIFFER.")
    print(f"Calls of FCL, {a} / {b}: {ratio(*(value(report, 'checks.exact_calls') for report in reports))}")
    print(f"Time in checking, {a} / {b}: {ratio(*(value(report, 'seconds.checking') for report in reports))}")
    return 1 if same_run and not same_tree else 0


if __name__ == "__main__":
    sys.exit(main())
