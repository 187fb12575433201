"""Cells of a grid, and octomaps"""

import array
import pathlib
from typing import Any, List, Tuple

import numpy as np
import ompl_certificates as oc
import pytest
from numpy.typing import NDArray

SIZE = 0.5
RADIUS = 0.3
Bools = NDArray[np.bool_]


def hall(dimension: int) -> oc.Scene:
    """A ball in an empty hall"""
    scene = oc.Scene([0] * dimension, [10] * dimension, "hall")
    ball = oc.Body.disc(RADIUS) if dimension == 2 else oc.Body.sphere(RADIUS)
    robot = oc.Robot.rigid("ball", ball, [0] * dimension, [10] * dimension, turns=False)
    scene.add_robot(robot, [0] * dimension, [10] * dimension)
    return scene


def free(states: NDArray[np.float64], occupied: Bools, first: Tuple[int, ...], origin: Tuple[float, ...]) -> Bools:
    """Whether a ball in each state touches no occupied cell"""
    low = origin + (np.argwhere(occupied) + first) * SIZE
    away = np.maximum(np.maximum(low[None] - states[:, None], states[:, None] - low[None] - SIZE), 0)
    nearest: Bools = np.linalg.norm(away, axis=2).min(axis=1, initial=np.inf) > RADIUS
    return nearest


@pytest.mark.parametrize("dimension", [2, 3])
@pytest.mark.parametrize("method", ["fcl", "standard", "shared"])
def test_cells_that_change_give_the_verdicts_of_the_geometry(dimension: int, method: str) -> None:
    seed = 40 + dimension
    rng = np.random.default_rng(seed)
    occupied = rng.random([24] * dimension) < 0.05
    first = (-2, -1, -2)[:dimension]
    origin = (0.13, -0.27, 0.41)[:dimension]
    scene = hall(dimension)
    scene.add_cloud(np.zeros((0, dimension)), 0.1)
    assert scene.add_grid(occupied, SIZE, first, origin) == 1
    checker = oc.Checker(scene, method)
    states = rng.uniform(0, 10, (1000, dimension))
    for _ in range(5):
        expected = free(states, occupied, first, origin)
        assert (checker.is_valid(states) == expected).all(), f"seed {seed}"
        assert 0 < expected.sum() < len(states)
        begin = rng.integers(0, 16, dimension)
        block = rng.random([8] * dimension) < 0.1
        occupied[tuple(slice(i, i + 8) for i in begin)] = block
        checker.change_grid(1, block, begin + first)

    empty = oc.Checker(hall(dimension), method)
    number = empty.add_grid(np.zeros([3] * dimension, dtype=bool), SIZE, origin=origin)
    assert empty.is_valid(states).all()
    empty.change_grid(number, occupied, first)
    assert (empty.is_valid(states) == free(states, occupied, first, origin)).all()
    with pytest.raises(oc.Error, match=f"origin: must be {dimension} numbers, not 1"):
        empty.add_grid(occupied, SIZE, origin=[1.0])


def test_a_map_of_ros_is_a_grid(tmp_path: pathlib.Path) -> None:
    rng = np.random.default_rng(7)
    pixels = rng.choice(np.array([0, 205, 254], dtype=np.uint8), (30, 24), p=[0.05, 0.05, 0.9])
    (tmp_path / "map.pgm").write_bytes(b"P5\n24 30\n255\n" + pixels.tobytes())
    file = tmp_path / "map.yaml"
    file.write_text("image: map.pgm\nresolution: 0.5\norigin: [-1.2, -2.3, 0.0]\nnegate: 0\n"
                    "occupied_thresh: 0.65\nfree_thresh: 0.196\n")
    cells = pixels[::-1].T
    states = rng.uniform(0, 10, (1000, 2))
    for unknown in (False, True):
        scene = hall(2)
        assert scene.add_occupancy_map_file(file, unknown_occupied=unknown) == 0
        expected = free(states, cells < 254 if unknown else cells == 0, (0, 0), (-1.2, -2.3))
        assert (oc.Checker(scene).is_valid(states) == expected).all()
        assert 0 < expected.sum() < len(states)
    with pytest.raises(oc.Error, match="none.yaml"):
        hall(2).add_occupancy_map_file(tmp_path / "none.yaml")
    with pytest.raises(oc.Error, match="must have 3 dimensions, not 2"):
        hall(3).add_occupancy_map_file(file)


