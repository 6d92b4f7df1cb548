"""The habits of a hand."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from keyphase.simulation.demonstrating.hand_path import (
    Habits,
    HandPath,
    Z,
    band_noise,
    minimum_jerk,
)
from keyphase.simulation.impedance import Reference

START = Reference(np.array([0.4, -0.2, 0.2]), np.array([0.0, 0.0, 1.0, 0.0]))
STEADY = Habits(0.0, 0.0, 0.0, 0.0, 0.0)
SHAKY = Habits(1e-4, 2e-4, 5e-4, 2e-3, 0.03)


def path_of(habits: Habits, seed: int = 0) -> HandPath:
    return HandPath(START, habits, np.random.default_rng(seed))


def positions(path: HandPath) -> np.ndarray:
    return np.array([reference.position_m for reference in path.references()])


@settings(max_examples=40)
@given(
    goal=st.tuples(*[st.floats(-0.3, 0.3)] * 3).filter(lambda g: np.linalg.norm(g) > 0.01),
    duration=st.floats(0.3, 3.0),
    seed=st.integers(0, 1000),
)
def test_a_stroke_starts_here_and_ends_at_its_goal(goal, duration, seed) -> None:
    path = path_of(SHAKY, seed)
    path.stroke("there", START.position_m + goal, duration)
    assert path.here_m == pytest.approx(START.position_m + goal, abs=1e-9)
    assert path.end_s == pytest.approx(duration, abs=0.004)


def test_a_steady_stroke_is_straight_and_never_turns_back() -> None:
    path = path_of(STEADY)
    path.stroke("down", START.position_m - 0.1 * Z, 1.0)
    course = positions(path)
    assert np.allclose(course[:, :2], START.position_m[:2])
    assert (np.diff(course[:, 2]) <= 0.0).all()


def test_a_stroke_on_the_table_bends_sideways_only() -> None:
    path = path_of(Habits(0.0, 0.0, 0.0, 0.0, 0.03), seed=3)
    path.stroke("aside", START.position_m + np.array([0.0, 0.1, 0.0]), 1.0, on_table=True)
    course = positions(path)
    assert np.ptp(course[:, 2]) < 1e-12
    assert np.ptp(course[:, 0]) > 1e-4


def test_overlapping_strokes_blend_and_lose_no_way() -> None:
    path = path_of(STEADY)
    path.stroke("first", START.position_m + np.array([0.1, 0.0, 0.0]), 1.0)
    path.stroke("second", START.position_m + np.array([0.1, 0.1, 0.0]), 1.0, overlap_s=0.2)
    assert path.end_s == pytest.approx(1.8)
    assert positions(path)[-1] == pytest.approx(START.position_m + np.array([0.1, 0.1, 0.0]))
    assert [phase.start_s for phase in path.phases] == pytest.approx([0.0, 0.8])


def test_velocities_are_of_what_was_meant_not_of_the_tremor() -> None:
    steady, shaky = path_of(STEADY), path_of(Habits(1e-4, 2e-4, 0.0, 0.0, 0.0))
    for path in (steady, shaky):
        path.stroke("down", START.position_m - 0.1 * Z, 1.0)
    for calm, shaken in zip(steady.references(), shaky.references(), strict=True):
        assert np.allclose(calm.velocity_m_s, shaken.velocity_m_s)


def test_tremor_has_the_stated_strength_and_band() -> None:
    noise = band_noise(np.random.default_rng(0), 2500, (4.0, 12.0))
    assert noise.std(axis=0) == pytest.approx([1.0] * 3)
    power = np.abs(np.fft.rfft(noise[:, 0])) ** 2
    frequencies = np.fft.rfftfreq(2500, 0.004)
    outside = (frequencies < 3.9) | (frequencies > 12.1)
    assert power[outside].sum() < 1e-9 * power.sum()


@given(st.floats(0.0, 1.0), st.floats(0.0, 1.0))
def test_minimum_jerk_rises_from_nought_to_one(a, b) -> None:
    low, high = minimum_jerk(np.array(sorted((a, b))))
    assert 0.0 <= low <= high <= 1.0


def test_a_turn_leaves_the_tool_in_place() -> None:
    path = path_of(STEADY)
    path.turn("turn", np.radians(55.0) * Z, 1.0)
    assert np.ptp(positions(path), axis=0).max() < 0.005
    first, last = path.references()[0], path.references()[-1]
    angle = 2.0 * np.arccos(abs(float(first.orientation_wxyz @ last.orientation_wxyz)))
    assert np.degrees(angle) == pytest.approx(55.0, abs=0.1)
