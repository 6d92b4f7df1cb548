# MuJoCo tells no types.
# pyright: reportAttributeAccessIssue=false
"""Record a demonstration: a scripted operator leads the robot through a workcell's task."""

from collections.abc import Mapping, Sequence
from typing import Any

import mujoco
import numpy as np

from keyphase import __version__
from keyphase.demonstration import Demonstration
from keyphase.errors import SimulationError
from keyphase.simulation.disturbance import NOMINAL, Disturbance
from keyphase.simulation.hand_path import HandPath
from keyphase.simulation.impedance import Reference
from keyphase.simulation.operator import hand_path
from keyphase.simulation.robot_scene import ARM_JOINTS
from keyphase.simulation.simulation import Sample, Simulation
from keyphase.simulation.workcell import Workcell, workcell

ONSET_FORCE_N = 0.2
"""Normal force from which two parts count as touching, in the simulator's own view."""

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
    path = hand_path(simulation, _settled(simulation, random), random)
    samples = _led(simulation, path)
    _refuse_unless_done(simulation, seed)
    return as_demonstration(
        samples, f"{cell.name}", _metadata(simulation, samples, path, seed, disturbance)
    )


def as_demonstration(
    samples: Sequence[Sample], name: str, metadata: Mapping[str, Any]
) -> Demonstration:
    """The samples of one recording, time counted from its first one."""

    def column(channel: str) -> np.ndarray:
        return np.array([getattr(sample, channel) for sample in samples])

    time = column("time_s")
    return Demonstration(
        name=name,
        # Rounded to whole nanoseconds, so that equal steps are written equal.
        time_s=np.round(time - time[0], 9),
        position_m=column("position_m"),
        orientation_wxyz=column("orientation_wxyz"),
        force_N=column("force_N"),
        torque_Nm=column("torque_Nm"),
        joints_rad=column("joints_rad"),
        metadata=metadata,
    )


def onsets_s(samples: Sequence[Sample], names: Sequence[str]) -> dict[str, float]:
    """First time, from the recording's start, at which each pair of parts touched."""
    force = np.array([sample.contact_N for sample in samples])
    touching = force > ONSET_FORCE_N
    start = samples[0].time_s
    return {
        name: round(samples[int(np.argmax(touching[:, index]))].time_s - start, 9)
        for index, name in enumerate(names)
        if touching[:, index].any()
    }


def _settled(simulation: Simulation, random: np.random.Generator) -> Reference:
    """Start pose: near the nominal one, and at rest."""
    home = simulation.here()
    spread = random.uniform(-_START_SPREAD_M, _START_SPREAD_M, 3)
    start = Reference(home.position_m + spread, home.orientation_wxyz)
    for _ in range(_SETTLING_TICKS):
        simulation.step(start)
    return start


def _led(simulation: Simulation, path: HandPath) -> list[Sample]:
    last = simulation.contacts.names.index(simulation.workcell.onsets[-1])
    samples: list[Sample] = []
    end_s = np.inf
    for reference in path.references():
        sample = simulation.step(reference)
        samples.append(sample)
        if simulation.workcell.ends_at_contact and sample.contact_N[last] > ONSET_FORCE_N:
            end_s = min(end_s, sample.time_s + _AFTER_LAST_CONTACT_S)
        if sample.time_s >= end_s:
            break
    return samples


def _refuse_unless_done(simulation: Simulation, seed: int) -> None:
    failed = [name for name, holds in simulation.workcell.checks(simulation).items() if not holds]
    if failed:
        raise SimulationError(
            f"The scripted operator must accomplish {simulation.workcell.name}, but with seed "
            f"{seed} and this disturbance it ended without: {', '.join(failed)}; try another seed "
            "or a smaller disturbance."
        )


def _metadata(
    simulation: Simulation,
    samples: Sequence[Sample],
    path: HandPath,
    seed: int,
    disturbance: Disturbance,
) -> dict[str, Any]:
    cell = simulation.workcell
    contacts = onsets_s(samples, simulation.contacts.names)
    return {
        "recorder": f"keyphase {__version__}",
        "simulator": f"MuJoCo {mujoco.__version__}",
        "operator": "scripted",
        "workcell": cell.name,
        "seed": seed,
        "disturbance": disturbance.as_json(),
        "joint_names": list(ARM_JOINTS),
        "ground_truth": {
            "contact_onsets_s": contacts,
            "contact_changes_s": [contacts[name] for name in cell.onsets],
            "phases": _phases(path, samples[-1].time_s - samples[0].time_s),
        },
    }


def _phases(path: HandPath, end_s: float) -> list[dict[str, Any]]:
    """What the operator did, each phase up to the start of the next or the contact that ended it.

    Pauses without a name are the hand's own and belong to the phase before.
    """
    named = [phase for phase in path.phases if phase.name and phase.start_s < end_s]
    return [
        {"name": phase.name, "start_s": round(phase.start_s, 9), "end_s": round(later, 9)}
        for phase, later in zip(named, [*(p.start_s for p in named[1:]), end_s], strict=True)
    ]
