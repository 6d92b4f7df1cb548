"""A contact that gave way is told from a rim by its depth, and sought where it is missing."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from strokes import lowered
from strokes import segment as planned

from keyphase.demonstration import Demonstration
from keyphase.files.shipped import shipped
from keyphase.readers import read
from keyphase.segmentation import segment
from keyphase.segmentation.end_condition import ContactEnd
from keyphase.skills import Sensed
from keyphase.skills.coupling import Reference
from keyphase.skills.execution.executor import STEP_S
from keyphase.skills.execution.seeking import Seeking
from keyphase.skills.library import skills_of
from keyphase.skills.pressed import Press
from keyphase.skills.search import MAX_PRESSES, Search, before_touch, search_for
from keyphase.skills.skill import Skill

DOWN = np.array([0.0, 0.0, -1.0])


def pressed_in(depth_m: float, gives_way: bool) -> Demonstration:
    """Down at 30 mm/s; a touch at 1 s, then `depth_m` further in, with or without a detent."""
    time = np.arange(500) / 250
    gone = np.clip(0.03 * (time - 1.0), -0.03, depth_m)
    force = np.where(time > 1.0, 3.0, 0.0)
    if gives_way:
        force = np.where((gone > 0.6 * depth_m) & (gone < depth_m), 0.9, force)
    position = np.c_[np.zeros((len(time), 2)), -gone]
    return Demonstration("in", time, position, None, np.c_[np.zeros((len(time), 2)), force])


def its_search(demonstration: Demonstration) -> Search | None:
    return search_for(demonstration, 1.08, Press(DOWN, 3.0, np.zeros(3)))


def test_a_detent_asks_for_the_demonstrated_depth() -> None:
    found = its_search(pressed_in(0.0025, gives_way=True))
    assert found is not None
    assert found.depth_m == pytest.approx(0.0025, abs=3e-4)


def test_a_shake_of_the_hand_shortly_before_the_touch_makes_nothing_deeper() -> None:
    demonstration = pressed_in(0.0025, gives_way=True)
    force, time = demonstration.force_N, demonstration.time_s
    assert force is not None
    shaken = np.where((time > 0.93) & (time < 0.96), 2.0, force[:, 2])
    found = its_search(replace(demonstration, force_N=np.c_[force[:, :2], shaken]))
    assert found is not None
    assert found.depth_m == pytest.approx(0.0025, abs=3e-4)


@pytest.mark.parametrize(("depth_m", "gives_way"), [(0.0003, False), (0.0025, False), (0.02, True)])
def test_what_is_hard_soft_or_deep_is_not_sought(depth_m, gives_way) -> None:
    assert its_search(pressed_in(depth_m, gives_way)) is None


def test_of_the_bundled_recordings_only_the_snap_is_sought() -> None:
    sought = {}
    for name in ("setup1", "setup2"):
        demonstration = read(Path(shipped("data")) / f"{name}.npz")
        kept = [one for one in segment(demonstration).segments if not one.idle]
        sought[name] = [one.search is not None for one in skills_of(demonstration, kept)]
    assert sum(sought["setup1"]) == 1
    assert not any(sought["setup2"])


def test_the_spiral_grows_to_its_radius_and_stays_square_to_the_press() -> None:
    search = Search(0.002)
    way = np.array([search.aside(DOWN, time) for time in np.linspace(0.0, 5.0, 200)])
    assert np.linalg.norm(way, axis=1).max() == pytest.approx(search.radius_m, rel=0.01)
    assert np.abs(way @ DOWN).max() < 1e-12
    assert np.linalg.norm(way[0]) == 0.0


def test_a_touch_lasts_as_long_as_the_force_does() -> None:
    touch = before_touch(DOWN, np.zeros(3))
    for depth in np.linspace(0.0, 0.002, 20):
        touch = touch.step(np.array([0.0, 0.0, -depth]), np.array([0.0, 0.0, 3.0]))
    assert touch.depth_m(np.array([0.0, 0.0, -0.002])) > 0.0015
    for _ in range(20):
        touch = touch.step(np.zeros(3), np.zeros(3))
    assert touch.touched_m is None


@pytest.mark.parametrize(("ticks", "forgotten"), [(10, False), (20, True)])
def test_a_touch_that_springs_off_is_one_touch(ticks: int, forgotten: bool) -> None:
    touch = before_touch(DOWN, np.zeros(3))
    for force_N in (*[3.0] * 10, *[0.0] * ticks):
        touch = touch.step(np.zeros(3), np.array([0.0, 0.0, force_N]))
    assert (touch.touched_m is None) is forgotten


UPRIGHT = np.array([1.0, 0.0, 0.0, 0.0])


def sensed(deep_m: float, force_N: float, aside_N: float = 0.0) -> Sensed:
    """A tool so deep, under a force along the press and one aside of it."""
    return Sensed(deep_m * DOWN, UPRIGHT, np.zeros(6), np.array([aside_N, 0.0, force_N]))


def sought() -> Skill:
    """A skill that seeks 2 mm."""
    down = planned(0.0, 1.2, ContactEnd((0.0, 0.0, 1.0), 3.0), "down until contact")
    press = Press(DOWN, 5.0, np.zeros(3))
    return replace(skills_of(lowered(), [down])[0], search=Search(0.002), press=press)


def gone_in(depth_m: float, lasting_s: float) -> tuple[Seeking, Sensed]:
    """A skill that seeks 2 mm, pressing, after its part went in by a depth within some time."""
    now = sensed(0.0, 0.0)
    seeking = Seeking(sought(), now, STEP_S)
    ticks = round(lasting_s / STEP_S)
    for deep_m in (*np.zeros(25), *np.linspace(0.0, depth_m, ticks)):
        now = sensed(float(deep_m), 5.0)
        seeking.watch(now, lasts=True)
    return seeking, now


@pytest.mark.parametrize(
    ("depth_m", "lasting_s", "is_in"),
    [(0.0021, 0.1, True), (0.0021, 2.0, False), (0.0041, 2.0, True), (0.0015, 0.1, False)],
)
def test_a_part_is_in_that_fell_so_deep_or_crept_twice_as_deep(depth_m, lasting_s, is_in) -> None:
    seeking, now = gone_in(depth_m, lasting_s)
    assert seeking.is_in(now) is is_in


def test_a_part_that_fell_into_its_seat_is_left_to_lie_flat_there() -> None:
    on_the_rim, fallen = (gone_in(depth_m, 0.1)[0] for depth_m in (0.001, 0.003))
    assert fallen.turning < on_the_rim.turning / 2.0


def test_a_part_that_was_found_by_searching_is_left_to_lie_flat_there() -> None:
    crept, found = (gone_in(0.0041, 2.0)[0] for _ in range(2))
    found.searched = True
    assert found.turning < crept.turning / 2.0


@pytest.mark.parametrize(("felt_before_N", "follows"), [(0.0, False), (2.0, True)])
def test_what_a_sensor_reads_too_much_catches_no_search(felt_before_N, follows) -> None:
    """6 N aside is more than a search exerts, but not where 2 N of it are the sensor's."""
    seeking = Seeking(sought(), sensed(0.0, 0.0, felt_before_N), STEP_S)
    at = Reference(np.zeros(3), UPRIGHT, np.zeros(6), np.zeros(6))
    now = sensed(0.0, 6.0, 6.0)
    for _ in range(50):
        seeking.watch(now, lasts=True)
    aside = [seeking.moving(at, now, time_s).position_m for time_s in (0.5, 1.0)]
    wanted = [seeking.search.aside(DOWN, time_s) for time_s in (0.5, 1.0)]
    assert np.allclose(aside, wanted) is follows


