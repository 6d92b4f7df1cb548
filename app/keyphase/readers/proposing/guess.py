"""One guess: what some columns probably are, in which unit, and why."""

from dataclasses import dataclass
from typing import Literal

import numpy as np

from keyphase.demonstration import Array

Role = Literal[
    "time", "demonstration", "pose", "position", "quaternion", "euler", "turn", "rot6d", "matrix",
    "force", "torque", "gripper", "joints",
]  # fmt: skip
"""`turn` are three numbers that turn: a rotation vector or Euler angles, a person knows which."""

_MAX_TORQUE_NM = 50.0

OTHERS = "others that would fit begin with"
"""How the evidence names columns that a person may have to choose instead."""


@dataclass(frozen=True)
class Guess:
    """What some columns, in this order, probably are.

    unit      as a recipe writes it, or "" where the numbers do not tell
    detail    order of a quaternion, sequence of Euler angles, layout of a matrix, format of a
              stamp, or ""
    evidence  sentences, the best reason first
    likely    where `detail` is open: what a person is shown first
    """

    role: Role
    columns: tuple[int, ...]
    unit: str
    detail: str
    evidence: tuple[str, ...]
    likely: str = ""

    @property
    def is_one_of_several(self) -> bool:
        """Whether only a person knows which of several places is the tool's."""
        placed = self.role in ("position", "pose")
        return placed and any(one.startswith(OTHERS) for one in self.evidence)


def measured_rows(values: Array, columns: tuple[int, ...]) -> Array:
    """The rows of some columns in which all of them are numbers (M, len(columns))."""
    chosen = values[:, list(columns)]
    return chosen[np.isfinite(chosen).all(axis=1)]


def reach_of(values: Array, columns: tuple[int, ...]) -> float:
    """The largest number in some columns, regardless of its sign."""
    return float(np.abs(measured_rows(values, columns)).max(initial=0.0))


def likely_torque_unit(top: float) -> str:
    """N m for torques that hands and tools bear, else "": they may be in N mm."""
    return "Nm" if top < _MAX_TORQUE_NM else ""
