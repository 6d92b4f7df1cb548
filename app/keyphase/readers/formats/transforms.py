"""Transforms over several links: where a tool is in the base, by the links that lead there.

Each link has a clock of its own. A chain has the times of the link that came most often; the others
are interpolated to them, and static ones hold for good.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from keyphase.demonstration import Array
from keyphase.readers.resampling import interpolate

_PREFIXES = ("/tf[", "/tf_static[")
_MAX_FRAMES = 100
_MAX_CHAINS = 200


@dataclass(frozen=True)
class _Link:
    """Where a child is in its parent: times (N,) [s], places (N, 3) [m], turns (N, 4) w x y z."""

    parent: str
    times: Array
    places: Array
    turns: Array
    static: bool


def with_chains(arrays: dict[str, NDArray[Any]]) -> dict[str, NDArray[Any]]:
    """The columns of a bag without static links, and with a transform for every chain of links.

    A chain begins at a frame without a parent, or one that is called base or world.
    """
    links = dict(_links(arrays))
    kept = {name: one for name, one in arrays.items() if not name.startswith(_PREFIXES[1])}
    if not 1 < len(links) <= _MAX_FRAMES:
        return kept
    for count, (ancestor, child) in enumerate(_chains(links)):
        if count >= _MAX_CHAINS:
            break
        topic = f"/tf[{ancestor}>{child}]"
        times, places, turns = _composed(links, ancestor, child)
        kept[f"{topic}.stamp"] = times
        for i, axis in enumerate("xyz"):
            kept[f"{topic}.transform.translation.{axis}"] = places[:, i]
        for axis, i in zip("xyzw", (1, 2, 3, 0), strict=True):
            kept[f"{topic}.transform.rotation.{axis}"] = turns[:, i]
    return kept


def _links(arrays: dict[str, NDArray[Any]]) -> Iterator[tuple[str, _Link]]:
    """Each child and the link to its parent, where its stamps rise."""
    for name in arrays:
        prefix = next((one for one in _PREFIXES if name.startswith(one)), None)
        topic, ending, _ = name.partition("].transform.translation.x")
        if prefix is None or not ending:
            continue
        parent, _, child = topic.removeprefix(prefix).partition(">")
        topic += "]"
        times = arrays.get(f"{topic}.stamp", np.empty(0))
        place = [arrays[f"{topic}.transform.translation.{axis}"] for axis in "xyz"]
        turn = [arrays[f"{topic}.transform.rotation.{axis}"] for axis in "wxyz"]
        norms = np.linalg.norm(turn, axis=0)
        static = prefix == _PREFIXES[1]
        if len(times) and (static or (np.diff(times) > 0).all()) and (norms > 0.5).all():
            turns = np.stack(turn, axis=1) / norms[:, None]
            yield child, _Link(parent, times, np.stack(place, axis=1), turns, static)


def _chains(links: dict[str, _Link]) -> Iterator[tuple[str, str]]:
    """Ancestor and child of every chain of at least two links, one of which moves."""
    for child in links:
        moves, length, seen, frame = False, 0, {child}, child
        while frame in links:
            moves, length = moves or not links[frame].static, length + 1
            frame = links[frame].parent
            if frame in seen:
                break
            seen.add(frame)
            begins = frame not in links or any(word in frame.lower() for word in ("base", "world"))
            if begins and length > 1 and moves:
                yield frame, child


def _composed(links: dict[str, _Link], ancestor: str, child: str) -> tuple[Array, Array, Array]:
    path = []
    frame = child
    while frame != ancestor:
        path.append(links[frame])
        frame = links[frame].parent
    moving = [link for link in path if not link.static]
    lead = min(moving, key=lambda link: float(np.median(np.diff(link.times)))).times
    begin, end = max(m.times[0] for m in moving), min(m.times[-1] for m in moving)
    times = lead[(lead >= begin) & (lead <= end)]
    place, turn = np.zeros((len(times), 3)), Rotation.identity(len(times))
    for link in path:
        places, turns = _at(link, times)
        place, turn = turns.apply(place) + places, turns * turn
    return times, place, turn.as_quat(scalar_first=True)


def _at(link: _Link, times: Array) -> tuple[Array, Rotation]:
    if link.static:
        places, turns = link.places[-1:].repeat(len(times), 0), link.turns[-1:]
        return places, Rotation.from_quat(turns.repeat(len(times), 0), scalar_first=True)
    places = interpolate("position_m", link.times, link.places, times)
    turns = interpolate("orientation_wxyz", link.times, link.turns, times)
    return places, Rotation.from_quat(turns, scalar_first=True)
