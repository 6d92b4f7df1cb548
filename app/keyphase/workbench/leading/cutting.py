"""A recording without its ends, as a recording of its own; what was recorded stays as it is."""

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from keyphase.demonstration import Demonstration
from keyphase.errors import RequestError, SimulationError
from keyphase.files.parts import stem_of
from keyphase.readers import save_npz
from keyphase.workbench.exporting.beside import Beside

MIN_SAMPLES = 10


def cut(demonstration: Demonstration, from_s: float, to_s: float) -> Demonstration:
    """What was recorded from `from_s` to `to_s`, at the times at which it was.

    Raises RequestError where that leaves next to nothing, or all of it.
    """
    inside = (demonstration.time_s >= from_s) & (demonstration.time_s <= to_s)
    count = int(inside.sum())
    if count < MIN_SAMPLES or count == len(demonstration):
        raise RequestError(
            f"A cut must leave at least {MIN_SAMPLES} samples and take some away, but leaves "
            f"{count} of {len(demonstration)}; zoom to what is to stay."
        )
    names = ("position_m", "orientation_wxyz", "force_N", "torque_Nm", "joints_rad", "gripper")
    kept: dict[str, Any] = {name: _part(getattr(demonstration, name), inside) for name in names}
    time_s = demonstration.time_s[inside]
    kept["channels"] = {name: values[inside] for name, values in demonstration.channels.items()}
    events = tuple(one for one in demonstration.events if from_s <= one.time_s <= to_s)
    return replace(demonstration, time_s=time_s, source=None, notices=(), events=events, **kept)


def write_cut(demonstration: Demonstration, recording: Path, from_s: float, to_s: float) -> Path:
    """Write it beside the recording as `NAME_cut_01.npz`, or the next that is free; its path.

    Raises RequestError as `cut` does, SimulationError where the folder takes no files.
    """
    made = cut(demonstration, from_s, to_s)
    number = 1
    while (path := Beside(recording).folder / _name(recording, number)).exists():
        number += 1
    try:
        save_npz(made, path)
    except OSError as error:
        raise SimulationError(
            f"{path} must be writable, but is not ({error.strerror}); check the folder."
        ) from error
    return path


def _name(recording: Path, number: int) -> str:
    return f"{stem_of(recording)}_cut_{number:02d}.npz"


def _part(values: np.ndarray | None, inside: np.ndarray) -> np.ndarray | None:
    return None if values is None else values[inside]
