"""Segmenting many recordings at once and writing a segment file for each."""

import os
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from keyphase.errors import KeyphaseError, ParameterError, SegmentFileError
from keyphase.files.parts import stem_of
from keyphase.labeling.segment_file import SUFFIX
from keyphase.readers import Found, find_recordings
from keyphase.segmentation.parameters import Parameters


@dataclass(frozen=True)
class Written:
    """A recording and the segment file that was written for it."""

    recording: Path
    segment_file: Path


@dataclass(frozen=True)
class Refusal:
    """A recording that was refused, and why."""

    path: Path
    reason: str


@dataclass(frozen=True)
class BatchReport:
    """What became of the recordings, each list in the order they were found."""

    written: tuple[Written, ...]
    refused: tuple[Refusal, ...]


def segment_all(
    paths: Sequence[Path],
    output: Path,
    *,
    recipe: Path | None = None,
    parameters: Parameters | None = None,
    csv: bool = False,
    jobs: int = -1,
    progress: Callable[[int, int], None] | None = None,
) -> BatchReport:
    """Segment recordings and write a segment file for each below `output`.

    `paths` are files, and folders that are searched. A segment file is named by its recording's
    path relative to the folder given, or by the file's own name, without suffix. `jobs` run at
    once, -1 on all cores, by joblib, so its `parallel_config` moves them to a cluster. `progress`
    is told how many are done and how many there are. A recording that is refused is reported and
    the others go on.

    Raises SegmentFileError before any work where two recordings would be written to one file,
    ParameterError for no jobs, and KeyphaseError where no recording is found.
    """
    from joblib import Parallel, delayed

    if jobs == 0:
        raise ParameterError("jobs must be a number of processes or -1 for all cores, but is 0.")
    tasks = _tasks(find_recordings(paths, recipe), output)
    if not tasks:
        raise KeyphaseError(
            f"Expected recordings in {', '.join(map(str, paths))}, but found none; name files, or "
            "give a recipe for tables that are not in keyphase's own form."
        )
    segmenting = delayed(_segment_one)
    todo = [segmenting(task, recipe, parameters or Parameters(), csv) for task in tasks]
    results: list[Written | Refusal] = []
    if progress:
        progress(0, len(tasks))
    running: Any = Parallel(n_jobs=jobs, return_as="generator")(todo)
    for result in running:
        results.append(result)
        if progress:
            progress(len(results), len(tasks))
    return BatchReport(
        tuple(result for result in results if isinstance(result, Written)),
        tuple(result for result in results if isinstance(result, Refusal)),
    )


def _tasks(found: Iterable[Found], output: Path) -> list[Written]:
    """What is to be written where; two recordings for one file are refused."""
    tasks: dict[str, Written] = {}
    for recording, relative in found:
        target = output / relative.with_name(stem_of(relative) + SUFFIX)
        other = tasks.setdefault(os.path.normcase(target), Written(recording, target))
        if other.recording != recording:
            raise SegmentFileError(
                f"{other.recording} and {recording} would both be written to {target}; segment "
                "them into different folders."
            )
    return list(tasks.values())


def _segment_one(
    task: Written, recipe: Path | None, parameters: Parameters, csv: bool
) -> Written | Refusal:
    from keyphase.labeling.label import label
    from keyphase.labeling.segment_file import write_segment_file
    from keyphase.readers import read
    from keyphase.segmentation import segment

    try:
        labeling = label(segment(read(task.recording, recipe), parameters))
        task.segment_file.parent.mkdir(parents=True, exist_ok=True)
        write_segment_file(labeling, task.segment_file)
        if csv:
            write_segment_file(labeling, task.segment_file.with_suffix(".csv"))
    except KeyphaseError as error:
        return Refusal(task.recording, str(error))
    except OSError as error:
        return Refusal(task.recording, f"{error.filename}: {error.strerror}")
    return task
