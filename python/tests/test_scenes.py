"""Bodies, robots and scenes"""

import math
import pathlib
from typing import Any, List, Tuple

import numpy as np
import ompl_certificates as oc
import pytest

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
    wrongs: List[Any] = [(1, 0, 0, 0, 0, 1, 1), (1, 2, 3, 4), np.ones((4, 4)), (math.nan, 0, 0)]
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
    with pytest.raises(oc.Error, match="^bounds: "):
        oc.Scene([0, 0], [1])
    assert (oc.Body.sphere(1).signed_distance([[0, 0, 0], [3, 0, 0]]) == [-1, 2]).all()


def test_arm_comes_from_urdf(scenes: pathlib.Path) -> None:
    arm = oc.Robot.arm(str(scenes / "arms" / "arm6.urdf"), str(scenes / "arms" / "arm6.srdf"), "arm")
    assert len(arm.coordinates) == 6
    poses = arm.poses([0] * 6)
    assert poses.shape == (len(arm.bodies), 4, 4)
    assert np.allclose(poses[:, 3], [0, 0, 0, 1])
    scene = oc.Scene([-2] * 3, [2] * 3, "cell")
    scene.add_robot(arm, [0] * 6, [0.5] * 6)
    assert oc.plan(scene, time=5).solved
    scene.add_obstacle(oc.Body.sphere(0.1), poses[-1])
    with pytest.raises(oc.Error, match="^cell: robots"):
        scene.validate()
    assert not oc.Checker(scene).is_valid([0] * 6)


def test_car_with_trailer_has_four_coordinates() -> None:
    car = oc.Robot.car_with_trailer("car", oc.Body.box(1, 0.5), oc.Body.box(1, 0.5), 1.2, [0, 0], [10, 10])
    assert len(car.coordinates) == 4
    assert np.allclose(car.poses([5, 5, 0, 0])[1][:3, 3], [3.8, 5, 0])
