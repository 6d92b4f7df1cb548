"""From what touches what, sample by sample, to when contact was made, lost or changed.

What counts is what the tool feels: whatever touches the tool, and whatever touches a thing that
the tool touches or holds, the bench under a thing it pushes left out. A change that lasts less than
`LASTS_S`, or moves the force by less than `FELT_N`, is no event; boundaries there count neither
way.
"""

from collections.abc import Iterable, Sequence
from itertools import pairwise

import numpy as np

from keyphase.demonstration import Array
from keyphase.making import Event
from keyphase.simulation.making.bench import RATE_HZ, Touching

LASTS_S = 0.15
FELT_N = 0.3
_FINGERS = frozenset({"left", "right"})
_TOOLS = _FINGERS | {"tool"}
_WINDOW_S = (0.02, 0.25)


def felt(touching: Iterable[Touching], held: bool) -> list[Touching]:
    """Of all that touches what the tool feels; of a thing that it pushes (and does not hold) not
    that it stands on the bench."""
    return [_felt(pairs, held) for pairs in touching]


def contact_events(
    felt_pairs: Sequence[Touching], force: Array
) -> tuple[list[Event], list[tuple[float, float]]]:
    """Events, and stretches in which contact changes in a way that nobody could judge [s]."""
    changes = [0, *_changes(felt_pairs), len(felt_pairs)]
    lasting = LASTS_S * RATE_HZ
    steady = [(first, last) for first, last in pairwise(changes) if last - first >= lasting]
    events: list[Event] = []
    ignored: list[tuple[float, float]] = []
    for (before, left), (entered, _) in pairwise(steady):
        was, now = felt_pairs[before], felt_pairs[entered]
        around = (left / RATE_HZ - LASTS_S, entered / RATE_HZ + LASTS_S)
        if entered - left > lasting or (was != now and _step(force, left, entered) < FELT_N):
            ignored.append(around)
        elif was != now:
            at = left if now or not was else entered
            label = "contact changed" if was and now else "contact made" if now else "contact lost"
            events.append(Event(at / RATE_HZ, label, "contact"))
        elif entered > left:
            ignored.append(around)
    return events, ignored


def grip_events(touching: Sequence[Touching], closing: Array) -> tuple[Event, ...]:
    """When both fingers began to hold the same thing, and when the first of them left it again.

    `closing` (N,) is what the hand wants, above a half to hold; what leaves meanwhile slips.
    Touches shorter than `LASTS_S` are fingers that bounce.
    """
    held = np.array([_held(pairs) for pairs in touching])
    changes = np.flatnonzero(np.diff(held.astype(int))) + 1
    events: list[Event] = []
    for row, until in pairwise([*changes.tolist(), len(held)]):
        if until - row < LASTS_S * RATE_HZ or (events and held[row] == _is_grasp(events[-1])):
            continue
        if held[row] or events:
            label = "grasp" if held[row] else "slip" if closing[row] > 0.5 else "release"
            events.append(Event(row / RATE_HZ, label, "contact"))
    return tuple(events)


def _is_grasp(event: Event) -> bool:
    return event.label == "grasp"


def _held(pairs: Touching) -> bool:
    by = {finger: {a for pair in pairs if finger in pair for a in pair} for finger in _FINGERS}
    return bool(by["left"] & by["right"] - _FINGERS)


def _felt(pairs: Touching, held: bool) -> Touching:
    touched = {name for pair in pairs if _TOOLS & set(pair) for name in pair} - _TOOLS
    kept = set()
    for pair in pairs:
        others = set(pair) - _TOOLS
        ours = bool(_TOOLS & set(pair))
        stands = "bench" in pair and not ours
        if ours or (others & touched - {"bench"} and (held or not stands)):
            kept.add(("tool", *others) if ours else pair)
    return frozenset(kept)


def _changes(values: Sequence[Touching]) -> list[int]:
    return [i for i in range(1, len(values)) if values[i] != values[i - 1]]


def _step(force: Array, left: int, entered: int) -> float:
    near, far = (round(side * RATE_HZ) for side in _WINDOW_S)
    before = force[max(left - far, 0) : max(left - near, 1)]
    after = force[entered + near : entered + far]
    if not len(before) or not len(after):
        return 0.0
    return float(np.linalg.norm(after.mean(axis=0) - before.mean(axis=0)))
