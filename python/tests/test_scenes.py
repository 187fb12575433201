"""Bodies, robots and scenes"""

import math
import pathlib
import re
from typing import Any, Callable, List, Tuple

import numpy as np
import ompl_certificates as oc
import pytest
from conftest import TurnsDuring

CUBE = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], dtype=float)
FACES = np.array(
    [[0, 1, 3], [0, 3, 2], [4, 6, 7], [4, 7, 5], [0, 4, 5], [0, 5, 1], [2, 3, 7], [2, 7, 6], [0, 2, 6], [0, 6, 4]]
    + [[1, 5, 7], [1, 7, 3]]
)


def sphere_scene() -> oc.Scene:
    scene = oc.Scene([-5, -5, -5], [5, 5, 5])
    robot = oc.Robot.rigid("ball", oc.Body.sphere(0.25), [-5] * 3, [5] * 3, turns=False)
    scene.add_robot(robot, [-4, 0, 0], [4, 0, 0])
    return scene


def test_angles_that_look_like_degrees_are_noted() -> None:
    scene = oc.Scene([0, 0], [10, 10])
    robots = [oc.Robot.rigid(name, oc.Body.box(1, 0.5), [0, 0], [10, 10]) for name in ("cart", "truck")]
    scene.add_robot(robots[0], [1, 1, 2 * np.pi], [9, 9, -3.1])
    assert scene.notes == []
    scene.add_robot(robots[1], [1, 5, 0], [9, 5, 90])
    assert len(scene.notes) == 1 and "truck" in scene.notes[0] and "radians" in scene.notes[0]


def test_scene_of_a_file_tells_its_team(scenes: pathlib.Path) -> None:
    scene = oc.load_scene(str(scenes / "paper_five_discs.yaml"))
    assert scene.dimension == 2
    assert len(scene.robots) == 5
    assert len(scene.coordinates) == 10
    assert scene.start.shape == scene.goal.shape == (10,)


def test_errors_have_one_line_with_file_and_value() -> None:
    with pytest.raises(oc.Error, match=r"^nowhere.yaml: ") as error:
        oc.load_scene("nowhere.yaml")
    assert "\n" not in str(error.value)
    text = "environment: {min: [0, 0], max: [9, 9], obstacles: []}\nrobots:\n"
    text += "  - {name: a, type: rigid, space: R2, shape: {type: disc, radius: -1}, start: [1, 1], goal: [2, 2]}\n"
    with pytest.raises(oc.Error, match=r"^room\.yaml:3: robots\[0\]\.shape"):
        oc.scene_from_yaml(text, "room.yaml")


def test_boxes_polygons_and_meshes_are_the_same_obstacle() -> None:
    states = np.random.default_rng(1).uniform(-1, 2, (2000, 3))
    verdicts = []
    placed: List[Tuple[oc.Body, Any]] = [
        (oc.Body.box(1, 1, 1), (0.5, 0.5, 0.5)),
        (oc.Body.convex(CUBE), None),
        (oc.Body.convex_hull(np.vstack([CUBE, [[0.5, 0.5, 0.5]]])), np.eye(4)),
        (oc.Body.join([(oc.Body.box(1, 1, 0.5), (0, 0, -0.25)), (oc.Body.box(1, 1, 0.5), (0, 0, 0.25))]), [0.5] * 3),
    ]
    for body, pose in placed:
        scene = sphere_scene()
        scene.add_obstacle(body, pose)
        verdicts.append(oc.Checker(scene).is_valid(states))
    assert 0 < verdicts[0].sum() < len(states)
    for verdict in verdicts[1:]:
        assert (verdict == verdicts[0]).all()
    scene = sphere_scene()
    scene.add_obstacle(oc.Body.mesh(CUBE, FACES))
    surface = oc.Checker(scene).is_valid(states)
    # A mesh is a surface: only what lies wholly inside may differ.
    inside = (np.abs(states - 0.5) < 0.25).all(axis=1)
    assert (surface == verdicts[0])[~inside].all()
    assert surface[inside].all()


