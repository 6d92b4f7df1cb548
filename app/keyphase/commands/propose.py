"""The command `keyphase propose`: boundaries and names from finished recordings for the others."""

import json
import sys
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import tyro

from keyphase.errors import KeyphaseError

if TYPE_CHECKING:
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

    def run(self) -> int:
        """Propose, write, and say which are outliers."""
        from keyphase.files.parts import stem_of
        from keyphase.files.writing import write_whole
        from keyphase.labeling.segment_file import SUFFIX, write_segment_file
        from keyphase.readers import find_recordings
        from keyphase.transfer.folder import propose_all

        found = find_recordings(self.paths, self.recipe)
        if not found:
            raise KeyphaseError(f"Found no recordings in {', '.join(map(str, self.paths))}.")
        taught, known = self._taught([one.path for one in found])
        others = [one for one in found if one.path.resolve() not in known]
        proposed = propose_all(taught, [one.path for one in others], self.recipe)
        for one, result in zip(others, proposed, strict=True):
            if result.labeling is not None:
                target = self.output / one.relative.with_name(stem_of(one.relative) + SUFFIX)
                target.parent.mkdir(parents=True, exist_ok=True)
                write_segment_file(result.labeling, target)
        if self.report:
            values = [_values(result) for result in proposed]
            write_whole(self.report, json.dumps(values, indent=1).encode())
        return _tell(taught, proposed)

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
