"""Writes a recording down while it is made, so that a crash loses at most its last second.

A take is a file that only grows: a line of JSON, then chunks of rows, each with its own check sum
and on the disk before the next begins. Finished, it becomes an ordinary NPZ recording.
"""

import fcntl
import json
import os
import struct
import zlib
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, BinaryIO

import numpy as np

from keyphase.demonstration import Array, Demonstration
from keyphase.errors import SimulationError
from keyphase.readers import save_npz
from keyphase.simulation.impedance import RATE_HZ
from keyphase.simulation.samples import as_demonstration, ground_truth
from keyphase.simulation.simulation import Sample

TAKE_SUFFIX = ".take"
MAX_UNWRITTEN_S = 0.5

_FORMAT = "keyphase take 1"
_CHUNK = struct.Struct("<4sII")
_CHUNK_MAGIC = b"rows"
_CHANNELS = ("time_s", "position_m", "orientation_wxyz", "force_N", "torque_Nm", "joints_rad")
_WIDTHS = (1, 3, 4, 3, 3, 7)


class Recorder:
    """Appends samples to a take beside `path`, and finishes it into the recording at `path`."""

    def __init__(
        self, path: Path, origin: Mapping[str, Any], unwritten_s: float = MAX_UNWRITTEN_S
    ) -> None:
        """Open a take with its provenance; `unwritten_s` is the most that is not on the disk yet.

        Raises SimulationError where the recording or a take of it exists, or nothing can be
        written.
        """
        self.path, self.take = path, take_of(path)
        if path.exists():
            raise SimulationError(f"{path} must be a new recording, but exists; choose a new name.")
        self._samples: list[Sample] = []
        self._written, self._most_unwritten = 0, max(1, round(unwritten_s * RATE_HZ))
        self._origin = dict(origin)
        self._file = _opened(self.take)
        header = json.dumps({"format": _FORMAT, "origin": self._origin})
        self._put(header.encode() + b"\n")

    @property
    def duration_s(self) -> float:
        """How much has been recorded."""
        return len(self._samples) / RATE_HZ

    def append(self, sample: Sample) -> None:
        """Take one sample; what has come in goes to the disk from time to time."""
        self._samples.append(sample)
        if len(self._samples) - self._written >= self._most_unwritten:
            self._write_down()

    def finish(self) -> Demonstration:
        """Put the recording at `path` as a whole, then drop the take.

        Raises SimulationError if fewer than two samples came.
        """
        self._write_down()
        demonstration = _demonstration(self._samples, self._origin, self.path)
        save_npz(demonstration, self.path)
        self.discard()
        return demonstration

    def discard(self) -> None:
        """Drop the take, without a recording."""
        self._file.close()
        self.take.unlink(missing_ok=True)

    def _write_down(self) -> None:
        unwritten = self._samples[self._written :]
        if unwritten:
            rows = np.array([_row(sample) for sample in unwritten])
            self._put(_chunk(rows))
            self._written = len(self._samples)

    def _put(self, data: bytes) -> None:
        self._file.write(data)
        self._file.flush()
        os.fsync(self._file.fileno())


@dataclass(frozen=True)
class Recovered:
    """A recording brought back from a take: where it is now and how long it is."""

    path: Path
    duration_s: float


def take_of(path: Path) -> Path:
    """The take a recording at `path` grows in."""
    return path.with_name(path.name + TAKE_SUFFIX)


def recover(folder: Path) -> tuple[Recovered, ...]:
    """Finish every take in `folder`. Raises SimulationError for a file that is no take."""
    takes = sorted(folder.glob("*" + TAKE_SUFFIX))
    return tuple(recovered for take in takes for recovered in recover_take(take))


