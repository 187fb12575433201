"""What several tests use"""

import pathlib
import signal
import threading
import time
from typing import Callable

import ompl_certificates as oc
import pytest

TurnsDuring = Callable[[Callable[[], object]], int]

ROOT = pathlib.Path(__file__).resolve().parents[2]


@pytest.fixture(autouse=True)
def interrupts() -> None:
    """Python heeds Ctrl-C, also in a job of the background, which a shell starts with SIGINT ignored."""
    signal.signal(signal.SIGINT, signal.default_int_handler)


@pytest.fixture()
def scenes() -> pathlib.Path:
    """The folder of the demos' scenes"""
    return ROOT / "demos" / "scenes"


@pytest.fixture()
def room() -> oc.Scene:
    """Two discs that change sides, past a box in the middle of a room of 10 by 10"""
    scene = oc.Scene([0, 0], [10, 10], "room")
    scene.add_obstacle(oc.Body.box(2, 2), (5, 5))
    for name, start, goal in (("left", [1, 5], [9, 5]), ("right", [9, 5], [1, 5])):
        body = oc.Body.disc(0.5)
        scene.add_robot(oc.Robot.rigid(name, body, [0, 0], [10, 10], turns=False), start, goal)
    return scene


@pytest.fixture()
def turns_during() -> TurnsDuring:
    """How often another thread of Python, which sleeps for a millisecond each time, gets its turn during a call"""

    def count(call: Callable[[], object]) -> int:
        turns = 0

        def work() -> None:
            nonlocal turns
            while not done.is_set():
                turns += 1
                time.sleep(0.001)

        done = threading.Event()
        thread = threading.Thread(target=work)
        thread.start()
        try:
            call()
        finally:
            done.set()
            thread.join()
        return turns

    return count
