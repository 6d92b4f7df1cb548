"""What was taught on one recording arrives on others of its task, and only there."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from keyphase.demonstration import Demonstration
from keyphase.errors import LabelingError
from keyphase.files.shipped import shipped
from keyphase.labeling.label import label
from keyphase.making import make
from keyphase.readers import read
from keyphase.segmentation import segment
from keyphase.segmentation.segmentation import Segmentation
from keyphase.simulation import record
from keyphase.transfer.alignment import align
from keyphase.transfer.as_edit import as_edit
from keyphase.transfer.evidence_places import Place, Places
from keyphase.transfer.own_boundaries import ProposedBoundary, own_where_better, with_own
from keyphase.transfer.placing import Teacher
from keyphase.transfer.proposing import ProposedPhase, Transfer, propose, usual_cost_of
from keyphase.transfer.signals import signals_of
from keyphase.transfer.taught import Taught, taught_by

NAMES = ("reach", "wait", "lower", "settle", "slide")


def named(demonstration: Demonstration) -> Taught:
    """Taught with a name for each of its phases."""
    found = taught_by_program(demonstration)
    phases = tuple(
        replace(phase, name=name) for phase, name in zip(found.phases, NAMES, strict=True)
    )
    return replace(found, phases=phases)


def taught_by_program(demonstration: Demonstration) -> Taught:
    return taught_by(label(segment(demonstration)))


def teacher(taught: Taught, demonstration: Demonstration) -> Teacher:
    return Teacher(taught, align(taught.signals, signals_of(demonstration)))


@pytest.fixture(scope="module")
def shown() -> Demonstration:
    return record("setup1", seed=1)


@pytest.fixture(scope="module")
def first(shown: Demonstration) -> Taught:
    return named(shown)


@pytest.fixture(scope="module")
def second() -> Demonstration:
    return record("setup1", seed=4)


def test_a_recording_aligns_with_itself_without_cost(first: Taught) -> None:
    itself = align(first.signals, first.signals)
    assert itself.cost == pytest.approx(0.0, abs=1e-6)
    assert itself.at(3.0) == pytest.approx(3.0, abs=0.05)


def test_a_stretched_recording_aligns_moment_by_moment(shown: Demonstration, first: Taught) -> None:
    slower = replace(shown, time_s=2.0 * shown.time_s)
    assert align(first.signals, signals_of(slower)).at(3.0) == pytest.approx(6.0, abs=0.2)


def test_boundaries_and_names_arrive_on_another_recording(
    first: Taught, second: Demonstration
) -> None:
    own = segment(second)
    found = propose([first], second, own)
    assert [phase.name for phase in found.phases] == list(NAMES)
    expected = [boundary.time_s for boundary in own.boundaries]
    np.testing.assert_allclose([b.time_s for b in found.boundaries], expected, atol=0.2)
    assert found.teachers == (first.name,)


def resting(demonstration: Demonstration, at: int, seconds: float) -> Demonstration:
    """The same, standing still at a row for some seconds."""
    count = int(seconds * demonstration.rate_hz)
    rows = np.concatenate([np.arange(at), np.full(count, at), np.arange(at, len(demonstration))])
    time_s = demonstration.start_s + np.arange(len(rows)) / demonstration.rate_hz
    channels = ("position_m", "orientation_wxyz", "force_N", "torque_Nm")
    changed = {name: getattr(demonstration, name)[rows] for name in channels}
    return Demonstration("rested", time_s, **changed)


def test_a_long_rest_that_was_not_taught_is_part_of_the_phase_it_interrupts(
    first: Taught, second: Demonstration
) -> None:
    """The program's own boundaries are taken there, of which its end is one."""
    rested = resting(second, 0, 5.0)
    own = segment(rested)
    assert len(own.boundaries) == len(NAMES)
    found = propose([first], rested, own)
    assert [phase.name for phase in found.phases] == list(NAMES)


