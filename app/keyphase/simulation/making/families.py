"""What is demonstrated on the bench: each family draws its surroundings and what the hand wants."""

from collections.abc import Callable, Mapping

import numpy as np

from keyphase.making.draws import chance, log_uniform
from keyphase.simulation.making.bench import TIP_M, Surroundings, Thing
from keyphase.simulation.making.wanting import Wanting

Demonstrated = tuple[Surroundings, Wanting]
_ABOVE_M = 0.12


def press(rng: np.random.Generator) -> Demonstrated:
    """Down on something hard or soft, hold, off, elsewhere again."""
    around = _surroundings(rng, softness_s=log_uniform(rng, 0.006, 0.3))
    wanting = _start(rng)
    for _ in range(rng.integers(1, 5)):
        _down(wanting, around)
        wanting.rest(0.5, 4.0)
        wanting.go(z=_ABOVE_M * rng.uniform(0.3, 1.0))
        _elsewhere(wanting)
    return around, wanting


def wipe(rng: np.random.Generator) -> Demonstrated:
    """Down, circles or lines to and fro, off."""
    around = _surroundings(rng, softness_s=log_uniform(rng, 0.006, 0.15))
    wanting = _start(rng)
    for _ in range(rng.integers(1, 4)):
        _down(wanting, around)
        if chance(rng, 0.5):
            wanting.rest(0.3, 1.5)
        flatness = 0.0 if chance(rng, 0.5) else rng.uniform(0.5, 1.0)
        wanting.rounds(rng.uniform(2.0, 9.0), rng.uniform(0.02, 0.08), flatness)
        wanting.go(z=_ABOVE_M * rng.uniform(0.4, 1.0))
        _elsewhere(wanting)
    return around, wanting


def slide(rng: np.random.Generator) -> Demonstrated:
    """Down, along until a wall stops the tool, along the wall, off."""
    wall = Thing("wall", (0.25, 0.0, 0.05), (0.02, 0.6, 0.05))
    around = _surroundings(rng, (wall,))
    wanting = _start(rng)
    for _ in range(rng.integers(1, 3)):
        wanting.go(x=rng.uniform(0.0, 0.1), y=rng.uniform(-0.1, 0.1))
        _down(wanting, around)
        wanting.rest(0.4, 1.5)
        wanting.go(x=0.25 - 0.02 - TIP_M + _deep(rng, around))
        wanting.rest(0.4, 2.0)
        if chance(rng, 0.6):
            wanting.go(y=wanting.at_m[1] + rng.uniform(0.05, 0.2))
            wanting.rest(0.4, 1.5)
        wanting.go(x=rng.uniform(0.0, 0.15), z=_ABOVE_M)
        wanting.rest()
    return around, wanting


def push(rng: np.random.Generator) -> Demonstrated:
    """Against a part, along with it against the next one, and away."""
    gap = rng.uniform(0.1, 0.2)
    half = (0.025, 0.025, 0.02)
    first = Thing("part 1", (0.1, 0.0, 0.02), half, rng.uniform(0.4, 1.5))
    second = Thing("part 2", (0.1 + 0.05 + gap, 0.0, 0.02), half, rng.uniform(0.4, 1.5))
    around = _surroundings(rng, (first, second), softness_s=log_uniform(rng, 0.006, 0.05))
    wanting = _start(rng, (-0.1, 0.0, 0.1))
    wanting.go(z=0.025)
    wanting.rest()
    wanting.go(x=0.1 + rng.uniform(0.3, 0.7) * gap)
    if chance(rng, 0.5):
        wanting.rest(0.5)
    wanting.go(x=0.1 + gap + rng.uniform(0.06, 0.15))
    wanting.rest(0.5)
    wanting.go(x=wanting.at_m[0] - 0.12)
    wanting.rest(0.3)
    wanting.go(z=0.15)
    wanting.rest()
    return around, wanting


