#!/usr/bin/env python3
"""Where the nanoseconds of a motion go: a table for some scenes and team sizes, as perf sees plans by RRT*.

    budget.py build/bin [--method shared] [--iterations 20000] [--scenes maze,canyon]

Needs Linux's perf and python3-yaml. Scenes among shared meshes are skipped by name where those are absent."""

import argparse
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
from typing import NamedTuple

try:
    import yaml
except ImportError:
    yaml = None

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
SHARED = os.environ.get("OMPL_CERTIFICATES_SHARED_DIR", os.path.join(os.path.dirname(ROOT), "shared"))
FREQUENCY = 4999  # samples in a second

SCENES = {
    "paper_discs": "demos/scenes/paper_three_discs.yaml",
    "maze": "demos/scenes/maze.yaml",
    "canyon": "demos/scenes/canyon.yaml",
    "drones": "demos/scenes/drones_3d.yaml",
    "cubicles": "benchmarks/scenes-shared/cubicles_team.yaml",
    "apartment": "benchmarks/scenes-shared/apartment_team.yaml",
}
PANDA = "panda"

# What a function's own time is for: the first that matches "library function", as perf names them
CATEGORIES = [
    ("random numbers", r"mersenne_twister|generate_canonical|RNG::|Sampler::|normal_distribution|_distribution<"),
    ("neighbors", r"_neighbors\.so|NearestNeighbors|PlannerKdTree|TimedNeighbors"),
    ("clocks", r"clock_gettime|steady_clock|vdso"),
    ("FCL", r"libfcl|libccd|SpatialCheck|PlanarCheck|FclBodies|FclConvex"),
    ("pairs", r"RobotPairs|TwoBodies|SelfPairs|PairGap"),
    ("hints", r"settleByHint|HitMemory|hitsAgain|References|coveringBy|CertificateTree::cover$|findBucket|StandingBodies"),
    ("lookups", r"CertificateTree::(covering|search|prefetch|.*CoverSearch)|CoverSearch"),
    ("new certificates", r"CertificateTree::|ChunkedArray|CertificateLimit"),
    ("contact", r"ontactTest|touch|crossing|overlaps|boxOf<|apart|ContactOf|separat|Overlap|settleTwo|TriangleContact"),
    ("clearances", r"TriangleTree::(distance|find)|lowerToDistance|signedDistance|ClearanceTree|PointTree|CellTree|gap$|Gap"
                   r"|ConvexCover|ConvexSearch|MeshSurface|clearance"),
    ("poses", r"computePoses|placeBodies|sincos|__sin|__cos|transform_transform|Quaternion|toRotation|RigidRobot|Arm::"),
    ("states", r"StateSpace::|ScopedState|acos|interpolate|validSegmentCount|copyState"),
    ("counters, locks", r"Statistics|WorldLock|pthread|tls_get_addr|atomic"),
    ("checks", r"Method::|TeamCheck|MotionCheck|MotionValidator|ValidityChecker|CertifiedEnvironment|SwitchingPolicy"
               r"|ProvenTimes|ExactCheck|PoseQuery|SampledMotion|Body::"),
    ("planner", r"libompl\.so|\bcertificates\b|PlannerTerminationCondition"),
]
OTHER = "other"

# Those of a check, in the order of the table; the others are the planner's.
CHECKS = ["poses", "hints", "lookups", "new certificates", "clearances", "contact", "FCL", "pairs", "checks",
          "counters, locks", "clocks"]


class Sample(NamedTuple):
    """How often a function was met"""

    count: int
    function: str


class Row(NamedTuple):
    """A plan, and the time of a motion by categories"""

    scene: str
    robots: int
    motions: int
    nanoseconds: dict


def read_samples(report: str) -> list:
    """The lines of `perf report -n --sort dso,symbol`, without their comments"""
    line = re.compile(r"^\s*[\d.]+%\s+(\d+)\s+(\S+)\s+\[[.k]\]\s+(.*\S)\s*$")
    matches = (line.match(text) for text in report.splitlines() if not text.startswith("#"))
    return [Sample(int(match[1]), f"{match[2]} {match[3]}") for match in matches if match]


def category_of(function: str) -> str:
    for name, pattern in CATEGORIES:
        if re.search(pattern, function):
            return name
    return OTHER


def group(samples: list) -> dict:
    """How often each category was met"""
    counts = {name: 0 for name, _ in CATEGORIES}
    counts[OTHER] = 0
    for sample in samples:
        counts[category_of(sample.function)] += sample.count
    return counts


class Unmeasured(Exception):
    """Why a scene has no column"""


def fail(message: str) -> None:
    print(f"budget.py: {message}", file=sys.stderr)
    sys.exit(2)


def first_robots(scene: str, robots: int, folder: str) -> str:
    """A file of the scene with its first robots; files that it names are found from anywhere."""
    with open(scene, encoding="utf-8") as file:
        content = yaml.safe_load(file)
    if len(content["robots"]) < robots:
        fail(f"{scene}: it has {len(content['robots'])} robots, not {robots}")
    content["robots"] = content["robots"][:robots]

    def with_whole_paths(node):
        if isinstance(node, dict):
            return {key: os.path.join(os.path.dirname(scene), value) if key == "file" else with_whole_paths(value)
                    for key, value in node.items()}
        return [with_whole_paths(value) for value in node] if isinstance(node, list) else node

    path = os.path.join(folder, "scene.yaml")
    with open(path, "w", encoding="utf-8") as file:
        yaml.safe_dump(with_whole_paths(content), file)
    return path