def test_grids_are_refused_by_name() -> None:
    scene = hall(2)
    for occupied, first, message in (
        (np.full((3, 3), -1), (), "^occupied: must be bools$"),
        (np.zeros((3, 3, 3), dtype=bool), (), r"^occupied: must be an array of shape \(nx, ny\), not \(3, 3, 3\)$"),
        (np.zeros((3, 3), dtype=bool), (1, 2, 3), "^first: must be 2 numbers, not 3$"),
        (np.zeros((3, 3), dtype=bool), (32766, 0), "^first: .* from -32768 to 32767, not 32766 to 32768$"),
        (np.zeros((3, 3), dtype=bool), (0, 2**62), "^first: cells must have numbers from -32768 to 32767"),
    ):
        with pytest.raises(oc.Error, match=message):
            scene.add_grid(occupied, SIZE, first)
    for size in (0.0, -1.0, np.nan):
        with pytest.raises(oc.Error, match="size"):
            scene.add_grid(np.ones((3, 3), dtype=bool), size)
    cloud = scene.add_cloud([[5.0, 5.0]], 0.1)
    grid = scene.add_grid([[True]], SIZE)
    checker = oc.Checker(scene)
    with pytest.raises(oc.Error, match="^grid: number 0 is a cloud of points, not of cells$"):
        checker.change_grid(cloud, [[True]])
    with pytest.raises(oc.Error, match="^cloud: number 1 is a map of cells, not of points$"):
        checker.change_cloud(grid, insert=[[1.0, 1.0]])
    with pytest.raises(oc.Error, match="^grid: there is none of number 2$"):
        checker.change_grid(2, [[True]])
    with pytest.raises(oc.Error, match="^cloud 0: remove: There is no point at 9 9 to be removed$"):
        checker.change_cloud(cloud, remove=[[9.0, 9.0]])


def test_unknown_cells_are_free_or_occupied(tmp_path: pathlib.Path) -> None:
    # Of the eight cells about (0.5, 0.5, 0.5) the first is occupied and the last is free. Two bits for each child: 2 is
    # occupied, 1 free, 3 has children itself.
    nodes = [3 << 14] + 14 * [3] + [2 + (1 << 14)]
    head = "# Octomap OcTree binary file\nid OcTree\nsize 18\nres 0.5\ndata\n".encode()
    file = tmp_path / "eight.bt"
    file.write_bytes(head + np.array(nodes, dtype="<u2").tobytes())
    seed = 6
    states = np.random.default_rng(seed).uniform(-1, 2, (2000, 3))
    for unknown in (False, True):
        cells = np.full((2, 2, 2), unknown)
        cells[0, 0, 0] = True
        cells[1, 1, 1] = False
        scene = hall(3)
        scene.add_octomap_file(file, unknown_occupied=unknown)
        assert (oc.Checker(scene).is_valid(states) == free(states, cells, (0, 0, 0), (0, 0, 0))).all(), f"seed {seed}"


def test_an_octomap_is_read_and_changed(scenes: pathlib.Path, tmp_path: pathlib.Path) -> None:
    maps = sorted(scenes.glob("**/*.bt"))
    assert maps
    space = hall(3)
    number = space.add_octomap_file(maps[0])
    checker = oc.Checker(space)
    seed = 5
    states = np.random.default_rng(seed).uniform(-5, 10, (2000, 3))
    valid = checker.is_valid(states)
    assert 0 < valid.sum() < len(states)
    # A message has what a file has after its header.
    data = maps[0].read_bytes().split(b"data\n", 1)[1]
    forms: List[Any] = [data, np.frombuffer(data, dtype=np.int8), list(data), array.array("b", data)]
    for form in forms:
        same = hall(3)
        same.add_octomap(form, 0.25)
        assert (oc.Checker(same).is_valid(states) == valid).all()
    shifted = hall(3)
    shifted.add_octomap(data, 0.25, origin=(1.5, -2.0, 0.25))
    assert (oc.Checker(shifted).is_valid(states + (1.5, -2.0, 0.25)) == valid).mean() > 0.99
    with pytest.raises(oc.Error, match="^octomap: ends before its last node$"):
        shifted.add_octomap(data[:-1], 0.25)
    with pytest.raises(oc.Error, match="^data: must be bytes, from -128 to 255, not 300"):
        shifted.add_octomap([1, 300], 0.25)
    coarse = hall(3)
    coarse.add_octomap_file(maps[0], depth=14)
    assert not (oc.Checker(coarse).is_valid(states) & ~valid).any()
    checker.change_grid(number, np.zeros((400, 400, 400), dtype=bool), (-200, -200, -200))
    assert checker.is_valid(states).all()

    plane = hall(2)
    plane.add_octomap_file(maps[0], heights=(0.2, 1.0))
    assert 0 < oc.Checker(plane).is_valid(states[:, :2]).sum() < len(states)
    with pytest.raises(oc.Error, match="^heights: a planar scene needs those of the slice"):
        plane.add_octomap_file(maps[0])
    with pytest.raises(oc.Error, match="^heights: are for planar scenes alone$"):
        space.add_octomap_file(maps[0], heights=(0.0, 1.0))
    broken = tmp_path / "broken.bt"
    broken.write_bytes(maps[0].read_bytes()[:-40])
    with pytest.raises(oc.Error, match="broken.bt"):
        space.add_octomap_file(broken)


