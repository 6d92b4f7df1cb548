"""Labels in LeRobot datasets: language rows, SARM stages, subtasks, words for each frame, tasks."""

from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from keyphase.auditing.given import GivenSegment, runs
from keyphase.demonstration import Array, Demonstration
from keyphase.readers.formats.lerobot import file_of_episode
from keyphase.writers.lerobot.dataset import EXTRA, Dataset, damage_told, opened
from keyphase.writers.lerobot.episode import episode_number, frame_times
from keyphase.writers.lerobot.metadata import TASKS_V2, TASKS_V3, json_lines
from keyphase.writers.packages import package

Named = tuple[str, tuple[GivenSegment, ...]]

WORDS = ("primitive", "subtask", "skill", "phase", "stage", "language_instruction")
"""Columns of text in which others have named what each frame is part of."""


def lerobot_labels(recording: Path, demonstration: Demonstration) -> Iterator[Named]:
    """What a dataset says of an episode, each with the place it was found in, the surest first."""
    number = episode_number(recording)
    dataset = opened(recording.with_name(recording.name.rpartition("#")[0]))
    with damage_told(dataset.path):
        times = frame_times(recording, demonstration, dataset.timestamps(number))
        table = _frames(dataset, number)
        end = demonstration.end_s
        yield from _language(table, times, end)
        yield from _stages(dataset, number, times, end)
        yield from _numbered(dataset, table, "subtask_index", "meta/subtasks.parquet", times, end)
        for name in WORDS:
            if name in table.column_names and _is_text(table[name]):
                yield f"column {name}", runs(table[name].to_pylist(), times.tolist(), end)
        yield from _numbered(dataset, table, "task_index", _tasks_of(dataset), times, end)


def _frames(dataset: Dataset, number: int) -> Any:
    parquet = package("pyarrow.parquet", EXTRA)
    file = file_of_episode(dataset.path, dataset.info, number)
    return parquet.read_table(file, filters=[("episode_index", "=", number)])


def _language(table: Any, times: Array, end_s: float) -> Iterator[Named]:
    if "language_persistent" not in table.column_names or not table.num_rows:
        return
    stamps = table["timestamp"].to_numpy()
    rows = [r for r in table["language_persistent"][0].as_py() or () if r["style"] == "subtask"]
    rows.sort(key=lambda row: row["timestamp"])
    at = [np.searchsorted(stamps, np.float32(row["timestamp"])) for row in rows]
    starts = [float(times[min(int(i), len(times) - 1)]) for i in at]
    if rows:
        ends = [*starts[1:], end_s]
        names = [str(row["content"]) for row in rows]
        yield "language rows of style subtask", _spans(starts, ends, names)


def _stages(dataset: Dataset, number: int, times: Array, end_s: float) -> Iterator[Named]:
    if not dataset.is_v3:
        return
    row = _episode_row(dataset, number)
    for prefix in ("sparse_", "", "dense_"):
        names = row.get(f"{prefix}subtask_names")
        if not names:
            continue
        firsts, lasts = (row[f"{prefix}subtask_{which}_frames"] for which in ("start", "end"))
        starts = [float(times[min(first, len(times) - 1)]) for first in firsts]
        ends = [float(times[last + 1]) if last + 1 < len(times) else end_s for last in lasts]
        yield f"SARM's {prefix or 'sparse_'}subtask stages", _spans(starts, ends, names)


def _episode_row(dataset: Dataset, number: int) -> Mapping[str, Any]:
    parquet = package("pyarrow.parquet", EXTRA)
    for file in sorted((dataset.path / "meta" / "episodes").rglob("*.parquet")):
        rows = parquet.read_table(file, filters=[("episode_index", "=", number)]).to_pylist()
        if rows:
            return rows[0]
    return {}


def _numbered(
    dataset: Dataset, table: Any, column: str, words: str, times: Array, end_s: float
) -> Iterator[Named]:
    """Numbers of a list of words; one word for all of an episode says nothing about segments."""
    if column not in table.column_names or not (dataset.path / words).is_file():
        return
    names = _words(dataset.path / words, column)
    labels = [names.get(number, "") for number in table[column].to_pylist()]
    if len(set(labels)) > 1:
        yield f"column {column}", runs(labels, times.tolist(), end_s)


def _words(path: Path, column: str) -> dict[int, str]:
    if path.suffix == ".jsonl":
        return {line["task_index"]: line["task"] for line in json_lines(path)}
    table = package("pyarrow.parquet", EXTRA).read_table(path)
    (text,) = [name for name in table.column_names if name != column]
    return dict(zip(table[column].to_pylist(), table[text].to_pylist(), strict=True))


def _tasks_of(dataset: Dataset) -> str:
    return TASKS_V3 if dataset.is_v3 else TASKS_V2


def _is_text(column: Any) -> bool:
    types = package("pyarrow.types", EXTRA)
    return types.is_string(column.type) or types.is_large_string(column.type)


def _spans(
    starts: Sequence[float], ends: Sequence[float], names: Sequence[str]
) -> tuple[GivenSegment, ...]:
    return tuple(GivenSegment(a, b, n) for a, b, n in zip(starts, ends, names, strict=True))
