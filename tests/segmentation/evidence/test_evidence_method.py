"""Boundaries by evidence: lines, reasons, rests, gaps, and what an estimated wrench does."""

import dataclasses
import itertools
from pathlib import Path

import numpy as np
import pytest

import synthetic
from keyphase.demonstration import Demonstration
from keyphase.making import make
from keyphase.readers import read
from keyphase.segmentation import Parameters, Segmenter, segment
from keyphase.segmentation.evidence.telling.counts import HIGHEST, LOWEST
from keyphase.segmentation.evidence.weights import shipped_weights

DATA = Path(__file__).parents[3] / "data"
LINES = (0.0003, 0.001, 0.003, 0.01, 0.03, 0.1, 0.3, 0.5, 0.7, 0.9, 0.97, 0.99, 0.997, 0.999)


@pytest.mark.slow
@pytest.mark.parametrize("name", ["setup1", "setup2", "wipe"])
def test_dragging_a_line_over_its_range_changes_the_number_of_segments(name):
    segmenter = Segmenter(read(DATA / f"{name}.npz"))
    steps = segmenter.segment().line_counts[0].steps
    lines = np.sqrt(np.multiply((LOWEST, *steps), (*steps, HIGHEST)))
    counts = [len(segmenter.segment(Parameters(force_threshold=x)).segments) for x in lines]
    assert np.count_nonzero(np.diff(counts)) >= 3


@pytest.fixture(scope="module")
def bundled() -> Segmenter:
    return Segmenter(synthetic.bundled_setup1())


def test_the_bundled_demonstration_gives_the_contacts_of_setup_1(bundled):
    found = bundled.segment()
    contacts = [b.time_s for b in found.boundaries if b.contact_change]
    np.testing.assert_allclose(contacts, [4.2, 6.97], atol=0.05)
    assert next(b.change for b in found.boundaries if b.contact_change) == "made"


def test_a_higher_line_gives_no_contact_change_that_a_lower_one_does_not(bundled):
    def contacts(line: float) -> set[float]:
        found = bundled.segment(Parameters(force_threshold=line))
        return {b.time_s for b in found.boundaries if b.contact_change}

    given = [contacts(line) for line in LINES]
    assert all(more >= fewer for more, fewer in itertools.pairwise(given))


def test_moving_a_line_looks_at_nothing_again(bundled, monkeypatch):
    from keyphase.segmentation.evidence import finding

    first = bundled.segment()

    def refuse(*_):
        raise AssertionError("evidence was computed again")

    for name in ("evidence_of", "scores_of", "track_of"):
        monkeypatch.setattr(finding, name, refuse)
    for changed in ({"force_threshold": 0.9}, {"motion_threshold": 0.9}, {"turns": "none"}):
        found = bundled.segment(dataclasses.replace(Parameters(), **changed))
        assert found.track is first.track
        assert found.curve is first.curve


def test_the_reasons_of_a_boundary_are_the_terms_of_its_probability(bundled):
    weights = shipped_weights()
    found = bundled.segment()
    for boundary in found.boundaries:
        calibration = (
            weights.contact_calibration if boundary.contact_change else weights.motion_calibration
        )
        reasons = boundary.reasons
        assert reasons
        sizes = [abs(reason.contribution) for reason in reasons]
        assert sizes == sorted(sizes, reverse=True)
        odds = np.log(boundary.confidence / (1.0 - boundary.confidence))
        summed = sum(reason.contribution for reason in reasons)
        if not boundary.contact_change:
            # Terms and bias are stretched alike, so that what is left is what a score of zero says.
            score = np.interp(odds, calibration.odds, calibration.scores)
            bias = calibration.slope(np.array([score]))[0] * weights.motion.bias
            nothing = calibration.log_odds(np.zeros(1))[0]
            assert odds == pytest.approx(summed + bias + nothing, abs=0.01)


def test_what_is_not_given_says_what_would_let_it_in(bundled):
    strict = bundled.segment(Parameters(force_threshold=0.999999))
    missed = [c for c in strict.candidates if c.kind == "contact" and not c.given]
    assert missed
    for candidate in missed:
        assert "let it in" in candidate.why_not
    likeliest = max(missed, key=lambda candidate: candidate.probability)
    lower = Parameters(force_threshold=likeliest.probability - 1e-6)
    assert any(
        b.time_s == likeliest.time_s and b.contact_change for b in bundled.segment(lower).boundaries
    )


def test_the_track_is_as_high_as_its_candidates(bundled):
    found = bundled.segment()
    assert found.track is not None
    assert found.track.contact is not None
    for boundary in found.boundaries:
        track = found.track.contact if boundary.contact_change else found.track.motion
        place = int(np.argmin(np.abs(found.track.time_s - boundary.time_s)))
        assert track[place] >= boundary.confidence - 0.02


