"""The command `keyphase inspect`: what recordings hold, how healthy they are, how to read them."""

import json
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import groupby
from pathlib import Path
from typing import TYPE_CHECKING, Any

import tyro

from keyphase.commands.saying import say
from keyphase.errors import (
    DemonstrationError,
    FileInTheWayError,
    KeyphaseError,
    MissingPackageError,
)
from keyphase.files.parts import split_part
from keyphase.printable import printable_line

if TYPE_CHECKING:
    from keyphase.demonstration import Demonstration
    from keyphase.readers.proposing.proposal import Proposal

HEALTHY, ODD, UNREAD = 0, 1, 2
"""Exit codes: all is read and sound; something is odd; something cannot be read."""

_MAX_SHOWN = 30


@dataclass(frozen=True)
class Inspect:
    """Say what recordings hold, what is odd about them, and how an unknown table could be read.

    0 where all is sound, 1 where something is odd, 2 where something cannot be read.
    """

    paths: tyro.conf.Positional[tuple[Path, ...]]
    """Recordings, datasets or folders."""
    recipe: Path | None = None
    """How to read tables that are not in keyphase's own form (TOML)."""
    write: bool = False
    """Write the recipe that is proposed for an unknown table beside it, for you to complete."""
    replace: bool = False
    """Write it over a recipe that is there already."""
    json: bool = False
    """Print for machines."""

    def run(self) -> int:
        """Inspect each, in the order found."""
        from keyphase.readers import find_recordings

        if not self.paths:
            raise KeyphaseError("Name at least one recording or folder to inspect.")
        found = [one.path for one in find_recordings(self.paths, self.recipe)]
        named = [path for path in self.paths if path.is_dir()]
        found += [path for folder in named for path in _unread_tables(folder, found)]
        if not found:
            raise KeyphaseError(
                f"Expected recordings in {', '.join(map(str, self.paths))}, but found none."
            )
        proposals: dict[Path, Proposal | str] = {}
        results = [_inspected(path, self.recipe, proposals) for path in found]
        if self.write:
            for result in {split_part(one["path"])[0]: one for one in results[::-1]}.values():
                _write_recipe(result, replace=self.replace)
        if self.json:
            say(json.dumps([_plain(result) for result in results], indent=1))
        else:
            say("\n".join(line for alike in _alike(results) for line in _lines(alike)))
        return max(result["code"] for result in results)


def _unread_tables(folder: Path, found: list[Path]) -> Iterator[Path]:
    """Tables right in a folder that have no recipe yet."""
    from keyphase.readers.finding import EXPORTED_SUFFIXES

    known = set(found)
    for path in sorted(folder.iterdir()):
        is_table = path.suffix.lower() in (".csv", ".tsv", ".txt", ".dat", ".log", ".asc")
        is_read = path in known or any(one.name.startswith(f"{path.name}#") for one in found)
        if is_table and not is_read and not path.name.endswith(EXPORTED_SUFFIXES):
            yield path


def _inspected(
    path: Path, recipe: Path | None, proposals: "dict[Path, Proposal | str]"
) -> dict[str, Any]:
    """One recording; of those in one file only one is looked at for a proposal."""
    from keyphase.readers import read

    try:
        demonstration = read(path, recipe)
    except KeyphaseError as error:
        file = split_part(path)[0]
        if file not in proposals:
            proposals[file] = _proposal(path)
        proposed = proposals[file]
        result: dict[str, Any] = {"path": path, "code": UNREAD, "reason": str(error)}
        if not isinstance(proposed, str):
            return result | {"proposal": proposed}
        return result | {"proposal": None, "no_recipe": proposed.replace(f"{file}: ", "")}
    odd = set(_oddities(demonstration))
    notices = tuple(notice for notice in demonstration.notices if notice not in odd)
    return {
        "path": path,
        "code": ODD if odd else HEALTHY,
        "facts": _facts(demonstration) | {"not_read": _not_read(path, recipe)},
        "notices": notices,
    }


def _not_read(path: Path, recipe: Path | None) -> list[str]:
    """Columns that nobody reads."""
    from keyphase.readers import load_recipe, own_or_folder_recipe
    from keyphase.readers.unread import unread_columns

    chosen = recipe or own_or_folder_recipe(path)
    try:
        return list(unread_columns(path, load_recipe(chosen) if chosen else None))
    except KeyphaseError:
        return []


def _alike(results: list[dict[str, Any]]) -> Iterator[list[dict[str, Any]]]:
    """Recordings of one file that cannot be read for one reason are told together."""

    def reason(result: dict[str, Any]) -> tuple[object, ...]:
        file, part = split_part(result["path"])
        if "reason" not in result or part is None:
            return (result["path"],)
        return file, result["reason"].replace(f"#{part}", "")

    for _, alike in groupby(results, reason):
        yield list(alike)


