"""While a skill runs that squares a part: the strokes, and whether they are done."""

import numpy as np

from keyphase.demonstration import Array
from keyphase.skills.changed import changed
from keyphase.skills.coupling import Reference
from keyphase.skills.execution.sensed import Sensed
from keyphase.skills.pressed import Press
from keyphase.skills.squaring import Squaring

FLATTENING = 0.1
"""Part of the stiffness in rotation that is left while the part is pressed: it is to lie flat, as
one that stands on an edge turns what it then carries along."""


class Squared:
    """Of one skill that has a squaring; has the face of `Seeking`."""

    turning = FLATTENING

    def __init__(self, squaring: Squaring, press: Press, step_s: float) -> None:
        self.search, self.press, self.searched = squaring, press, False
        self._step_s, self._done_s = step_s, 0.0
        self._from_m: Array = press.position_m

    def watch(self, _sensed: Sensed, _lasts: bool) -> None:
        """Nothing is asked of what is sensed: the strokes do the same wherever the sides are."""

    def is_in(self, _sensed: Sensed) -> bool:
        """Whether all strokes are done."""
        return self._done_s >= self.search.strokes_s

    def again(self, sensed: Sensed) -> None:
        """The strokes begin where the tool is."""
        self._from_m = sensed.position_m

    def moving(self, reference: Reference, _sensed: Sensed, time_s: float) -> Reference:
        """The reference on its strokes, `time_s` after they began."""
        self._done_s = time_s
        direction, wxyz = self.press.direction, reference.orientation_wxyz
        away = self.search.away(direction, wxyz, time_s)
        then = self.search.away(direction, wxyz, time_s + self._step_s)
        velocity = np.concatenate([(then - away) / self._step_s, np.zeros(3)])
        return changed(reference, position_m=self._from_m + away, velocity=velocity)
