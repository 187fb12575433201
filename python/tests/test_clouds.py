"""Clouds of points that come and go"""

import pathlib
import signal
import threading
import time
from typing import Any, Callable, List, Tuple

import numpy as np
import ompl_certificates as oc
import pytest
from numpy.typing import NDArray

RADIUS = 0.2
Points = NDArray[np.float64]


def world(dimension: int, points: Points) -> Tuple[oc.Scene, int]:
    """A ball among a box and points; the scene and the number of its cloud"""
    scene = oc.Scene([0] * dimension, [10] * dimension, "cloud")
    scene.add_obstacle(oc.Body.box(*[1] * dimension), [5] * dimension)
    ball = oc.Body.disc(0.3) if dimension == 2 else oc.Body.sphere(0.3)
    robot = oc.Robot.rigid("ball", ball, [0] * dimension, [10] * dimension, turns=False)
    scene.add_robot(robot, [0] * dimension, [10] * dimension)
    return scene, scene.add_cloud(points, RADIUS)


def distances(states: Points, points: Points) -> Points:
    """From each state to the surfaces of the nearest point and of the box"""
    nearest = np.linalg.norm(states[:, None] - points[None], axis=2).min(axis=1) - RADIUS
    least: Points = np.minimum(nearest, np.linalg.norm(np.maximum(np.abs(states - 5) - 0.5, 0), axis=1))
    return least


@pytest.mark.parametrize("dimension", [2, 3])
@pytest.mark.parametrize("method", ["fcl", "standard", "basic", "partial", "shared"])
def test_changes_give_the_verdicts_of_the_geometry(dimension: int, method: str) -> None:
    seed = 20 + dimension
    rng = np.random.default_rng(seed)
    points = rng.uniform(0, 10, (100, dimension))
    scene, first = world(dimension, points)
    checker = oc.Checker(scene, method)
    checker.set_adaptive(False)
    second = checker.add_cloud(np.zeros((0, dimension)), RADIUS)
    others = np.zeros((0, dimension))
    states = rng.uniform(0, 10, (2000, dimension))
    for _ in range(8):
        checker.is_valid(states)
        low = rng.uniform(0, 6, dimension)
        inside = ((points >= low) & (points <= low + 3)).all(axis=1)
        seen = rng.uniform(0, 10, (20, dimension))
        checker.change_cloud(first, insert=seen, remove=points[~inside][:5], clear=(low, low + 3))
        points = np.vstack([points[~inside][5:], seen])
        checker.change_cloud(second, insert=seen[:3] + 0.1)
        others = np.vstack([others, seen[:3] + 0.1])

        there = checker.cloud_points(first)
        assert sorted(map(tuple, there)) == sorted(map(tuple, points)), f"seed {seed}"
        expected = distances(states, np.vstack([points, others]))
        assert (checker.is_valid(states) == (expected > 0.3)).all(), f"seed {seed}"
        certificates = checker.certificates()
        # Within the box nothing is said of how deep a point is.
        outside = np.abs(certificates[:, :dimension] - 5).max(axis=1, initial=0) > 0.5
        clearances = distances(certificates[outside, :dimension], np.vstack([points, others]))
        assert np.allclose(certificates[outside, dimension], clearances, atol=1e-4), f"seed {seed}"
    if method != "fcl" and method != "standard":
        assert len(certificates) > 10