def profile(arguments: list, iterations: int, options: argparse.Namespace, folder: str) -> tuple:
    """The motions of a plan, and the samples of the program"""
    data, report = os.path.join(folder, "perf.data"), os.path.join(folder, "report.json")
    plan = [os.path.join(options.programs, "certificates"), "plan", *arguments, "--planner", "RRTstar", "--iterations",
            str(iterations), "--method", options.method, "--seed", "1", "--quiet", "--report", report]
    run = subprocess.run(["perf", "record", "-q", "-e", "cpu-clock", "-F", str(FREQUENCY), "-o", data, "--", *plan],
                         capture_output=True, text=True, check=False)
    if not os.path.exists(report):
        raise Unmeasured(run.stderr.strip().splitlines()[-1] if run.stderr.strip() else "perf or the plan failed")
    with open(report, encoding="utf-8") as file:
        motions = json.load(file)["checks"]["motions"]
    os.remove(report)
    listing = subprocess.run(["perf", "report", "-i", data, "-n", "--sort", "dso,symbol", "--stdio"], capture_output=True,
                             text=True, check=False)
    if listing.returncode != 0:
        raise Unmeasured("perf report failed")
    return motions, read_samples(listing.stdout)


def measure(name: str, arguments: list, robots: int, options: argparse.Namespace, folder: str) -> Row:
    # A plan of one iteration takes the time to start, which no motion should pay for.
    motions_before, before = profile(arguments, 1, options, folder)
    motions, samples = profile(arguments, options.iterations, options, folder)
    motions -= motions_before
    total = sum(sample.count for sample in samples)
    for sample in samples:
        if category_of(sample.function) == OTHER and sample.count > 0.02 * total:
            print(f"{name}: in no category: {100.0 * sample.count / total:.1f} % {sample.function}", file=sys.stderr)
    start = group(before)
    return Row(name, robots, motions, {key: max(0.0, 1e9 * (count - start[key]) / FREQUENCY / motions)
                                       for key, count in group(samples).items()})


def plans_of(name: str, folder: str):
    """The arguments of certificates plan, and how many robots it has, for each plan of a scene"""
    if name == PANDA:
        robot = os.path.join(SHARED, "robots", "panda")
        problem = os.path.join(robot, "problems", "bookshelf_small")
        if not os.path.exists(robot):
            raise Unmeasured(f"{robot} is not there")
        yield [os.path.join(problem, "scene0001.yaml"), "--request", os.path.join(problem, "request0001.yaml"),
               "--urdf", os.path.join(robot, "panda.urdf"), "--srdf", os.path.join(robot, "panda.srdf")], 1
        return
    for robots in (1, 3):
        yield [first_robots(os.path.join(ROOT, SCENES[name]), robots, folder)], robots


def measure_all(options: argparse.Namespace) -> list:
    rows = []
    for name in options.scenes:
        with tempfile.TemporaryDirectory() as folder:
            try:
                for arguments, robots in plans_of(name, folder):
                    rows.append(measure(name, arguments, robots, options, folder))
            except Unmeasured as reason:
                print(f"{name}: skipped: {reason}", file=sys.stderr)
    return rows


def print_table(rows: list) -> None:
    names = [*CHECKS, *(name for name, _ in CATEGORIES if name not in CHECKS), OTHER]
    print("| ns a motion | " + " | ".join(f"{row.scene}, {row.robots}" for row in rows) + " |")
    print("|---" * (len(rows) + 1) + "|")
    for name in names:
        print(f"| {name} | " + " | ".join(f"{row.nanoseconds[name]:.0f}" for row in rows) + " |")
    print("| all | " + " | ".join(f"{sum(row.nanoseconds.values()):.0f}" for row in rows) + " |")
    print("| motions | " + " | ".join(str(row.motions) for row in rows) + " |")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("programs", help="folder of certificates, such as build/bin")
    parser.add_argument("--method", default="shared", choices=["fcl", "standard", "basic", "partial", "shared"])
    parser.add_argument("--iterations", type=int, default=20000, help="iterations of each plan")
    parser.add_argument("--scenes", default=[*SCENES, PANDA], type=lambda text: text.split(","),
                        help="scenes, separated by commas; by default all")
    options = parser.parse_args()
    for name in options.scenes:
        if name not in SCENES and name != PANDA:
            fail(f"there is no scene '{name}', only {', '.join([*SCENES, PANDA])}")
    if not shutil.which("perf"):
        fail("perf is not installed (Debian: linux-perf)")
    if yaml is None:
        fail("Python's yaml is not installed (Debian: python3-yaml)")
    if not os.access(os.path.join(options.programs, "certificates"), os.X_OK):
        fail(f"{options.programs} has no program certificates")
    print_table(measure_all(options))


if __name__ == "__main__":
    main()
