"""While a skill runs: has the part gone into its seat, and if not, where is it?"""

import numpy as np

from keyphase.demonstration import Array
from keyphase.rotations import quaternions
from keyphase.skills.changed import changed
from keyphase.skills.coupling import Reference
from keyphase.skills.execution.sensed import Sensed
from keyphase.skills.search import FOUND, HELD_S, before_touch
from keyphase.skills.skill import Skill

GIVING = 0.15
"""Part of the stiffness, sideways and in rotation, that is left while a part is pressed in.

A seat that lies aside or is turned, and a held part that sits tilted, align the tool themselves.
"""


class Seeking:
    """Of one skill that has a search; `watch` is told every tick."""

    def __init__(self, skill: Skill, sensed: Sensed) -> None:
        assert skill.search is not None
        assert skill.press is not None
        self.search, self.press = skill.search, skill.press
        self.searched, self._in_s = False, 0.0
        self._end_wxyz = skill.end_orientation_wxyz
        self._touch = before_touch(self.press.direction, sensed.force_N)

    def watch(self, sensed: Sensed) -> None:
        """Take in what was sensed at the end of a tick."""
        self._touch = self._touch.step(sensed.position_m, sensed.force_N)

    def is_in(self, sensed: Sensed) -> bool:
        """Whether the part has gone in as deep as the demonstration did after its first touch."""
        return self._touch.depth_m(sensed.position_m) >= self.search.depth_m

    def has_found(self, sensed: Sensed, h: float) -> bool:
        """Whether a search has led the part in: from the rim on which it began, or for a while."""
        self._in_s = self._in_s + h if self.is_in(sensed) else 0.0
        deep = self._touch.depth_m(sensed.position_m) >= FOUND * self.search.depth_m
        return deep or self._in_s >= HELD_S

    def giving(self, reference: Reference, sensed: Sensed) -> Reference:
        """The reference sideways and in orientation near where the seat has moved the tool."""
        off = reference.position_m - sensed.position_m
        along = float(off.dot(self.press.direction)) * self.press.direction
        position = sensed.position_m + along + GIVING * (off - along)
        return changed(self.turning(reference, sensed), position_m=position)

    def turning(self, reference: Reference, sensed: Sensed) -> Reference:
        """The reference with an orientation that the seat can turn."""
        left = quaternions.shortest_rotation_vector(
            quaternions.product(
                reference.orientation_wxyz, quaternions.conjugate(sensed.orientation_wxyz)
            )
        )
        turn = quaternions.from_rotation_vector(GIVING * left)
        wxyz = quaternions.product(turn, sensed.orientation_wxyz)
        return changed(reference, orientation_wxyz=wxyz)

    def circling(self, reference: Reference, sensed: Sensed, time_s: float) -> Reference:
        """The reference on its spiral, `time_s` after the search began."""
        reference = self.turning(reference, sensed)
        aside = self.search.aside(self.press.direction, time_s)
        return changed(reference, position_m=reference.position_m + aside)

    def turned_by(self, sensed: Sensed) -> Array:
        """How the seat turned the tool against the demonstration, as a quaternion (4,)."""
        turn = quaternions.product(sensed.orientation_wxyz, quaternions.conjugate(self._end_wxyz))
        return turn / np.linalg.norm(turn)


def seeking_of(skill: Skill, sensed: Sensed) -> Seeking | None:
    """What watches a skill; None for a skill that has no search."""
    return None if skill.search is None or skill.press is None else Seeking(skill, sensed)