def recover_take(take: Path) -> tuple[Recovered, ...]:
    """Finish a take whose recorder is gone; one too short to use is dropped.

    Nothing comes of a take that is still being recorded, and nothing happens to it. Raises
    SimulationError for a file that is no take.
    """
    if _is_held(take):
        return ()
    path = take.with_name(take.name.removesuffix(TAKE_SUFFIX))
    samples, origin = read_take(take)
    recovered = []
    if len(samples) >= 2 and not path.exists():
        demonstration = _demonstration(samples, origin | {"recovered": True}, path)
        save_npz(demonstration, path)
        recovered.append(Recovered(path, demonstration.duration_s))
    take.unlink()
    return tuple(recovered)


def read_take(take: Path) -> tuple[list[Sample], dict[str, Any]]:
    """Samples and provenance of a take, up to the last chunk that is whole.

    Raises SimulationError for a file that never was a take.
    """
    data = take.read_bytes()
    line, newline, rest = data.partition(b"\n")
    if not newline:
        # Cut off in its first line: nothing had been recorded yet.
        return [], {}
    try:
        header = json.loads(line)
        origin = dict(header["origin"]) if header["format"] == _FORMAT else None
    except (ValueError, KeyError, TypeError):
        origin = None
    if origin is None:
        raise SimulationError(
            f"{take} must begin as a take of this version ('{_FORMAT}'), but does not; "
            "move it out of the folder."
        )
    return _samples_in(rest, sum(_WIDTHS) + len(origin["contact_names"])), origin


def _samples_in(data: bytes, width: int) -> list[Sample]:
    samples: list[Sample] = []
    at = 0
    while (rows := _rows_at(data, at, width)) is not None:
        samples += [_sample(row) for row in rows]
        at += _CHUNK.size + rows.nbytes
    return samples


def _rows_at(data: bytes, at: int, width: int) -> Array | None:
    """The chunk of rows that begins at byte `at`, None where none is whole."""
    if at + _CHUNK.size > len(data):
        return None
    magic, count, check = _CHUNK.unpack_from(data, at)
    body = data[at + _CHUNK.size : at + _CHUNK.size + count * width * 8]
    whole = magic == _CHUNK_MAGIC and len(body) == count * width * 8
    if not whole or zlib.crc32(body) != check:
        return None
    return np.frombuffer(body, dtype="<f8").reshape(count, width)


def _chunk(rows: Array) -> bytes:
    body = np.ascontiguousarray(rows, dtype="<f8").tobytes()
    return _CHUNK.pack(_CHUNK_MAGIC, len(rows), zlib.crc32(body)) + body


def _row(sample: Sample) -> Array:
    channels = [np.atleast_1d(getattr(sample, name)) for name in _CHANNELS]
    return np.concatenate([*channels, sample.contact_N])


def _sample(row: Array) -> Sample:
    time, *channels, contact = np.split(row, np.cumsum(_WIDTHS))
    values = dict(zip(_CHANNELS[1:], channels, strict=True))
    return Sample(time_s=float(time[0]), contact_N=contact, **values)


def _demonstration(samples: list[Sample], origin: Mapping[str, Any], path: Path) -> Demonstration:
    if len(samples) < 2:
        raise SimulationError(
            f"A recording must have at least two samples, but {path.name} has {len(samples)}; "
            "record for longer."
        )
    metadata = {**origin, "ground_truth": ground_truth(samples, origin)}
    return as_demonstration(samples, path.stem, metadata)


def _opened(take: Path) -> BinaryIO:
    try:
        file = take.open("xb")
        # The system lets go of it when the process ends, however.
        fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        return file
    except FileExistsError as error:
        raise SimulationError(
            f"{take} must not exist when a recording begins, but does; recover or remove it."
        ) from error
    except OSError as error:
        raise SimulationError(
            f"{take} must be writable, but is not ({error.strerror}); check the folder."
        ) from error


def _is_held(take: Path) -> bool:
    """Whether a recorder, in this process or another, still writes the take."""
    with take.open("rb") as file:
        try:
            fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            return True
    return False
