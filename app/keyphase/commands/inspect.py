"""The command `keyphase inspect`: what recordings hold, how healthy they are, how to read them."""

import json
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import tyro

from keyphase.errors import DemonstrationError, FileInTheWayError, KeyphaseError

if TYPE_CHECKING:
    from keyphase.demonstration import Demonstration
    from keyphase.readers.proposing.proposal import Proposal

HEALTHY, ODD, UNREAD = 0, 1, 2
"""Exit codes: all is read and sound; something is odd; something cannot be read."""


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
        results = [_inspected(path, self.recipe) for path in found]
        if self.write:
            for result in results:
                _write_recipe(result, replace=self.replace)
        if self.json:
            print(json.dumps([_plain(result) for result in results], indent=1))
        else:
            print("\n".join(line for result in results for line in _lines(result)))
        return max(result["code"] for result in results)


def _unread_tables(folder: Path, found: list[Path]) -> Iterator[Path]:
    """Tables right in a folder that have no recipe yet."""
    known = set(found)
    for path in sorted(folder.iterdir()):
        is_table = path.suffix.lower() in (".csv", ".tsv", ".txt", ".dat", ".log", ".asc")
        is_read = path in known or any(one.name.startswith(f"{path.name}#") for one in found)
        if is_table and not is_read and not path.name.endswith(".segments.csv"):
            yield path


def _inspected(path: Path, recipe: Path | None) -> dict[str, Any]:
    from keyphase.readers import read

    try:
        demonstration = read(path, recipe)
    except KeyphaseError as error:
        return {"path": path, "code": UNREAD, "reason": str(error), "proposal": _proposal(path)}
    odd = set(_oddities(demonstration))
    notices = tuple(notice for notice in demonstration.notices if notice not in odd)
    return {
        "path": path,
        "code": ODD if odd else HEALTHY,
        "facts": _facts(demonstration),
        "notices": notices,
    }


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
    }


def _proposal(path: Path) -> "Proposal | None":
    from keyphase.readers.proposing.proposal import propose

    try:
        return propose(path)
    except DemonstrationError:
        return None


def _write_recipe(result: dict[str, Any], *, replace: bool) -> None:
    """A recipe that is in the way stays, and is told."""
    from keyphase.commands.putting import put
    from keyphase.readers import RECIPE_SUFFIX

    proposal: Proposal | None = result.get("proposal")
    path: Path = result["path"]
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


def _lines(result: dict[str, Any]) -> Iterator[str]:
    yield f"{result['path']}:"
    if "reason" in result:
        yield f"  cannot be read: {result['reason']}"
        yield from _proposed_lines(result)
        return
    facts = result["facts"]
    channels = ", ".join(f"{name} ({width})" for name, width in facts["channels"].items())
    yield f"  {facts['rows']} rows, {facts['duration_s']:g} s, {facts['rate_hz']:g} Hz: {channels}"
    yield from (f"  {notice}" for notice in result["notices"])
    yield from (f"  odd: {oddity}" for oddity in facts["odd"])


def _proposed_lines(result: dict[str, Any]) -> Iterator[str]:
    proposal: Proposal | None = result["proposal"]
    if proposal is None:
        return
    if "in_the_way" in result:
        yield f"  {result['in_the_way']}"
    if "written" in result:
        yield f"  A recipe was written to {result['written']}; complete what is commented out."
        return
    asked = f", which leaves open: {', '.join(proposal.open)}" if proposal.open else ""
    yield f"  A recipe that may fit{asked}:"
    yield from (f"    {line}" for line in proposal.recipe_text().splitlines())