def test_pose_with_quaternion_is_that_of_its_matrix() -> None:
    half = math.sqrt(0.5)
    matrix = np.array([[0, -1, 0, 1], [1, 0, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]], dtype=float)
    states = np.random.default_rng(2).uniform(-3, 3, (1000, 3))
    verdicts = []
    poses: List[Any] = [(1, 0, 0, 0, 0, half, half), matrix]
    for pose in poses:
        scene = sphere_scene()
        scene.add_obstacle(oc.Body.box(4, 0.5, 1), pose)
        verdicts.append(oc.Checker(scene).is_valid(states))
    assert (verdicts[0] == verdicts[1]).all()
    assert 0 < verdicts[0].sum() < 1000
    wrongs: List[Any] = [(1, 0, 0, 0, 0, 1, 1), (1, 2, 3, 4), np.ones((4, 4)), (math.nan, 0, 0), "ab", [[1, 2], [3]]]
    for wrong in wrongs:
        with pytest.raises(oc.Error, match="^pose: "):
            sphere_scene().add_obstacle(oc.Body.sphere(1), wrong)


def test_cloud_is_the_union_of_its_balls() -> None:
    rng = np.random.default_rng(3)
    points, states = rng.uniform(-4, 4, (300, 3)), rng.uniform(-4, 4, (2000, 3))
    scene = sphere_scene()
    scene.add_cloud(points, radius=0.3)
    distances = np.linalg.norm(states[:, None] - points[None], axis=2).min(axis=1)
    assert (oc.Checker(scene).is_valid(states) == (distances > 0.55)).all()
    with pytest.raises(oc.Error, match=r"^points: must be an array of shape \(n, 3\), not \(4, 5\)$"):
        scene.add_cloud(np.zeros((4, 5)), radius=0.1)


def test_planar_cloud_takes_points_of_the_plane(room: oc.Scene) -> None:
    room.add_cloud(np.array([[1.0, 1.0], [2.0, 8.0]]), radius=0.1)
    checker = oc.Checker(room)
    assert not checker.is_valid([1, 1, 9, 9])
    assert checker.is_valid([1, 3, 9, 9])


def test_bodies_refuse_what_makes_no_sense() -> None:
    with pytest.raises(oc.Error):
        oc.Body.disc(-1)
    with pytest.raises(oc.Error, match="^faces: there is no vertex -1$"):
        oc.Body.mesh(CUBE, [[0, 1, -1]])
    with pytest.raises(oc.Error):
        oc.Body.mesh(CUBE, [[0, 1, 8]])
    wrongs: List[Any] = [[[0, 1, 2.7]], [["0", "1", "2"]], [[0, 1, math.nan]], [[0, 1, math.inf]], [[0, 1], [2]], None]
    for faces in wrongs:
        with pytest.raises(oc.Error, match="^faces: must be whole numbers"):
            oc.Body.mesh(CUBE, faces)
    for kind in (float, np.int32, np.uint64):
        assert oc.Body.mesh(CUBE, FACES.astype(kind)).bounding_radius == oc.Body.mesh(CUBE, FACES).bounding_radius
    with pytest.raises(oc.Error, match="^bounds: "):
        oc.Scene([0, 0], [1])
    assert (oc.Body.sphere(1).signed_distance([[0, 0, 0], [3, 0, 0]]) == [-1, 2]).all()


def test_robots_refuse_what_is_no_number() -> None:
    scene = oc.Scene([0, 0], [10, 10], "room")
    low, high = np.zeros(2), np.full(2, 10.0)
    disc = oc.Robot.rigid("disc", oc.Body.disc(0.5), low, high, turns=False)
    for weight in (-1.0, math.nan, math.inf):
        message = rf"^room: robot 'disc': weight must be finite and not negative, not {weight:.6f}$"
        with pytest.raises(oc.Error, match=message):
            scene.add_robot(disc, [1, 1], [9, 9], weight)
    for speed in (0.0, -1.0, math.nan, math.inf):
        with pytest.raises(oc.Error, match=rf"^room: robot 'disc': speed must be from 1e-9 to 1e9, not {speed:.6f}$"):
            scene.add_robot(disc, [1, 1], [9, 9], speed=speed)
    with pytest.raises(oc.Error, match="^room: robot 'disc': start must be finite, not nan$"):
        scene.add_robot(disc, [1, math.nan], [9, 9])
    with pytest.raises(oc.Error, match="^room: robot 'disc': goal must be finite, not inf$"):
        scene.add_robot(disc, [1, 1], [math.inf, 9])
    assert not scene.robots
    scene.add_robot(disc, low + 1, high - 1, np.full(1, 2.0)[0])
    assert (scene.start == 1).all() and (scene.goal == 9).all()


