"""`keyphase agree`: how well two people agree about a folder of recordings."""

import json
from dataclasses import dataclass
from pathlib import Path

import tyro

from keyphase.commands.saying import complain, say


@dataclass(frozen=True)
class AgreeSegments:
    """Compare two people's segment files of the same recordings.

    0 where all could be compared, 1 where some could not.
    """

    first: tyro.conf.Positional[Path]
    """A folder of segment files."""
    second: tyro.conf.Positional[Path]
    """Another person's, with the same names."""
    tolerance: float = 0.25
    """How far apart two boundaries may lie and still be the same [s]."""
    disagreements: bool = False
    """Print only where they disagree: recording, from, to, and what each has, a row each."""
    json: bool = False
    """Print for machines."""

    def run(self) -> int:
        """Print F1 of boundaries and agreement of labels per recording, and the disagreements."""
        from keyphase.labeling.comparing.agreement import agreement
        from keyphase.labeling.comparing.agreement_report import (
            agreement_json,
            agreement_table,
            disagreement_rows,
            disagreement_table,
        )

        found = agreement(self.first, self.second, self.tolerance)
        if self.disagreements:
            rows = json.dumps(disagreement_rows(found), indent=1)
            say(rows if self.json else disagreement_table(found))
            for key, why in found.refused:
                complain(f"{key}: not compared: {why}")
        else:
            say(agreement_json(found) if self.json else agreement_table(found))
        return 1 if found.refused else 0
