"""Segmenting many recordings at once and writing a segment file for each."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from time import perf_counter

from keyphase.batch.backends import Backend, running_on
from keyphase.batch.manifest import Manifest, known_by, settings_hash
from keyphase.batch.running import in_groups, one_by_one
from keyphase.batch.tasks import (
    BatchReport,
    Refusal,
    Written,
    report_of,
    shard_of,
    tasks_of,
)
from keyphase.demonstration import Demonstration
from keyphase.errors import KeyphaseError, SegmentFileError
from keyphase.jobs import require_jobs
from keyphase.readers import find_recordings
from keyphase.segmentation.parameters import Parameters, checked_for_variant


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
    replace: bool = False,
    progress: Callable[[int, int], None] | None = None,
) -> BatchReport:
    """Segment recordings and write a segment file for each below `output`.

    `paths` are files, datasets, and folders that are searched. A segment file is named by its
    recording's path relative to the folder given, or by the file's own name, without suffix. `jobs`
    run at once, -1 on all cores, or on a cluster (`backend`, `address`); of sixteen machines the
    third does `shard` 3/16. What an earlier run has done is left as it is, unless `again`.
    A file in the way that keyphase did not write as it is refuses its recording, unless `replace`.
    `progress` is told how many are done and how many there are. A recording that is refused is
    reported and the others go on.

    Raises SegmentFileError before any work where two recordings would be written to one file,
    ParameterError for what no parameter can be, and KeyphaseError where no recording is found.
    """
    require_jobs(jobs)
    tasks = shard_of(_found(paths, output, recipe), shard)
    chosen = checked_for_variant(parameters or Parameters())
    manifest = Manifest(output, settings_hash(chosen, recipe, csv))
    kept = () if again else (task for task in tasks if manifest.holds(task))
    became: dict[Written, Written | Refusal] = {task: _before(task) for task in kept}
    todo = [task for task in tasks if task not in became]
    tell = progress or (lambda _done, _total: None)
    tell(len(became), len(tasks))
    with running_on(backend, address):
        do = partial(_segment_one, _How(recipe, chosen, csv, replace))
        results = _results(do, todo, jobs, backend)
        for task, result in zip(todo, _kept(results, manifest), strict=True):
            became[task] = result
            tell(len(became), len(tasks))
    return report_of([became[task] for task in tasks])


def _results(
    do: Callable[[Written], Written | Refusal], todo: list[Written], jobs: int, backend: Backend
) -> Iterator[Written | Refusal]:
    return in_groups(do, todo, jobs) if backend == "ray" else one_by_one(do, todo, jobs, _ended)


def _kept(results: Iterator[Written | Refusal], manifest: Manifest) -> Iterator[Written | Refusal]:
    """The results, each written down as it comes."""
    try:
        for result in results:
            manifest.keep(result) if isinstance(result, Written) else manifest.keep_refusal(result)
            yield result
    finally:
        manifest.sync()


def _found(paths: Sequence[Path], output: Path, recipe: Path | None) -> list[Written]:
    tasks = tasks_of(find_recordings(paths, recipe), output)
    if not tasks:
        raise KeyphaseError(
            f"Expected recordings in {', '.join(map(str, paths))}, but found none; name files, or "
            "give a recipe for tables that are not in keyphase's own form."
        )
    return tasks


@dataclass(frozen=True)
class _How:
    recipe: Path | None
    parameters: Parameters
    csv: bool
    replace: bool


def _before(task: Written) -> Written:
    return Written(task.recording, task.segment_file, went_before=True)


def _ended(task: Written) -> Refusal:
    return Refusal(
        task.recording,
        f"{task.recording}: expected a recording that can be read, but the program that read it "
        "ended, as a library does over a damaged file or the system where memory runs out; the "
        "others go on. Copy or export it again.",
    )


def _segment_one(how: _How, task: Written) -> Written | Refusal:
    try:
        return _segmented(task, how)
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


def _made_from(recording: Path, demonstration: Demonstration, how: _How) -> str:
    """With another recipe the same file is another recording: one arm of two, say."""
    source = demonstration.source
    if how.recipe is None or source is None or source.recipe is None:
        return recording.name
    return f"{recording.name} as {Path(source.recipe).name} reads it"


def _segmented(task: Written, how: _How) -> Written:
    from keyphase.labeling.label import label
    from keyphase.labeling.segment_file import segment_file_data
    from keyphase.labeling.storage.written_files import write_unasked
    from keyphase.readers import read
    from keyphase.segmentation import segment

    begun = perf_counter()
    demonstration = read(task.recording, how.recipe)
    labeling = label(segment(demonstration, how.parameters))
    task.segment_file.parent.mkdir(parents=True, exist_ok=True)
    data = segment_file_data(labeling, task.segment_file)
    written = {task.segment_file: data}
    if how.csv:
        csv = task.segment_file.with_suffix(".csv")
        written[csv] = segment_file_data(labeling, csv)
    for path, content in written.items():
        write_unasked(
            path,
            content,
            _made_from(task.recording, demonstration, how),
            SegmentFileError,
            if_there="replace" if how.replace else "ask",
        )
    seconds = perf_counter() - begun
    known = known_by(task, data)
    return replace(task, notices=demonstration.notices, seconds=seconds, known_by=known)