def test_a_rest_does_not_make_the_program_right_where_persons_mean_other_places(
    first: Taught, second: Demonstration
) -> None:
    """It finds one boundary more there, but nothing is missing or doubled."""
    late_s = [*(end_s + 0.2 for end_s in first.ends_s), first.phases[-1].end_s]
    begun_s = [first.phases[0].start_s, *late_s]
    marks = zip(first.phases, begun_s, late_s, strict=False)
    late = tuple(replace(phase, start_s=start_s, end_s=end_s) for phase, start_s, end_s in marks)
    rested = resting(second, 0, 5.0)
    own = segment(rested)
    found = propose([replace(first, phases=late)], rested, own)
    own_s = [boundary.time_s for boundary in own.boundaries[1:]]
    late_by = np.subtract([boundary.time_s for boundary in found.boundaries], own_s)
    assert float(np.median(late_by)) == pytest.approx(0.2, abs=0.1)


def test_another_task_is_an_outlier_and_nothing_is_forced_on_it(first: Taught) -> None:
    found = propose([first], record("setup2", seed=1))
    assert found.outlier
    assert (found.boundaries, found.phases) == ((), ())


def test_a_stranger_whose_mirror_image_fits_less_badly_is_an_outlier() -> None:
    """Places and forces alone, which a wipe upside down has half in common with a snap."""
    snap, wipe = (read(shipped("data") / f"{name}.npz") for name in ("setup1", "wipe"))
    plain = Demonstration("plain", snap.time_s, snap.position_m, force_N=snap.force_N)
    found = propose([taught_by(label(segment(plain)))], wipe)
    assert found.outlier


@pytest.mark.parametrize("family", ["reach", "pick-and-place"])
def test_where_no_force_was_recorded_a_stranger_is_an_outlier_too(
    shown: Demonstration, second: Demonstration, family: str
) -> None:
    """Recordings with fewer kinds of signals have less to differ in."""
    taught = taught_by_program(replace(shown, force_N=None, torque_Nm=None))
    stranger = replace(make(family, 1).demonstration, force_N=None, torque_Nm=None, gripper=None)
    assert propose([taught], stranger).outlier
    assert not propose([taught], replace(second, force_N=None, torque_Nm=None)).outlier


def test_confidence_falls_where_nothing_of_its_own_is_near(
    first: Taught, second: Demonstration
) -> None:
    with_evidence = propose([first], second, segment(second))
    without = propose([first], second)
    assert min(b.confidence for b in without.boundaries) < min(
        b.confidence for b in with_evidence.boundaries
    )


def test_a_proposal_is_one_edit_that_makes_it(first: Taught, second: Demonstration) -> None:
    own = segment(second)
    found = propose([first], second, own)
    made = label(own, {0: as_edit(found, own)})
    assert [piece.label for piece in made.segments] == list(NAMES)
    assert [b.time_s for b in made.boundaries] == [b.time_s for b in found.boundaries]
    assert made.inapplicable == ()


def test_nothing_taught_is_refused(second: Demonstration) -> None:
    with pytest.raises(LabelingError, match="finished recordings to learn from"):
        propose([], second)


def test_one_taught_recording_has_no_usual_cost(first: Taught) -> None:
    assert usual_cost_of([first]) is None
    assert usual_cost_of([first, first]) == pytest.approx(0.0, abs=1e-6)


def in_frame(shown: Demonstration, matrix: np.ndarray) -> Demonstration:
    """The same by a robot whose base stands otherwise, or in a mirror."""
    assert shown.orientation_wxyz is not None
    assert shown.force_N is not None
    own = Rotation.from_quat(shown.orientation_wxyz, scalar_first=True).as_matrix()
    mirrored = matrix @ own @ np.diag([1.0, 1.0, np.linalg.det(matrix)])
    return replace(
        shown,
        position_m=shown.position_m @ matrix.T,
        orientation_wxyz=Rotation.from_matrix(mirrored).as_quat(scalar_first=True),
        force_N=shown.force_N @ matrix.T,
    )