def test_what_is_refused_changes_nothing() -> None:
    points = np.array([[2.0, 2.0], [8.0, 8.0]])
    scene, cloud = world(2, points)
    checker = oc.Checker(scene)
    everywhere = ([-np.inf] * 2, [np.inf] * 2)
    for number, change, message in (
        (7, {"clear": everywhere}, "^cloud: there is none of number 7$"),
        (cloud, {"remove": points[:1] + 1e-9}, "not there|no point|none"),
        (cloud, {"clear": everywhere, "insert": [[np.nan, 1]]}, "finite|nan"),
        (cloud, {"clear": everywhere, "insert": [[1, 1, np.nan]]}, "^insert: must be finite$"),
        (cloud, {"remove": [[2, 2, np.nan]]}, "^remove: must be finite$"),
        (cloud, {"insert": [1, 1]}, r"^insert: must be an array of shape \(n, 2\), not \(2,\)"),
        (cloud, {"clear": ([0, 0, 0], [1, 1, 1])}, "^clear: must be two corners of 2 numbers each$"),
        (cloud, {"clear": ([0, 3], [1, 2])}, "^clear: the first corner must be below the second: 3.*, 2"),
    ):
        with pytest.raises(oc.Error, match=message):
            checker.change_cloud(number, **change)  # type: ignore[arg-type]
        assert sorted(map(tuple, checker.cloud_points(cloud))) == sorted(map(tuple, points))
        assert checker.is_valid([[2, 2], [8, 8], [2, 8]]).tolist() == [False, False, True]
    with pytest.raises(oc.Error, match="radius"):
        checker.add_cloud(points, -1.0)

    # An emptied cloud keeps its radius, also after what was refused.
    checker.change_cloud(cloud, clear=everywhere)
    with pytest.raises(oc.Error):
        checker.change_cloud(cloud, remove=points)
    assert checker.is_valid(points).all()
    checker.change_cloud(cloud, insert=points)
    assert np.isclose(checker.clearance([[2, 3]])[0], 1 - RADIUS - 0.3)


@pytest.mark.parametrize("method", ["standard", "basic", "shared"])
def test_what_is_removed_is_free_and_leaves_no_number(method: str) -> None:
    points = np.array([[2.0, 2.0], [8.0, 8.0]])
    scene, cloud = world(2, points)
    checker = oc.Checker(scene, method)
    checker.set_adaptive(False)
    seed = 31
    states = np.random.default_rng(seed).uniform(0, 10, (3000, 2))
    before = checker.is_valid(states)
    scan = checker.add_cloud([[3.0, 6.0]], RADIUS)
    grid = checker.add_grid(np.ones((2, 2), dtype=bool), 1.0, origin=(7, 2))
    assert checker.is_valid([[3, 6], [8, 3]]).tolist() == [False, False]
    assert sorted(map(tuple, checker.grid_cells(grid))) == [(0, 0), (0, 1), (1, 0), (1, 1)]
    with pytest.raises(oc.Error, match=f"^grid: number {scan} is a cloud of points, not of cells$"):
        checker.remove_grid(scan)
    with pytest.raises(oc.Error, match=f"^cloud: number {grid} is a map of cells, not of points$"):
        checker.remove_cloud(grid)
    checker.is_valid(states)
    checker.remove_cloud(scan)
    checker.remove_grid(grid)
    # What is known of the rest stays, and is as if they had never been there.
    known = checker.certificates()
    outside = np.abs(known[:, :2] - 5).max(axis=1, initial=0) > 0.5
    assert np.allclose(known[outside, 2], distances(known[outside, :2], points), atol=1e-4), f"seed {seed}"
    assert method == "standard" or len(known) > 10
    assert (checker.is_valid(states) == before).all(), f"seed {seed}"
    for use in (checker.remove_cloud, checker.cloud_points):
        with pytest.raises(oc.Error, match=f"^cloud: there is none of number {scan}$"):
            use(scan)
    for of_grid in (checker.remove_grid, checker.grid_cells):
        with pytest.raises(oc.Error, match=f"^grid: there is none of number {grid}$"):
            of_grid(grid)
    assert checker.add_cloud([[3.0, 6.0]], RADIUS) > grid
    checker.remove_cloud(cloud)
    assert checker.is_valid(points).all()
    empty = checker.add_cloud(np.zeros((0, 2)), RADIUS)
    checker.remove_cloud(empty)
    assert checker.describe_collision([3, 6]).endswith(f"added cloud {grid + 1}")


