"""Segmenting many recordings at once and writing a segment file for each."""

from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from time import perf_counter
from typing import Any

from keyphase.batch.backends import Backend, running_on
from keyphase.batch.manifest import Manifest, settings_hash
from keyphase.batch.tasks import (
    BatchReport,
    Refusal,
    Written,
    report_of,
    shard_of,
    tasks_of,
)
from keyphase.errors import KeyphaseError, ParameterError
from keyphase.readers import find_recordings
from keyphase.segmentation.parameters import Parameters


def segment_all(
    paths: Sequence[Path],
    output: Path,
    *,
    recipe: Path | None = None,
    parameters: Parameters | None = None,
    csv: bool = False,
    jobs: int = -1,
    shard: str | None = None,
    backend: Backend = "cores",
    address: str | None = None,
    again: bool = False,
    progress: Callable[[int, int], None] | None = None,
) -> BatchReport:
    """Segment recordings and write a segment file for each below `output`.

    `paths` are files, datasets, and folders that are searched. A segment file is named by its
    recording's path relative to the folder given, or by the file's own name, without suffix. `jobs`
    run at once, -1 on all cores, or on a cluster (`backend`, `address`); of sixteen machines the
    third does `shard` 3/16. What an earlier run has done is left as it is, unless `again`.
    `progress` is told how many are done and how many there are. A recording that is refused is
    reported and the others go on.

    Raises SegmentFileError before any work where two recordings would be written to one file,
    ParameterError for no jobs or no such shard, and KeyphaseError where no recording is found.
    """
    if jobs == 0:
        raise ParameterError("jobs must be a number of processes or -1 for all cores, but is 0.")
    tasks = shard_of(_found(paths, output, recipe), shard)
    chosen = parameters or Parameters()
    manifest = Manifest(output, settings_hash(chosen, recipe, csv))
    became: dict[Written, Written | Refusal] = {}
    if not again:
        became |= {task: _before(task) for task in tasks if manifest.holds(task)}
    todo = [task for task in tasks if task not in became]
    tell = progress or (lambda _done, _total: None)
    tell(len(became), len(tasks))
    with running_on(backend, address):
        for task, result in zip(todo, _results(todo, recipe, chosen, csv, jobs), strict=True):
            became[task] = result
            manifest.keep(result) if isinstance(result, Written) else manifest.keep_refusal(result)
            tell(len(became), len(tasks))
    return report_of([became[task] for task in tasks])


def _found(paths: Sequence[Path], output: Path, recipe: Path | None) -> list[Written]:
    tasks = tasks_of(find_recordings(paths, recipe), output)
    if not tasks:
        raise KeyphaseError(
            f"Expected recordings in {', '.join(map(str, paths))}, but found none; name files, or "
            "give a recipe for tables that are not in keyphase's own form."
        )
    return tasks


def _results(
    todo: Sequence[Written], recipe: Path | None, parameters: Parameters, csv: bool, jobs: int
) -> Iterator[Written | Refusal]:
    """What becomes of each, in order; workers get paths, never arrays."""
    from joblib import Parallel, delayed

    calls = (delayed(_segment_one)(task, recipe, parameters, csv) for task in todo)
    running: Any = Parallel(n_jobs=jobs, return_as="generator")(calls)
    return iter(running)


def _before(task: Written) -> Written:
    return Written(task.recording, task.segment_file, went_before=True)


def _segment_one(
    task: Written, recipe: Path | None, parameters: Parameters, csv: bool
) -> Written | Refusal:
    try:
        return _segmented(task, recipe, parameters, csv)
    except KeyphaseError as error:
        return Refusal(task.recording, str(error))
    except OSError as error:
        return Refusal(task.recording, f"{error.filename}: {error.strerror}")
    except Exception as error:
        return Refusal(
            task.recording,
            f"{task.recording}: something is wrong inside keyphase with this recording "
            f"({error!r}); the others go on. Please report it.",
        )


def _segmented(task: Written, recipe: Path | None, parameters: Parameters, csv: bool) -> Written:
    from keyphase.labeling.label import label
    from keyphase.labeling.segment_file import write_segment_file
    from keyphase.readers import read
    from keyphase.segmentation import segment

    begun = perf_counter()
    demonstration = read(task.recording, recipe)
    labeling = label(segment(demonstration, parameters))
    task.segment_file.parent.mkdir(parents=True, exist_ok=True)
    write_segment_file(labeling, task.segment_file)
    if csv:
        write_segment_file(labeling, task.segment_file.with_suffix(".csv"))
    seconds = perf_counter() - begun
    return Written(task.recording, task.segment_file, demonstration.notices, seconds)