@pytest.mark.parametrize("turned_rad", [0.7, 3.0])
def test_a_recording_that_stands_turned_to_the_robot_is_turned_back(
    shown: Demonstration, first: Taught, turned_rad: float
) -> None:
    turned = in_frame(shown, Rotation.from_rotvec([0.0, 0.0, turned_rad]).as_matrix())
    alignment = align(first.signals, signals_of(turned))
    assert alignment.standing.turned_rad == pytest.approx(-turned_rad, abs=0.02)
    assert alignment.cost < 0.1


@pytest.mark.parametrize(
    "matrix",
    [np.diag([1.0, -1.0, -1.0]), np.roll(np.eye(3), 1, axis=0), np.diag([1.0, 1.0, -1.0])],
    ids=["hangs upside down", "stands at a wall", "mirror image"],
)
def test_what_was_taught_arrives_by_a_robot_in_any_other_place(
    first: Taught, second: Demonstration, matrix: np.ndarray
) -> None:
    other = in_frame(second, matrix)
    found = propose([first], other, segment(other))
    assert [phase.name for phase in found.phases] == list(NAMES)


def test_a_recording_that_began_at_another_place_is_moved_back(
    shown: Demonstration, first: Taught
) -> None:
    # The tool comes within a second from 0.2 m aside of where the finished one begins.
    aside = np.clip(1.0 - (shown.time_s - shown.start_s), 0.0, None)[:, None] * [0.2, 0.0, 0.0]
    alignment = align(
        first.signals, signals_of(replace(shown, position_m=shown.position_m + aside))
    )
    assert alignment.standing.moved[0] > 0.5
    assert alignment.cost < 0.3


def test_a_long_rest_moves_what_comes_after_it_and_nothing_else(
    shown: Demonstration, first: Taught
) -> None:
    # It waits for eight seconds where it waits for one, between the first and the second phase.
    at = int(np.searchsorted(shown.time_s, first.ends_s[0] + 0.4))
    index = np.concatenate([np.arange(at), np.full(2000, at), np.arange(at, len(shown.time_s))])
    time_s = shown.start_s + 0.004 * np.arange(len(index))
    rested = replace(
        shown,
        time_s=time_s,
        position_m=shown.position_m[index],
        orientation_wxyz=None,
        force_N=None,
        torque_Nm=None,
        joints_rad=None,
    )
    alignment = align(first.signals, signals_of(rested))
    expected = [first.ends_s[0], *(end_s + 8.0 for end_s in first.ends_s[1:])]
    np.testing.assert_allclose([alignment.at(t) for t in first.ends_s], expected, atol=0.1)
    assert alignment.tempo == pytest.approx(1.0, abs=0.1)


def test_a_recording_without_one_of_the_phases_differs_what_is_called_so(
    second: Demonstration, first: Taught
) -> None:
    """The way down into the contact is left out; what follows begins where it did."""
    own = segment(second).boundaries
    first_row, last_row = np.searchsorted(second.time_s, [own[0].time_s, own[2].time_s])
    gone = second.position_m[last_row] - second.position_m[first_row]

    def without(values: np.ndarray, moved: np.ndarray | float = 0.0) -> np.ndarray:
        return np.concatenate([values[:first_row], values[last_row:] - moved])

    assert second.force_N is not None
    short = Demonstration(
        "short",
        without(second.time_s, second.time_s[last_row] - second.time_s[first_row]),
        without(second.position_m, gone),
        force_N=without(second.force_N),
    )
    found = propose([first], short, segment(short))
    assert found.differs is not None
    assert not found.outlier
    assert propose(first, second, segment(second)).differs is None


def test_a_name_is_unsure_where_its_phase_is_not_there(shown: Demonstration, first: Taught) -> None:
    until = int(np.searchsorted(shown.time_s, first.ends_s[-1]))
    stopped = replace(
        shown,
        time_s=shown.time_s[:until],
        position_m=shown.position_m[:until],
        orientation_wxyz=None,
        force_N=None,
        torque_Nm=None,
        joints_rad=None,
    )
    named_as = {one.name: one.confidence for one in propose([first], stopped).phases}
    assert named_as.pop(NAMES[-1], 0.0) < 0.85
    assert named_as[NAMES[0]] > 0.95


