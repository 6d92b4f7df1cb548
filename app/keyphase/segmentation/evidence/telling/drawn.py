"""The paper's normalized error, drawn beside the evidence, and the candidates on its peaks."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from keyphase.demonstration import Array, Demonstration
from keyphase.segmentation.bins import Indices
from keyphase.segmentation.evidence.probability import log_odds, sigmoid
from keyphase.segmentation.evidence.selection import BELOW, CLOSE, GIVEN, SMALL, Scores, Selection
from keyphase.segmentation.evidence.stage import Evidence
from keyphase.segmentation.kept import Kept
from keyphase.segmentation.paper.force import error_curve
from keyphase.segmentation.parameters import Parameters
from keyphase.segmentation.segmentation import ErrorCurve, Peak, Rejection

MIN_DRAWN = 0.1
"""Candidates less likely than this are not drawn on the curve."""

_REACH_S = 0.1
_REJECTIONS: dict[int, Rejection] = {
    GIVEN: "",
    BELOW: "below threshold",
    CLOSE: "too close",
    SMALL: "small step",
}


@dataclass(frozen=True, eq=False)
class DrawnCurve:
    """The curve, and for each contact candidate (C,) the bin of its highest error near by."""

    curve: ErrorCurve
    evidence: Evidence
    bin: Indices

    @classmethod
    def of(
        cls, demonstration: Demonstration, evidence: Evidence, parameters: Parameters
    ) -> "DrawnCurve | None":
        """The curve of a demonstration under these parameters; None without force."""
        curve = error_curve(demonstration, parameters)
        if curve is None:
            return None
        return cls(curve, evidence, _highest(curve, evidence.contact_s))

    @cached_property
    def _peaks(self) -> Kept[Peak]:
        return Kept(len(self.bin), 2, self._peak)

    def peaks(self, scores: Scores, selection: Selection) -> tuple[Peak, ...]:
        """The given and the likelier other candidates, in time order."""
        drawn = (selection.contact == GIVEN) | (scores.contact >= log_odds(MIN_DRAWN))
        codes = selection.contact[drawn].astype(np.float64)
        on = np.column_stack([codes, sigmoid(scores.contact[drawn])])
        return tuple(self._peaks.of(np.flatnonzero(drawn), on).tolist())

    def _peak(self, index: int, on: list[float]) -> Peak:
        place, (code, probability) = self.bin[index], on
        height = float(self.curve.error[place])
        x, y, z = self.evidence.force_step_N[index].tolist()
        return Peak(
            time_s=float(self.evidence.contact_s[index]),
            bin_time_s=float(self.curve.time_s[place]),
            height=height,
            ratio=height / max(float(self.curve.running_median[place]), 1e-12),
            force_step_N=(x, y, z),
            torque_step_Nm=None,
            persistence=0.0,
            rejection=_REJECTIONS[int(code)],
            probability=probability,
        )


def _highest(curve: ErrorCurve, at: Array) -> Indices:
    """The bin of the highest error within a tenth of a second of each time."""
    first = np.searchsorted(curve.time_s, at - _REACH_S)
    last = np.searchsorted(curve.time_s, at + _REACH_S)
    first = np.minimum(first, len(curve.time_s) - 1)
    cells = first[:, None] + np.arange(max(int((last - first).max(initial=1)), 1))
    cells = np.minimum(cells, np.maximum(last - 1, first)[:, None])
    return cells[np.arange(len(at)), curve.error[cells].argmax(axis=1)]
