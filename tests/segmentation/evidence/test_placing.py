"""When a contact change is said to have happened: rises of several shapes."""

import numpy as np
import pytest

from keyphase.demonstration import Demonstration
from keyphase.segmentation import segment

TIME_S = np.arange(0.0, 12.0, 0.01)


def contacts(force_N: np.ndarray) -> list[float]:
    rng = np.random.default_rng(0)
    force = np.outer(force_N, [0.0, 0.0, 1.0]) + rng.normal(0.0, 0.03, (len(TIME_S), 3))
    swing = np.outer(0.05 * np.sin(2.0 * TIME_S), [1.0, 0.0, 0.0])
    found = segment(Demonstration("rise", TIME_S, swing, force_N=force))
    return [b.time_s for b in found.boundaries if b.contact_change]


def test_a_rise_in_a_third_of_a_second_that_ends_with_a_click_is_one_change():
    rise = np.clip((TIME_S - 5.0) / 0.3, 0.0, 1.0)
    click = 1.0 - np.exp(-np.maximum(TIME_S - 5.28, 0.0) / 0.02)
    assert contacts(6.0 * rise**2 + 4.0 * click) == [pytest.approx(5.15, abs=0.2)]


def test_a_step_after_a_light_touch_lies_where_it_is_and_not_at_the_touch():
    light = 2.0 * np.clip((TIME_S - 4.0) / 0.4, 0.0, 1.0)
    firm = 5.0 * (1.0 - np.exp(-np.maximum(TIME_S - 5.2, 0.0) / 0.03))
    found = contacts(light + firm)
    assert min(abs(time - 5.2) for time in found) < 0.06


def test_a_touch_that_snaps_at_once_lies_at_the_snap():
    touch, snap = (np.clip((TIME_S - at_s) / 0.02, 0.0, 1.0) for at_s in (5.0, 5.18))
    off = np.clip((TIME_S - 9.0) / 0.05, 0.0, 1.0)
    made, _ = contacts((1.5 * touch + 6.0 * snap) * (1.0 - off))
    assert made == pytest.approx(5.19, abs=0.03)


@pytest.mark.parametrize("seconds", [0.3, 0.5, 0.8])
def test_contact_begins_as_the_force_leaves_free_space_and_ends_when_it_is_gone(seconds):
    rise = np.clip((TIME_S - 3.0) / seconds, 0.0, 1.0) ** 1.6
    fall = 1.0 - (1.0 - np.clip((TIME_S - 8.0) / seconds, 0.0, 1.0)) ** 1.6
    made, lost = contacts(6.0 * (rise - fall))
    assert made == pytest.approx(3.0 + 0.2 * seconds, abs=0.2 * seconds)
    assert lost == pytest.approx(8.0 + 0.8 * seconds, abs=0.2 * seconds)


def test_a_step_lies_inside_its_rise_and_not_where_that_is_over():
    touch = np.clip((TIME_S - 3.0) / 0.05, 0.0, 1.0) - np.clip((TIME_S - 9.0) / 0.05, 0.0, 1.0)
    harder = np.clip((TIME_S - 6.0) / 0.05, 0.0, 1.0)
    made, changed, _ = contacts(touch * (5.0 + 6.0 * harder))
    assert (made, changed) == (pytest.approx(3.015, abs=0.02), pytest.approx(6.015, abs=0.02))


@pytest.mark.parametrize("seconds", [0.5, 0.8])
def test_a_contact_that_presses_harder_lies_on_the_way_and_not_where_it_is_fastest(seconds):
    touch = np.clip((TIME_S - 3.0) / 0.05, 0.0, 1.0) - np.clip((TIME_S - 9.0) / 0.05, 0.0, 1.0)
    harder = np.clip((TIME_S - 6.0) / seconds, 0.0, 1.0) ** 3
    made, changed, lost = contacts(touch * (4.0 + 6.0 * harder))
    assert (made, lost) == (pytest.approx(3.0, abs=0.1), pytest.approx(9.0, abs=0.1))
    assert 6.0 + 0.4 * seconds < changed < 6.0 + 0.8 * seconds


def test_a_contact_that_changes_before_it_is_let_go_is_not_put_where_it_is_gone():
    touch = np.clip((TIME_S - 3.0) / 0.05, 0.0, 1.0) - np.clip((TIME_S - 6.5) / 0.05, 0.0, 1.0)
    harder = np.clip((TIME_S - 6.0) / 0.2, 0.0, 1.0)
    _, changed, lost = contacts(touch * (4.0 + 6.0 * harder))
    assert (changed, lost) == (pytest.approx(6.1, abs=0.12), pytest.approx(6.55, abs=0.1))


def test_with_one_sample_a_second_a_rise_is_still_placed():
    time_s = np.arange(60.0)
    force = np.outer(time_s > 30.0, [0.0, 0.0, 5.0])
    found = segment(Demonstration("slow", time_s, np.zeros((60, 3)), force_N=force))
    assert [b.time_s for b in found.boundaries] == [pytest.approx(30.5, abs=1.0)]
