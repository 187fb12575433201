"""Times a million states, checked in one batch from Python and one by one in C++, by turns: batch.py CHECK_STATES"""

import pathlib
import statistics
import subprocess
import sys
import tempfile
import time

import numpy as np
import ompl_certificates as oc

SCENES = pathlib.Path(__file__).resolve().parents[2] / "demos" / "scenes"
STATES, ROUNDS = 1000000, 5


def main() -> None:
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "states.bin"
        for name in ("paper_one_disc", "paper_five_discs", "maze"):
            path = str(SCENES / f"{name}.yaml")
            scene = oc.load_scene(path)
            rng = np.random.default_rng(1)
            low, high = np.minimum(scene.start, scene.goal), np.maximum(scene.start, scene.goal)
            states = rng.uniform(low, high, (STATES, len(low)))
            states.tofile(file)
            python, cpp = [], []
            for _ in range(ROUNDS):
                checker = oc.Checker(scene)
                begin = time.perf_counter()
                valid = checker.is_valid(states)
                python.append(time.perf_counter() - begin)
                answer = subprocess.run([sys.argv[1], path, str(file)], check=True, capture_output=True, text=True)
                seconds, count = answer.stdout.split()
                cpp.append(float(seconds))
                if int(count) != valid.sum():
                    sys.exit(f"{name}: {valid.sum()} valid states in Python, {count} in C++")
            ours, theirs = statistics.median(python), statistics.median(cpp)
            print(f"{name}: Python {ours:.3f} s, C++ {theirs:.3f} s, ratio {ours / theirs:.2f}")


main()
