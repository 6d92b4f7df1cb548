"""A margin: how far the world may differ until a plan fails, beside plans that reach less far."""

from xml.etree import ElementTree

import pytest
from drawn_contact import its_plan, pressed_slide
from replaying import Drawn

from keyphase.errors import ParameterError
from keyphase.simulation.recorded.cell import RecordedCell
from keyphase.simulation.replay.margin import Axis, _furthest, axes_of, margin_of
from keyphase.simulation.replay.margin_report import (
    margin_svg,
    margin_text,
    margin_values,
    margin_verdict,
)
from keyphase.simulation.workcells.registry import workcell
from keyphase.skills.library import skills_of


@pytest.fixture(scope="module")
def margin():
    cell = RecordedCell(pressed_slide())
    by_pose = [Drawn(each.start_s, each.end_s, each.label) for each in its_plan()]
    plans = {
        "the plan": skills_of(cell.demonstration, its_plan()),
        "by pose alone": skills_of(cell.demonstration, by_pose),
    }
    heard = []
    found = margin_of(
        cell,
        cell.demonstration,
        plans,
        axes=["towards the tool", "away from it"],
        progress=lambda done, total: heard.append((done, total)),
    )
    assert heard[-1][0] == heard[-1][1]
    return found


def test_contact_ends_reach_further_than_poses_do(margin) -> None:
    plan, by_pose = margin.plans
    assert plan.nominal == "success"
    for axis in ("towards the tool", "away from it"):
        assert plan.reach(axis).value > 8.0
        assert (by_pose.reach(axis).value or 0.0) < plan.reach(axis).value


def test_the_verdict_says_how_far_and_how_far_without(margin) -> None:
    verdict = margin_verdict(margin)
    assert verdict.startswith("works from −")
    assert "by pose alone" in verdict
    assert margin_text(margin).splitlines()[-1] == verdict
    assert margin_values(margin)["verdict"] == verdict


def test_the_picture_is_one(margin) -> None:
    root = ElementTree.fromstring(margin_svg(margin, "<pressed & slid>"))
    assert root.tag.endswith("svg")


def test_the_furthest_is_tried_first_and_then_the_distance_halved() -> None:
    tried = []

    def failure(value: float) -> str | None:
        tried.append(value)
        return None if value <= 7.0 else "too far"

    axis = Axis("higher", "mm", 32.0, 1.0, lambda _: None)  # pyright: ignore
    good, failed = _furthest(failure, axis)
    assert tried[0] == 32.0
    assert 6.0 <= good <= 7.0
    assert failed == "too far"
    assert len(tried) < 11


def test_a_plan_that_fails_in_a_nearer_world_reaches_no_further() -> None:
    axis = Axis("higher", "mm", 32.0, 1.0, lambda _: None)  # pyright: ignore
    good, failed = _furthest(lambda value: "hit" if 7.0 < value < 9.0 else None, axis)
    assert 6.0 <= good <= 7.0
    assert failed == "hit"


def test_workcells_differ_in_height_place_turn_and_friction() -> None:
    names = [axis.name for axis in axes_of(workcell("setup1"))]
    assert names == ["higher", "lower", "ahead", "aside", "turned", "rougher"]


def test_without_a_plan_there_is_no_margin() -> None:
    cell = RecordedCell(pressed_slide())
    with pytest.raises(ParameterError, match="at least one plan"):
        margin_of(cell, cell.demonstration, {})