def test_a_path_is_asked_about_in_one_world() -> None:
    scene, _ = world(2, np.array([[2.0, 2.0]]))
    checker = oc.Checker(scene)
    path = np.array([[1, 1], [1, 9], [9, 9], [9, 1], [5, 1]], dtype=float)
    assert checker.find_blocked(path).tolist() == []
    assert checker.find_blocked(path[:0]).shape == (0,)
    box = checker.add_obstacle(oc.Body.box(0.5, 0.5), (5, 9))
    assert checker.find_blocked(path).tolist() == [1]
    checker.move_obstacle(box, (9, 1))  # where a state is: both motions there are blocked
    assert checker.find_blocked(path).tolist() == [2, 3]
    assert checker.find_blocked(path[3]).tolist() == [0]
    assert checker.find_blocked(path[:1]).tolist() == []
    assert checker.find_blocked(np.array([[1, 1], [1, np.nan], [1, 2]])).tolist() == [0, 1]
    with pytest.raises(oc.Error, match="^path: must be an array of shape"):
        checker.find_blocked(np.zeros((3, 4)))
    seed = 8
    states = np.random.default_rng(seed).uniform(0, 10, (200, 2))
    valid = checker.is_valid(states)
    free = valid[:-1] & valid[1:] & checker.check_motions(states[:-1], states[1:])
    assert (checker.find_blocked(states) == np.flatnonzero(~free)).all(), f"seed {seed}"

    # The box is always in the way of all motions or of none, whatever the other thread does.
    done = threading.Event()

    def move() -> None:
        while not done.is_set():
            checker.move_obstacle(box, (3, 5))
            checker.move_obstacle(box, (9, 9))

    thread = threading.Thread(target=move)
    thread.start()
    try:
        counts = {len(checker.find_blocked(np.tile([[3.0, 4.0], [3.0, 6.0]], (500, 1)))) for _ in range(50)}
    finally:
        done.set()
        thread.join()
    assert counts <= {0, 999}


def test_handlers_change_the_world_after_a_path_was_asked_about() -> None:
    scene, _ = world(2, np.array([[2.0, 2.0]]))
    checker = oc.Checker(scene)
    states = np.random.default_rng(1).uniform([4.6, 7.6], [5.4, 8.4], (500, 2))
    checker.set_adaptive(False)
    assert checker.is_valid(states).all()
    seen: List[int] = []

    def see(_signal: int, _frame: Any) -> None:
        seen.append(checker.add_cloud([[5.0, 8.0]], 1.0))

    before = signal.signal(signal.SIGALRM, see)
    try:
        signal.setitimer(signal.ITIMER_REAL, 0.02)
        path = np.tile([[5.0, 8.0], [5.0, 9.0]], (200, 1))
        end = time.monotonic() + 20
        while not seen and time.monotonic() < end:
            checker.find_blocked(path)
    finally:
        signal.signal(signal.SIGALRM, before)
    assert len(checker.find_blocked(path)) == len(path) - 1
    assert not checker.is_valid(states).any()


def test_points_with_heights_are_seen_from_above_in_the_plane() -> None:
    scene, _ = world(2, np.array([[2.0, 2.0]]))
    checker = oc.Checker(scene)
    frame = np.array([[4, 4, 0.5], [4.2, 4, 1], [6, 4, 0.5], [np.nan] * 3, [7, 4, np.inf], [8, 4, 2]])
    state = [4, 4]
    assert checker.find_robots(frame, state, padding=0.1).tolist() == [True, True, False, False, False, False]
    assert (checker.without_robots(frame, state, padding=0.1) == frame[[2, 5]]).all()
    assert (checker.without_robots(frame[:, :2], state, padding=0.1) == frame[[2, 4, 5], :2]).all()
    scan = checker.add_cloud(checker.without_robots(frame, state, padding=0.1), RADIUS)
    assert len(checker.cloud_points(scan)) == 2


def slab(low: float, high: float) -> oc.Body:
    """A box as a planar mesh, from one height to another, 1 wide"""
    corners = np.array([[x, y, z] for x in (-0.5, 0.5) for y in (-0.5, 0.5) for z in (low, high)])
    faces = [[0, 1, 3], [0, 3, 2], [4, 6, 7], [4, 7, 5], [0, 4, 5], [0, 5, 1], [2, 3, 7], [2, 7, 6]]
    faces += [[0, 2, 6], [0, 6, 4], [1, 5, 7], [1, 7, 3]]
    return oc.Body.mesh(corners, faces, dimension=2)


