"""From a demonstration to its segmentation: invariants, stages, robustness."""

import dataclasses

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

import synthetic
from keyphase.demonstration import Demonstration
from keyphase.segmentation import Parameters, Segmentation, Segmenter, segment
from keyphase.segmentation.end_condition import ConfigurationEnd, ContactEnd


def assert_well_formed(found: Segmentation) -> None:
    """Segments tile the recording, boundaries ascend inside it, intervals hold their time."""
    recording = found.demonstration
    times = [boundary.time_s for boundary in found.boundaries]
    edges = [recording.start_s, *times, recording.end_s]
    assert edges == sorted(set(edges))
    assert [segment.start_s for segment in found.segments] == edges[:-1]
    assert [segment.end_s for segment in found.segments] == edges[1:]
    for boundary in found.boundaries:
        low, high = boundary.interval_s
        assert low <= boundary.time_s <= high
        assert 0.0 <= boundary.confidence <= 1.0
        assert boundary.contact_change == (boundary.origin in ("force", "both"))
    assert (found.curve is None) == (recording.force_N is None)
    assert all(np.isfinite(gaussian.covariance_m2).all() for gaussian in found.gaussians)


readings = st.floats(-1e3, 1e3) | st.floats(-1e9, 1e9)


@st.composite
def demonstrations(draw) -> Demonstration:
    """Any valid demonstration of up to 60 samples, absurd scales included."""
    count = draw(st.integers(2, 60))
    steps = draw(arrays(float, count, elements=st.sampled_from([1e-6, 1e-3, 4e-3, 0.02, 0.1, 7.0])))
    position = draw(arrays(float, (count, 3), elements=readings, fill=st.just(0.25)))
    wrench = draw(arrays(float, (count, 6), elements=readings, fill=st.just(1.0)))
    quaternion = draw(arrays(float, (count, 4), elements=st.floats(-1, 1), fill=st.just(0.5)))
    quaternion[np.linalg.norm(quaternion, axis=1) < 0.1] = [1, 0, 0, 0]
    quaternion /= np.linalg.norm(quaternion, axis=1, keepdims=True)
    has_orientation, has_force, has_torque = (draw(st.booleans()) for _ in range(3))
    return Demonstration(
        "any",
        draw(st.floats(-1e3, 1e3)) + np.cumsum(steps),
        position,
        quaternion if has_orientation else None,
        wrench[:, :3] if has_force else None,
        wrench[:, 3:] if has_force and has_torque else None,
    )


@pytest.mark.filterwarnings("error::RuntimeWarning")
@settings(max_examples=150, deadline=None)
@given(demonstrations())
def test_any_valid_demonstration_is_segmented(recording):
    assert_well_formed(segment(recording))


@settings(max_examples=25, deadline=None)
@given(
    demonstrations(),
    st.builds(
        Parameters,
        force_threshold=st.none() | st.floats(1e-3, 1e6),
        force_ratio=st.floats(0.0, 100.0),
        min_distance_s=st.floats(0.0, 2.0),
        persistence=st.floats(0.0, 20.0),
        gaussians=st.none() | st.integers(1, 200),
        estimator=st.sampled_from(["equal-distance", "weight-crossing"]),
        merge_tolerance_s=st.floats(0.0, 2.0),
    ),
)
def test_under_any_parameters(recording, parameters):
    assert_well_formed(segment(recording, parameters))


@pytest.mark.parametrize("mixture", ["keyphase", "scikit-learn"])
@pytest.mark.parametrize("count", [2, 3, 5, 30])
def test_very_short_demonstrations_are_segmented(mixture, count):
    time = np.arange(count) / 250
    recording = Demonstration("short", time, np.outer(time, [1, 0, 0]), force_N=np.ones((count, 3)))
    assert_well_formed(segment(recording, Parameters(mixture=mixture)))


def test_a_tool_that_stands_still_is_one_idle_segment():
    still = Demonstration("still", np.arange(500) / 100, np.full((500, 3), 0.3))
    found = segment(still)
    assert [piece.label for piece in found.segments] == ["idle"]
    assert found.segments[0].idle
    assert found.curve is None
    assert found.peaks == ()
    assert found.threshold is None


@pytest.fixture(scope="module")
def bundled() -> Segmenter:
    return Segmenter(synthetic.bundled_setup1())


def test_the_bundled_demonstration_gives_the_key_phases_of_setup_1(bundled):
    found = bundled.segment()
    kinds = [piece.label.split(" mm")[0].rstrip("0123456789 ") for piece in found.segments]
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
    found = bundled.segment()
    down, left = found.segments[2].end_condition, found.segments[4].end_condition
    assert isinstance(down, ContactEnd)
    assert isinstance(left, ContactEnd)
    np.testing.assert_allclose(down.direction, (0, 0, 1), atol=0.1)
    np.testing.assert_allclose(left.direction, (0, -1, 0), atol=0.2)
    assert isinstance(found.segments[0].end_condition, ConfigurationEnd)


def test_the_bump_on_the_way_is_seen_and_rejected(bundled):
    rejected = [peak for peak in bundled.segment().peaks if peak.rejection == "does not stay"]
    assert any(abs(peak.time_s - 0.78) < 0.06 for peak in rejected)