def _oddities(demonstration: "Demonstration") -> Iterator[str]:
    """What no sound recording has: what is odd about it, and channels that stand still."""
    import numpy as np

    from keyphase.oddities import oddities_of

    yield from (odd.text for odd in oddities_of(demonstration))
    for name in ("position_m", "orientation_wxyz", "force_N", "torque_Nm", "joints_rad"):
        values = getattr(demonstration, name)
        told = any(notice.startswith(f"{name} never") for notice in demonstration.notices)
        if values is not None and not told and (np.ptp(values, axis=0) == 0).all():
            yield f"{name} never changes."


def _facts(demonstration: "Demonstration") -> dict[str, Any]:
    from keyphase.clock_offset import clock_offset

    channels = {
        name: values.shape[1] if values.ndim > 1 else 1
        for name in (
            "position_m",
            "orientation_wxyz",
            "force_N",
            "torque_Nm",
            "joints_rad",
            "gripper",
        )
        if (values := getattr(demonstration, name)) is not None
    }
    return {
        "rows": len(demonstration),
        "duration_s": round(demonstration.duration_s, 6),
        "rate_hz": round(demonstration.rate_hz, 3),
        "channels": channels,
        "odd": list(_oddities(demonstration)),
        "clock": offset.text if (offset := clock_offset(demonstration)) else "",
    }


def _proposal(path: Path) -> "Proposal | str":
    """The proposal, or why there is none."""
    from keyphase.readers.proposing.proposal import propose

    try:
        return propose(path)
    except (DemonstrationError, MissingPackageError) as error:
        return str(error)


def _write_recipe(result: dict[str, Any], *, replace: bool) -> None:
    """A recipe that is in the way stays, and is told."""
    from keyphase.commands.putting import put
    from keyphase.readers import RECIPE_SUFFIX

    proposal: Proposal | None = result.get("proposal")
    path = split_part(result["path"])[0]
    if proposal is None:
        return
    recipe = path.with_name(f"{path.name}{RECIPE_SUFFIX}")
    try:
        put(recipe, proposal.recipe_text().encode(), path.name, replace=replace)
    except FileInTheWayError as error:
        result["in_the_way"] = str(error)
    else:
        result["written"] = str(recipe)


def _plain(result: dict[str, Any]) -> dict[str, Any]:
    """For JSON."""
    proposal = result.get("proposal")
    shown = {key: value for key, value in result.items() if key not in ("path", "proposal")}
    shown["path"] = str(result["path"])
    if proposal is not None:
        shown["recipe"], shown["open"] = proposal.recipe_text(), list(proposal.open)
    return shown


def _lines(alike: list[dict[str, Any]]) -> Iterator[str]:
    result = alike[0]
    more = f" to {alike[-1]['path']} ({len(alike)} recordings)" if len(alike) > 1 else ""
    yield f"{printable_line(str(result['path']))}{more}:"
    if "reason" in result:
        yield f"  cannot be read: {result['reason']}"
        yield from _proposed_lines(result)
        return
    facts = result["facts"]
    channels = ", ".join(f"{name} ({width})" for name, width in facts["channels"].items())
    yield f"  {facts['rows']} rows, {facts['duration_s']:g} s, {facts['rate_hz']:g} Hz: {channels}"
    yield from (f"  {notice}" for notice in result["notices"])
    yield from (f"  odd: {oddity}" for oddity in facts["odd"])
    if facts["clock"]:
        yield f"  clocks: {facts['clock']}"
    if facts["not_read"]:
        yield f"  not read: {_listed(facts['not_read'])}"


def _listed(names: list[str]) -> str:
    """Names, those of one array as one."""
    counts = Counter(name.partition("[")[0] if name.endswith("]") else name for name in names)
    shown = [f"{name[:60]} ({count})" if count > 1 else name[:60] for name, count in counts.items()]
    more = f" and {len(shown) - _MAX_SHOWN} more" if len(shown) > _MAX_SHOWN else ""
    return ", ".join(shown[:_MAX_SHOWN]) + more


def _proposed_lines(result: dict[str, Any]) -> Iterator[str]:
    proposal: Proposal | None = result["proposal"]
    if proposal is None:
        told = "expected a recording, but" in result["reason"]
        told = told or "the file is binary" in result["no_recipe"]
        if not told and result["no_recipe"] not in result["reason"]:
            yield f"  no recipe can be proposed: {result['no_recipe']}"
        return
    if "in_the_way" in result:
        yield f"  {result['in_the_way']}"
    if "written" in result:
        yield f"  A recipe was written to {result['written']}; complete what is commented out."
        return
    asked = f", which leaves open: {', '.join(proposal.open)}" if proposal.open else ""
    yield f"  A recipe that may fit{asked}:"
    yield from (f"    {line}" for line in proposal.recipe_text().splitlines())
