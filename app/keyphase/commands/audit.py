"""`keyphase audit`: labels that others made, against what keyphase finds in the same recordings."""

from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING

import tyro

from keyphase.commands.saying import complain, say
from keyphase.errors import KeyphaseError
from keyphase.segmentation.parameters import Parameters

if TYPE_CHECKING:
    from keyphase.auditing import Audited


@dataclass(frozen=True)
class AuditLabels:
    """Compare labels that others left in recordings with what keyphase finds there."""

    paths: tyro.conf.Positional[tuple[Path, ...]]
    """Recordings, datasets, or folders of them."""
    recipe: Path | None = None
    """How to read what no preset knows (TOML)."""
    tolerance_s: float = 0.25
    """So far from each other two boundaries are still one."""
    output: Path | None = None
    """Write the labels, taken over, as segment files into this folder."""
    replace: bool = False
    """Replace files there that keyphase did not write, or that were changed since."""
    json: bool = False
    """Print for machines."""
    parameters: tyro.conf.OmitArgPrefixes[Parameters] = field(default_factory=Parameters)

    def run(self) -> int:
        """Print a line for each recording, those that agree least first."""
        from keyphase.auditing import audit
        from keyphase.auditing.report import as_json, as_table
        from keyphase.readers import find_recordings

        done: list[Audited] = []
        refused = 0
        for found in find_recordings(self.paths, self.recipe):
            try:
                one = audit(found.path, self.recipe, self.parameters, self.tolerance_s)
            except KeyphaseError as error:
                complain(error)
                refused += 1
                continue
            self._write(one)
            done.append(one)
        say(as_json(done) if self.json else as_table(done))
        return 1 if refused or not done else 0

    def _write(self, one: "Audited") -> None:
        if self.output is None:
            return
        from keyphase.writers import Options, SegmentedRecording, planned_export

        item = SegmentedRecording.of_labeling(one.labeling)
        options = Options(if_there="replace" if self.replace else "ask")
        for _ in planned_export([item], "json", self.output, options).write():
            pass
