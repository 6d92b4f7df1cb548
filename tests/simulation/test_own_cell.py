"""A workcell of one's own, from a TOML and an MJCF file: it runs, and nothing in it can harm."""

import shutil
from contextlib import suppress
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from replaying import Drawn

from keyphase.errors import SimulationError
from keyphase.segmentation.end_condition import ConfigurationEnd, ContactEnd
from keyphase.simulation import Reference
from keyphase.simulation.choosing import cell_for
from keyphase.simulation.mjcf import spec_from
from keyphase.simulation.replay.replay import run
from keyphase.simulation.samples import as_demonstration
from keyphase.simulation.workcells.expression import condition
from keyphase.simulation.workcells.own_cell import own_cell
from keyphase.skills.connecting import minimum_jerk
from keyphase.skills.library import skills_of

EXAMPLE = Path(__file__).parents[2] / "examples" / "peg_in_hole"
PARTS, CONTACTS = frozenset({"peg", "block"}), frozenset({"touch"})
DOWN_S = 2.0


@pytest.fixture
def cell_file(tmp_path: Path) -> Path:
    """A copy of the example."""
    for name in ("scene.xml", "peg_in_hole.toml"):
        shutil.copy(EXAMPLE / name, tmp_path)
    return tmp_path / "peg_in_hole.toml"


def led_down():
    """The example's peg led into its hole, 5 mm further than it goes; when it is down."""
    simulation = own_cell(EXAMPLE / "peg_in_hole.toml").build()
    start = simulation.here()
    samples = []
    for time in np.arange(0.0, DOWN_S + 0.4, 0.004):
        way = 0.078 * float(minimum_jerk(np.array([min(time / DOWN_S, 1.0)]))[0])
        down = start.position_m - np.array([0.0, 0.0, way])
        samples.append(simulation.step(Reference(down, start.orientation_wxyz)))
    touched = max(s.time_s for s in samples if s.force_N[2] <= 1.0) - samples[0].time_s
    return as_demonstration(samples, "peg", {}), touched


def test_a_six_axis_arm_of_ones_own_replays_to_what_the_file_calls_success() -> None:
    demonstration, touched_s = led_down()
    cell = cell_for(demonstration, str(EXAMPLE / "peg_in_hole.toml"))
    plan = [Drawn(0.0, touched_s, "down", ContactEnd((0.0, 0.0, 1.0), 3.0))]
    result = run(cell.build(), skills_of(demonstration, plan), demonstration)
    assert result.succeeded, result.outcome()
    assert set(result.checks) >= {"bottom reached", "in the hole", "not tilted"}
    short = [replace(plan[0], end_s=0.8, end_condition=ConfigurationEnd())]
    result = run(cell.build(), skills_of(demonstration, short), demonstration)
    assert "bottom reached" in result.outcome()
    assert "in the hole" in result.outcome()


def asked(name: str, parts: tuple[str, ...]) -> float:
    return {"touch": 2.0, "distance": 0.01, "tilt": 3.0, "moved": 0.0}[name]


@pytest.mark.parametrize(
    ("text", "holds"),
    [
        ("touch > 1 and distance(peg, block) < 0.02", True),
        ("not touch > 1 or tilt(peg) >= 4", False),
        ("0 < touch * 2 - 1 <= 3", True),
        ("touch / moved(peg) > 1", False),
    ],
)
def test_a_condition_compares_what_is_true_in_the_scene(text: str, holds: bool) -> None:
    assert condition(text, PARTS, CONTACTS).holds(asked) is holds


HOSTILE = [
    "__import__('os').system('true') > 0",
    "touch.__class__ > 1",
    "9 ** 9 ** 9 > 1",
    "(lambda: 1)() > 0",
    "[x for x in touch] > 0",
    "'a' < 'b'",
    "touch",
    "1 + 1",
    "distance(peg) < 1",
    "distance(peg, os) < 1",
    "open(peg) < 1",
    "touch << 5 > 1",
    "(" * 400 + "touch > 1",
    "not " * 120 + "touch > 1" + " " * 400,
    "touch > 1\x00",
    "touch > 1; import os",
    "True < 2",
    "",
]


@pytest.mark.parametrize("text", HOSTILE)
def test_anything_but_a_comparison_is_refused(text: str) -> None:
    with pytest.raises(SimulationError, match="condition of success"):
        condition(text, PARTS, CONTACTS)


@given(st.text(max_size=60))
def test_any_text_is_a_condition_or_refused(text: str) -> None:
    with suppress(SimulationError):
        condition(text, PARTS, CONTACTS).holds(asked)


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ("scene.xml", "../scene.xml", "does not lie beside it"),
        ("scene.xml", "/etc/passwd", "does not lie beside it"),
        ("scene.xml", "other.xml", "no such file"),
        ('held = "peg"', 'held = "nobody"', "one of its parts"),
        ("axis_6 = 0.0", "axis_7 = 0.0", "must have a joint 'axis_7'"),
        ("axis_6 = 0.0", "axis_6 = nan", "starts at no angle"),
        ('[["tip"], ["floor"]]', '[["tip"]]', "two groups"),
        ('["floor"]', '["ceiling"]', "must have a geom 'ceiling'"),
        ("bottom > 1", "bottom.real > 1", "condition of success"),
        ("title =", "titel =", "titel"),
        ('name = "peg_in_hole"', "name = [", "expected a workcell"),
    ],
)
def test_a_file_that_cannot_be_meant_is_refused(
    cell_file: Path, old: str, new: str, said: str
) -> None:
    cell_file.write_text(cell_file.read_text().replace(old, new))
    with pytest.raises(SimulationError, match=said):
        own_cell(cell_file)


@pytest.mark.parametrize(
    "inside",
    [
        '<include file="/etc/passwd"/>',
        '<asset><mesh name="m" file="/etc/passwd"/></asset>',
        '<asset><mesh name="m" file="../m.stl"/></asset>',
        '<extension><plugin plugin="evil"/></extension>',
        '<worldbody><replicate count="1000000000"><geom size="1"/></replicate></worldbody>',
        '<asset><texture name="t" builtin="flat" type="2d" width="999999999" height="9"/></asset>',
        "<worldbody><body></worldbody>",
        '<worldbody><geom size="nan"/></worldbody>',
    ],
)
def test_a_scene_that_reads_runs_or_multiplies_is_refused(cell_file: Path, inside: str) -> None:
    scene = cell_file.with_name("scene.xml")
    scene.write_text(scene.read_text().replace("</mujoco>", inside + "</mujoco>"))
    with pytest.raises(SimulationError, match="expected a model"):
        own_cell(cell_file)


def test_a_document_type_is_refused(tmp_path: Path) -> None:
    bomb = tmp_path / "bomb.xml"
    bomb.write_text('<!DOCTYPE m [<!ENTITY a "aaaa"><!ENTITY b "&a;&a;">]><mujoco>&b;</mujoco>')
    with pytest.raises(SimulationError, match="document type"):
        spec_from(bomb)
