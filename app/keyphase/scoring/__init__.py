"""Scores of segment files against reference events that people, controllers or makers noted.

What a reference file says and how it is judged is in docs/scoring.md.
"""

from keyphase.scoring.calibration import Calibration, calibration
from keyphase.scoring.counting import Tally, tally
from keyphase.scoring.judging import Claim, Verdict, judge
from keyphase.scoring.report import as_json, as_table
from keyphase.scoring.score import RecordingScore, Score, score
from keyphase.scoring.truth import Judged, ReferenceEvent, Truth, read_truth

__all__ = [
    "Calibration",
    "Claim",
    "Judged",
    "RecordingScore",
    "ReferenceEvent",
    "Score",
    "Tally",
    "Truth",
    "Verdict",
    "as_json",
    "as_table",
    "calibration",
    "judge",
    "read_truth",
    "score",
    "tally",
]
