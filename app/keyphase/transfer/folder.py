"""The recordings of a folder: which are finished and teach, and what is proposed for the others."""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from keyphase.errors import KeyphaseError, LabelingError
from keyphase.jobs import require_jobs
from keyphase.labeling.label import label
from keyphase.labeling.labeling import Labeling
from keyphase.labeling.segment_file import SegmentFile, read_segment_file
from keyphase.labeling.storage.journal import Journal
from keyphase.labeling.tasks.task import TaskPhase
from keyphase.readers import read
from keyphase.segmentation import segment
from keyphase.segmentation.parameters import Parameters
from keyphase.transfer.as_edit import as_edit
from keyphase.transfer.proposing import Transfer, propose, usual_cost_of
from keyphase.transfer.taught import Taught, taught_by, taught_by_file

WORTH_PROCESSES = 20
"""For fewer recordings no other processes are started: that takes longer than they do."""


@dataclass(frozen=True, eq=False)
class Proposed:
    """What is proposed for one recording, or why nothing is."""

    recording: Path
    transfer: Transfer | None
    labeling: Labeling | None
    refusal: str = ""


def taught_in_files(files: Iterable[Path], recipe: Path | None = None) -> list[Taught]:
    """What segment files teach, each with the recording it is about.

    Raises SegmentFileError and DemonstrationError for what cannot be read.
    """
    found = []
    for path in files:
        file: SegmentFile = read_segment_file(path)
        found.append(taught_by_file(file, read(file.recording, recipe)))
    return found


def taught_in_folder(recordings: Iterable[Path], recipe: Path | None = None) -> dict[Path, Taught]:
    """What the finished recordings among these teach, by their journals, opened for looking."""
    found: dict[Path, Taught] = {}
    for path in recordings:
        demonstration = read(path, recipe)
        with Journal(demonstration, Parameters(), read_only=True) as journal:
            document = journal.document
        if document.done:
            made = segment(demonstration, document.parameters)
            found[path] = taught_by(label(made, document.edits))
    return found


def propose_all(
    taught: Sequence[Taught],
    recordings: Sequence[Path],
    recipe: Path | None = None,
    jobs: int = -1,
    phases: Sequence[TaskPhase] = (),
) -> Iterator[Proposed]:
    """A proposal for each recording in its order, as soon as it is there.

    One that cannot be read, or is an outlier, stops nothing. `jobs` processes work at once (-1: as
    many as there are cores; few recordings are not worth starting any); the outcome is the same.

    Raises LabelingError where nothing was taught, ParameterError for no processes.
    """
    from joblib import Parallel, delayed

    if not taught:
        raise LabelingError(
            "Expected a finished recording to learn from, but there is none; mark one as done in "
            "the page, or name its segment file with --from."
        )
    require_jobs(jobs)
    usual = usual_cost_of(taught)
    calls = (delayed(_proposed)(taught, path, recipe, usual, phases) for path in recordings)
    at_once = jobs if len(recordings) >= WORTH_PROCESSES else 1
    running: Any = Parallel(n_jobs=at_once, return_as="generator")(calls)
    return iter(running)


def _proposed(
    taught: Sequence[Taught],
    path: Path,
    recipe: Path | None,
    usual: float | None,
    phases: Sequence[TaskPhase],
) -> Proposed:
    try:
        demonstration = read(path, recipe)
        segmentation = segment(demonstration)
    except KeyphaseError as error:
        return Proposed(path, None, None, str(error))
    transfer = propose(taught, demonstration, segmentation, usual_cost=usual, phases=phases)
    if transfer.outlier:
        return Proposed(path, transfer, None)
    return Proposed(path, transfer, label(segmentation, {0: as_edit(transfer, segmentation)}))