def test_a_least_step_in_newtons_leaves_lighter_touches_out(bundled):
    found = bundled.segment(Parameters(least_step_N=1000.0))
    assert not any(boundary.contact_change for boundary in found.boundaries)


def stops_in_a_long_path() -> tuple[Demonstration, list[tuple[float, float]]]:
    """A wide path with rotation and dead stops of 0.6 to 2 s, and when they are."""
    rng = np.random.default_rng(3)
    pose, time, stops = [np.zeros(6)], 1.5, []
    for stroke, stop in enumerate([0.0, 0.6, 0.0, 1.0, 2.0, 0.7]):
        size = 0.5 if stroke == 0 else 0.08
        step = size * rng.normal(size=6) * [1, 1, 1, 2, 2, 2]
        phase = synthetic.minimum_jerk(np.linspace(0.0, 1.0, 50))[:, None]
        pose += list(pose[-1] + phase * step)
        time += 1.0
        if stop:
            stops.append((time, time + stop))
            pose += [pose[-1]] * round(50 * stop)
            time += stop
    path = np.array([pose[0]] * 75 + pose[1:] + [pose[-1]] * 75)
    path = path + rng.normal(0.0, 2e-5, path.shape)
    angle = np.linalg.norm(path[:, 3:], axis=1, keepdims=True)
    axis = path[:, 3:] / np.maximum(angle, 1e-12)
    wxyz = np.hstack([np.cos(angle / 2), axis * np.sin(angle / 2)])
    return Demonstration("stops", np.arange(len(path)) / 50.0, path[:, :3], wxyz), stops


def test_a_stop_of_half_a_second_is_idle_whatever_else_the_recording_holds():
    recording, stops = stops_in_a_long_path()
    idle = [(s.start_s, s.end_s) for s in segment(recording).segments if s.idle]
    # The last stop goes on to the end of the recording.
    for start, end in stops[:-1]:
        assert any(abs(a - start) < 0.35 and abs(b - end) < 0.2 for a, b in idle), (start, end)


def test_steps_of_half_a_newton_beside_a_press_of_nine_are_less_likely():
    rng = np.random.default_rng(0)
    time = np.arange(0.0, 24.0, 0.02)
    force = 0.6 * np.add.outer(np.zeros(3), sum(time >= at for at in (4.0, 7.5))).T * [1, 0, 0]
    force += np.where((time >= 14.0) & (time < 19.0), 8.7, 0.0)[:, None] * [0, 0, 1]
    force += rng.normal(0.0, 0.02, force.shape)
    down = synthetic.minimum_jerk((time - 12.0) / 2.0) - synthetic.minimum_jerk((time - 19.0) / 2.0)
    recording = Demonstration("press", time, np.outer(down, [0, 0, -0.1]), force_N=force)
    found = segment(recording)
    contacts = {round(b.time_s): b.confidence for b in found.boundaries if b.contact_change}
    assert contacts[14] > 0.9
    assert contacts[19] > 0.9
    assert all(chance < 0.6 for time_s, chance in contacts.items() if time_s not in (14, 19))


def test_a_stop_too_short_for_two_boundaries_has_one_in_its_middle():
    strokes, stop_s = 6, 0.14
    phase = synthetic.minimum_jerk(np.linspace(0.0, 1.0, 50))
    still = np.zeros(round(50 * stop_s))
    out, back = (np.concatenate([p, still + p[-1]]) for p in (phase, 1.0 - phase))
    way = np.concatenate([back if stroke % 2 else out for stroke in range(strokes)])
    time = np.arange(len(way)) / 50.0
    recording = Demonstration("swings", time, np.outer(way, [0.4, 0.0, 0.0]))
    boundaries = [b.time_s for b in segment(recording).boundaries]
    stops = (np.arange(strokes - 1) + 1) * (1.0 + stop_s) - 0.5 * stop_s
    np.testing.assert_allclose(boundaries, stops, atol=0.1)


@pytest.mark.parametrize(("family", "seed"), [("press", 1_000_004), ("two-handed", 1_000_005)])
def test_times_since_1970_give_the_candidates_that_seconds_from_zero_give(family, seed):
    """They are rounded to 0.2 us, by which samples and durations lay on edges of cells."""
    made = make(family, seed).demonstration
    later = segment(dataclasses.replace(made, time_s=made.time_s + 1.7e9)).candidates
    first = segment(made).candidates
    found = [(one.time_s - 1.7e9, one.probability) for one in later]
    expected = [(one.time_s, one.probability) for one in first]
    np.testing.assert_allclose(found, expected, atol=1e-4)