def test_resolution_is_a_fraction_or_that_of_ompl(room: oc.Scene) -> None:
    own = room.resolution
    assert own == 0
    for wrong in (-0.1, 1e-9, 1.0, 2.0, math.nan, math.inf):
        with pytest.raises(oc.Error, match="resolution"):
            room.resolution = wrong
        assert room.resolution == own
    starts, ends = np.array([[4.0, 3.4, 9, 9]]), np.array([[6.0, 3.4, 9, 9]])
    room.add_obstacle(oc.Body.box(0.01, 0.01), (5.05, 2.95))
    verdicts = []
    for fraction in (0.0, 1e-6, 0.9, 0.0):
        room.resolution = fraction
        assert room.resolution == fraction
        verdicts.append(bool(oc.Checker(room).check_motions(starts, ends)[0]))
    # The point is passed by a hair's breadth. Only long steps miss it; OMPL's own are a hundredth.
    assert verdicts == [False, False, True, False]


def test_robots_and_scenes_tell_their_bounds(scenes: pathlib.Path) -> None:
    cart = oc.Robot.rigid("cart", oc.Body.box(1, 1), [-1, -2], [3, 4])
    low, high = cart.bounds
    assert low.tolist() == [-1, -2, -math.pi] and high.tolist() == [3, 4, math.pi]
    arm = oc.Robot.arm(scenes / "arms" / "arm6.urdf", scenes / "arms" / "arm6.srdf", "arm")
    low, high = arm.bounds
    limits = {}
    for joint in re.finditer(r'<joint name="(\w+)".*?</joint>', (scenes / "arms" / "arm6.urdf").read_text(), re.S):
        limit = re.search(r'lower="([^"]+)" upper="([^"]+)"', joint[0])
        limits[joint[1]] = (float(limit[1]), float(limit[2])) if limit else (-math.pi, math.pi)
    assert list(zip(low, high)) == [limits[name] for name in arm.coordinates]
    scene = oc.load_scene(scenes / "drones_3d.yaml")
    low, high = scene.state_bounds
    assert len(low) == len(high) == len(scene.coordinates)
    assert ((low <= scene.start) & (scene.start <= high)).all()


def test_angles_may_be_any() -> None:
    scene = oc.Scene([0, 0], [10, 10])
    scene.add_robot(oc.Robot.rigid("box", oc.Body.box(1, 0.5), [0, 0], [10, 10]), [1, 1, 7.0], [9, 9, -4.0])
    assert np.isclose(scene.start[2], 7.0 - 2 * np.pi) and np.isclose(scene.goal[2], 2 * np.pi - 4.0)
    scene.validate()
    assert oc.plan(scene, "RRTConnect", time=20).solved
    with pytest.raises(oc.Error, match=r"start: must have 3 coordinates, not 2$"):
        scene.add_robot(oc.Robot.rigid("other", oc.Body.box(1, 0.5), [0, 0], [10, 10]), [1, 1], [9, 9, 0])
    with pytest.raises(TypeError):
        scene.add_robot(None, [1, 1], [9, 9])  # type: ignore[arg-type]


def test_car_with_trailer_has_four_coordinates() -> None:
    car = oc.Robot.car_with_trailer("car", oc.Body.box(1, 0.5), oc.Body.box(1, 0.5), 1.2, [0, 0], [10, 10])
    assert len(car.coordinates) == 4
    assert np.allclose(car.poses([5, 5, 0, 0])[1][:3, 3], [3.8, 5, 0])


def test_checkers_of_the_same_robot_keep_their_resolutions() -> None:
    robot = oc.Robot.rigid("r", oc.Body.disc(0.05), [0, 0], [10, 10], turns=False)
    scene = oc.Scene([0, 0], [10, 10])
    scene.add_robot(robot, [1, 1], [9, 1])
    scene.add_obstacle(oc.Body.box(0.01, 9), (5, 4.9))
    scene.resolution = 0.001
    fine = oc.Checker(scene)
    scene.resolution = 0.9
    assert scene.coordinates == ["r.x", "r.y"]
    coarse = oc.Checker(scene)
    ends = [[1.0, 1.0]], [[9.0, 1.0]]
    assert coarse.check_motions(*ends).all()  # It looks at one place beside the ends.
    assert not fine.check_motions(*ends).any()
    assert oc.plan(coarse, "RRTConnect", time=1)
    assert not fine.check_motions(*ends).any()
    plan = oc.plan(fine, "RRTConnect", time=1)
    assert not plan or fine.check_motions(plan.path[:-1], plan.path[1:]).all()


