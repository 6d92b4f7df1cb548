"""What counts as a stop: half a second within a millimetre, and slow beside the strokes."""

import numpy as np

import synthetic
from keyphase.demonstration import Demonstration
from keyphase.segmentation.evidence.grid import grid_of
from keyphase.segmentation.evidence.rests import rests, up_to_strokes
from keyphase.segmentation.evidence.speed import speed_of
from keyphase.segmentation.motion import motion_of
from keyphase.segmentation.segmenter import segment


def stops(position: np.ndarray) -> list[list[float]]:
    time = np.arange(len(position)) / 50.0
    recording = Demonstration("strokes", time, np.outer(position, [1.0, 0.0, 0.0]))
    grid = grid_of(recording, motion_of(recording))
    found = rests(grid, speed_of(grid).fast_m_s)
    return grid.time_s[found].round(2).tolist()


def out_and_back(length_m: float, seconds: float, stop_s: float) -> np.ndarray:
    phase = synthetic.minimum_jerk(np.linspace(0.0, 1.0, round(50 * seconds)))
    return length_m * np.concatenate([phase, np.ones(round(50 * stop_s)), phase[::-1]])


def test_the_turn_of_a_slow_stroke_is_no_stop():
    braking = np.cumsum(np.concatenate([np.linspace(0.0, 0.018, 50), np.linspace(0.018, 0.0, 50)]))
    stroke = braking / 50.0
    inside = [s for s in stops(np.concatenate([stroke, stroke[::-1]])) if 0.5 < s[0] < 3.5]
    assert inside == []


def test_a_stop_of_half_a_second_between_strokes_is_one():
    (stop,) = [s for s in stops(out_and_back(0.2, 1.5, 0.7)) if 1.0 < s[0] < 3.0]
    assert stop[0] <= 1.55
    assert stop[1] >= 2.15


def test_stops_parted_by_a_sway_are_one_and_by_a_stroke_two():
    still, sway = np.zeros(60), 0.003 * np.sin(np.linspace(0.0, np.pi, 40)) ** 2
    stroke = out_and_back(0.2, 1.0, 0.0)
    position = np.concatenate([still, sway, still, stroke, still])
    recording = Demonstration(
        "sways", np.arange(len(position)) / 50.0, np.outer(position, [1.0, 0.0, 0.0])
    )
    grid = grid_of(recording, motion_of(recording))
    speed = speed_of(grid)
    assert len(speed.rests) == 3
    assert grid.time_s[speed.stops].round(1).tolist() == [[0.0, 3.3], [5.1, 6.4]]


def test_a_stop_ends_where_the_stroke_after_it_sets_off_and_not_where_its_place_is_left():
    still, creep = np.zeros(60), np.linspace(0.0, 0.004, 20)
    stroke = 0.004 + 0.4 * synthetic.minimum_jerk(np.linspace(0.0, 1.0, 75))
    position = np.concatenate(
        [still, creep, stroke, stroke[-1] + creep, stroke[-1] + 0.004 + still]
    )
    recording = Demonstration(
        "gentle", np.arange(len(position)) / 50.0, np.outer(position, [1.0, 0.0, 0.0])
    )
    grid = grid_of(recording, motion_of(recording))
    speed = speed_of(grid)
    (_, place_left), (place_reached, _) = speed.stops.tolist()
    peak = np.array([np.argmax(speed.speed_m_s)])
    (_, sets_off), (comes_to_rest, _) = up_to_strokes(speed.stops, peak, speed.speed_m_s).tolist()
    slow = 0.07 * speed.speed_m_s[peak[0]]
    assert place_left + 5 < sets_off
    assert comes_to_rest < place_reached - 5
    assert speed.speed_m_s[sets_off] < slow <= speed.speed_m_s[sets_off + 1]
    assert speed.speed_m_s[comes_to_rest] < slow <= speed.speed_m_s[comes_to_rest - 1]


def test_stops_of_half_a_second_are_idle_however_short_the_strokes_between_them_are():
    rate, stroke_s, stop_s = 50, 0.4, 0.56
    reach = out_and_back(0.3, 3.0, 0.0)
    short = synthetic.minimum_jerk(np.linspace(0.0, 1.0, round(rate * stroke_s)))
    still = np.ones(round(rate * stop_s))
    steps = [0.02 * (k + part) for k in range(3) for part in (short, still)]
    position = np.concatenate([np.zeros(rate), reach, reach, 0.0 * still, *steps, 0.06 - reach])
    noise = 1e-5 * np.random.default_rng(0).standard_normal((len(position), 3))
    time = np.arange(len(position)) / rate
    found = segment(Demonstration("steps", time, np.outer(position, [1.0, 0.0, 0.0]) + noise))
    idle = [(one.start_s, one.end_s) for one in found.segments if one.label == "idle"]
    first_s = time[rate + 2 * len(reach) + len(still)] + stroke_s
    middles = first_s + stop_s / 2 + np.arange(3) * (stroke_s + stop_s)
    assert all(any(start < middle < end for start, end in idle) for middle in middles)
    assert all(end - start < 1.0 for start, end in idle if first_s < start < middles[-1])
