"""Where a recording has evidence of its own, and which of it a person's boundary belongs to.

A boundary that a person puts a little before the tool really moves lies so in every recording of
the task: what is carried over is the evidence it belongs to, and how far from it the boundary lies.
"""

from dataclasses import dataclass
from functools import cached_property
from typing import Literal

import numpy as np

from keyphase.segmentation.segmentation import Segmentation

PlaceKind = Literal["contact", "motion", "grasp", "release"]

REACH_S = 0.7
"""How far from evidence a person's boundary may lie and still belong to it."""

MIN_PROBABILITY = 0.2
"""Less likely evidence is none."""

_NEAR_S = 0.03
_GRIPPER_PROBABILITY = 0.98


@dataclass(frozen=True)
class Place:
    """One place with evidence: when, of what kind, how probable."""

    time_s: float
    kind: PlaceKind
    probability: float


@dataclass(frozen=True, eq=False)
class Places:
    """All places of a recording in their order."""

    all: tuple[Place, ...]

    @cached_property
    def times_s(self) -> np.ndarray:
        """Their times (P,)."""
        return np.array([place.time_s for place in self.all], float)

    def of(self, time_s: float) -> Place | None:
        """The place that a boundary at this time belongs to: near, and probable."""
        near = [one for one in self.all if abs(one.time_s - time_s) <= REACH_S]
        return max(near, key=lambda one: _worth(one, abs(one.time_s - time_s)), default=None)


NO_PLACES = Places(())


def places_of(segmentation: Segmentation) -> Places:
    """The candidates of a segmentation that are likely enough, and where the gripper acts."""
    found = [
        Place(one.time_s, one.kind, one.probability)
        for one in segmentation.candidates
        if one.probability >= MIN_PROBABILITY
    ]
    for boundary in segmentation.boundaries:
        if boundary.gripper:
            found.append(Place(boundary.time_s, boundary.gripper, _GRIPPER_PROBABILITY))
    return Places(tuple(sorted(found, key=lambda place: place.time_s)))


def _worth(place: Place, away_s: float) -> float:
    """What is very near is meant, however unlikely; of what is farther away the likelier."""
    return float(np.sqrt(place.probability) / (1.0 + (away_s / _NEAR_S) ** 2))
