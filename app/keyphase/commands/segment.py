"""The command `keyphase segment`: a segment file for each recording, on all cores."""

from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING

import tyro

from keyphase.batch.backends import Backend
from keyphase.commands.saying import complain, say
from keyphase.errors import KeyphaseError
from keyphase.segmentation.parameters import Parameters

if TYPE_CHECKING:
    from keyphase.batch.tasks import BatchReport


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
    shard: str | None = None
    """Which part of the recordings, such as 3/16 for the third of sixteen machines."""
    backend: Backend = "cores"
    """Where to run: this machine's cores, or a Dask or Ray cluster."""
    address: str | None = None
    """Address of the cluster's scheduler; without, a cluster of this machine is started."""
    again: bool = False
    """Do again what an earlier run into the same folder has done."""
    replace: bool = False
    """Replace files in the way that keyphase did not write, or that were changed since."""
    report: Path | None = None
    """Write what became of every recording (JSON)."""
    parameters: tyro.conf.OmitArgPrefixes[Parameters] = field(default_factory=Parameters)

    def run(self) -> int:
        """Segment all, then list what was refused."""
        if not self.paths:
            raise KeyphaseError("Name at least one recording or folder to segment.")
        from tqdm import tqdm

        from keyphase.batch.report import report_json
        from keyphase.batch.segmenting import segment_all
        from keyphase.commands.putting import put, refuse_in_the_way

        made_from = f"the report of {self.output}"
        if self.report:
            refuse_in_the_way(self.report, made_from, replace=self.replace)
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
                shard=self.shard,
                backend=self.backend,
                address=self.address,
                again=self.again,
                replace=self.replace,
                progress=progress,
            )
        if self.report:
            put(self.report, report_json(report).encode(), made_from, replace=self.replace)
        return _tell(report, self.output)


def _tell(report: "BatchReport", output: Path) -> int:
    """Print what a person should know; 0 where all went well."""
    from keyphase.batch.report import refusal_lines, report_lines

    before = sum(one.went_before for one in report.written)
    for line in report_lines(report):
        say(line)
    done = f", {before} of them by an earlier run" if before else ""
    say(f"{len(report.written)} segment files in {output}{done}")
    if report.refused:
        complain(f"{len(report.refused)} refused:")
        for line in refusal_lines(report.refused):
            complain(f"  {line}")
    return 1 if report.refused or not report.written else 0
