"""The command `keyphase propose`: boundaries and names from finished recordings for the others."""

import dataclasses
import json
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import tyro

from keyphase.commands.saying import complain, say
from keyphase.errors import KeyphaseError

if TYPE_CHECKING:
    from keyphase.labeling.labeling import Labeling
    from keyphase.labeling.tasks.task import TaskPhase
    from keyphase.readers import Found
    from keyphase.transfer.folder import Proposed
    from keyphase.transfer.taught import Taught


@dataclass(frozen=True)
class Propose:
    """Propose boundaries and names for recordings from those of the same task that are finished.

    0 where something is proposed for all of them, 1 where some are outliers or cannot be read.
    """

    paths: tyro.conf.Positional[tuple[Path, ...]]
    """Recordings, or folders of them; those marked as done in the page are learnt from."""
    output: Path
    """Folder the proposed segment files are written to."""
    taught: Annotated[tuple[Path, ...], tyro.conf.arg(name="from")] = ()
    """Segment files to learn from, instead of what was marked as done."""
    recipe: Path | None = None
    """How to read tables that are not in keyphase's own form (TOML)."""
    report: Path | None = None
    """Write what is proposed, with its confidences (JSON)."""
    jobs: int = -1
    """How many at once; -1 takes all cores."""
    replace: bool = False
    """Replace files in the way that keyphase did not write, or that were changed since."""

    def run(self) -> int:
        """Propose, write, and say which are outliers."""
        from keyphase.commands.putting import put, refuse_in_the_way
        from keyphase.readers import find_recordings
        from keyphase.transfer.folder import propose_all

        made_from = f"the proposals in {self.output}"
        if self.report:
            refuse_in_the_way(self.report, made_from, replace=self.replace)
        found = find_recordings(self.paths, self.recipe)
        if not found:
            raise KeyphaseError(f"Found no recordings in {', '.join(map(str, self.paths))}.")
        taught, known = self._taught([one.path for one in found])
        others = [one for one in found if one.path.resolve() not in known]
        results = propose_all(
            taught, [one.path for one in others], self.recipe, self.jobs, _phases_of(found)
        )
        proposed, in_the_way = self._write(others, results)
        if self.report:
            values = [_values(result) for result in proposed]
            put(self.report, json.dumps(values, indent=1).encode(), made_from, replace=self.replace)
        for line in in_the_way:
            complain(line)
        return max(_tell(taught, proposed), 1 if in_the_way else 0)

    def _write(
        self, found: "list[Found]", results: "Iterator[Proposed]"
    ) -> "tuple[list[Proposed], list[str]]":
        """Write segment files as they come; those that were in the way stay, and are told."""
        from tqdm import tqdm

        proposed, in_the_way = [], []
        with tqdm(total=len(found), unit="recording", disable=None) as bar:
            for one, result in zip(found, results, strict=True):
                bar.update()
                if result.labeling is not None:
                    in_the_way += self._put(one, result.labeling)
                # Two hundred recordings need not be in memory at once.
                proposed.append(dataclasses.replace(result, labeling=None))
        return proposed, in_the_way

    def _put(self, one: "Found", labeling: "Labeling") -> list[str]:
        from keyphase.commands.putting import put
        from keyphase.errors import FileInTheWayError, SegmentFileError
        from keyphase.files.parts import stem_of
        from keyphase.labeling.segment_file import SUFFIX, segment_file_data

        target = self.output / one.relative.with_name(stem_of(one.relative) + SUFFIX)
        target.parent.mkdir(parents=True, exist_ok=True)
        data, name = segment_file_data(labeling, target), one.path.name
        try:
            put(target, data, name, replace=self.replace, refusal=SegmentFileError)
        except FileInTheWayError as error:
            return [str(error)]
        return []

    def _taught(self, recordings: list[Path]) -> "tuple[list[Taught], set[Path]]":
        """What is learnt from, and the recordings it was learnt on."""
        from keyphase.transfer.folder import taught_in_files, taught_in_folder

        if self.taught:
            taught = taught_in_files(self.taught, self.recipe)
            sources = [one.source for one in taught]
            return taught, {source.path.resolve() for source in sources if source is not None}
        done = taught_in_folder(recordings, self.recipe)
        return list(done.values()), {path.resolve() for path in done}


def _phases_of(found: "Iterable[Found]") -> "list[TaskPhase]":
    """Of the tasks of the folders that the recordings lie in."""
    from keyphase.labeling.storage.folder_settings import read_folder_settings

    folders = sorted({one.path.parent for one in found})
    tasks = [task for folder in folders for task in read_folder_settings(folder).tasks]
    return [phase for task in tasks for phase in task.phases]


def _tell(taught: "list[Taught]", proposed: "list[Proposed]") -> int:
    say(f"Learnt from {', '.join(one.name for one in taught)}.")
    transfers = [(one.recording, one.transfer) for one in proposed if one.transfer is not None]
    for recording, transfer in transfers:
        if not transfer.outlier:
            parts = (*transfer.boundaries, *transfer.phases)
            least = min((part.confidence for part in parts), default=1.0)
            say(f"{recording}: {len(transfer.phases)} phases, least confidence {least:.2f}")
        if transfer.differs is not None:
            complain(
                f"{recording}: differs from them: {transfer.differs.told}; look at what is proposed"
            )
    for one in proposed:
        if one.refusal:
            complain(f"{one.recording}: cannot be read: {one.refusal}")
    outliers = [(recording, one.cost) for recording, one in transfers if one.outlier]
    for recording, cost in outliers:
        complain(f"{recording}: fits none of them (cost {cost:.2f}); nothing is proposed")
    return 0 if len(transfers) - len(outliers) == len(proposed) else 1


def _values(proposed: "Proposed") -> dict[str, Any]:
    """For JSON."""
    transfer = proposed.transfer
    if transfer is None:
        return {"recording": str(proposed.recording), "refused": proposed.refusal}
    return {
        "recording": str(proposed.recording),
        "outlier": transfer.outlier,
        "differs": dataclasses.asdict(transfer.differs) if transfer.differs else None,
        "cost": round(transfer.cost, 4),
        "from": list(transfer.teachers),
        "boundaries": [
            {"time_s": round(b.time_s, 6), "confidence": round(b.confidence, 4)}
            for b in transfer.boundaries
        ],
        "phases": [
            {
                "start_s": round(p.start_s, 6),
                "end_s": round(p.end_s, 6),
                "name": p.name,
                "confidence": round(p.confidence, 4),
            }
            for p in transfer.phases
        ],
    }