def insert(rng: np.random.Generator) -> Demonstrated:
    """A peg onto the rim beside its hole, over into it, down to its ground, and out."""
    clear = TIP_M + rng.uniform(0.0008, 0.002)
    wide = 0.03
    walls = [
        Thing("rim 1", (clear + wide, 0.0, 0.03), (wide, clear + 2 * wide, 0.03)),
        Thing("rim 2", (-clear - wide, 0.0, 0.03), (wide, clear + 2 * wide, 0.03)),
        Thing("rim 3", (0.0, clear + wide, 0.03), (clear, wide, 0.03)),
        Thing("rim 4", (0.0, -clear - wide, 0.03), (clear, wide, 0.03)),
    ]
    around = _surroundings(rng, walls, tool="peg")
    top = 0.06 + 0.03
    wanting = _start(rng, (rng.uniform(0.05, 0.15), 0.0, 0.2))
    wanting.go(x=rng.uniform(0.012, 0.02), z=top + 0.03)
    wanting.go(z=top - _deep(rng, around))
    wanting.rest(0.5, 2.0)
    wanting.go(x=0.0)
    wanting.rest(0.4, 1.5)
    wanting.go(z=0.03 - _deep(rng, around))
    wanting.rest(0.6, 3.0)
    wanting.go(z=0.2)
    _elsewhere(wanting)
    return around, wanting


def pick_and_place(rng: np.random.Generator) -> Demonstrated:
    """Down around a part, close, lift, carry, set down, open, up."""
    half = (0.015, 0.015, 0.025)
    part = Thing("part 1", (0.0, 0.0, 0.025), half, rng.uniform(0.15, 0.6))
    around = _surroundings(rng, (part,), tool="gripper", stiffness_N_m=rng.uniform(600.0, 1500.0))
    wanting = _start(rng, (-0.1, 0.0, 0.15))
    wanting.go(x=0.0)
    wanting.go(z=0.03)
    wanting.rest(0.4, 1.2)
    wanting.grip(True)
    wanting.rest(0.6, 1.5)
    wanting.go(z=rng.uniform(0.08, 0.18))
    if chance(rng, 0.5):
        wanting.rest()
    wanting.go(x=rng.uniform(0.1, 0.3), y=rng.uniform(-0.1, 0.1))
    wanting.go(z=0.03 - rng.uniform(0.0, 0.003))
    wanting.rest(0.5, 1.5)
    wanting.grip(False)
    wanting.rest(0.6, 1.5)
    wanting.go(z=0.15)
    wanting.rest()
    return around, wanting


FAMILIES: Mapping[str, Callable[[np.random.Generator], Demonstrated]] = {
    "simulated-press": press,
    "simulated-wipe": wipe,
    "simulated-slide": slide,
    "simulated-push": push,
    "simulated-insert": insert,
    "simulated-pick-and-place": pick_and_place,
}
"""Every family by its name."""


def _surroundings(rng: np.random.Generator, things=(), softness_s=None, **more) -> Surroundings:
    soft = log_uniform(rng, 0.006, 0.05) if softness_s is None else softness_s
    more.setdefault("stiffness_N_m", log_uniform(rng, 300.0, 2000.0))
    return Surroundings(tuple(things), soft, rng.uniform(0.15, 0.4), **more)


def _start(rng: np.random.Generator, at=(-0.05, 0.0, _ABOVE_M)) -> Wanting:
    return Wanting(rng, np.asarray(at), log_uniform(rng, 0.4, 1.6))


def _deep(rng: np.random.Generator, around: Surroundings) -> float:
    """How far into something the hand wants [m], for 2 to 15 N of its spring."""
    return rng.uniform(2.0, 15.0) / around.stiffness_N_m


def _down(wanting: Wanting, around: Surroundings) -> None:
    wanting.go(z=TIP_M - _deep(wanting.rng, around))


def _elsewhere(wanting: Wanting) -> None:
    rng = wanting.rng
    wanting.go(
        wanting.at_m[0] + rng.uniform(-0.15, 0.15), wanting.at_m[1] + rng.uniform(-0.15, 0.15)
    )
    wanting.rest()
