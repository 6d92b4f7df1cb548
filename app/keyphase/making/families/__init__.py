"""What is demonstrated: each family writes a script, another one for each seed."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass

from keyphase.making.families.assembling import hand_over, insert, screw, snap, two_handed
from keyphase.making.families.carrying import pick_and_place, push
from keyphase.making.families.free import carry, long_path, reach
from keyphase.making.families.light_touch import light_touch
from keyphase.making.families.mixed import mixed
from keyphase.making.families.surfaces import peel, press, slide, wipe
from keyphase.making.script import Script


@dataclass(frozen=True)
class Family:
    """How a family writes its script, and what is recorded of it.

    wrench      share of its recordings that have a wrench
    estimated   share of those whose wrench is estimated from the joints
    settles     share of contacts after which the force takes up to a second to settle
    """

    write: Callable[[Script], None]
    wrench: float = 1.0
    estimated: float = 0.1
    settles: float = 0.35


FAMILIES: Mapping[str, Family] = {
    "reach": Family(reach, wrench=0.0),
    "long-path": Family(long_path, wrench=0.3, estimated=0.5),
    "carry": Family(carry, estimated=0.6),
    "press": Family(press, estimated=0.5),
    "wipe": Family(wipe, estimated=0.25),
    "slide": Family(slide, estimated=0.25),
    "peel": Family(peel),
    "insert": Family(insert, estimated=0.25),
    "snap": Family(snap, estimated=0.0),
    "screw": Family(screw, estimated=0.25),
    "push": Family(push, estimated=0.4),
    "pick-and-place": Family(pick_and_place, wrench=0.5, estimated=0.2),
    "hand-over": Family(hand_over, estimated=0.25),
    "two-handed": Family(two_handed, estimated=0.0),
    "mixed": Family(mixed, estimated=0.4),
}
"""Every family by its name."""

SINGLE: Mapping[str, Family] = {"light-touch": Family(light_touch, estimated=0.0, settles=0.0)}
"""Made when asked for by name, and no part of what weights are fitted on."""
