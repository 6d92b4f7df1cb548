"""Record a demonstration: a scripted operator leads the robot through a workcell's task."""

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from keyphase.demonstration import Demonstration
from keyphase.errors import SimulationError
from keyphase.simulation.demonstrating.hand_path import UNTIL_CONTACT, HandPath
from keyphase.simulation.demonstrating.operator import hand_path
from keyphase.simulation.disturbance import NOMINAL, Disturbance
from keyphase.simulation.impedance import Reference
from keyphase.simulation.samples import (
    ONSET_FORCE_N,
    as_demonstration,
    ground_truth,
    provenance,
)
from keyphase.simulation.simulation import Sample, Simulation
from keyphase.simulation.workcells.course import Course
from keyphase.simulation.workcells.registry import workcell
from keyphase.simulation.workcells.workcell import Workcell

_SETTLING_TICKS = 200
_START_SPREAD_M = 0.008
_AFTER_LAST_CONTACT_S = 0.09


def record(
    cell: str | Workcell, seed: int = 0, disturbance: Disturbance = NOMINAL
) -> Demonstration:
    """A demonstration of the workcell's task, led by a scripted operator.

    The same arguments give the same demonstration, to the bit. Its metadata hold the simulator's
    contact onsets and the operator's intentions as ground truth; its channels do not.

    Raises SimulationError for an unknown workcell, and when the task was not accomplished.
    """
    cell = workcell(cell) if isinstance(cell, str) else cell
    hand_seed, sensor_seed = np.random.SeedSequence(seed).generate_state(2)
    random = np.random.default_rng(hand_seed)
    simulation = cell.build(disturbance, seed=int(sensor_seed))
    path = hand_path(simulation, settle(simulation, random), random)
    course = Course(cell)
    samples = lead(simulation, path, course)
    _refuse_unless_done(course.checks(simulation), cell.name, seed)
    return as_demonstration(samples, cell.name, _metadata(simulation, samples, path, seed))


def settle(simulation: Simulation, random: np.random.Generator) -> Reference:
    """Bring the tool to rest near its start; nobody starts twice from the same place."""
    home = simulation.here()
    spread = random.uniform(-_START_SPREAD_M, _START_SPREAD_M, 3)
    start = Reference(home.position_m + spread, home.orientation_wxyz)
    for _ in range(_SETTLING_TICKS):
        simulation.step(start)
    return start


def lead(simulation: Simulation, path: HandPath, course: Course) -> list[Sample]:
    """Lead the tool along a hand's path; a task that ends at a contact is over soon after it."""
    last = simulation.contacts.names.index(simulation.workcell.onsets[-1])
    samples: list[Sample] = []
    end_s = np.inf
    for reference in path.references():
        sample = simulation.step(reference)
        course.watch(simulation)
        samples.append(sample)
        if simulation.workcell.ends_at_contact and sample.contact_N[last] > ONSET_FORCE_N:
            end_s = min(end_s, sample.time_s + _AFTER_LAST_CONTACT_S)
        if sample.time_s >= end_s:
            break
    return samples


def _refuse_unless_done(checks: Mapping[str, bool], name: str, seed: int) -> None:
    failed = [goal for goal, holds in checks.items() if not holds]
    if failed:
        raise SimulationError(
            f"The scripted operator must accomplish {name}, but with seed "
            f"{seed} and this disturbance it ended without: {', '.join(failed)}; try another seed "
            "or a smaller disturbance."
        )


def _metadata(
    simulation: Simulation, samples: Sequence[Sample], path: HandPath, seed: int
) -> dict[str, Any]:
    origin = provenance(simulation, "scripted") | {"seed": seed}
    truth = ground_truth(samples, origin)
    duration_s = samples[-1].time_s - samples[0].time_s
    phases = _phases(path, truth["contact_changes_s"], duration_s)
    return origin | {"ground_truth": truth | {"phases": phases}}


def _phases(path: HandPath, changes_s: Sequence[float], end_s: float) -> list[dict[str, Any]]:
    """What the operator did, in the order it was done.

    A phase lasts until the contact change it was waiting for, others until the next begins.
    """
    contact = iter(changes_s)
    phases: list[dict[str, Any]] = []
    start_s = 0.0
    followers = [*(phase.start_s for phase in path.phases[1:]), end_s]
    for phase, next_s in zip(path.phases, followers, strict=True):
        ends_s = next(contact) if phase.name.endswith(UNTIL_CONTACT) else next_s
        phases.append({"name": phase.name, "start_s": start_s, "end_s": round(ends_s, 9)})
        start_s = round(ends_s, 9)
    phases[-1]["end_s"] = round(end_s, 9)
    return phases