def test_wrong_numbers_are_told_in_one_line(room: oc.Scene) -> None:
    disc = oc.Robot.rigid("disc", oc.Body.disc(0.1), [0, 0], [10, 10], turns=False)
    checker = oc.Checker(room)
    nothing: Any = None
    masked: Any = np.ma.masked_array(np.ones((3, 3), bool), True)  # type: ignore[no-untyped-call]
    calls: List[Tuple[Callable[[], object], str]] = [
        (lambda: oc.Scene([0, 0], [0, 30]), "^bounds: high must be above low, not from 0.0+ to 0.0+$"),
        (lambda: oc.Scene([5, 0], [4, 4]), "^bounds: high must be above low, not from 5.0+ to 4.0+$"),
        (lambda: room.add_robot(disc, [1, 1], nothing), "^goal: must be numbers, not None$"),
        (lambda: room.add_robot(disc, [[1, 1]], [1, 1]), r"^start: must be a list of numbers, not .* \(1, 2\)$"),
        (lambda: room.add_cloud(np.zeros((2, 2), complex), 0.1), "^points: must be real numbers, not complex ones$"),
        (lambda: checker.is_valid(np.zeros(4, complex)), "^states: must be real numbers, not complex ones$"),
        (lambda: checker.is_valid(nothing), "^states: must be numbers, not None$"),
        (lambda: checker.add_cloud(nothing, 0.1), "^points: must be numbers, not None$"),
        (lambda: oc.Body.disc(1).signed_distance([[math.nan, 0]]), "^points: must be numbers, not nan$"),
        (lambda: oc.Body.convex("abc"), "^points: must be numbers$"),
        (lambda: room.add_grid(masked, 0.5), "^occupied: must not be a masked array"),
    ]
    for call, message in calls:
        with pytest.raises(oc.Error, match=message):
            call()
    with pytest.raises(TypeError):
        oc.Body.disc(nothing)


def test_bodies_and_checkers_print_what_they_are(room: oc.Scene) -> None:
    assert repr(oc.Body.disc(0.5)) == "<Body of 1 shape in the plane, bounding radius 0.5>"
    pair = oc.Body.join([(oc.Body.sphere(1), None), (oc.Body.sphere(1), (2, 0, 0))])
    assert repr(pair) == "<Body of 2 shapes in space, bounding radius 3>"
    assert repr(oc.Checker(room, "partial", "continuous")) == "<Checker of 'room': partial, continuous>"


def test_python_runs_while_a_scene_is_read(turns_during: TurnsDuring) -> None:
    obstacles = "\n".join(
        f"    - {{type: disc, radius: 0.1, center: [{i % 100}, {i // 100}]}}" for i in range(10000)
    )
    robot = "  - {name: disc, type: rigid, space: R2, shape: {type: disc, radius: 1}, start: [-5, 0], goal: [-5, 9]}"
    text = f"environment:\n  min: [-9, -9]\n  max: [99, 99]\n  obstacles:\n{obstacles}\nrobots:\n{robot}\n"
    assert turns_during(lambda: oc.scene_from_yaml(text)) > 20