def test_a_boundary_keeps_its_distance_from_the_evidence_it_belongs_to(
    first: Taught, second: Demonstration
) -> None:
    own = segment(second)
    early = tuple(
        replace(phase, start_s=phase.start_s - 0.15 * (i > 0), end_s=phase.end_s - 0.15)
        for i, phase in enumerate(first.phases)
    )
    found = propose([replace(first, phases=early)], second, own)
    expected = [boundary.time_s - 0.15 for boundary in own.boundaries]
    np.testing.assert_allclose([b.time_s for b in found.boundaries], expected, atol=0.1)


def test_a_boundary_belongs_to_what_is_near_rather_than_to_what_is_likely() -> None:
    near, likely = Place(1.02, "contact", 0.3), Place(1.12, "motion", 0.9)
    assert Places((near, likely)).of(1.0) == near
    assert Places((near, likely)).of(2.0) is None


def test_of_evidence_that_is_not_near_a_boundary_belongs_to_the_likelier() -> None:
    unlikely, likely = Place(1.2, "contact", 0.15), Place(1.3, "motion", 0.9)
    assert Places((unlikely, likely)).of(1.0) == likely


def test_of_three_one_that_was_marked_elsewhere_decides_nothing(
    first: Taught, second: Demonstration
) -> None:
    own = segment(second)
    late = tuple(
        replace(phase, start_s=phase.start_s + 0.3 * (i > 0), end_s=phase.end_s + 0.3)
        for i, phase in enumerate(first.phases)
    )
    other = replace(first, phases=late, found_s=())
    found = propose([first, other, first], second, own)
    alone = propose([first], second, own)
    at = [b.time_s for b in found.boundaries]
    np.testing.assert_allclose(at, [b.time_s for b in alone.boundaries], atol=0.02)


def _better(
    teachers: list[Teacher], proposed: Sequence[ProposedBoundary], own: Segmentation
) -> bool:
    """Where all that were aligned fit well."""
    return own_where_better(teachers, teachers, proposed, own) is not None


def test_a_program_of_which_three_of_four_were_kept_is_not_believed_yet(
    first: Taught, second: Demonstration
) -> None:
    own = segment(second)
    proposed = propose([first], second).boundaries
    ends = first.ends_s
    three = replace(first, found_s=(*ends[:-1], ends[-1] + 0.3))
    assert len(ends) == 4
    assert not _better([teacher(three, second)], proposed, own)


def test_a_program_of_which_two_of_three_were_right_is_not_believed_however_many_there_were(
    first: Taught, second: Demonstration
) -> None:
    own = segment(second)
    proposed = propose([first], second).boundaries
    wrong = tuple(end_s + 0.4 for end_s in first.ends_s[-2:])
    half = teacher(replace(first, found_s=(*first.ends_s, *wrong)), second)
    assert first.agreement == (4, 4)
    assert half.taught.agreement == (4, 4)
    assert not _better([half] * 6, proposed, own)


def test_a_brief_phase_tells_nothing_by_how_well_it_fits() -> None:
    long = ProposedPhase(0.0, 2.0, "long", True, 0.5)
    brief = replace(long, brief=True)
    told = [Transfer("a", (), (phase,), False, 0.1, ("b",)).differs for phase in (long, brief)]
    assert [one is None for one in told] == [False, True]


def test_a_little_early_in_a_fast_recording_is_early_in_a_slow_one(
    first: Taught, second: Demonstration
) -> None:
    slower = segment(replace(second, time_s=3.0 * second.time_s))
    proposed = propose([first], slower.demonstration).boundaries
    own = replace(slower, boundaries=slower.boundaries[: len(proposed)])
    early = replace(first, found_s=tuple(end_s + 0.05 for end_s in first.ends_s))
    assert len(own.boundaries) == len(proposed)
    assert not _better([teacher(early, slower.demonstration)], proposed, own)


