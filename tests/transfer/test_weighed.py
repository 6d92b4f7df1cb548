"""The program's own boundaries are weighed against those of the finished recordings."""

from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest

from keyphase.segmentation.segmentation import Boundary
from keyphase.transfer.alignment import Alignment
from keyphase.transfer.evidence_places import NO_PLACES, Place, Places
from keyphase.transfer.meant_places import meant_elsewhere_s
from keyphase.transfer.placing import Teacher, placed_ends
from keyphase.transfer.signals import Signals
from keyphase.transfer.taught import Phase, Taught
from keyphase.transfer.weighed import weighed


def boundary(time_s: float, confidence: float = 0.95, *, contact: bool = False) -> Boundary:
    return Boundary(time_s, "position", (time_s, time_s), confidence, contact)


def teacher(ends_s: Sequence[float], found_s: Sequence[float] = ()) -> Teacher:
    """Ten seconds at an even speed, moment by moment like the new recording."""
    edges = [0.0, *ends_s, 10.0]
    phases = tuple(
        Phase(start, end, f"{i}", True, False) for i, (start, end) in enumerate(pairwise(edges))
    )
    time_s = np.linspace(0.0, 10.0, 251)
    still = Signals(time_s, np.zeros((251, 1)), ("speed",))
    taught = Taught("finished", phases, still, NO_PLACES, tuple(found_s))
    return Teacher(taught, Alignment(time_s, time_s, np.zeros(251), 0.0))


def times_of(own: Sequence[Boundary], teachers: Sequence[Teacher]) -> list[float]:
    return [one.time_s for one in weighed(own, teachers)]


def test_a_short_pause_that_persons_mark_once_is_one_boundary_in_its_middle() -> None:
    own = [boundary(2.0), boundary(4.8), boundary(5.2), boundary(8.0)]
    once, twice = teacher([2.0, 5.0, 8.0]), teacher([2.0, 4.8, 5.2, 8.0])
    assert times_of(own, [once]) == pytest.approx([2.0, 5.0, 8.0])
    assert times_of(own, [once, twice, twice]) == [2.0, 4.8, 5.2, 8.0]


def test_who_has_a_phase_as_short_as_a_pause_would_have_marked_it() -> None:
    own = [boundary(2.0), boundary(4.8), boundary(5.2)]
    assert times_of(own, [teacher([2.0, 2.3, 5.0])]) == [2.0, 4.8, 5.2]


def test_who_marks_pauses_once_does_so_where_no_mark_arrives() -> None:
    own = [boundary(2.0), boundary(4.8), boundary(5.2), boundary(8.0)]
    one = teacher([2.0, 8.0], (1.8, 2.2, 8.0)).taught
    stops = Places(tuple(Place(at_s, "motion", 0.9) for at_s in (1.8, 2.2)))
    habit = Teacher(replace(one, places=stops), teacher([]).alignment)
    assert [b.time_s for b in weighed(own, [habit], [habit])] == [2.0, 5.0, 8.0]
    assert [b.time_s for b in weighed(own, [habit])] == [2.0, 4.8, 5.2, 8.0]


def test_who_marks_pauses_twice_does_so_where_one_mark_arrives() -> None:
    own = [boundary(2.0), boundary(4.8), boundary(5.2), boundary(8.0)]
    one = teacher([1.8, 2.2, 5.0, 8.0], (1.8, 2.2, 8.0))
    stops = Places(tuple(Place(at_s, "motion", 0.9) for at_s in (1.8, 2.2)))
    habit = replace(one, taught=replace(one.taught, places=stops))
    once = teacher([2.0, 5.0, 8.0])
    assert [b.time_s for b in weighed(own, [once], [habit])] == [2.0, 4.8, 5.2, 8.0]


def test_ends_that_arrive_at_one_moment_are_put_beside_each_other() -> None:
    finished = teacher([2.0, 5.0, 8.0])
    at_s = finished.alignment.to_s
    arrives_s = np.where(at_s > 4.0, np.maximum(at_s, 9.0), at_s)
    squeezed = Teacher(finished.taught, replace(finished.alignment, to_s=arrives_s))
    ends = placed_ends([squeezed], finished.taught.signals, NO_PLACES)
    assert ends is not None
    assert [end.time_s for end in ends] == pytest.approx([2.0, 9.0, 9.04], abs=0.05)


def test_a_pause_in_which_the_contact_changes_keeps_both_ends() -> None:
    own = [boundary(2.0), boundary(4.8, contact=True), boundary(5.2)]
    assert times_of(own, [teacher([2.0, 5.0, 8.0])]) == [2.0, 4.8, 5.2]


def test_what_is_unsure_and_before_the_task_is_none_of_its_boundaries() -> None:
    own = [boundary(0.5, 0.7), boundary(2.0), boundary(3.5, 0.7), boundary(5.0)]
    finished = teacher([2.0, 5.0])
    assert times_of(own, [finished]) == [2.0, 3.5, 5.0]
    assert times_of([replace(own[0], confidence=0.95)], [finished]) == [0.5]


def test_marks_now_on_one_side_now_on_the_other_mean_no_other_place() -> None:
    ends = np.arange(1.0, 9.0)
    now_and_then = ends + 0.15 * np.array([1, -1, 1, -1, 1, -1, 1, -1])
    early = teacher(ends.tolist(), (ends + 0.15).tolist())
    careless = teacher(ends.tolist(), now_and_then.tolist())
    assert meant_elsewhere_s([early]) == pytest.approx(0.15)
    assert meant_elsewhere_s([careless]) == 0.0


def test_of_few_marks_scatter_may_be_meant() -> None:
    ends = np.array([2.0, 4.0, 6.0, 8.0])
    now_and_then = teacher(ends.tolist(), (ends + 0.15 * np.array([1, -1, 1, -1])).tolist())
    assert meant_elsewhere_s([now_and_then]) == pytest.approx(0.15)


def test_several_of_the_same_phases_tell_of_each_boundary_where_it_is_meant() -> None:
    ends = np.array([2.0, 4.0, 6.0, 8.0])
    each = teacher(ends.tolist(), (ends + 0.15 * np.array([1, -1, 1, -1])).tolist())
    assert meant_elsewhere_s([each, each, each]) == pytest.approx(0.15)
