"""Pages that show plans"""

import base64
import html
import json
import pathlib
import re
import resource
from typing import Any, Dict

import numpy as np
import ompl_certificates as oc
import pytest


def shown_in(page: str) -> Dict[str, Any]:
    """What a page shows, as JSON"""
    data = re.findall(r'<script id="plan" type="application/json">(.*?)</script>', page, re.DOTALL)[-1]
    shown: Dict[str, Any] = json.loads(data)
    return shown


def floats(text: str) -> "np.ndarray[Any, np.dtype[np.float32]]":
    return np.frombuffer(base64.b64decode(text), dtype="<f4")


def test_page_shows_the_plan(room: oc.Scene, tmp_path: pathlib.Path) -> None:
    plan = oc.plan(room, time=1.0)
    file = tmp_path / "plan.html"
    view = plan.view(file)
    assert file.read_text(encoding="utf-8") == view.html
    shown = shown_in(view.html)
    assert shown["end"] == plan.times[-1]
    assert shown["report"] == plan.report
    for i, robot in enumerate(shown["robots"]):
        poses = floats(robot["poses"]).reshape(-1, 7)
        origin = shown["bounds"]["origin"][:2]
        assert np.allclose(poses[0, :2] + origin, plan.path[0].reshape(-1, 2)[i])
        assert np.allclose(poses[-1, :2] + origin, plan.path[-1].reshape(-1, 2)[i])


def test_notebooks_show_it_in_a_frame(room: oc.Scene) -> None:
    view = oc.plan(room, time=1.0).view()
    frame = view._repr_html_()
    inside = re.fullmatch(r'<iframe [^<>]*srcdoc="([^"]*)"></iframe>', frame)
    assert inside and html.unescape(inside[1]) == view.html


def test_page_shows_the_world_and_the_goal_of_its_plan(room: oc.Scene) -> None:
    checker = oc.Checker(room)
    crate = checker.add_obstacle(oc.Body.box(1, 1), (2, 2))
    goal = np.array([9.0, 4.0, 1.0, 6.0])
    plan = oc.plan(checker, time=1.0, goal=goal)
    checker.remove_obstacle(crate)
    shown = shown_in(plan.view().html)
    assert sum(len(floats(obstacle["poses"])) // 7 for obstacle in shown["obstacles"]) == 2
    for i, robot in enumerate(shown["robots"]):
        assert np.allclose(floats(robot["goal"])[:2] + shown["bounds"]["origin"][:2], goal.reshape(-1, 2)[i])


def test_page_of_an_earlier_plan_stays(room: oc.Scene) -> None:
    checker = oc.Checker(room)
    first = oc.plan(checker, "RRT", time=5.0, seed=1)
    before = first.view().html
    oc.plan(checker, "RRT", time=5.0, seed=2)
    assert first.view().html == before
    del checker
    assert first.view().html == before


def test_without_a_solution_robots_stay_at_their_starts(room: oc.Scene) -> None:
    room.add_obstacle(oc.Body.box(0.2, 12), (7, 5))
    plan = oc.plan(room, "RRT", time=0.2)
    assert not plan.solved
    shown = shown_in(plan.view().html)
    assert shown["end"] == 0 and len(floats(shown["robots"][0]["times"])) == 1


def test_pages_and_pictures_show_the_start_of_their_plan(room: oc.Scene, tmp_path: pathlib.Path) -> None:
    room.add_obstacle(oc.Body.box(0.2, 12), (7, 5))
    checker = oc.Checker(room)
    start = np.array([2.0, 8.0, 3.0, 2.0])
    # The second plan starts where the first one does.
    for given in (start, None):
        plan = oc.plan(checker, "RRT", time=0.2, start=given)
        assert not plan.solved
        shown = shown_in(plan.view().html)
        for i, robot in enumerate(shown["robots"]):
            assert np.allclose(floats(robot["poses"])[:2] + shown["bounds"]["origin"][:2], start.reshape(-1, 2)[i])
    checker.remove_obstacle(1)
    plan = oc.plan(checker, "RRTConnect", time=20, first=True, start=start)
    assert plan.solved
    file = tmp_path / "plan.svg"
    plan.save_picture(file)
    svg = file.read_text(encoding="utf-8")
    # The picture begins at (44, 44), with 72 pixels for a unit.
    for x, y in start.reshape(-1, 2):
        assert f"<circle cx='{44 + 72 * x:.2f}' cy='{44 + 72 * (10 - y):.2f}' r='36.00'" in svg


def test_files_stay_where_there_is_no_room_for_new_ones(room: oc.Scene, tmp_path: pathlib.Path) -> None:
    plan = oc.plan(room, time=5.0, first=True)
    page, path = tmp_path / "plan.html", tmp_path / "plan.csv"
    page.write_text("old")
    page.chmod(0o640)
    path.write_text("old")
    limits = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (50, limits[1]))
    try:
        with pytest.raises(OSError):
            plan.view(page)
        with pytest.raises(oc.Error, match="plan.csv"):
            plan.save(path)
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, limits)
    assert page.read_text() == path.read_text() == "old" and len(list(tmp_path.iterdir())) == 2
    plan.view(page)
    assert page.read_text(encoding="utf-8").startswith("<!") and page.stat().st_mode & 0o777 == 0o640


def test_file_that_cannot_be_written_is_named(room: oc.Scene, tmp_path: pathlib.Path) -> None:
    with pytest.raises(OSError, match="nowhere"):
        oc.plan(room, time=1.0).view(tmp_path / "nowhere" / "plan.html")
