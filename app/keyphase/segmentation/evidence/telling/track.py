"""The evidence over time, to be drawn: a bump at each candidate, as high as it is likely."""

import numpy as np

from keyphase.demonstration import Array
from keyphase.segmentation.bins import Indices
from keyphase.segmentation.evidence.probability import sigmoid
from keyphase.segmentation.evidence.selection import Scores
from keyphase.segmentation.evidence.stage import Evidence
from keyphase.segmentation.segmentation import EvidenceTrack

_WIDTH_S = 0.06
_REACH = 3.0


def bumps(count: int, rate_hz: float, cell: Indices, probability: Array) -> Array:
    """Probability (n,) over cells: the highest of a Gaussian bump of 60 ms at every candidate.

    A line at some height meets exactly the bumps of the candidates that are likelier.
    """
    track = np.zeros(count)
    reach = int(np.ceil(_REACH * _WIDTH_S * rate_hz))
    order = np.argsort(probability, kind="stable")
    cell, probability = cell[order], probability[order]
    for offset in range(-reach, reach + 1):
        shape = float(np.exp(-0.5 * (offset / rate_hz / _WIDTH_S) ** 2))
        place = cell + offset
        inside = (place >= 0) & (place < count)
        # Ascending: of two candidates at one place the likelier is written last.
        level = np.zeros(count)
        level[place[inside]] = probability[inside] * shape
        np.maximum(track, level, out=track)
    return track


def track_of(evidence: Evidence, scores: Scores) -> EvidenceTrack:
    """The track of a recording; candidates too close to likelier ones make no bump."""
    grid = evidence.grid
    contact = None
    if grid.wrench is not None:
        cells = np.asarray(evidence.contact.cell)
        contact = bumps(len(grid), grid.rate_hz, cells, sigmoid(scores.contact))
    cells = np.round(evidence.motion.cell).astype(np.intp)
    motion = bumps(len(grid), grid.rate_hz, cells, sigmoid(scores.motion))
    return EvidenceTrack(grid.time_s, contact, motion)
