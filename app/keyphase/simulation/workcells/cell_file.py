"""The TOML file of a workcell of one's own: what it may say, checked."""

import tomllib
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import msgspec

from keyphase.errors import SimulationError
from keyphase.files.reading import read_regular
from keyphase.simulation.contacts import Pair

MAX_BYTES = 256 * 1024
MAX_ENTRIES = 64
"""More joints, parts, contacts or conditions than this are no scene that a person wrote down."""


class _Written(msgspec.Struct, forbid_unknown_fields=True, frozen=True):
    """The file as it is written; `CellFile` says what it means."""

    model: str
    tool: str
    held: str
    joints: dict[str, float]
    parts: list[str]
    contacts: dict[str, list[list[str]]]
    success: dict[str, str]
    events: dict[str, str] = {}
    name: str = ""
    title: str = ""
    sensor: str = ""


@dataclass(frozen=True)
class CellFile:
    """What a workcell's file says.

    path, model  the file, and the MJCF file beside it
    tool         site of the tool point
    sensor       site of the wrist sensor, the tool's if none is named
    held         body in the gripper, one of `parts`
    joints       driven joints from shoulder to wrist, each with its angle at the start [rad]
    parts        bodies that are no robot
    contacts     two groups of geoms that may touch, by name
    events       what has to happen, in this order; success: what has to hold at the end
    """

    path: Path
    model: Path
    name: str
    title: str
    tool: str
    sensor: str
    held: str
    joints: Mapping[str, float]
    parts: tuple[str, ...]
    contacts: Mapping[str, Pair]
    events: Mapping[str, str]
    success: Mapping[str, str]


def read_cell_file(path: Path) -> CellFile:
    """The workcell's file at `path`. Raises SimulationError for what it may not say."""
    written = _written(path)
    _refuse_bad(path, written)
    pairs = {name: (tuple(a), tuple(b)) for name, (a, b) in written.contacts.items()}
    return CellFile(
        path=path,
        model=path.parent / written.model,
        name=written.name or path.stem,
        title=written.title or written.name or path.stem,
        tool=written.tool,
        sensor=written.sensor or written.tool,
        held=written.held,
        joints=written.joints,
        parts=tuple(written.parts),
        contacts=pairs,
        events=written.events,
        success=written.success,
    )


def _written(path: Path) -> _Written:
    try:
        values: Any = tomllib.loads(read_regular(path, MAX_BYTES).decode())
        return msgspec.convert(values, _Written)
    except FileNotFoundError as error:
        raise _refused(path, "there is no such file") from error
    except (OSError, ValueError, RecursionError) as error:
        # Of msgspec, of tomllib, and of the decoder alike.
        raise _refused(path, str(error)) from error


def _refuse_bad(path: Path, written: _Written) -> None:
    model = Path(written.model)
    if model.is_absolute() or ".." in model.parts:
        raise _refused(path, f"its model '{written.model}' does not lie beside it")
    for what in ("joints", "parts", "contacts", "success"):
        count = len(getattr(written, what))
        if not 0 < count <= MAX_ENTRIES:
            raise _refused(path, f"it has {count} {what} (1 to {MAX_ENTRIES})")
    if len(written.events) > MAX_ENTRIES:
        raise _refused(path, f"it has {len(written.events)} events ({MAX_ENTRIES} at most)")
    if len(written.joints) < 4:
        raise _refused(path, "an arm needs four joints and more to be led by its tool")
    if not all(abs(angle) < 100.0 for angle in written.joints.values()):
        raise _refused(path, "a joint starts at no angle in radians")
    if written.held not in written.parts:
        raise _refused(path, f"what is held ('{written.held}') must be one of its parts")
    for name, pair in written.contacts.items():
        if not name.isidentifier() or len(pair) != 2 or not all(pair):
            raise _refused(
                path, f"the contact '{name}' must have a plain name and two groups of geoms"
            )


def _refused(path: Path, why: str) -> SimulationError:
    return SimulationError(
        f"{path}: expected a workcell with model, tool, held, joints, parts, contacts and success "
        f"(docs/workcells.md), but {why}; correct it."
    )