def test_raising_the_threshold_takes_contact_changes_away_and_leaves_the_rest(bundled):
    usual, strict = bundled.segment(), bundled.segment(Parameters(force_threshold=1e8))
    assert all(boundary.origin == "position" for boundary in strict.boundaries)
    positions = [b.position_s for b in usual.boundaries if b.position_s is not None]
    assert [b.time_s for b in strict.boundaries] == positions
    assert strict.threshold == 1e8


def test_thresholds_and_tolerance_refit_and_refilter_nothing(monkeypatch):
    segmenter = Segmenter(synthetic.bundled_setup1())
    first = segmenter.segment()

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
        changed = segmenter.segment(dataclasses.replace(Parameters(), **{name: value}))
        assert changed.curve is first.curve
        assert changed.gaussians is first.gaussians


@pytest.mark.parametrize(
    ("name", "value"), [("process_noise_ratio", 5.0), ("measurement_noise", 0.5)]
)
def test_noise_parameters_change_the_curve_and_not_the_gaussians(bundled, name, value):
    before = bundled.segment()
    after = bundled.segment(dataclasses.replace(Parameters(), **{name: value}))
    assert not np.allclose(before.curve.error, after.curve.error)
    assert after.gaussians is before.gaussians


def test_going_back_gives_the_same_segmentation_as_at_first(bundled):
    before = bundled.segment()
    bundled.segment(Parameters(force_threshold=1e6, gaussians=3))
    after = bundled.segment()
    assert after.boundaries == before.boundaries
    assert after.segments == before.segments
    assert after.peaks == before.peaks


def test_a_contact_after_a_gentle_end_of_two_seconds_is_that_end():
    # Position sees a movement that slows down this long end a third of a second early.
    found = segment(synthetic.setup1(5043, "real", forces=True).demonstration)
    assert [b.origin for b in found.boundaries] == ["position", "position", "both", "position"]
    met = found.boundaries[2]
    assert met.position_s is not None
    assert 0.3 < met.time_s - met.position_s < Parameters().merge_tolerance_s


def test_a_fresh_segmenter_agrees_with_one_that_was_used(bundled):
    parameters = Parameters(force_threshold=200.0, merge_tolerance_s=0.05)
    fresh = segment(synthetic.bundled_setup1(), parameters)
    used = bundled.segment(parameters)
    assert fresh.boundaries == used.boundaries
    assert fresh.segments == used.segments


def test_the_filterpy_engine_gives_the_same_segmentation(bundled):
    ours, theirs = bundled.segment(), bundled.segment(Parameters(engine="filterpy"))
    np.testing.assert_allclose(ours.curve.error, theirs.curve.error, rtol=1e-9, atol=1e-9)
    assert ours.segments == theirs.segments


@pytest.mark.parametrize("mixture", ["keyphase", "scikit-learn"])
@pytest.mark.parametrize("count", [1, 4, 9])
def test_a_given_number_of_gaussians_is_fitted(bundled, mixture, count):
    found = bundled.segment(Parameters(gaussians=count, mixture=mixture))
    assert len(found.gaussians) == count
    assert_well_formed(found)


def test_the_estimators_agree_closely(bundled):
    equal = bundled.segment(Parameters(estimator="equal-distance")).boundaries
    crossing = bundled.segment(Parameters(estimator="weight-crossing")).boundaries
    np.testing.assert_allclose([b.time_s for b in equal], [b.time_s for b in crossing], atol=0.02)
    assert [b.time_s for b in equal] != [b.time_s for b in crossing]


def test_a_constant_force_offset_changes_neither_boundaries_nor_labels():
    made = synthetic.bundled_setup1()
    offset = dataclasses.replace(made, force_N=made.force_N + np.array([2.0, -3.0, 14.0]))
    plain, shifted = segment(made), segment(offset)
    assert [b.time_s for b in plain.boundaries] == [b.time_s for b in shifted.boundaries]
    assert [s.label for s in plain.segments] == [s.label for s in shifted.segments]


@pytest.mark.parametrize("rate_hz", [50.0, 100.0, 1000.0])
def test_the_rate_of_the_recording_does_not_matter(rate_hz):
    made = synthetic.bundled_setup1()
    time = np.arange(round(made.duration_s * rate_hz)) / rate_hz

    def at_rate(values):
        return np.column_stack([np.interp(time, made.time_s, column) for column in values.T])

    force = at_rate(made.force_N)
    found = segment(Demonstration("rate", time, at_rate(made.position_m), force_N=force))
    reference = segment(dataclasses.replace(made, orientation_wxyz=None, torque_Nm=None))
    np.testing.assert_allclose(
        [b.time_s for b in found.boundaries], [b.time_s for b in reference.boundaries], atol=0.06
    )


def test_the_bundled_file_is_what_the_generator_makes():
    made = synthetic.bundled_setup1()
    with np.load(synthetic.BUNDLED) as file:
        np.testing.assert_array_equal(file["time_s"], made.time_s)
        np.testing.assert_allclose(file["position_m"], made.position_m, atol=1e-7)
        np.testing.assert_allclose(file["orientation_wxyz"], made.orientation_wxyz, atol=1e-7)
        np.testing.assert_allclose(file["force_N"], made.force_N, atol=1e-5)
        np.testing.assert_allclose(file["torque_Nm"], made.torque_Nm, atol=1e-6)
