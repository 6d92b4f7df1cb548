"""`keyphase score`: how right segment files are, against reference events."""

from dataclasses import dataclass
from pathlib import Path

import tyro

from keyphase.commands.saying import say


@dataclass(frozen=True)
class ScoreSegments:
    """Score segment files against reference events."""

    truth: tyro.conf.Positional[Path]
    """A truth.json: for each recording its events, and what of it may be judged."""
    segments: tyro.conf.Positional[Path]
    """A folder of segment files, or one of them."""
    json: bool = False
    """Print for machines."""
    picture: Path | None = None
    """Draw it, too (.png, .svg or .pdf; needs matplotlib)."""
    replace: bool = False
    """Replace a picture in the way that keyphase did not write, or that was changed since."""

    def run(self) -> int:
        """Print judged and strict scores, timing and calibration, per recording and set."""
        from keyphase.scoring import as_json, as_table, score

        result = score(self.truth, self.segments)
        if self.picture is not None:
            from keyphase.commands.putting import put
            from keyphase.scoring.picture import score_picture

            made_from = f"the score of {self.segments}"
            put(self.picture, score_picture(result, self.picture), made_from, replace=self.replace)
        say(as_json(result) if self.json else as_table(result))
        return 0
