"""A recording whose phases are missing, done again or in another order is told apart, and how."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from keyphase.demonstration import Demonstration
from keyphase.labeling.label import label
from keyphase.labeling.tasks.task import TaskPhase
from keyphase.segmentation import segment
from keyphase.simulation import record
from keyphase.transfer.alignment import align
from keyphase.transfer.phase_order import how_it_differs
from keyphase.transfer.proposing import propose
from keyphase.transfer.signals import signals_of
from keyphase.transfer.taught import Taught, taught_by

NAMES = ("reach", "wait", "lower", "settle", "slide")
IN_ORDER = tuple(range(len(NAMES)))


@pytest.fixture(scope="module")
def first() -> Taught:
    found = taught_by(label(segment(record("setup1", seed=0))))
    named = zip(found.phases, NAMES, strict=True)
    return replace(found, phases=tuple(replace(phase, name=name) for phase, name in named))


@pytest.fixture(scope="module")
def second() -> Demonstration:
    return record("setup1", seed=3)


def done(demonstration: Demonstration, order: Sequence[int]) -> Demonstration:
    """With its phases in this order, each from where the one before ended."""
    ends = [boundary.time_s for boundary in segment(demonstration).boundaries]
    rows = np.searchsorted(demonstration.time_s, [0.0, *ends, np.inf])
    position, force = demonstration.position_m, demonstration.force_N
    assert force is not None
    places, forces = [position[:1]], [force[:1]]
    for number in order:
        piece = slice(rows[number], rows[number + 1])
        places.append(position[piece] - position[rows[number]] + places[-1][-1])
        forces.append(force[piece])
    count = sum(map(len, places))
    time_s = demonstration.time_s
    step_s = (time_s[-1] - time_s[0]) / (len(time_s) - 1)
    return Demonstration(
        "otherwise", step_s * np.arange(count), np.vstack(places), force_N=np.vstack(forces)
    )


@pytest.mark.parametrize(
    ("order", "told", "at"),
    [
        (IN_ORDER, None, None),
        ((0, 1, 2, 3), "'slide' is missing", "settle"),
        ((1, 2, 3, 4), "'reach' is missing", "wait"),
        ((0, 1, 2, 3, 4, 2, 3, 4), "'lower', 'settle', 'slide' are done again", "lower"),
        ((0, 1, 4, 2, 3), "'slide' comes before 'lower'", "slide"),
    ],
)
def test_what_is_other_is_told_and_named_in_its_order(
    first: Taught, second: Demonstration, order: Sequence[int], told: str | None, at: str | None
) -> None:
    recording = done(second, order)
    found = propose([first], recording, segment(recording))
    assert not found.outlier
    assert (found.differs and (found.differs.told, found.differs.at)) == (told and (told, at))
    assert [phase.name for phase in found.phases] == [NAMES[number] for number in order]


def test_what_the_task_lets_be_missing_or_come_again_is_no_difference(
    first: Taught, second: Demonstration
) -> None:
    phases = [
        TaskPhase("slide", "#808080", "contact", optional=True),
        TaskPhase("lower", "#808080", "contact", repeated=True),
        TaskPhase("settle", "#808080", "contact", repeated=True),
    ]
    for order in ((0, 1, 2, 3), (0, 1, 2, 3, 2, 3, 4)):
        recording = done(second, order)
        own = segment(recording)
        assert propose([first], recording, own).differs is not None
        found = propose([first], recording, own, phases=phases)
        assert found.differs is None
        assert [phase.name for phase in found.phases] == [NAMES[number] for number in order]


def test_in_another_order_its_samples_stay_as_far_apart(first: Taught) -> None:
    """The clock of the signals is that of its smallest step."""
    step_s = first.signals.step_s
    for order in ((1, 2, 3, 4), (0, 1, 2, 3, 2, 3, 4), (4, 0)):
        other = first.in_order(order)
        assert other.signals.step_s == pytest.approx(step_s)
        assert [phase.name for phase in other.phases] == [NAMES[number] for number in order]
        ends = [phase.start_s for phase in other.phases[1:]]
        assert ends == [phase.end_s for phase in other.phases[:-1]]


def test_a_rest_within_a_phase_is_no_other_phase(first: Taught, second: Demonstration) -> None:
    middle = int(np.searchsorted(second.time_s, 0.6 * segment(second).boundaries[0].time_s))
    step_s = (second.time_s[-1] - second.time_s[0]) / (len(second.time_s) - 1)
    held = round(5.0 / step_s)
    force = second.force_N
    assert force is not None
    noise = np.random.default_rng(0).normal(0.0, 0.05, (held, 3))
    rested = Demonstration(
        "rested",
        step_s * np.arange(len(second.time_s) + held),
        np.insert(second.position_m, [middle] * held, second.position_m[middle], axis=0),
        force_N=np.insert(force, [middle] * held, force[middle] + noise, axis=0),
    )
    assert propose([first], rested, segment(rested)).differs is None


def test_what_the_other_hand_does_goes_the_other_way_and_is_no_other_phase(
    first: Taught, second: Demonstration
) -> None:
    aside = np.array([1.0, -1.0, 1.0])
    force = second.force_N
    assert force is not None
    mirrored = Demonstration(
        "mirrored", second.time_s, second.position_m * aside, force_N=force * aside
    )
    assert propose([first], mirrored, segment(mirrored)).differs is None


def test_a_force_of_the_other_sign_fits_as_well(first: Taught, second: Demonstration) -> None:
    force = second.force_N
    assert force is not None
    reacting = replace(second, force_N=-force, torque_Nm=None)
    as_it_is = align(first.signals, signals_of(replace(second, torque_Nm=None)))
    other = align(first.signals, signals_of(reacting))
    assert (as_it_is.standing.pushed, other.standing.pushed) == (1.0, -1.0)
    assert other.cost == pytest.approx(as_it_is.cost, rel=0.3)


@given(st.lists(st.sampled_from(IN_ORDER), min_size=1, max_size=8))
def test_only_the_order_that_was_taught_is_no_difference(order: list[int]) -> None:
    steps = [a for a, b in zip(order, [*order[1:], None], strict=True) if a != b]
    differs = how_it_differs(order, NAMES)
    assert (differs is None) == (tuple(order) == IN_ORDER)
    assert differs is None or differs.at in {NAMES[number] for number in steps}
