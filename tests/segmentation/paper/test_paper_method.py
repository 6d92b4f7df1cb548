"""The paper's method whole: Gaussians, peaks and their combination, stages kept."""

import dataclasses

import numpy as np
import pytest

import synthetic
from keyphase.demonstration import Demonstration
from keyphase.segmentation import Parameters, Segmenter, segment
from keyphase.segmentation.end_condition import ConfigurationEnd, ContactEnd

PAPER = Parameters(variant="paper")


@pytest.fixture(scope="module")
def bundled() -> Segmenter:
    return Segmenter(synthetic.bundled_setup1())


def test_the_bundled_demonstration_gives_the_key_phases_of_setup_1(bundled):
    found = bundled.segment(PAPER)
    kinds = [piece.label.split(" until")[0] for piece in found.segments]
    assert kinds == ["Move forward", "idle", "Move down", "idle", "Slide left", "idle"]
    assert [b.origin for b in found.boundaries] == [
        "position",
        "position",
        "both",
        "position",
        "both",
    ]
    contacts = [b.time_s for b in found.boundaries if b.contact_change]
    np.testing.assert_allclose(contacts, [4.2, 6.97], atol=0.025)


def test_segments_that_end_in_contact_get_a_contact_end_condition(bundled):
    found = bundled.segment(PAPER)
    down, left = found.segments[2].end_condition, found.segments[4].end_condition
    assert isinstance(down, ContactEnd)
    assert isinstance(left, ContactEnd)
    np.testing.assert_allclose(down.direction, (0, 0, 1), atol=0.1)
    np.testing.assert_allclose(left.direction, (0, -1, 0), atol=0.2)
    assert isinstance(found.segments[0].end_condition, ConfigurationEnd)


def test_the_bump_on_the_way_is_seen_and_rejected(bundled):
    rejected = [peak for peak in bundled.segment(PAPER).peaks if peak.rejection == "does not stay"]
    assert any(abs(peak.time_s - 0.78) < 0.06 for peak in rejected)


def test_raising_the_threshold_takes_contact_changes_away_and_leaves_the_rest(bundled):
    usual, strict = (
        bundled.segment(PAPER),
        bundled.segment(Parameters(variant="paper", force_threshold=1e8)),
    )
    assert all(boundary.origin == "position" for boundary in strict.boundaries)
    positions = [b.position_s for b in usual.boundaries if b.position_s is not None]
    assert [b.time_s for b in strict.boundaries] == positions
    assert strict.threshold == 1e8


def test_thresholds_and_tolerance_refit_and_refilter_nothing(monkeypatch):
    segmenter = Segmenter(synthetic.bundled_setup1())
    first = segmenter.segment(PAPER)

    def refuse(*_):
        raise AssertionError("a stage was computed again")

    from keyphase.segmentation.paper import stages

    for name in ("fit_position", "error_curve", "candidates_of"):
        monkeypatch.setattr(stages, name, refuse)
    changes = {
        "force_threshold": 300.0,
        "force_ratio": 3.0,
        "min_distance_s": 1.0,
        "persistence": 0.0,
        "merge_tolerance_s": 0.0,
    }
    for name, value in changes.items():
        changed = segmenter.segment(dataclasses.replace(PAPER, **{name: value}))
        assert changed.curve is first.curve
        assert changed.gaussians is first.gaussians


@pytest.mark.parametrize(
    ("name", "value"), [("process_noise_ratio", 5.0), ("measurement_noise", 0.5)]
)
def test_noise_parameters_change_the_curve_and_not_the_gaussians(bundled, name, value):
    before = bundled.segment(PAPER)
    after = bundled.segment(dataclasses.replace(PAPER, **{name: value}))
    assert not np.allclose(before.curve.error, after.curve.error)
    assert after.gaussians is before.gaussians


def test_going_back_gives_the_same_segmentation_as_at_first(bundled):
    before = bundled.segment(PAPER)
    bundled.segment(Parameters(variant="paper", force_threshold=1e6, gaussians=3))
    after = bundled.segment(PAPER)
    assert after.boundaries == before.boundaries
    assert after.segments == before.segments
    assert after.peaks == before.peaks


def test_a_contact_after_a_gentle_end_of_two_seconds_is_that_end():
    # Position sees a movement that slows down this long end a third of a second early.
    found = segment(synthetic.setup1(5043, "real", forces=True).demonstration, PAPER)
    assert [b.origin for b in found.boundaries] == ["position", "position", "both", "position"]
    met = found.boundaries[2]
    assert met.position_s is not None
    assert 0.3 < met.time_s - met.position_s < PAPER.merge_tolerance_s


def test_a_fresh_segmenter_agrees_with_one_that_was_used(bundled):
    parameters = Parameters(variant="paper", force_threshold=200.0, merge_tolerance_s=0.05)
    fresh = segment(synthetic.bundled_setup1(), parameters)
    used = bundled.segment(parameters)
    assert fresh.boundaries == used.boundaries
    assert fresh.segments == used.segments


def test_the_filterpy_engine_gives_the_same_segmentation(bundled):
    ours, theirs = (
        bundled.segment(PAPER),
        bundled.segment(Parameters(variant="paper", engine="filterpy")),
    )
    np.testing.assert_allclose(ours.curve.error, theirs.curve.error, rtol=1e-9, atol=1e-9)
    assert ours.segments == theirs.segments


@pytest.mark.slow
@pytest.mark.parametrize("mixture", ["keyphase", "scikit-learn"])
@pytest.mark.parametrize("count", [1, 4, 9])
def test_a_given_number_of_gaussians_is_fitted(bundled, mixture, count):
    found = bundled.segment(Parameters(variant="paper", gaussians=count, mixture=mixture))
    assert len(found.gaussians) == count
    assert len(found.segments) == len(found.boundaries) + 1


def test_the_estimators_agree_closely(bundled):
    equal = bundled.segment(Parameters(variant="paper", estimator="equal-distance")).boundaries
    crossing = bundled.segment(Parameters(variant="paper", estimator="weight-crossing")).boundaries
    np.testing.assert_allclose([b.time_s for b in equal], [b.time_s for b in crossing], atol=0.02)
    assert [b.time_s for b in equal] != [b.time_s for b in crossing]


def test_a_constant_force_offset_changes_neither_boundaries_nor_labels():
    made = synthetic.bundled_setup1()
    offset = dataclasses.replace(made, force_N=made.force_N + np.array([2.0, -3.0, 14.0]))
    plain, shifted = segment(made, PAPER), segment(offset, PAPER)
    assert [b.time_s for b in plain.boundaries] == [b.time_s for b in shifted.boundaries]
    assert [s.label for s in plain.segments] == [s.label for s in shifted.segments]


@pytest.mark.parametrize("rate_hz", [50.0, 100.0, 1000.0])
def test_the_rate_of_the_recording_does_not_matter(rate_hz):
    made = synthetic.bundled_setup1()
    time = np.arange(round(made.duration_s * rate_hz)) / rate_hz

    def at_rate(values):
        return np.column_stack([np.interp(time, made.time_s, column) for column in values.T])

    force = at_rate(made.force_N)
    found = segment(Demonstration("rate", time, at_rate(made.position_m), force_N=force), PAPER)
    reference = segment(dataclasses.replace(made, orientation_wxyz=None, torque_Nm=None), PAPER)
    np.testing.assert_allclose(
        [b.time_s for b in found.boundaries], [b.time_s for b in reference.boundaries], atol=0.06
    )
