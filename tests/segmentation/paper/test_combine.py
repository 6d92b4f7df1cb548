"""The paper's rule for joining position and force boundaries."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from keyphase.segmentation.paper.combine import CLOSEST_S, NONE, SHARE_OF_SEGMENT, combine

END_S = 7.0


def joined(position, force, tolerance=0.3):
    """[(time, origin)] of a recording of seven seconds."""
    found = combine(np.array(position, float), np.array(force, float), 0.0, END_S, tolerance)
    origins = {(True, True): "both", (True, False): "force", (False, True): "position"}
    return [
        (round(float(t), 6), origins[bool(f != NONE), bool(p != NONE)])
        for t, f, p in zip(found.time_s, found.force, found.position, strict=True)
    ]


@pytest.mark.parametrize(
    ("position", "force", "expected"),
    [
        ([1, 2], [], [(1, "position"), (2, "position")]),
        ([2, 4.0], [4.16], [(2, "position"), (4.16, "both")]),
        ([2], [4.16], [(2, "position"), (4.16, "force")]),
        ([4.0], [3.9, 4.16], [(3.9, "both"), (4.16, "force")]),
        ([3.95, 4.08], [4.0], [(4.0, "force")]),
        ([3.5, 4.5], [4.0], [(3.5, "position"), (4.0, "force"), (4.5, "position")]),
        ([2.0], [4.0, 4.15], [(2, "position"), (4.0, "force"), (4.15, "force")]),
    ],
    ids=[
        "no force",
        "a force point moves the boundary",
        "a force point is added",
        "of two force points the nearer moves it",
        "leftover position points beside a force point are duplicates",
        "out of tolerance both stay",
        "force points of their own stay",
    ],
)
def test_the_rule(position, force, expected):
    assert joined(position, force) == expected


def test_of_equally_near_position_points_the_earlier_is_matched():
    assert joined([3.0, 5.0], [4.0], tolerance=1.0)[0][1] == "position"
    assert joined([3.5, 4.5], [4.0], tolerance=1.0) == [
        (3.5, "position"),
        (4.0, "force"),
        (4.5, "position"),
    ]
    assert joined([2.0, 4.0], [3.4, 4.6], tolerance=0.6) == [
        (2.0, "position"),
        (3.4, "both"),
        (4.6, "force"),
    ]


def test_a_short_segment_keeps_its_own_boundary():
    # 0.35 of the 0.5 s between the two position points is less than the tolerance.
    assert joined([3.0, 3.5], [3.75]) == [(3.0, "position"), (3.5, "position"), (3.75, "force")]
    assert joined([3.0, 3.5], [3.67]) == [(3.0, "position"), (3.67, "both")]


def test_position_points_at_the_ends_are_dropped():
    assert joined([0.05, 3.0, 6.95], []) == [(3.0, "position")]


times = st.lists(st.floats(0.0, END_S), max_size=12).map(sorted)
spaced_times = st.lists(st.integers(1, 23), max_size=8, unique=True).map(
    lambda parts: sorted(0.29 * part for part in parts)
)


@given(position=times, force=spaced_times, tolerance=st.floats(0.0, 2.0))
def test_every_force_point_is_kept_and_nothing_crowds(position, force, tolerance):
    found = combine(np.array(position), np.array(force), 0.0, END_S, tolerance)
    assert sorted(found.force[found.force != NONE].tolist()) == list(range(len(force)))
    assert (np.diff(found.time_s) >= CLOSEST_S - 1e-9).all()
    matched = (found.force != NONE) & (found.position != NONE)
    distance = np.abs(np.array(position)[found.position[matched]] - found.time_s[matched])
    assert (distance <= min(tolerance, SHARE_OF_SEGMENT * END_S) + 1e-9).all()


@given(position=times, force=spaced_times)
def test_no_point_is_used_twice(position, force):
    found = combine(np.array(position), np.array(force), 0.0, END_S, 0.3)
    for indices in (found.position, found.force):
        taken = indices[indices != NONE].tolist()
        assert len(taken) == len(set(taken))