def test_cars_drive_the_way_that_they_point() -> None:
    bounds = [0.0, 0.0], [10.0, 10.0]
    car = oc.Robot.rigid("car", oc.Body.box(0.8, 0.4), *bounds, turning_radius=1.0)
    assert car.coordinates == ["x", "y", "yaw"]
    scene = oc.Scene(*bounds)
    scene.add_obstacle(oc.Body.box(1, 4), (5, 4))
    scene.add_robot(car, start=[2, 2, 0], goal=[8, 2, 1.5])
    plan = oc.plan(scene, planner="RRTConnect", time=5, first=True, motion="continuous")
    assert plan and plan.prove().proved
    steps = plan.at(np.linspace(0.0, plan.times[-1], 4001))
    moves, headings = np.diff(steps[:, :2], axis=0), steps[:-1, 2]
    lengths = np.hypot(*moves.T)
    across = np.abs(moves[:, 1] * np.cos(headings) - moves[:, 0] * np.sin(headings))
    assert np.all(across <= 0.01 * lengths + 1e-9)
    with pytest.raises(oc.Error, match="^car: the turning radius must be finite and positive"):
        oc.Robot.rigid("car", oc.Body.box(0.8, 0.4), *bounds, turning_radius=0.0)
    with pytest.raises(oc.Error, match="^turning_radius: is for planar bodies that turn$"):
        oc.Robot.rigid("car", oc.Body.box(0.8, 0.4), *bounds, turns=False, turning_radius=1.0)
    with pytest.raises(oc.Error, match="^turning_radius: is for planar bodies that turn$"):
        oc.Robot.rigid("car", oc.Body.sphere(0.4), [0] * 3, [1] * 3, turning_radius=1.0)


def test_padded_bodies_keep_a_distance() -> None:
    box = oc.Body.box(1, 1).padded(0.25)
    assert box.padding == 0.25 and box != oc.Body.box(1, 1) and box.padded(0) == oc.Body.box(1, 1)
    assert "padding 0.25" in repr(box)
    scene = oc.Scene([-9, -9], [9, 9])
    scene.add_obstacle(oc.Body.box(2, 2), name="block")
    scene.add_robot(oc.Robot.rigid("r", box, [-9, -9], [9, 9]), [-5, 0, 0], [5, 0, 0])
    for method in ("fcl", "standard", "basic", "partial", "shared"):
        checker = oc.Checker(scene, method=method)
        assert checker.is_valid([[1.76, 0, 0], [1.74, 0, 0], [1.68, 1.68, 0], [1.67, 1.67, 0]]).tolist() == [
            True,
            False,
            True,
            False,
        ]
    assert checker.describe_collision([1.74, 0, 0]) == "robot 'r' touches 'block', with its padding of 0.25"
    plan = oc.plan(scene, time=20, first=True, motion="continuous")
    assert plan.solved and plan.prove()
    with pytest.raises(oc.Error, match="^The padding of a body must be finite and not negative"):
        oc.Body.disc(1).padded(-1)
    with pytest.raises(oc.Error, match="has a padding, which the robots are to have$"):
        scene.add_obstacle(box)


ZONE: List[Tuple[oc.Body, Any]] = [(oc.Body.box(2, 2), (5, 0))]


def test_robots_keep_out_of_their_zones() -> None:
    low, high, disc = [-9, -9], [9, 9], oc.Body.disc(0.3)
    makers: List[Callable[[Any], oc.Robot]] = [
        lambda zones: oc.Robot.rigid("r", disc, low, high, keep_out=zones),
        lambda zones: oc.Robot.rigid("r", disc, low, high, turns=False, keep_out=zones),
        lambda zones: oc.Robot.rigid("r", disc, low, high, turning_radius=1, keep_out=zones),
        lambda zones: oc.Robot.car_with_trailer("r", disc, oc.Body.disc(0.1), 0.6, low, high, keep_out=zones),
        lambda zones: oc.Robot.integrator("r", disc, low, high, 1, 1, keep_out=zones),
        lambda zones: oc.Robot.unicycle("r", disc, low, high, 1, 1, keep_out=zones),
        lambda zones: oc.Robot.car("r", disc, low, high, 1, 1, 0.3, keep_out=zones),
        lambda zones: oc.Robot.car("r", disc, low, high, 1, 1, 0.3, disc, 0.7, 0.5, keep_out=zones),
    ]
    for make in makers:
        robot, free = make(ZONE), make(())
        assert robot.coordinates == free.coordinates and len(robot.bodies) == len(free.bodies)
        scene = oc.Scene(low, high)
        rest = [0] * (len(robot.coordinates) - 2)
        scene.add_robot(robot, [0, 0, *rest], [0, 1, *rest])
        checker = oc.Checker(scene)
        states = np.array([[x, 0, *rest] for x in (3.6, 3.75, 5, 7.5)], dtype=float)
        verdicts = checker.is_valid(states)
        assert len(robot.poses(states[0])) == len(free.bodies)
        assert verdicts.tolist() == [True, False, False, True], robot
        assert checker.describe_collision(states[1]) == "robot 'r' touches keep_out[0]" + (
            " with body 0" if len(free.bodies) > 1 else ""
        )
    with pytest.raises(oc.Error, match="^r: a zone of 3 dimensions"):
        oc.Robot.rigid("r", disc, low, high, keep_out=[(oc.Body.sphere(1), None)])


