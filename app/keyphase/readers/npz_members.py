"""The members of an archive, read in pieces and never beyond what they declare.

What unpacks to more than it says, is packed in a way that needs memory before its first byte, or
has another shape than its recording, is refused before it has been unpacked.
"""

import io
import math
import warnings
import zipfile
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.lib import format as npy
from numpy.typing import NDArray

from keyphase.errors import DemonstrationError

METADATA = "metadata_json"
EVENTS = "events_json"
TEXTS = (METADATA, EVENTS)
"""Members that hold text; all others hold numbers."""

NAMED = "channel_"
"""How the members of further channels begin."""

WIDTHS: Mapping[str, int | None] = {
    "position_m": 3,
    "orientation_wxyz": 4,
    "force_N": 3,
    "torque_Nm": 3,
    "joints_rad": None,
}
"""Columns of each channel beside time."""

_PACKINGS = (zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED)
_HEADER_BYTES = 64 * 1024
_PIECE_BYTES = 1024**2
_MAX_TEXT_BYTES = 16 * 1024**2
_MAX_JOINTS = 1000


@dataclass(frozen=True)
class Member:
    """What a member's header says: where its numbers begin, and what they are."""

    name: str
    info: zipfile.ZipInfo
    shape: tuple[int, ...]
    fortran_order: bool
    dtype: np.dtype[Any]
    offset: int

    @property
    def bytes_in_memory(self) -> int:
        """What it takes as it will be kept: every number as eight bytes."""
        each = self.dtype.itemsize if self.name in TEXTS else 8
        return math.prod(self.shape) * each


def member_of(
    archive: zipfile.ZipFile, info: zipfile.ZipInfo, name: str, file: str, also: str = ""
) -> Member:
    """Read no more than the header of a member; `also` are further kinds that it may hold.

    Raises DemonstrationError where it cannot be one of a recording.
    """
    if info.compress_type not in _PACKINGS:
        raise DemonstrationError(
            f"{file}: {name} must be stored or deflated, but is packed in another way "
            f"({info.compress_type}); save it with numpy.savez or numpy.savez_compressed."
        )
    with archive.open(info) as packed:
        stream = io.BytesIO(packed.read(_HEADER_BYTES))
    shape, fortran_order, dtype = _header(stream, name, file)
    _refuse_wrong_type(dtype, name, file, also)
    member = Member(name, info, shape, fortran_order, dtype, stream.tell())
    expected = math.prod(shape) * dtype.itemsize
    came = info.file_size - member.offset
    if expected != came or min(shape, default=1) < 0:
        raise DemonstrationError(
            f"{file}: {name} declares shape {shape} and {expected} bytes, but {came} bytes "
            "follow; save the archive again."
        )
    return member


def refuse_wrong_shapes(members: Mapping[str, Member], file: str) -> None:
    """Refuse shapes that do not fit `time_s`, before anything is unpacked."""
    time = members["time_s"].shape
    if len(time) not in (1, 2) or time[1:] not in ((), (1,)) or time[0] < 2:
        raise DemonstrationError(
            f"{file}: time_s must be one column of at least two samples, but has shape {time}."
        )
    for name, width in WIDTHS.items():
        member = members.get(name)
        if member is None:
            continue
        shape = member.shape
        widths = (width,) if width else range(_MAX_JOINTS)
        fits = len(shape) == 2 and shape[0] == time[0] and shape[1] in widths
        if not fits:
            raise DemonstrationError(
                f"{file}: {name} must have shape ({time[0]}, {width or 'J'}), one row per time "
                f"sample, but has shape {shape}."
            )
    _refuse_wrong_named(members, time[0], file)
    for text in (members[name] for name in TEXTS if name in members):
        if text.bytes_in_memory > _MAX_TEXT_BYTES:
            raise DemonstrationError(
                f"{file}: {text.name} may have {_MAX_TEXT_BYTES} bytes, but has "
                f"{text.bytes_in_memory}; leave some of it out."
            )


def _refuse_wrong_named(members: Mapping[str, Member], rows: int, file: str) -> None:
    for name, member in members.items():
        if name.startswith(NAMED) and member.shape not in ((rows,), (rows, 1)):
            raise DemonstrationError(
                f"{file}: {name} must have shape ({rows},), one value per time sample, but has "
                f"shape {member.shape}; give each component a name of its own."
            )


def numbers_of(archive: zipfile.ZipFile, member: Member, file: str) -> NDArray[Any]:
    """The array of a member, unpacked in pieces into the room that it declared."""
    data = bytearray(member.info.file_size)
    at = 0
    with archive.open(member.info) as packed:
        while piece := packed.read(_PIECE_BYTES):
            if at + len(piece) > len(data):
                raise DemonstrationError(
                    f"{file}: {member.name} unpacks to more than it declares; save it again."
                )
            data[at : at + len(piece)] = piece
            at += len(piece)
    if at != len(data):
        raise DemonstrationError(
            f"{file}: {member.name} unpacks to less than it declares; copy or save it again."
        )
    if len(data) == member.offset:
        return np.empty(member.shape, member.dtype)
    flat = np.frombuffer(data, member.dtype, offset=member.offset)
    return flat.reshape(member.shape, order="F" if member.fortran_order else "C")


def _header(
    stream: io.BytesIO, name: str, file: str
) -> tuple[tuple[int, ...], bool, np.dtype[Any]]:
    version = npy.read_magic(stream)
    reading = {(1, 0): npy.read_array_header_1_0, (2, 0): npy.read_array_header_2_0}.get(version)
    if reading is not None:
        with warnings.catch_warnings():
            # Headers that Python 2 wrote are read all the same.
            warnings.simplefilter("ignore", UserWarning)
            return reading(stream)
    raise DemonstrationError(
        f"{file}: {name} must be stored in NPY version 1 or 2, but has {version}; "
        "save plain arrays with numpy.savez."
    )


def _refuse_wrong_type(dtype: np.dtype[Any], name: str, file: str, also: str) -> None:
    if dtype.hasobject:
        raise DemonstrationError(
            f"{file}: {name} holds pickled Python objects, which are never loaded; "
            "save plain arrays of numbers."
        )
    kinds, expected = ("U", "text") if name in TEXTS else ("fiu", "real numbers")
    if dtype.kind not in kinds + also:
        raise DemonstrationError(
            f"{file}: {name} must hold {expected}, but its type is {dtype}; "
            "convert it before saving."
        )
