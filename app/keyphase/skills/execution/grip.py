"""The gripper's opening while a skill runs: where it began, and how long it has stood still."""

from dataclasses import dataclass

STILL = 0.01
"""An opening that changes by less than this part of how far it has moved stands still."""


@dataclass(frozen=True)
class Grip:
    """The opening now, as the skill began, where it last stood, and for how long it has [s]."""

    opening: float
    begun_at: float
    stood_at: float
    still_s: float = 0.0


def gripped(before: Grip | None, opening: float, h: float) -> Grip:
    """Take in an opening, `h` seconds after the one before; the first begins it."""
    if before is None:
        return Grip(opening, opening, opening)
    moved = abs(opening - before.begun_at)
    if abs(opening - before.stood_at) <= STILL * moved:
        return Grip(opening, before.begun_at, before.stood_at, before.still_s + h)
    return Grip(opening, before.begun_at, opening)
