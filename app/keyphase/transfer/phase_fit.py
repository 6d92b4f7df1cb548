"""How well a stretch of a recording is the phase it is named as."""

from dataclasses import dataclass

import numpy as np

from keyphase.transfer.placing import MIN_GAP_S, Teacher
from keyphase.transfer.rests import LONGEST_S, STILL
from keyphase.transfer.signals import Signals

_LEFT = 0.6
"""So much of a name's confidence is left at the least."""

_USUAL_RESIDUAL, _USUAL_RATIO = 0.5, 0.5
"""Of right phases nine in ten lie within: how far signals are apart, and the logarithm of how much
longer or shorter the stretch is than the phase."""

_FAR, _SHORT, _LONG = 2.0, 0.75, 0.5
"""How much doubt each of them adds beyond that."""


@dataclass(frozen=True, eq=False)
class PhaseFit:
    """Compares phases of a new recording with those of a finished one."""

    teacher: Teacher
    signals: Signals

    def of(self, number: int, start_s: float, end_s: float) -> float:
        """How much of a name's confidence is left, 0.6 to 1, for the taught phase of this number.

        Signals farther apart than usual (of right phases nine in ten are nearer) make it less sure,
        and so does a stretch that is much shorter or longer than the phase was: where a phase
        is missing, its name is squeezed onto what is left.
        """
        doubt = _FAR * max(self._residual(start_s, end_s) - _USUAL_RESIDUAL, 0.0)
        ratio = self._log_ratio(number, start_s, end_s)
        doubt += _SHORT * max(-ratio - _USUAL_RATIO, 0.0) + _LONG * max(ratio - _USUAL_RATIO, 0.0)
        return float(_LEFT + (1.0 - _LEFT) * np.exp(-doubt))

    def rests(self, start_s: float, end_s: float) -> bool:
        """Whether the tool stands still there for long."""
        inside = (self.signals.time_s >= start_s) & (self.signals.time_s <= end_s)
        if end_s - start_s < LONGEST_S or not inside.any():
            return False
        return float(self.signals.only(["speed"]).values[inside].mean()) < STILL

    def _residual(self, start_s: float, end_s: float) -> float:
        alignment = self.teacher.alignment
        inside = (alignment.to_s >= start_s) & (alignment.to_s <= end_s)
        return float(alignment.residual[inside if inside.any() else slice(None)].mean())

    def _log_ratio(self, number: int, start_s: float, end_s: float) -> float:
        """How much longer the stretch is than the phase in this tempo, long rests left out."""
        taught, phase = self.teacher.taught, self.teacher.taught.phases[number]
        theirs = np.ptp(taught.signals.awake_s(np.array([phase.start_s, phase.end_s])))
        mine = np.ptp(self.signals.awake_s(np.array([start_s, end_s])))
        usual = max(float(theirs) * self.teacher.alignment.tempo, MIN_GAP_S)
        return float(np.log(max(float(mine), MIN_GAP_S) / usual))