def test_points_of_the_plane_are_in_the_way_of_meshes_at_any_height() -> None:
    scene = oc.Scene([0, 0], [10, 10], "hall")
    scene.add_robot(oc.Robot.rigid("slab", slab(1.0, 2.0), [0, 0], [10, 10], turns=False), [1, 1], [9, 9])
    empty = oc.Checker(scene)
    flat = np.array([[5.0, 5.0], [8.0, 2.0]])
    # The first two are within radius of the robot's heights, the others are above and below.
    high = np.array([[2.0, 7.0, 1.5], [4.0, 8.0, 2.1], [6.0, 8.0, 2.3], [3.0, 3.0, 0.0], [7.0, 5.0, -4.0]])
    states = np.vstack([flat, high[:, :2]])
    wanted = [False, False, False, False, True, True, True]
    scene.add_cloud(flat, RADIUS)
    scene.add_cloud(high, RADIUS)
    checker = oc.Checker(scene)
    assert checker.is_valid(states).tolist() == wanted
    assert empty.is_valid(states).all()

    clouds = [empty.add_cloud(points, RADIUS) for points in (flat, high)]
    assert empty.is_valid(states).tolist() == wanted
    assert sorted(map(tuple, empty.cloud_points(1))) == sorted(map(tuple, high[:2, :2]))
    for one, cloud, points in ((empty, clouds[0], flat), (empty, clouds[1], high), (checker, 0, flat)):
        before = sorted(map(tuple, one.cloud_points(cloud)))
        one.change_cloud(cloud, remove=points)
        assert len(one.cloud_points(cloud)) == 0
        one.change_cloud(cloud, insert=points)
        assert sorted(map(tuple, one.cloud_points(cloud))) == before
        assert one.is_valid(states).tolist() == wanted
    # What is seen once more may be told from above and from within the plane.
    empty.change_cloud(clouds[1], remove=high[:2, :2], insert=high[2:])
    assert len(empty.cloud_points(clouds[1])) == 0
    for bad in (np.nan, np.inf):
        with pytest.raises(oc.Error, match="^points: must be finite$"):
            scene.add_cloud([[1, 1, bad]], RADIUS)


def test_cells_make_the_radius_larger_also_for_later_points() -> None:
    scene, _ = world(2, np.zeros((0, 2)))
    cloud = scene.add_cloud([[2.0, 2.0], [2.4, 2.0]], RADIUS, cell=1.0)
    checker = oc.Checker(scene)
    assert len(checker.cloud_points(cloud)) == 1
    checker.change_cloud(cloud, insert=[[2.0, 8.0]])
    assert np.isclose(checker.clearance([2.0, 9.0]), 1 - 0.3 - (RADIUS + 0.4))
    for cell in (-1.0, np.nan):
        with pytest.raises(oc.Error, match="^cell: must not be negative, not -?(1.0|nan)"):
            scene.add_cloud([[2.0, 2.0]], RADIUS, cell=cell)


def test_cells_do_not_come_and_go(scenes: pathlib.Path) -> None:
    checker = oc.Checker(oc.load_scene(str(scenes / "drones_octomap.yaml")))
    with pytest.raises(oc.Error, match="^cloud: number 0 is a map of cells, not of points$"):
        checker.change_cloud(0, insert=[[1, 1, 1]])


def test_each_check_sees_all_of_a_change_or_nothing() -> None:
    wall = np.column_stack([np.full(50, 2.0), np.linspace(0, 10, 50)])
    scene, cloud = world(2, wall)
    checker = oc.Checker(scene)
    states = np.repeat(wall, 200, axis=0)
    valid: List[int] = []

    def check() -> None:
        while not done.is_set():
            valid.append(int(checker.is_valid(states).sum()))

    done = threading.Event()
    thread = threading.Thread(target=check)
    thread.start()
    for i in range(200):
        checker.change_cloud(cloud, clear=([1, -1], [3, 11]), insert=wall + [0.01 * (i % 2), 0])
    done.set()
    thread.join()
    assert valid and not any(valid)


def test_plans_and_pages_know_the_points_of_now() -> None:
    scene, cloud = world(2, np.zeros((1, 2)) + [9, 1])
    checker = oc.Checker(scene)
    wall = np.column_stack([np.full(80, 3.0), np.linspace(0, 8, 80)])
    checker.change_cloud(cloud, insert=wall)
    plan = oc.plan(checker, "RRTConnect", time=20)
    assert plan and distances(plan.path, wall).min() > 0.3
    assert (plan.path[:, 1] > 8).any()
    assert len(plan.view().html) > len(oc.plan(oc.Checker(scene), "RRTConnect", time=20).view().html)