@pytest.mark.parametrize(
    ("sinking_mm", "within_s", "presses_on"),
    [(0.3, 0.5, True), (0.02, 0.5, False), (1.2, 1.2, True), (0.3, 1.2, False)],
)
def test_a_part_that_still_goes_in_is_pressed_once_more(
    sinking_mm: float, within_s: float, presses_on: bool
) -> None:
    """0.3 mm at the end, or 1.2 mm by and by and then none for 0.3 s."""
    seeking, _ = gone_in(0.0025, 0.1)
    went_mm = np.linspace(0.0, sinking_mm, round(within_s / STEP_S))
    rests = round((1.5 - within_s) / STEP_S) if within_s > 0.5 else 0
    for deeper_mm in (*np.zeros(500), *went_mm, *np.full(rests, sinking_mm)):
        seeking.watch(sensed(1e-3 * (2.5 + float(deeper_mm)), 6.0), lasts=True)
    assert seeking.presses_on() is presses_on


def test_what_gives_way_on_and_on_is_not_pressed_for_ever() -> None:
    seeking, _ = gone_in(0.0025, 0.1)
    assert sum(seeking.presses_on() for _ in range(20)) == MAX_PRESSES - 1


def test_single_readings_lead_no_search_astray() -> None:
    """Of a noise of 2 N one reading in sixty is more than a search exerts."""
    seeking = Seeking(sought(), sensed(0.0, 0.0), STEP_S)
    at = Reference(np.zeros(3), UPRIGHT, np.zeros(6), np.zeros(6))
    for noise_N in np.random.default_rng(0).normal(0.0, 2.0, 250):
        now = sensed(0.0, 6.0, float(noise_N))
        seeking.watch(now, lasts=True)
        seeking.moving(at, now, 1.0)
    moved = seeking.moving(at, sensed(0.0, 6.0), 1.0).position_m
    assert np.allclose(moved, seeking.search.aside(DOWN, 1.0))


def test_a_search_that_gave_way_comes_back_to_where_the_seat_is_looked_for() -> None:
    """Caught for half a second, then free: a fifth of what it gave way is left after 1.6 s."""
    seeking = Seeking(sought(), sensed(0.0, 0.0), STEP_S)
    at = Reference(np.zeros(3), UPRIGHT, np.zeros(6), np.zeros(6))
    off_m: list[float] = []
    for aside_N in (*np.full(125, 8.0), *np.zeros(400)):
        now = sensed(0.0, 6.0, float(aside_N))
        seeking.watch(now, lasts=True)
        reached = seeking.moving(at, now, 1.0).position_m - seeking.search.aside(DOWN, 1.0)
        off_m.append(float(np.linalg.norm(reached)))
    assert off_m[124] > 0.001
    assert off_m[-1] == pytest.approx(np.exp(-1.6) * off_m[124], rel=0.1)
