"""The native archive: an NPZ with one array for each channel, named with its unit.

`time_s` (N,), `position_m` (N, 3), and where recorded `orientation_wxyz` (N, 4), `force_N` (N, 3),
`torque_Nm` (N, 3), `joints_rad` (N, J), `gripper` (N,), further channels as `channel_NAME` (N,),
`wrench_estimated`, one number that is not zero where force and torque are, and zero-dimensional
strings of JSON: `events_json`, a list of [seconds, words], and `metadata_json`, an object. Archives
come from anywhere, so nothing in one is unpickled, trusted in size or unpacked to disk: each member
is read within a limit, and its header before its data.
"""

import difflib
import io
import json
import struct
import tokenize
import zipfile
import zlib
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import Any, TypeVar

import numpy as np
from numpy.lib import format as npy
from numpy.typing import NDArray

from keyphase.demonstration import Demonstration
from keyphase.errors import DemonstrationError
from keyphase.files.reading import WholeFile
from keyphase.files.writing import write_whole
from keyphase.logged import Event
from keyphase.notices import Caution
from keyphase.readers.build import build
from keyphase.readers.formats.damage import what_is_wrong
from keyphase.readers.npz_members import (
    EVENTS,
    METADATA,
    NAMED,
    TEXTS,
    Member,
    member_of,
    numbers_of,
    refuse_wrong_shapes,
)

MAGIC = b"PK\x03\x04"
"""How a zip archive that holds anything begins."""

_REQUIRED = ("time_s", "position_m")
_OPTIONAL = ("orientation_wxyz", "force_N", "torque_Nm", "joints_rad", "gripper")
_ESTIMATED = "wrench_estimated"
_KNOWN = (*_REQUIRED, *_OPTIONAL, _ESTIMATED, *TEXTS)
_SUFFIX = ".npy"
_SHOWN_NAMES = 5

_DAMAGE = (
    zipfile.BadZipFile,
    zlib.error,
    struct.error,
    tokenize.TokenError,
    EOFError,
    LookupError,
    RecursionError,
    AttributeError,
    MemoryError,
    OSError,
    OverflowError,
    RuntimeError,
    SyntaxError,
    TypeError,
    ValueError,
)
"""What zipfile and NumPy raise over bytes that are not what they should be."""


def read_npz(file: WholeFile, limit_bytes: int) -> Demonstration:
    """The demonstration in a native archive.

    Raises DemonstrationError for damaged archives, missing or pickled members, wrong types and
    shapes, and archives that unpack to more than `limit_bytes`.
    """
    with _damage_told(file), zipfile.ZipFile(io.BytesIO(file.data)) as archive:
        found = _members(archive, file)
        members = {n: member_of(archive, info, n, file.name) for n, info in found.items()}
        refuse_wrong_shapes(members, file.name)
        _refuse_too_large(members, file, limit_bytes)
        arrays = {n: numbers_of(archive, member, file.name) for n, member in members.items()}
        unknown = _unknown_notices(archive)
    arrays["time_s"] = arrays["time_s"].reshape(-1)
    metadata = _json_member(arrays.pop(METADATA, None), METADATA, {}, file)
    events = _events(_json_member(arrays.pop(EVENTS, None), EVENTS, [], file), file)
    estimated = arrays.pop(_ESTIMATED, None)
    named = {name: arrays.pop(name) for name in list(arrays) if name.startswith(NAMED)}
    return build(
        file,
        arrays,
        named={name.removeprefix(NAMED): values for name, values in named.items()},
        events=events,
        wrench_estimated=estimated is not None and bool(np.any(estimated)),
        metadata=metadata,
        notices=unknown,
    )


@contextmanager
def _damage_told(file: WholeFile) -> Iterator[None]:
    try:
        yield
    except _DAMAGE as error:
        raise DemonstrationError(
            f"{file.name}: expected a whole NPZ archive, but it is damaged "
            f"({what_is_wrong(file.source.path, error)}); copy or export it again."
        ) from error


def _members(archive: zipfile.ZipFile, file: WholeFile) -> dict[str, zipfile.ZipInfo]:
    found: dict[str, zipfile.ZipInfo] = {}
    for info in archive.infolist():
        name = info.filename.removesuffix(_SUFFIX)
        if not _is_known(name) or name == info.filename:
            continue
        if name in found:
            raise DemonstrationError(
                f"{file.name}: expected one member {name}, but the archive holds several; "
                "save it again."
            )
        found[name] = info
    for name in _REQUIRED:
        if name not in found:
            raise DemonstrationError(
                f"{file.name}: the member {name} is missing; a native archive needs "
                f"{' and '.join(_REQUIRED)}, but this one holds {_shown(archive.namelist())}."
            )
    return found


