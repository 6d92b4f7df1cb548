"""The command `keyphase propose`: boundaries and names from finished recordings for the others."""

import json
import sys
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import tyro

from keyphase.errors import KeyphaseError

if TYPE_CHECKING:
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
        proposed = propose_all(taught, [one.path for one in others], self.recipe)
        in_the_way = self._write(others, proposed)
        if self.report:
            values = [_values(result) for result in proposed]
            put(self.report, json.dumps(values, indent=1).encode(), made_from, replace=self.replace)
        for line in in_the_way:
            print(line, file=sys.stderr)
        return max(_tell(taught, proposed), 1 if in_the_way else 0)

    def _write(self, found: "list[Found]", proposed: "list[Proposed]") -> list[str]:
        """The segment files; those that were in the way stay, and are told."""
        from keyphase.commands.putting import put
        from keyphase.errors import FileInTheWayError, SegmentFileError
        from keyphase.files.parts import stem_of
        from keyphase.labeling.segment_file import SUFFIX, segment_file_data

        in_the_way = []
        for one, result in zip(found, proposed, strict=True):
            if result.labeling is None:
                continue
            target = self.output / one.relative.with_name(stem_of(one.relative) + SUFFIX)
            target.parent.mkdir(parents=True, exist_ok=True)
            data, name = segment_file_data(result.labeling, target), one.path.name
            try:
                put(target, data, name, replace=self.replace, refusal=SegmentFileError)
            except FileInTheWayError as error:
                in_the_way.append(str(error))
        return in_the_way

    def _taught(self, recordings: list[Path]) -> "tuple[list[Taught], set[Path]]":
        """What is learnt from, and the recordings it was learnt on."""
        from keyphase.transfer.folder import taught_in_files, taught_in_folder

        if self.taught:
            taught = taught_in_files(self.taught, self.recipe)
            sources = [one.demonstration.source for one in taught]
            return taught, {source.path.resolve() for source in sources if source is not None}
        done = taught_in_folder(recordings, self.recipe)
        return list(done.values()), {path.resolve() for path in done}


def _tell(taught: "list[Taught]", proposed: "list[Proposed]") -> int:
    fitting = [one for one in proposed if one.labeling is not None]
    print(f"Learnt from {', '.join(one.name for one in taught)}.")
    for one in fitting:
        if one.transfer is not None:
            least = min((b.confidence for b in one.transfer.boundaries), default=1.0)
            count = len(one.transfer.phases)
            print(f"{one.recording}: {count} phases, least confidence {least:.2f}")
    for one in proposed:
        if one.refusal:
            print(f"{one.recording}: cannot be read: {one.refusal}", file=sys.stderr)
        elif one.labeling is None and one.transfer is not None:
            print(
                f"{one.recording}: fits none of them (cost {one.transfer.cost:.2f}); "
                "nothing is proposed",
                file=sys.stderr,
            )
    return 0 if len(fitting) == len(proposed) else 1


def _values(proposed: "Proposed") -> dict[str, Any]:
    """For JSON."""
    transfer = proposed.transfer
    if transfer is None:
        return {"recording": str(proposed.recording), "refused": proposed.refusal}
    return {
        "recording": str(proposed.recording),
        "outlier": transfer.outlier,
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
