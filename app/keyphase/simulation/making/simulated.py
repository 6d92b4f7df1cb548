"""Making one demonstration in the simulator: led over a bench, sensed, its truth from contacts."""

import zlib
from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from keyphase.demonstration import Demonstration
from keyphase.errors import MakingError
from keyphase.making import Made
from keyphase.making.hand import Hand
from keyphase.making.path import Stretch, motion_events, speed
from keyphase.making.sampling import Sampling
from keyphase.making.sensing import Moving, wrist_sensor
from keyphase.making.truth import with_truth
from keyphase.simulation.making.bench import RATE_HZ, Led, lead
from keyphase.simulation.making.families import FAMILIES
from keyphase.simulation.making.touching import contact_events, felt, grip_events
from keyphase.simulation.making.wanting import Wanting

MIN_STROKE_M = 0.003
"""A stroke that moves the tool by less, because something holds it, is no motion."""

SIMULATED: Mapping[str, object] = FAMILIES
"""Every family by its name."""


def make_simulated(family: str, seed: int) -> Made:
    """A demonstration of one of `SIMULATED`; the same seed gives the same bytes on one machine.

    Raises MakingError for a family that does not exist.
    """
    if family not in FAMILIES:
        raise MakingError(
            f"Expected one of the families {', '.join(FAMILIES)}, but got {family!r}."
        )
    rng = np.random.default_rng([zlib.crc32(family.encode()), seed])
    hand = Hand.drawn(rng)
    around, wanting = FAMILIES[family](rng)
    position, rotation, closing = wanting.wanted()
    shaky, turned = hand.unsteady(rng, position, rotation, RATE_HZ)
    led = lead(around, shaky, turned, closing)
    moving = Moving(led.position_m, led.rotation, RATE_HZ)
    pairs = felt(led.touching, held=around.tool == "gripper")
    contacts, ignored = contact_events(pairs, led.wrench[:, :3])
    wrench = wrist_sensor(rng, led.wrench, moving, newton=1.0)
    steps = speed(led.position_m, led.rotation, RATE_HZ)
    motion = motion_events(_really_moving(wanting, led), _smooth(steps), RATE_HZ)
    every = max(1, round(RATE_HZ / min(Sampling.drawn(rng).fine_hz, RATE_HZ)))
    rows = np.arange(0, len(steps), every)
    demonstration = Demonstration(
        f"{family}_{seed}",
        rows / RATE_HZ,
        led.position_m[rows] + rng.normal(0.0, 2e-5, (len(rows), 3)),
        np.asarray(led.rotation.as_quat(scalar_first=True))[rows],
        wrench[rows, :3],
        wrench[rows, 3:],
        gripper=None if led.opening_m is None else led.opening_m[rows],
    )
    made = with_truth(family, demonstration, contacts, motion, wanting.reversals_s, ignored)
    return replace(made, gripped=grip_events(led.touching, closing))


def _really_moving(wanting: Wanting, led: Led) -> list[Stretch]:
    """The strokes that moved the tool; what lies between them is rest."""
    kept: list[Stretch] = []
    for each in wanting.path.stretches:
        way = np.ptp(led.position_m[each.first : each.last], axis=0)
        moves = each.moves and float(np.linalg.norm(way)) >= MIN_STROKE_M
        if kept and not moves and not kept[-1].moves:
            kept[-1] = Stretch(False, kept[-1].first, each.last)
        else:
            kept.append(Stretch(moves, each.first, each.last))
    return kept


def _smooth(speed_m_s: np.ndarray) -> np.ndarray:
    """The mean over 50 ms: the tool trembles a little in the hand's spring."""
    width = round(0.05 * RATE_HZ) | 1
    return np.convolve(speed_m_s, np.full(width, 1.0 / width), "same")
