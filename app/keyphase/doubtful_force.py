"""Whether a recorded force can be what the surroundings exert on the tool: its sign, its frame.

The surroundings take energy from a tool that moves in contact with them, they do not give it: the
mean of F·v / (|F| |v|) in contact is below zero. Where it is not, the force has a wrong sign, or
stands in another frame than is said.

A surface holds a tool that slides square to its way, but for friction. A force that keeps its
direction in one frame while the tool turns stands in that frame: if it then lies along the way in
the frame that is said, it is said wrongly.
"""

from dataclasses import dataclass

import numpy as np

from keyphase.demonstration import Array, Demonstration
from keyphase.recorded_force import Even, evenly, in_contact, offset_while_moving
from keyphase.rotations import quaternions

HELPS, HELPS_MUCH = 0.05, 0.25
"""A force whose mean share of power is above this helps the motion."""

SURE, RATHER_SURE = 3.0, 1.5
"""By so many standard errors over stretches of half a second; less is asked where it is much."""

STEADY = 2.5
"""A force keeps its direction in a frame in which it turns so many times less than in another."""

TURNED_RAD = np.radians(12.0)
"""How far it turns in the other, in the root mean square: the tool turned enough to tell."""

WAY_TURNED_RAD = np.radians(20.0)
"""A way that turns less leaves friction and a push for an explanation."""

ALONG = 0.45
"""Largest part of a force along the way that is friction: a coefficient of 0.5."""

BETTER = 0.6
"""The other frame explains contact if there so much less of the force lies along the way."""

WEIGHT = -0.9
"""Height of the direction of a weight: what is lifted keeps its direction, too."""

_LOOKED_AT_S = 600.0
_LEAST_S = 0.5
_BLOCK_S, _MIN_BLOCKS = 0.5, 3
_SMOOTHED_S = 0.15
_MIN_SAMPLES = 100


def doubtful_force(demonstration: Demonstration) -> str | None:
    """Why the recorded force cannot be what the surroundings exert on the tool; None if it can."""
    if demonstration.force_N is None or demonstration.duration_s < _LEAST_S:
        return None
    even = evenly(demonstration, _LOOKED_AT_S)
    why = _helps(even) or _stands_elsewhere(even)
    if why is None:
        return None
    return (
        f"{why}; check both in the recipe. Directions, contact ends and a world made from this "
        "recording are not to be trusted."
    )


def power_share(even: Even) -> tuple[float, float] | None:
    """Mean of F·v / (|F| |v|) while moving in contact, -1 to 1, and its standard error.

    None where there is contact in fewer than three stretches of half a second.
    """
    force, velocity = even.force_N - offset_while_moving(even), even.velocity(0.05)
    inside = in_contact(force, velocity)
    block = np.arange(len(force)) // round(_BLOCK_S / even.step_s)
    if len(np.unique(block[inside])) < _MIN_BLOCKS:
        return None
    most = np.linalg.norm(force, axis=1) * np.linalg.norm(velocity, axis=1)
    power = np.bincount(block[inside], (force * velocity).sum(axis=1)[inside])
    most = np.bincount(block[inside], most[inside])
    share = float(power.sum() / most.sum())
    left = power - share * most
    return share, float(np.sqrt((left**2).sum()) / most.sum())


def _helps(even: Even) -> str | None:
    found = power_share(even)
    if found is None:
        return None
    share, error = found
    much = share > HELPS_MUCH and share > RATHER_SURE * error
    if not much and not (share > HELPS and share > SURE * error):
        return None
    return (
        f"The recorded force helps the motion ({100 * share:+.0f} % of its power, where the "
        "surroundings can only take): its sign is wrong, or it stands in another frame than the "
        "positions"
    )


def _stands_elsewhere(even: Even) -> str | None:
    """Why the force stands in another frame than is said, from how it turns and lies to the way."""
    force, velocity = even.force_N - offset_while_moving(even), even.velocity(_SMOOTHED_S)
    inside = in_contact(force, velocity)
    if inside.sum() < _MIN_SAMPLES:
        return None
    way, said, wxyz = _unit(velocity[inside]), _unit(force[inside]), even.orientation_wxyz[inside]
    if _spread(way) < WAY_TURNED_RAD:
        return None
    base = _seen(said, way)
    # What was said to be the tool's has been turned into the base by now, and is turned back.
    tool = _seen(_turned(quaternions.conjugate(wxyz), said), way)
    if _steadier(base, tool) and base.resists > ALONG and said[:, 2].mean() > WEIGHT:
        return (
            f"The recorded force keeps its direction in the base within {_degrees(base)} while the "
            f"tool turns it by {_degrees(tool)}, and where it slides {_percent(base.resists)} of "
            "it lie along the way, to which a surface holds a tool square: it probably stands in "
            "the sensor's frame, or the order of the quaternion is wrong"
        )
    turned = _seen(_turned(wxyz, said), way)
    for other, frame in ((tool, "base's, not the tool's"), (turned, "tool's, not the base's")):
        explains = base.along > ALONG and other.along < BETTER * base.along
        if _steadier(other, base) and explains:
            return (
                f"The recorded force is explained by contact if it is the {frame}: there it keeps "
                f"its direction within {_degrees(other)} instead of {_degrees(base)}, and "
                f"{_percent(other.along)} instead of {_percent(base.along)} lie along the way of "
                "a tool that slides: its frame is probably said wrongly"
            )
    return None


@dataclass(frozen=True)
class _Seen:
    """How directions of a force that are seen in a frame spread, and lie to a way.

    spread_rad  root mean square of the angle to their mean
    resists     mean of the part against the way, -1 to 1
    along       root mean square of the part along the way, 0 to 1
    """

    spread_rad: float
    resists: float
    along: float


def _seen(directions: Array, way: Array) -> _Seen:
    part = (directions * way).sum(axis=1)
    return _Seen(_spread(directions), -float(part.mean()), float(np.sqrt((part**2).mean())))


def _steadier(this: _Seen, other: _Seen) -> bool:
    return STEADY * this.spread_rad < other.spread_rad > TURNED_RAD


def _spread(directions: Array) -> float:
    cosine = directions @ _unit(directions.mean(axis=0))
    return float(np.sqrt((np.arccos(np.clip(cosine, -1.0, 1.0)) ** 2).mean()))


def _turned(wxyz: Array, vectors: Array) -> Array:
    pure = np.concatenate([np.zeros((len(vectors), 1)), vectors], axis=1)
    turned = quaternions.product(quaternions.product(wxyz, pure), quaternions.conjugate(wxyz))
    return turned[:, 1:]


def _unit(vectors: Array) -> Array:
    return vectors / np.maximum(np.linalg.norm(vectors, axis=-1, keepdims=True), 1e-9)


def _degrees(seen: _Seen) -> str:
    return f"{np.degrees(seen.spread_rad):.0f}°"


def _percent(share: float) -> str:
    return f"{100.0 * share:.0f} %"