def test_what_is_done_without_a_gripper_is_another_task(
    first: Taught, second: Demonstration
) -> None:
    opening = np.clip(2.0 * np.sin(second.time_s), 0.0, 1.0)
    gripping = replace(second, gripper=opening)
    assert not propose([first], second).outlier
    assert propose([first], gripping).cost > 1.5 * propose([first], second).cost


def test_the_program_is_believed_where_persons_left_its_boundaries_where_they_were(
    first: Taught, second: Demonstration
) -> None:
    own = segment(second)
    proposed = propose([first], second).boundaries
    kept = replace(first, found_s=first.ends_s)
    elsewhere = replace(first, found_s=tuple(end_s + 0.5 for end_s in first.ends_s))
    early = replace(first, found_s=tuple(end_s + 0.15 for end_s in first.ends_s))
    assert _better([teacher(kept, second)], proposed, own)
    assert not _better([teacher(elsewhere, second)], proposed, own)
    assert not _better([teacher(early, second)], proposed, own)


def test_one_who_marks_without_care_is_no_sign_that_elsewhere_is_meant(
    first: Taught, second: Demonstration
) -> None:
    own = segment(second)
    proposed = propose([first], second).boundaries
    kept = teacher(replace(first, found_s=first.ends_s), second)
    careless = teacher(replace(first, found_s=tuple(t + 0.15 for t in first.ends_s)), second)
    assert own_where_better([careless], [careless], proposed, own) is None
    assert own_where_better([careless], [careless, kept, kept], proposed, own) is not None


def test_a_program_that_is_unsure_of_what_it_finds_is_not_believed(
    first: Taught, second: Demonstration
) -> None:
    own = segment(second)
    proposed = propose([first], second).boundaries
    kept = teacher(replace(first, found_s=first.ends_s), second)
    unsure = tuple(replace(boundary, confidence=0.8) for boundary in own.boundaries)
    assert _better([kept], proposed, own)
    assert not _better([kept], proposed, replace(own, boundaries=unsure))


def test_where_a_recording_fits_well_the_program_must_find_all_that_is_proposed(
    first: Taught, second: Demonstration
) -> None:
    """Unless the finished recordings differ in their phases: then this one may, too."""
    own = segment(second)
    sure = tuple(replace(boundary, confidence=0.97) for boundary in own.boundaries)
    own = replace(own, boundaries=sure, candidates=())
    fewer = replace(own, boundaries=sure[1:])
    proposed = propose([first], second).boundaries
    kept = replace(first, found_s=first.ends_s)
    other = replace(kept, phases=tuple(replace(one, name=f"{one.name} 2") for one in kept.phases))
    well = replace(teacher(kept, second).alignment, cost=0.2)
    same, another = Teacher(kept, well), Teacher(other, well)
    assert not _better([same], proposed, fewer)
    assert _better([same, another], proposed, fewer)
    assert _better([same], proposed[1:], own)
    assert _better([replace(same, alignment=replace(well, cost=0.3))], proposed, fewer)


def test_another_number_than_proposed_is_not_believed_where_persons_mean_places_far_away(
    first: Taught, second: Demonstration
) -> None:
    own = segment(second)
    more = propose([first], second).boundaries[1:]
    early, far = (
        teacher(replace(first, found_s=tuple(end_s + away_s for end_s in first.ends_s)), second)
        for away_s in (0.1, 0.15)
    )
    assert _better([early], more, own)
    assert not _better([far], more, own)


def test_a_boundary_is_moved_where_all_moved_it_to_one_side(
    first: Taught, second: Demonstration
) -> None:
    own = segment(second)
    early, late = (
        teacher(replace(first, found_s=tuple(end_s + away_s for end_s in first.ends_s)), second)
        for away_s in (0.1, -0.06)
    )
    moved = [
        float(np.mean([one.time_s for one in with_own(both, (), own)]))
        - float(np.mean([one.time_s for one in own.boundaries]))
        for both in ([early, early], [early, late])
    ]
    assert moved == [pytest.approx(-0.033, abs=0.015), 0.0]
