"""What is always true of a demonstration, and what is refused on the way in."""

import pickle
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from keyphase.demonstration import Demonstration
from keyphase.errors import DemonstrationError

TIME = np.arange(5) / 10.0
STILL = np.zeros((5, 3))


def demonstration(**channels: Any) -> Demonstration:
    return Demonstration(**{"name": "one", "time_s": TIME, "position_m": STILL, **channels})


def test_knows_its_span_and_rate() -> None:
    one = demonstration(time_s=TIME + 7.0)
    assert (one.start_s, one.end_s) == (7.0, 7.4)
    assert one.duration_s == pytest.approx(0.4)
    assert one.rate_hz == pytest.approx(10.0)


def test_what_it_holds_cannot_be_changed() -> None:
    with pytest.raises(ValueError, match="read-only"):
        demonstration().position_m[0, 0] = 1.0


def test_what_it_was_made_from_can_still_be_changed() -> None:
    mine = STILL.copy()
    one = demonstration(position_m=mine)
    mine[0] = 1.0
    assert not one.position_m.any()


def test_it_arrives_in_another_process_as_it_was() -> None:
    one = demonstration(channels={"current": TIME}, metadata={"operator": "anna"})
    same = pickle.loads(pickle.dumps(one))
    assert same.metadata == {"operator": "anna"}
    np.testing.assert_array_equal(same.channels["current"], TIME)
    for values in (same.position_m, same.channels["current"]):
        assert not values.flags.writeable
    with pytest.raises(TypeError):
        same.metadata["operator"] = "ben"


@pytest.mark.parametrize(
    ("time_s", "message"),
    [
        (TIME[:1], "at least two samples"),
        (TIME[::-1], "row 1"),
        (np.where(TIME == 0.3, 0.2, TIME), "row 3"),
        (np.where(TIME == 0.2, np.nan, TIME), "row 2"),
        (np.arange(5) * 1e6, "at most 100 s"),
    ],
)
def test_refuses_time_that_does_not_increase(time_s: np.ndarray, message: str) -> None:
    with pytest.raises(DemonstrationError, match=message):
        demonstration(time_s=time_s, position_m=np.zeros((len(time_s), 3)))


@pytest.mark.parametrize(
    ("channel", "values", "message"),
    [
        ("position_m", np.zeros((4, 3)), r"\(5, 3\).*\(4, 3\)"),
        ("force_N", np.zeros((5, 2)), r"\(5, 3\).*\(5, 2\)"),
        ("torque_Nm", np.full((5, 3), np.inf), "row 0, column 0 holds inf"),
        ("joints_rad", np.zeros(5), r"\(5, J\)"),
        ("position_m", np.full((5, 3), 1e12), "unit"),
        ("orientation_wxyz", np.full((5, 4), 0.6), "norm 1.2"),
    ],
)
def test_refuses_a_channel_that_is_not_what_it_says(
    channel: str, values: np.ndarray, message: str
) -> None:
    with pytest.raises(DemonstrationError, match=message):
        demonstration(**{channel: values})


@given(st.lists(st.booleans(), min_size=5, max_size=5))
def test_orientation_is_continuous_in_sign(flipped: list[bool]) -> None:
    angle = np.linspace(0.0, 3.0, 5)
    turn = np.column_stack([np.cos(angle), np.sin(angle), np.zeros((5, 2))])
    signs = np.where(flipped, -1.0, 1.0)[:, None]
    orientation = demonstration(orientation_wxyz=turn * signs).orientation_wxyz
    assert orientation is not None
    assert (np.sum(orientation[1:] * orientation[:-1], axis=1) > 0).all()


@given(st.floats(-1.0, 2.0))
def test_finds_the_sample_nearest_to_a_time(time_s: float) -> None:
    index = demonstration().index_at(time_s)
    assert abs(TIME[index] - time_s) == pytest.approx(np.abs(TIME - time_s).min())


@pytest.mark.parametrize("shape", [(9,), (10, 2), (20,), ()])
def test_a_gripper_of_another_shape_is_refused_as_it_came(shape):
    with pytest.raises(DemonstrationError, match="gripper") as refused:
        Demonstration("t", np.arange(10.0), np.zeros((10, 3)), gripper=np.zeros(shape))
    assert f"(10,), one opening per time sample, but has shape {shape}" in str(refused.value)
