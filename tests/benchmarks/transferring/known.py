"""Recordings of one task whose phases are known: simulated ones, and sets of real ones.

Simulated ones differ in everything an operator and a place differ in: who leads, how fast (a tempo
of 0.6 to 1.6), where the parts lie (up to 15 mm aside, 20 mm higher or lower), and how the whole
stands to the robot (turned by up to 40 degrees, half a metre away).
"""

import json
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from scipy.spatial.transform import Rotation

from keyphase import read
from keyphase.demonstration import Demonstration
from keyphase.errors import SimulationError
from keyphase.making import Event
from keyphase.simulation import record
from keyphase.simulation.disturbance import Disturbance
from keyphase.simulation.making.simulated import make_simulated

WORKCELLS = ("setup1", "setup2")
GRIPPER = "simulated-pick-and-place"

SIMULATED_TOLERANCE_S = 0.2
LEAST_OF_ONE_TASK = 4


@dataclass(frozen=True, eq=False)
class Known:
    """A recording, where its phases end (K - 1,), what they are called (K,), and how it is judged.

    named     False where the reference has boundaries only
    ignore_s  stretches in which a boundary too many counts neither way
    """

    demonstration: Demonstration
    ends_s: tuple[float, ...]
    names: tuple[str, ...]
    tolerance_s: float
    named: bool = True
    ignore_s: tuple[tuple[float, float], ...] = ()


@dataclass(frozen=True, eq=False)
class Made:
    """A simulated recording as plain values, to be kept on disk: its channels, ends and names."""

    channels: dict[str, np.ndarray]
    ends_s: tuple[float, ...]
    names: tuple[str, ...]


def made(task: str, seed: int) -> Made | None:
    """One recording of a simulated task; None where it failed or the part slipped."""
    return _picked(seed) if task == GRIPPER else _led(task, seed)


def simulated(task: str, seed: int, made: Made) -> Known:
    """A made recording by a faster or slower operator, at another place."""
    channels = dict(made.channels)
    rng = np.random.default_rng([11, seed])
    tempo = float(np.exp(rng.uniform(np.log(0.6), np.log(1.6))))
    turn = Rotation.from_rotvec([0.0, 0.0, np.deg2rad(rng.uniform(-40.0, 40.0))])
    away = rng.uniform(-0.5, 0.5, 3)
    channels["time_s"] = channels["time_s"] * tempo
    for name in ("position_m", "force_N", "torque_Nm"):
        channels[name] = channels[name] @ turn.as_matrix().T
    channels["position_m"] = channels["position_m"] + away
    own = Rotation.from_quat(channels["orientation_wxyz"], scalar_first=True)
    channels["orientation_wxyz"] = (turn * own).as_quat(scalar_first=True)
    demonstration = Demonstration(f"{task}_{seed}", **channels)
    ends = tuple(tempo * end for end in made.ends_s)
    return Known(demonstration, ends, made.names, SIMULATED_TOLERANCE_S)


def real_sets(folder: Path) -> dict[str, list[Known]]:
    """The sets of real recordings with labelled events and enough recordings of one task."""
    truth = json.loads((folder / "truth.json").read_text())
    sets: dict[str, list[Known]] = {}
    for key, entry in truth.items():
        name, _, file = key.partition("/")
        subject = file.partition("_")[0]
        task = f"{name}/{subject}" if subject.startswith("subject") else name
        if entry["events"]:
            sets.setdefault(task, []).append(_real(folder / f"{key}.npz", entry))
    return {task: known for task, known in sets.items() if len(known) >= LEAST_OF_ONE_TASK}


def _led(task: str, seed: int) -> Made | None:
    rng = np.random.default_rng([7, seed])
    disturbance = Disturbance(
        part_height_m=float(rng.uniform(-0.02, 0.02)),
        part_offset_m=(float(rng.uniform(-0.015, 0.015)), float(rng.uniform(-0.015, 0.015))),
        friction=float(rng.uniform(0.2, 0.4)),
    )
    try:
        demonstration = record(task, seed, disturbance)
    except SimulationError:
        return None
    phases = demonstration.metadata["ground_truth"]["phases"]
    ends = tuple(phase["end_s"] for phase in phases[:-1])
    return Made(_channels(demonstration), ends, _numbered(phase["name"] for phase in phases))


def _picked(seed: int) -> Made | None:
    found = make_simulated(GRIPPER, seed)
    if [event.label for event in found.gripped] != ["grasp", "release"]:
        return None
    grasp, release = (event.time_s for event in found.gripped)
    between = [
        e.time_s for e in _contacts(found.events) if grasp + 0.05 < e.time_s < release - 0.05
    ]
    if len(between) != 2:
        return None
    names = ("reach", "hold", "carry", "set down", "leave")
    return Made(_channels(found.demonstration), (grasp, *between, release), names)


def _contacts(events: Iterable[Event]) -> Iterator[Event]:
    return (event for event in events if event.kind == "contact")


def _channels(demonstration: Demonstration) -> dict[str, np.ndarray]:
    names = ("time_s", "position_m", "orientation_wxyz", "force_N", "torque_Nm", "gripper")
    values = {name: getattr(demonstration, name) for name in names}
    return {name: np.array(value) for name, value in values.items() if value is not None}


def _real(path: Path, entry: dict) -> Known:
    ends = tuple(time for time, _ in entry["events"])
    labels = [label for _, label in entry["events"]]
    named = len(set(labels)) == len(labels)
    names = ("approach", *labels) if named else tuple(f"{n}" for n in range(len(ends) + 1))
    ignored = tuple((low, high) for low, high in entry["ignore"])
    return Known(read(path), ends, names, entry["tolerance_s"], named, ignored)


def _numbered(names: Iterable[str]) -> tuple[str, ...]:
    """Phases of the same name told apart, as a person would."""
    found: list[str] = []
    for name in names:
        count = sum(each.split(" #")[0] == name for each in found)
        found.append(f"{name} #{count + 1}" if count else name)
    return tuple(found)