@pytest.mark.parametrize("dimension", [2, 3])
def test_the_team_is_no_part_of_what_it_sees(dimension: int) -> None:
    scene = oc.Scene([0] * dimension, [10] * dimension)
    body = oc.Body.disc(1.0) if dimension == 2 else oc.Body.sphere(1.0)
    for name, x in (("a", 2.0), ("b", 7.0)):
        start, goal = [x] + [5.0] * (dimension - 1), [x] + [6.0] * (dimension - 1)
        scene.add_robot(oc.Robot.rigid(name, body, [0] * dimension, [10] * dimension, turns=False), start, goal)
    checker = oc.Checker(scene)
    points = np.random.default_rng(1).uniform(0, 10, (5000, dimension))
    seen = checker.without_robots(points, scene.start, padding=0.25)
    centers = scene.start.reshape(2, dimension)
    distances = np.linalg.norm(points[:, None] - centers, axis=2).min(axis=1)
    assert 0 < len(seen) < len(points) and (seen == points[distances > 1.25]).all()
    checker.add_cloud(seen, radius=0.25)
    assert checker.is_valid(scene.start)
    assert checker.without_robots(np.zeros((0, dimension)), scene.start).shape == (0, dimension)
    shapes = r"\(n, 2\) or \(n, 3\)" if dimension == 2 else r"\(n, 3\)"
    with pytest.raises(oc.Error, match=rf"^points: must have the shape {shapes}, not \(3, 4\)$"):
        checker.without_robots(np.zeros((3, 4)), scene.start)
    with pytest.raises(oc.Error, match="padding"):
        checker.without_robots(points, scene.start, padding=-1.0)


def test_clouds_that_are_empty_are_in_nobodys_way() -> None:
    scene, first = world(3, np.array([[2.0, 5, 5]]))
    checker = oc.Checker(scene)
    here, there = [2, 5, 5], [5, 5, 5]
    for _ in range(3):
        scan = checker.add_cloud([[2, 2, 2]], RADIUS)
        assert not checker.is_valid([2, 2, 2])
        checker.change_cloud(scan, clear=([0, 0, 0], [3, 3, 3]))
        assert checker.is_valid([2, 2, 2])
    assert not checker.is_valid(here) and not checker.is_valid(there)
    checker.change_cloud(first, remove=[[2, 5, 5]])
    assert checker.is_valid(here) and not checker.is_valid(there)
    checker.remove_obstacle(0)
    assert checker.is_valid([here, there]).all()
    checker.change_cloud(scan, insert=[[2, 2, 2]])
    assert not checker.is_valid([2, 2, 2]) and checker.is_valid(here)
    assert "cloud 3" in checker.describe_collision([2, 2, 2])


def test_robots_are_found_in_a_frame() -> None:
    scene, _ = world(3, np.zeros((0, 3)))
    checker = oc.Checker(scene)
    seed = 5
    frame = np.random.default_rng(seed).uniform(2, 4, (500, 3))
    frame[::7] = np.nan
    colors = np.arange(500)
    state = [3.0, 3, 3]
    mask = checker.find_robots(frame, state, padding=0.1)
    near = np.linalg.norm(frame - state, axis=1) <= 0.4
    assert (mask == near).all(), f"seed {seed}"
    assert 0 < mask.sum() < 500
    rest = np.isfinite(frame).all(axis=1) & ~mask
    assert (checker.without_robots(frame, state, padding=0.1) == frame[rest]).all(), f"seed {seed}"
    assert len(colors[rest]) == rest.sum()


