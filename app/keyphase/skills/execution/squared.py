"""While a skill runs that squares a part: the strokes, and whether they are done."""

import numpy as np

from keyphase.demonstration import Array
from keyphase.skills.changed import changed
from keyphase.skills.coupling import Reference
from keyphase.skills.execution.sensed import Sensed
from keyphase.skills.skill import Skill

FLATTENING = 0.03
"""Part of the stiffness in rotation that is left while the part is pressed: it is to lie flat, as
one that stands on an edge turns what it then carries along."""


HELD = 1.0
"""Part of the stiffness aside that is left meanwhile: the strokes put the part where it belongs,
and what lies at a slant would lead one off that gives way."""


class Squared:
    """Of one skill that has a squaring; has the face of `Seeking`."""

    turning, giving = FLATTENING, HELD

    def __init__(self, skill: Skill, step_s: float) -> None:
        assert skill.squaring is not None
        assert skill.press is not None
        self.search, self.press, self.searched = skill.squaring, skill.press, False
        self._step_s, self._done_s = step_s, 0.0
        self._there_m = self._from_m = skill.end_position_m
        self._aside_m = np.zeros(3)

    def watch(self, _sensed: Sensed, _lasts: bool) -> None:
        """Nothing is asked of what is sensed: the strokes do the same wherever the sides are."""

    def is_in(self, _sensed: Sensed) -> bool:
        """Whether all strokes are done."""
        return self._done_s >= self.search.strokes_s

    def presses_on(self) -> bool:
        """Never: it is pressed for as long as it is, wherever it stands."""
        return False

    def again(self, sensed: Sensed, shift_m: Array) -> None:
        """The strokes begin where the tool is, and go around where the demonstration was.

        That is moved by the skill's shift (3,). A part met higher is met aside of there, too.
        """
        normal = np.array(self.search.normal)
        off = self._there_m + shift_m - sensed.position_m
        self._from_m, self._aside_m = sensed.position_m, off - float(off.dot(normal)) * normal

    def moving(self, reference: Reference, _sensed: Sensed, time_s: float) -> Reference:
        """The reference on its strokes, `time_s` after they began."""
        self._done_s = time_s
        away, then = self._away(time_s), self._away(time_s + self._step_s)
        velocity = np.concatenate([(then - away) / self._step_s, np.zeros(3)])
        return changed(reference, position_m=self._from_m + away, velocity=velocity)

    def _away(self, time_s: float) -> Array:
        return self.search.approached(time_s) * self._aside_m + self.search.away(time_s)
