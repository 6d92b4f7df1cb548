"""What a replay meets of what its recording met: when, within which skill, and how firmly."""

from collections.abc import Mapping, Sequence

import numpy as np

from keyphase.simulation.impedance import RATE_HZ
from keyphase.simulation.recorded.span import Span
from keyphase.simulation.recorded.surfaces import Surface

TOUCHED_N = 0.2
MISSING, MISSING_N = 0.5, 3.0
"""A contact is pressed if no more than this part of the demonstrated force is missing, or 3 N.

Half of the step is what its own end condition asks for; 3 N is what a skill that loads a contact
leaves missing.
"""

DUE_S, AFTER_S = 0.05, 0.3
"""A contact is due so long before it was made, and belongs to a skill that ended so long before."""

OVER_S = 0.04
"""A force is averaged over this time, as that of the surfaces is: a blow presses nothing."""


class Meeting:
    """The contacts of one replay, by the index of their surface.

    due      those whose moment has come; not one that the recording begins in, as nobody came to it
    touched  when each was met first, since the replay began [s]
    missed   those that were not met before the skill was over that had demonstrated them
    """

    def __init__(self, surfaces: Sequence[Surface], begins_s: float) -> None:
        """The contacts of a recording; those made until `begins_s` are what it begins in."""
        self._surfaces, self._begins_s = surfaces, begins_s
        self.due, self.missed = set[int](), set[int]()
        self.touched = dict[int, float]()
        # Who leaves out that a contact was pressed has not repeated it, pause or not.
        come_to = [s.made_s > begins_s for s in surfaces]
        self._asked_N = np.array([s.force_N.max() for s in surfaces]) * come_to
        self._felt_N, self._pressed_N = np.zeros(len(surfaces)), np.zeros(len(surfaces))
        self._span_s: Span | None = None

    def repeat(self, moment_s: float, span_s: Span) -> None:
        """A moment of the demonstration is being repeated, of the stretch that a skill repeats."""
        if span_s != self._span_s:
            self._missed_before(span_s)
            self._span_s = span_s
        for index, surface in enumerate(self._surfaces):
            begun = surface.made_s - DUE_S <= moment_s <= surface.lost_s
            if not begun or surface.made_s > span_s[1] + AFTER_S:
                continue
            if surface.made_s > self._begins_s:
                self.due.add(index)
            if surface.made_s <= moment_s <= surface.time_s[-1]:
                self._asked_N[index] = max(self._asked_N[index], surface.pressed_with(moment_s))

    def press(self, forces_N: Mapping[int, float], time_s: float) -> list[int]:
        """Take in the force on each surface that is touched; those touched for the first time."""
        felt = np.zeros(len(self._surfaces))
        felt[list(forces_N)] = list(forces_N.values())
        self._felt_N += (felt - self._felt_N) / (OVER_S * RATE_HZ)
        np.maximum(self._pressed_N, self._felt_N, out=self._pressed_N)
        new = [i for i, now_N in forces_N.items() if now_N > TOUCHED_N and i not in self.touched]
        self.touched.update(dict.fromkeys(new, time_s))
        return new

    @property
    def in_order(self) -> bool:
        """Whether all that was due was met, in its order, by the skill that had demonstrated it."""
        met = [self.touched[index] for index in sorted(self.due) if index in self.touched]
        return len(met) == len(self.due) and met == sorted(met) and not self.missed

    @property
    def firm(self) -> bool:
        """Whether each was pressed with half of what was demonstrated.

        What the recording begins in, only as far as it was repeated.
        """
        missing = self._asked_N - self._pressed_N
        return bool((missing <= np.maximum(MISSING * self._asked_N, MISSING_N)).all())

    def _missed_before(self, span_s: Span) -> None:
        """What was to be met by now, as another stretch begins."""
        for index in self.due - self.touched.keys():
            made_s = self._surfaces[index].made_s
            if made_within(made_s, self._span_s) and not made_within(made_s, span_s):
                self.missed.add(index)


def made_within(made_s: float, span_s: Span | None) -> bool:
    """Whether a contact was made within the stretch that is repeated, not before it."""
    return span_s is not None and span_s[0] < made_s <= span_s[1] + AFTER_S