def test_only_one_robot_keeps_out_of_a_zone() -> None:
    scene = oc.Scene([-9, -9], [9, 9])
    for name, y, zones in (("shy", 0.0, ZONE), ("bold", 0.5, ())):
        robot = oc.Robot.rigid(name, oc.Body.disc(0.2), [-9, -9], [9, 9], turns=False, keep_out=zones)
        scene.add_robot(robot, [3, y], [7, y])
    plan = oc.plan(scene, time=20, first=True, motion="continuous")
    assert plan.solved and plan.prove()
    ways = plan.at(np.linspace(0, plan.times[-1], 1000))
    from_middle = [np.abs(ways[:, [i, i + 1]] - [5, 0]).max(axis=1).min() for i in (0, 2)]
    assert from_middle[0] > 1.0 > from_middle[1]


def test_messages_call_an_obstacle_by_its_name() -> None:
    scene = oc.Scene([0, 0], [10, 10])
    scene.add_robot(oc.Robot.rigid("disc", oc.Body.disc(0.5), [0, 0], [10, 10], turns=False), [1, 1], [9, 9])
    assert scene.add_obstacle(oc.Body.box(1, 1), (5, 5), name="crate") == 0
    assert scene.add_obstacle(oc.Body.box(1, 1), (5, 8)) == 1
    checker = oc.Checker(scene)
    assert checker.describe_collision([5, 5]) == "robot 'disc' touches 'crate'"
    assert checker.describe_collision([5, 8]) == "robot 'disc' touches environment.obstacles[1]"
    with pytest.raises(oc.Error, match="name: must not have a line break"):
        scene.add_obstacle(oc.Body.box(1, 1), (5, 5), name="two\nlines")


def test_obstacles_of_the_plane_stand_upright(room: oc.Scene) -> None:
    tilted = np.array([[1, 0, 0, 5], [0, 0, -1, 5], [0, 1, 0, 0], [0, 0, 0, 1.0]])
    lifted = np.eye(4)
    lifted[2, 3] = 0.1
    checker = oc.Checker(room)
    for pose in (tilted, lifted):
        with pytest.raises(oc.Error, match=r"^room: environment\.obstacles\[1\]: must stand upright, and at z = 0"):
            room.add_obstacle(oc.Body.box(1, 2), pose)
        with pytest.raises(oc.Error, match="^room: 'beam': must stand upright"):
            room.add_obstacle(oc.Body.box(1, 2), pose, "beam")
        with pytest.raises(oc.Error, match="must stand upright"):
            checker.add_obstacle(oc.Body.box(1, 2), pose)
        with pytest.raises(oc.Error, match="^obstacle 0: .* must stand upright"):
            checker.change_obstacles(move={0: pose})
    room.add_obstacle(oc.Body.mesh(CUBE, FACES, dimension=2), lifted)
    rounded = np.eye(4)
    rounded[2, 3] = 1e-13
    assert room.add_obstacle(oc.Body.box(1, 2), rounded) == 2


def test_names_of_coordinates_do_not_clash() -> None:
    scene = oc.Scene([0, 0], [20, 20], "yard")
    box, disc = oc.Body.box(1, 0.5), oc.Body.disc(0.3)
    car = oc.Robot.car_with_trailer("c", box, box, 1.2, [0, 0], [20, 20])
    scene.add_robot(car, [5, 5, 0, 0], [15, 5, 0, 0])
    clashing = oc.Robot.rigid("c.car", disc, [0, 0], [20, 20], turns=False)
    message = r"^yard: robots\[1\]\.name: the robots 'c' and 'c.car' would both have a coordinate 'c.car.x'$"
    with pytest.raises(oc.Error, match=message):
        scene.add_robot(clashing, [5, 15], [15, 15])
    scene.add_robot(oc.Robot.rigid("c.d", disc, [0, 0], [20, 20], turns=False), [5, 15], [15, 15])
    assert len(set(scene.coordinates)) == 6