def _is_known(name: str) -> bool:
    return name in _KNOWN or name.startswith(NAMED)


def _refuse_too_large(members: Mapping[str, Member], file: WholeFile, limit_bytes: int) -> None:
    """Counted in bytes as they will lie in memory, whatever type they are stored in."""
    unpacked = sum(max(m.bytes_in_memory, m.info.file_size) for m in members.values())
    if unpacked > limit_bytes:
        raise DemonstrationError(
            f"{file.name}: the archive unpacks to {unpacked} bytes, more than the limit of "
            f"{limit_bytes}; cut the recording or raise the limit."
        )


_Json = TypeVar("_Json", dict[str, Any], list[Any])


def _json_member(array: NDArray[Any] | None, name: str, empty: _Json, file: WholeFile) -> _Json:
    """What a member of text holds, which must be of the same kind as `empty`."""
    if array is None:
        return empty
    try:
        content = json.loads(str(array.item()), parse_constant=_refuse_constant)
    except (ValueError, RecursionError) as error:
        raise DemonstrationError(
            f"{file.name}: {name} must be one string of JSON, but cannot be read as such "
            f"({error}); write it with json.dumps."
        ) from error
    if not isinstance(content, type(empty)):
        kind = "object" if isinstance(empty, dict) else "list"
        raise DemonstrationError(
            f"{file.name}: {name} must hold a JSON {kind}, but holds a "
            f"{type(content).__name__}; put it {'under a key' if kind == 'object' else 'in one'}."
        )
    return content


def _events(content: list[Any], file: WholeFile) -> list[Event]:
    try:
        return [Event(float(time), str(text)) for time, text in content]
    except (TypeError, ValueError, OverflowError) as error:
        raise DemonstrationError(
            f"{file.name}: {EVENTS} must hold pairs of seconds and words, but does not ({error}); "
            'write each as [1.5, "part found"].'
        ) from error


def _refuse_constant(word: str) -> None:
    raise ValueError(f"{word} is not JSON")


def _unknown_notices(archive: zipfile.ZipFile) -> tuple[str, ...]:
    unknown = [name for name in archive.namelist() if not _is_known(name.removesuffix(_SUFFIX))]
    if not unknown:
        return ()
    near = difflib.get_close_matches(unknown[0].removesuffix(_SUFFIX)[:60], _KNOWN, n=1)
    hint = f"; did you mean {near[0]}?" if near else "."
    return (Caution(f"Left out members that are no channel: {_shown(unknown)}{hint}"),)


def _shown(names: list[str]) -> str:
    shown = ", ".join(repr(name[:60]) for name in names[:_SHOWN_NAMES]) or "nothing"
    return shown + (f" and {len(names) - _SHOWN_NAMES} more" if len(names) > _SHOWN_NAMES else "")


def save_npz(demonstration: Demonstration, path: Path | str) -> None:
    """Write the native archive; a file that is there is replaced.

    Name, source and notices are not stored: a reader sets them. Raises DemonstrationError where
    the metadata is not JSON or the folder takes no files.
    """
    write_whole(Path(path), npz_data(demonstration), DemonstrationError)


def npz_data(demonstration: Demonstration) -> bytes:
    """The native archive; the same demonstration gives the same bytes.

    Raises DemonstrationError where the metadata is not JSON.
    """
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w") as archive:
        for name in (*_REQUIRED, *_OPTIONAL):
            values = getattr(demonstration, name)
            if values is not None:
                _write_member(archive, name, values)
        for name, values in sorted(demonstration.channels.items()):
            _write_member(archive, NAMED + name, values)
        if demonstration.wrench_estimated:
            _write_member(archive, _ESTIMATED, np.array(1))
        if demonstration.events:
            events = [[event.time_s, event.text] for event in demonstration.events]
            _write_member(archive, EVENTS, np.array(json.dumps(events)))
        if demonstration.metadata:
            _write_member(archive, METADATA, np.array(_json(demonstration)))
    return buffer.getvalue()


def _write_member(archive: zipfile.ZipFile, name: str, values: NDArray[Any]) -> None:
    """ZipInfo's own date is fixed, where ZipFile.write would take the clock's."""
    data = io.BytesIO()
    npy.write_array(data, values, allow_pickle=False)
    archive.writestr(zipfile.ZipInfo(name + _SUFFIX), data.getvalue())


def _json(demonstration: Demonstration) -> str:
    try:
        return json.dumps(dict(demonstration.metadata), allow_nan=False, sort_keys=True)
    except (TypeError, ValueError, RecursionError) as error:
        raise DemonstrationError(
            f"{demonstration.name}: metadata must be JSON values to be saved, but is not ({error})."
        ) from error
