"""The offset between the clocks of pose and wrench, by where the tool stops and the force comes."""

import numpy as np
import pytest

from keyphase.clock_offset import clock_offset
from keyphase.demonstration import Demonstration

RATE_HZ = 100.0


def pressing(later_s: float, presses: int = 9, seed: int = 4) -> Demonstration:
    """A tool that comes down and meets a table again and again; its force is told late."""
    random = np.random.default_rng(seed)
    time = np.arange(int(3.0 * presses * RATE_HZ)) / RATE_HZ
    turns = np.cumsum(random.uniform(0.6, 0.9, 4 * presses))
    height = np.interp(time, turns, np.tile([0.1, 0.0, 0.0, 0.1], presses))

    def felt(at: np.ndarray) -> np.ndarray:
        low = np.interp(at, time, height)
        return np.where(low <= 1e-9, 6.0, 0.0) + random.normal(0.0, 0.05, len(at))

    place = np.column_stack([0.02 * np.sin(time), 0 * time, height])
    force = np.column_stack([0 * time, 0 * time, felt(time - later_s)])
    return Demonstration("pressing", time, place, force_N=force)


@pytest.mark.parametrize("later_s", [0.0, 0.3, -0.4])
def test_presses_tell_how_late_the_force_is(later_s: float) -> None:
    found = clock_offset(pressing(later_s))
    assert found is not None
    assert found.is_sure
    assert found.offset_s == pytest.approx(-later_s, abs=0.03)
    assert bool(found.text) == (later_s != 0.0)


def test_a_few_contacts_are_not_enough_to_be_sure() -> None:
    found = clock_offset(pressing(0.3, presses=4))
    assert found is None or (not found.is_sure and found.text == "")


def test_a_force_that_has_nothing_to_do_with_the_motion_says_nothing() -> None:
    made = pressing(0.0)
    force = pressing(0.0, seed=7).force_N
    found = clock_offset(Demonstration("other", made.time_s, made.position_m, force_N=force))
    assert found is not None
    assert not found.is_sure


def test_without_a_force_there_is_nothing_to_say() -> None:
    made = pressing(0.0)
    assert clock_offset(Demonstration("bare", made.time_s, made.position_m)) is None


def test_of_a_recording_that_is_mostly_a_gap_nothing_is_said_and_nothing_made_up() -> None:
    """A day between two rows would be seventeen million samples."""
    made = pressing(0.3)
    time = made.time_s + 86_400.0 * (made.time_s > 10.0)
    broken = Demonstration("broken", time, made.position_m, force_N=made.force_N)
    assert clock_offset(broken) is None
