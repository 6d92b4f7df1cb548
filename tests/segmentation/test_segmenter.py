"""From a demonstration to its segmentation: invariants, stages, robustness."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

import synthetic
from keyphase.demonstration import Demonstration
from keyphase.segmentation import Parameters, Segmentation, segment


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
@given(demonstrations())
def test_any_valid_demonstration_is_segmented(recording):
    assert_well_formed(segment(recording))


@pytest.mark.slow
@settings(max_examples=25)
@given(
    demonstrations(),
    st.builds(
        Parameters,
        variant=st.sampled_from(["evidence", "paper"]),
        force_threshold=st.none() | st.floats(1e-3, 1e6),
        motion_threshold=st.none() | st.floats(0.0, 1.0),
        turns=st.sampled_from(["none", "clear", "all"]),
        least_step_N=st.floats(0.0, 10.0),
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


@pytest.mark.parametrize(
    "parameters",
    [
        Parameters(),
        Parameters(variant="paper"),
        Parameters(variant="paper", mixture="scikit-learn"),
    ],
)
@pytest.mark.parametrize("count", [2, 3, 5, 30])
def test_very_short_demonstrations_are_segmented(parameters, count):
    time = np.arange(count) / 250
    recording = Demonstration("short", time, np.outer(time, [1, 0, 0]), force_N=np.ones((count, 3)))
    assert_well_formed(segment(recording, parameters))


def test_a_tool_that_stands_still_is_one_idle_segment():
    still = Demonstration("still", np.arange(500) / 100, np.full((500, 3), 0.3))
    found = segment(still)
    assert [piece.label for piece in found.segments] == ["idle"]
    assert found.segments[0].idle
    assert found.curve is None
    assert found.peaks == ()
    assert found.threshold is None


def test_the_bundled_file_is_what_the_generator_makes():
    made = synthetic.bundled_setup1()
    with np.load(synthetic.BUNDLED) as file:
        np.testing.assert_array_equal(file["time_s"], made.time_s)
        np.testing.assert_allclose(file["position_m"], made.position_m, atol=1e-7)
        np.testing.assert_allclose(file["orientation_wxyz"], made.orientation_wxyz, atol=1e-7)
        np.testing.assert_allclose(file["force_N"], made.force_N, atol=1e-5)
        np.testing.assert_allclose(file["torque_Nm"], made.torque_Nm, atol=1e-6)
