"""Plans with one checker, again and again"""

import pathlib

import ompl_certificates as oc
import pytest


def test_checker_plans_again_in_a_changed_world(room: oc.Scene) -> None:
    checker = oc.Checker(room)
    assert oc.plan(checker, "RRTConnect", time=20)
    for x in (3, 4, 6):
        checker.move_obstacle(0, (x, 5))
        plan = oc.plan(checker, "RRTConnect", time=20)
        assert plan.solved and checker.is_valid(plan.path).all()
    plan = oc.plan(checker, time=0.5, start=[1, 1, 9, 9], goal=[9, 9, 1, 1])
    assert (plan.path[-1] == [9, 9, 1, 1]).all()


@pytest.mark.parametrize("planner", oc.planner_names())
def test_checker_plans_again_after_each_planner(planner: str, scenes: pathlib.Path) -> None:
    checker = oc.Checker(oc.load_scene(scenes / "paper_one_disc.yaml"))
    # OMPL's LazyLBTRRT frees some of its memory twice if it is cleared and then destroyed.
    plan = oc.plan(checker, planner, time=0.1)
    path = plan.path.copy()
    for again in (planner, "RRTConnect"):
        other = oc.plan(checker, again, time=0.1 if again == planner else 20)
    assert other and other.report["planner"] == "RRTConnect"
    assert (plan.path == path).all() and len(plan.view().html) > 1000


def test_checker_keeps_its_method_and_motion(room: oc.Scene) -> None:
    checker = oc.Checker(room, "partial", "continuous")
    plan = oc.plan(checker, "RRTConnect", time=20)
    assert (plan.report["method"], plan.report["motion"]) == ("partial", "continuous")
    with pytest.raises(oc.Error, match="^method: a Checker has its own$"):
        oc.plan(checker, method="partial")
    with pytest.raises(oc.Error, match="^motion: a Checker has its own$"):
        oc.plan(checker, motion="discrete")
    report = oc.plan(room, "RRTConnect", time=20).report
    assert (report["method"], report["motion"]) == ("shared", "discrete")


def test_one_checker_plans_once_at_a_time(room: oc.Scene) -> None:
    checker = oc.Checker(room)

    def callback(seconds: float, cost: float) -> None:
        oc.plan(checker, time=0.1)

    with pytest.raises(oc.Error, match="a plan with this checker is under way"):
        oc.plan(checker, "RRTstar", time=20, callback=callback)
    assert oc.plan(checker, "RRTConnect", time=20), "it plans again once that plan has ended"
