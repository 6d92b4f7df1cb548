"""What a tool ran up against as it slid: where its way ended, it does not slide on.

The normal of a surface is the recorded force, and a plane stops nothing along itself. Where a tool
slid in contact, stood still, and the force rose against its way, something stood in that way. It is
as stiff as it was found to be: as steeply as the force rose where the tool then went to and fro.
What it slid on is still below it then: the force of the stop turns the recorded one aside, and a
tool that presses in both directions would slip down along a single plane between the two.
"""

from dataclasses import dataclass

import numpy as np

from keyphase.demonstration import Array
from keyphase.recorded_force import RATE_HZ, Even, running_mean

STOOD_S, STOOD_M, STAYED_M = 0.5, 0.001, 0.002
"""A tool that moved less than a millimetre for so long stood, and stands until it is further away
than two; its tremor is averaged over 0.2 s."""

SLID_S, SLID_M, CAUGHT_S = 1.0, 0.003, 0.25
"""It slid this far at least within this time, until so shortly before it stood: as it is caught it
may snap in, or bounce, aside of its way."""

AGAINST_N, AGAINST = 1.0, 0.2
"""The mean force rose against the way by this much at least, and this part of its whole change."""

PUSHED = 0.7
"""Where more than this part of the force lay along the way, it was a push and no slide."""

STIFFNESS_N_M = (4000.0, 12000.0)
"""A stop is at least as stiff as a surface, and at most three times as stiff."""

_SMOOTH_S = 0.2
_MEAN_S = 0.5
_STEP = 10


@dataclass(frozen=True, eq=False)
class Stop:
    """An end of a slide: the place (3,) up to which nothing is felt, and the normal (3,).

    from_s, to_s   while it stands in the way, in the demonstration's time
    stiffness_N_m  how stiff it is beyond that place
    """

    point_m: Array
    normal: Array
    from_s: float
    to_s: float
    stiffness_N_m: float


def stops_of(even: Even, first: int, last: int) -> tuple[Stop, ...]:
    """The stops in a stretch in contact, rows [first, last), in their order."""
    position = running_mean(even.position_m, _SMOOTH_S)
    stood = _stood(position, first, last)
    return tuple(
        stop for begun, ended in stood for stop in _stopped(even, position, (first, begun, ended))
    )


def _stood(position: Array, first: int, last: int) -> list[tuple[int, int]]:
    """Rows [begun, ended) in which the tool stood, each as long as it is."""
    least, found, begun = round(STOOD_S * RATE_HZ), list[tuple[int, int]](), first
    while begun + least <= last:
        ended = begun + least
        if _away(position, begun, ended) > STOOD_M:
            begun += _STEP
            continue
        away = np.linalg.norm(position[ended:last] - position[begun], axis=1) > STAYED_M
        ended = ended + int(away.argmax()) if away.any() else last
        found.append((begun, ended))
        begun = ended
    return found


def _away(position: Array, begun: int, ended: int) -> float:
    """How far a stretch gets from where it began."""
    return float(np.linalg.norm(position[begun:ended] - position[begun], axis=1).max())


def _slope(place_m: Array, force_N: Array) -> float:
    """How steeply a force (N,) rises with a place (N,) [N/m]."""
    off = place_m - place_m.mean()
    return float(off @ force_N / max(off @ off, 1e-12))


def _stopped(even: Even, position: Array, rows: tuple[int, int, int]) -> tuple[Stop, ...]:
    """What a tool stood at in rows [begun, ended) of a contact, and on what; empty for nothing."""
    first, begun, ended = rows
    slid = max(first, begun - round(CAUGHT_S * RATE_HZ))
    before = max(first, slid - round(SLID_S * RATE_HZ))
    mean = round(_MEAN_S * RATE_HZ)
    came = even.force_N[max(first, begun - mean) : begun]
    stood = even.force_N[begun : begun + mean]
    if not len(came):
        return ()
    way = position[slid] - position[before]
    length, pressed = float(np.linalg.norm(way)), came.mean(axis=0)
    if length < SLID_M:
        return ()
    ahead, change = way / length, stood.mean(axis=0) - pressed
    pushed = abs(float(pressed @ ahead)) > PUSHED * float(np.linalg.norm(pressed))
    against = -float(change @ ahead)
    if pushed or against < max(AGAINST_N, AGAINST * float(np.linalg.norm(change))):
        return ()
    furthest = even.position_m[begun:ended] @ ahead
    least, most = STIFFNESS_N_M
    # As it is stopped the force rises in any case; its tremor then tells how steeply.
    settled = begun + round(_SMOOTH_S * RATE_HZ)
    swayed = slice(settled, min(settled + mean, ended))
    steep = _slope(even.position_m[swayed] @ ahead, -even.force_N[swayed] @ ahead)
    stop = Stop(
        point_m=even.position_m[begun + int(furthest.argmax())],
        normal=-ahead,
        from_s=float(even.time_s[before]),
        to_s=float(even.time_s[ended - 1]),
        stiffness_N_m=float(np.clip(steep, least, most)),
    )
    held = pressed - float(pressed @ ahead) * ahead
    return (stop, _slid_on(even, stop, held, slice(slid, ended)))


def _slid_on(even: Even, stop: Stop, held_N: Array, rows: slice) -> Stop:
    """What held a tool with a force (3,) as it slid up to a stop: it came no deeper in `rows`."""
    normal = held_N / np.linalg.norm(held_N)
    deepest = int((even.position_m[rows] @ normal).argmin())
    return Stop(
        point_m=even.position_m[rows][deepest],
        normal=normal,
        from_s=float(even.time_s[rows.start]),
        to_s=stop.to_s,
        stiffness_N_m=STIFFNESS_N_M[0],
    )
