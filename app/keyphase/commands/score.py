"""The command `keyphase score`: segment files against reference events."""

from dataclasses import dataclass
from pathlib import Path

import tyro


@dataclass(frozen=True)
class ScoreSegments:
    """Score segment files against reference events."""

    truth: tyro.conf.Positional[Path]
    """A truth.json: for each recording its events, tolerance and intervals to ignore."""
    segments: tyro.conf.Positional[Path]
    """A folder of segment files, or one of them."""
    json: bool = False
    """Print for machines."""

    def run(self) -> int:
        """Print precision, recall, F1 and timing error per recording and set."""
        from keyphase.scoring import score

        result = score(self.truth, self.segments)
        print(result.as_json() if self.json else result.as_text())
        return 0