def test_the_next_octomap_takes_the_place_of_the_last(scenes: pathlib.Path) -> None:
    file = sorted(scenes.glob("**/*.bt"))[0]
    data = file.read_bytes().split(b"data\n", 1)[1]
    seed = 7
    states = np.random.default_rng(seed).uniform(-5, 10, (2000, 3))
    scene = hall(3)
    scene.add_octomap(data, 0.25)
    expected = oc.Checker(scene).is_valid(states)
    checker = oc.Checker(hall(3))
    checker.set_adaptive(False)
    free_at_first = checker.is_valid(states)
    grid = checker.add_octomap(data, 0.25)
    assert (checker.is_valid(states) == expected).all() and not expected.all()
    cells = checker.grid_cells(grid)
    assert cells.shape[1] == 3 and len(np.unique(cells, axis=0)) == len(cells)
    # A map with one cell, (0, 0, 0), and then the first one again. Two bits for each child: 3 has children, 2 is full.
    one = np.array([3 << 14] + 14 * [3] + [2], dtype="<u2").tobytes()
    checker.change_octomap(grid, one, 0.25)
    assert checker.grid_cells(grid).tolist() == [[0, 0, 0]]
    known = checker.certificates()
    away = np.abs(known[:, :3] - 0.125) - 0.125
    outside = away.max(axis=1) > 0
    assert outside.sum() > 10
    assert np.allclose(known[outside, 3], np.linalg.norm(np.maximum(away[outside], 0), axis=1)), f"seed {seed}"
    small = hall(3)
    small.add_octomap(one, 0.25)
    assert (checker.is_valid(states) == oc.Checker(small).is_valid(states)).all()
    certificates = len(checker.certificates())
    checker.change_octomap(grid, one, 0.25)
    assert len(checker.certificates()) == certificates
    checker.change_octomap(grid, data, 0.25)
    assert (checker.is_valid(states) == expected).all()
    assert sorted(map(tuple, checker.grid_cells(grid))) == sorted(map(tuple, cells))
    with pytest.raises(oc.Error, match=f"^grid {grid}: has cells of 0.25, not of 0.5$"):
        checker.change_octomap(grid, data, 0.5)
    with pytest.raises(oc.Error, match=f"^grid {grid}: has its origin at 0 0 0, not at 1 0 0$"):
        checker.change_octomap(grid, data, 0.25, origin=(1, 0, 0))
    with pytest.raises(oc.Error, match="^octomap: ends before its last node$"):
        checker.change_octomap(grid, data[:-1], 0.25)
    assert (checker.is_valid(states) == expected).all()
    checker.remove_grid(grid)
    assert (checker.is_valid(states) == free_at_first).all()

    # One node of half the world: too many cells to be changed one by one, and to be listed, but others take its place.
    half = np.array([2], dtype="<u2").tobytes()
    large = checker.add_octomap(half, 0.25)
    with pytest.raises(oc.Error, match=rf"^grid {large}: has \d+ occupied cells, more than 100000000$"):
        checker.grid_cells(large)
    checker.change_octomap(large, one, 0.25)
    assert checker.grid_cells(large).tolist() == [[0, 0, 0]]
    coarse = checker.add_octomap(data, 0.25, depth=15)
    checker.change_octomap(coarse, data, 0.25, depth=15)
    with pytest.raises(oc.Error, match=f"^grid {coarse}: has cells of "):
        checker.change_octomap(coarse, data, 0.5, depth=15)