@pytest.mark.parametrize(
    "points, message",
    [
        (np.ma.masked_array(np.eye(3), np.eye(3) < 0.5), "must not be a masked array"),  # type: ignore[no-untyped-call]
        (np.array([["1", "2", "3"]]), "must be numbers"),
        (np.zeros((1, 3), "datetime64[s]"), "must be numbers"),
        (np.zeros(2, [("x", "f4"), ("y", "f4"), ("z", "f4")]), "take the fields that are coordinates"),
    ],
)
def test_points_are_numbers(points: Any, message: str) -> None:
    scene = world(3, np.zeros((0, 3)))[0]
    checker = oc.Checker(scene)
    calls: List[Callable[[], object]] = [
        lambda: checker.add_cloud(points, RADIUS),
        lambda: scene.add_cloud(points, RADIUS),
        lambda: oc.Body.sphere(1).signed_distance(points),
        lambda: oc.Body.convex_hull(points),
    ]
    for call in calls:
        with pytest.raises(oc.Error, match=message):
            call()


def test_empty_lists_are_no_points() -> None:
    scene = world(3, np.zeros((0, 3)))[0]
    assert scene.add_cloud([], RADIUS) == 1
    cloud = scene.add_cloud([[3.0, 3.0, 3.0]], RADIUS)
    oc.Checker(scene).change_cloud(cloud, insert=[], remove=[])
    assert len(oc.Body.sphere(1).signed_distance([])) == 0
    with pytest.raises(oc.Error, match=r"^points: must be an array of shape \(n, 3\), not \(3,\)$"):
        scene.add_cloud([1.0, 2.0, 3.0], RADIUS)


def test_certificates_are_kept_up_to_a_limit() -> None:
    scene, cloud = world(3, np.random.default_rng(1).uniform(0, 10, (2000, 3)))
    checker = oc.Checker(scene)
    checker.set_adaptive(False)
    checker.set_max_certificates(5)
    states = np.random.default_rng(2).uniform(0, 10, (500, 3))
    valid = checker.is_valid(states)
    assert len(checker.certificates()) == 5
    checker.set_max_certificates(None)
    assert (checker.is_valid(states) == valid).all()
    assert len(checker.certificates()) > 5
    checker.clear_certificates()
    assert len(checker.certificates()) == 0
    assert (checker.is_valid(states) == valid).all()


def test_an_obstacle_is_not_moved_and_removed_at_once() -> None:
    checker = oc.Checker(world(3, np.zeros((0, 3)))[0])
    with pytest.raises(oc.Error, match="^remove: obstacle 0 is to be moved as well$"):
        checker.change_obstacles(move={0: [1, 1, 1]}, remove=[0])


def test_points_of_a_file_are_an_array(tmp_path: pathlib.Path) -> None:
    file = tmp_path / "frame.xyz"
    file.write_text("1 2 3\nnan 0 0\n4 5 6\n")
    points = oc.load_cloud(file)
    assert points.dtype == float and points.tolist() == [[1, 2, 3], [4, 5, 6]]
    scene, other = (oc.Scene([-9, -9, -9], [9, 9, 9]) for _ in range(2))
    for each in (scene, other):
        each.add_robot(oc.Robot.rigid("ball", oc.Body.sphere(0.5), [-9] * 3, [9] * 3, turns=False), [0] * 3, [8] * 3)
    scene.add_cloud_file(file, radius=0.5)
    other.add_cloud(points, radius=0.5)
    states = np.random.default_rng(1).uniform(0, 7, (2000, 3))
    valid = oc.Checker(scene).is_valid(states)
    assert (valid == oc.Checker(other).is_valid(states)).all() and not valid.all()
    with pytest.raises(oc.Error, match="none.pcd"):
        oc.load_cloud(tmp_path / "none.pcd")


def test_what_has_seen_nothing_is_noted(tmp_path: pathlib.Path) -> None:
    (tmp_path / "nothing.xyz").write_text("nan nan nan\n")
    scene = oc.Scene([-1, -1, -1], [1, 1, 1])
    scene.add_cloud([[0.5, 0.5, 0.5]], 0.1)
    assert scene.notes == []
    scene.add_cloud(np.zeros((0, 3)), 0.1)
    scene.add_cloud_file(tmp_path / "nothing.xyz", 0.1)
    scene.add_grid(np.zeros((3, 3, 3), dtype=bool), 0.1)
    empty = ("clouds[1]", "clouds[2]", "grids[3]")
    assert scene.notes == [f"{what} is empty: nothing of it is an obstacle" for what in empty]
