"""The native table: a CSV whose header names each column with its unit.

`time_s, position_x_m, …, orientation_w, …, force_x_N, …, torque_x_Nm, …, joint_1_rad, …, gripper,
channel_NAME` in any order; what a demonstration may lack, the table may.
"""

import re
from collections import Counter
from collections.abc import Mapping
from pathlib import Path

import numpy as np

from keyphase.demonstration import Array, Demonstration
from keyphase.errors import DemonstrationError
from keyphase.files.reading import WholeFile
from keyphase.files.writing import write_whole
from keyphase.notices import Caution
from keyphase.readers.build import build
from keyphase.readers.orientation import refuse_not_unit
from keyphase.readers.table import Table, TableForm, open_table, split_cells
from keyphase.readers.timing import refuse_not_increasing

_GROUPS: Mapping[str, tuple[str, ...]] = {
    "time_s": ("time_s",),
    "position_m": ("position_x_m", "position_y_m", "position_z_m"),
    "orientation_wxyz": ("orientation_w", "orientation_x", "orientation_y", "orientation_z"),
    "force_N": ("force_x_N", "force_y_N", "force_z_N"),
    "torque_Nm": ("torque_x_Nm", "torque_y_Nm", "torque_z_Nm"),
    "gripper": ("gripper",),
}
_NAMED = "channel_"
_REQUIRED = ("time_s", "position_m")
_JOINT = re.compile(r"joint_([1-9][0-9]{0,3})_rad")
_SHOWN_NAMES = 5

MAX_HEADER_BYTES = 65536
"""Bytes in which a native header must end."""


def has_native_header(data: bytes) -> bool:
    """Whether a file that begins with `data` begins with the header of a native table."""
    first = data[:MAX_HEADER_BYTES].decode("utf-8-sig", errors="replace").splitlines()[:1]
    names = {cell.strip() for line in first for cell in split_cells(line, ",")}
    return all(name in names for channel in _REQUIRED for name in _GROUPS[channel])


def read_csv(file: WholeFile, limit_bytes: int) -> Demonstration:
    """The demonstration in a native table.

    Raises DemonstrationError, with line and column, for missing, doubled or incomplete columns
    and for cells that cannot be.
    """
    table = open_table(file.name, file.data, TableForm(), limit_bytes)
    groups = _groups(table)
    columns = [table.names.index(name) for names in groups.values() for name in names]
    values = table.numbers(columns)
    ends = np.cumsum([len(names) for names in groups.values()])
    channels = dict(zip(groups, np.split(values, ends[:-1], axis=1), strict=True))
    for channel in {"time_s", "gripper"} & channels.keys():
        channels[channel] = channels[channel][:, 0]
    named = {name: channels.pop(name)[:, 0] for name in groups if name.startswith(_NAMED)}
    _refuse_impossible(table, channels)
    further = {name.removeprefix(_NAMED): values for name, values in named.items()}
    return build(
        file, channels, named=further, notices=(*table.notices, *_unknown_notices(table, columns))
    )


def _groups(table: Table) -> dict[str, tuple[str, ...]]:
    """The columns of each channel that the table has, each channel complete."""
    named = [name for name in table.names if name]
    doubled = next((name for name, count in Counter(named).items() if count > 1), None)
    if doubled is not None:
        raise DemonstrationError(
            f"{table.file}: the header names {doubled[:80]!r} more than once; rename one of them."
        )
    joints = [name for name in named if _JOINT.fullmatch(name)]
    every = dict(_GROUPS) | {name: (name,) for name in named if name.startswith(_NAMED)}
    if joints:
        every["joints_rad"] = tuple(f"joint_{i}_rad" for i in range(1, len(joints) + 1))
    groups = {}
    for channel, names in every.items():
        missing = [name for name in names if name not in named]
        if not missing:
            groups[channel] = names
        elif channel in _REQUIRED or len(missing) < len(names) or channel == "joints_rad":
            raise _missing(table, missing)
    return groups


def _missing(table: Table, missing: list[str]) -> DemonstrationError:
    found = ", ".join(repr(name[:40]) for name in table.names[:_SHOWN_NAMES])
    return DemonstrationError(
        f"{table.file}: the column {missing[0]} is missing from the header in line 1, which begins "
        f"{found}; name the columns as a native table does."
    )


def _refuse_impossible(table: Table, channels: Mapping[str, Array]) -> None:
    refuse_not_increasing(
        channels["time_s"], lambda row: f"{table.file}: line {table.line(row)}, column 'time_s'"
    )
    if "orientation_wxyz" in channels:
        refuse_not_unit(
            channels["orientation_wxyz"],
            lambda row: (
                f"{table.file}: line {table.line(row)}, columns 'orientation_w' to 'orientation_z'"
            ),
        )


def _unknown_notices(table: Table, columns: list[int]) -> tuple[str, ...]:
    unknown = [table.label(i) for i in range(table.width) if i not in columns]
    if not unknown:
        return ()
    more = f" and {len(unknown) - _SHOWN_NAMES} more" if len(unknown) > _SHOWN_NAMES else ""
    shown = ", ".join(unknown[:_SHOWN_NAMES])
    return (Caution(f"Left out columns that are no channel: {shown}{more}."),)


def save_csv(demonstration: Demonstration, path: Path | str) -> None:
    """Write the native table; numbers are written so that they read back exactly.

    A table has no place for events and metadata: save an archive where it must be kept. The same
    demonstration gives the same bytes. Raises DemonstrationError where the folder takes no files.
    """
    names, columns = ["time_s"], [demonstration.time_s[:, None]]
    groups = dict(_GROUPS)
    if demonstration.joints_rad is not None:
        joints = range(1, demonstration.joints_rad.shape[1] + 1)
        groups["joints_rad"] = tuple(f"joint_{i}_rad" for i in joints)
    for channel, group in list(groups.items())[1:]:
        values = getattr(demonstration, channel)
        if values is not None:
            names.extend(group)
            columns.append(values.reshape(len(demonstration), -1))
    for name, values in sorted(demonstration.channels.items()):
        names.append(_cell(_NAMED + name))
        columns.append(values[:, None])
    rows = (",".join(map(repr, row)) for row in np.hstack(columns).tolist())
    write_whole(Path(path), "\n".join([",".join(names), *rows, ""]).encode(), DemonstrationError)


def _cell(text: str) -> str:
    """A name as a cell of the header: in quotes where it holds a separator or a quote."""
    return '"' + text.replace('"', '""') + '"' if set(text) & set(',"') else text
