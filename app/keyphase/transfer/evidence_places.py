"""Where a recording has evidence of its own, and which of it a person's boundary belongs to.

A boundary that a person puts a little before the tool really moves lies so in every recording of
the task: what is carried over is the evidence it belongs to, and how far from it the boundary lies.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Literal

import numpy as np

from keyphase.segmentation.segmentation import Segmentation

PlaceKind = Literal["contact", "motion", "grasp", "release"]

REACH_S = 0.4
"""How far from evidence a person's boundary may lie and still belong to it."""

MIN_PROBABILITY = 0.1
"""Less likely evidence is none."""

_NEAR_S = 0.1
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


def usual_kind(places: Sequence[Place | None]) -> PlaceKind | None:
    """The kind that most of the places of one boundary have, in several recordings."""
    kinds: list[PlaceKind | None] = [None if place is None else place.kind for place in places]
    return max(kinds, key=lambda kind: (kinds.count(kind), kind is not None))


def _worth(place: Place, away_s: float) -> float:
    return float(np.sqrt(place.probability) * np.exp(-away_s / _NEAR_S))
