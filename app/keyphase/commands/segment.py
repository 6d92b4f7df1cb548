"""The command `keyphase segment`: a segment file for each recording, on all cores."""

import sys
from dataclasses import dataclass, field
from pathlib import Path

import tyro

from keyphase.errors import KeyphaseError
from keyphase.segmentation.parameters import Parameters


@dataclass(frozen=True)
class SegmentRecordings:
    """Segment recordings and write a segment file for each."""

    paths: tyro.conf.Positional[tuple[Path, ...]]
    """Recordings or folders of recordings."""
    output: Path
    """Folder the segment files are written to."""
    recipe: Path | None = None
    """How to read tables that are not in keyphase's own form (TOML)."""
    csv: bool = False
    """Write a CSV beside each segment file."""
    jobs: int = -1
    """How many at once; -1 takes all cores."""
    parameters: tyro.conf.OmitArgPrefixes[Parameters] = field(default_factory=Parameters)

    def run(self) -> int:
        """Segment all, then list what was refused."""
        if not self.paths:
            raise KeyphaseError("Name at least one recording or folder to segment.")
        from tqdm import tqdm

        from keyphase.commands.batch import segment_all

        with tqdm(unit="recording", disable=None) as bar:

            def progress(done: int, total: int) -> None:
                bar.total = total
                bar.update(done - bar.n)

            report = segment_all(
                self.paths,
                self.output,
                recipe=self.recipe,
                parameters=self.parameters,
                csv=self.csv,
                jobs=self.jobs,
                progress=progress,
            )
        print(f"{len(report.written)} segment files in {self.output}")
        if report.refused:
            print(f"{len(report.refused)} refused:", file=sys.stderr)
            for refusal in report.refused:
                print(f"  {refusal.reason}", file=sys.stderr)
        return 1 if report.refused or not report.written else 0
