"""What LeRobot keeps about episodes and tasks, in `meta/`, of both versions."""

import json
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from keyphase.errors import ExportError
from keyphase.files.writing import write_whole
from keyphase.writers.lerobot.dataset import EXTRA, Dataset, rewrite
from keyphase.writers.packages import package

TASKS_V3 = "meta/tasks.parquet"
TASKS_V2 = "meta/tasks.jsonl"
EPISODES_V2 = "meta/episodes.jsonl"


def change_episodes(dataset: Dataset, changes: Mapping[str, tuple[Any, Mapping[int, Any]]]) -> None:
    """Set columns of `meta/episodes` (v3.0): for each its Arrow type, and values by episode.

    Where an episode has no value, a column that was there keeps what it had; a new one is null.
    """
    for file in sorted((dataset.path / "meta" / "episodes").rglob("*.parquet")):
        rewrite(file, lambda table: _with_columns(table, changes))


def _with_columns(table: Any, changes: Mapping[str, tuple[Any, Mapping[int, Any]]]) -> Any:
    arrow = package("pyarrow", EXTRA)
    numbers = table["episode_index"].to_pylist()
    for name, (kind, values) in changes.items():
        there = name in table.column_names
        before = table[name].to_pylist() if there else [None] * len(numbers)
        after = [values.get(number, old) for number, old in zip(numbers, before, strict=True)]
        column = arrow.array(after, table[name].type if there else kind)
        if there:
            table = table.set_column(table.column_names.index(name), name, column)
        else:
            table = table.append_column(name, column)
    return table


def add_tasks(dataset: Dataset, names: Sequence[str]) -> dict[str, int]:
    """Number names as tasks of the dataset, after those it has; a name it has keeps its number."""
    return _add_v3(dataset, names) if dataset.is_v3 else _add_v2(dataset, names)


def _add_v3(dataset: Dataset, names: Sequence[str]) -> dict[str, int]:
    arrow = package("pyarrow", EXTRA)
    parquet = package("pyarrow.parquet", EXTRA)
    table = parquet.read_table(dataset.path / TASKS_V3)
    (text,) = [name for name in table.column_names if name != "task_index"]
    before = dict(zip(table[text].to_pylist(), table["task_index"].to_pylist(), strict=True))
    after = _numbered(before, names)
    columns = {text: list(after), "task_index": list(after.values())}
    arrays = [arrow.array(columns[one], table[one].type) for one in table.column_names]
    parquet.write_table(
        arrow.Table.from_arrays(arrays, schema=table.schema), dataset.path / TASKS_V3
    )
    return after


def _add_v2(dataset: Dataset, names: Sequence[str]) -> dict[str, int]:
    lines = json_lines(dataset.path / TASKS_V2)
    after = _numbered({line["task"]: line["task_index"] for line in lines}, names)
    write_json_lines(
        dataset.path / TASKS_V2,
        [{"task_index": number, "task": task} for task, number in after.items()],
    )
    return after


def _numbered(before: Mapping[str, int], names: Sequence[str]) -> dict[str, int]:
    after = dict(before)
    for name in names:
        after.setdefault(name, max(after.values(), default=-1) + 1)
    return after


def json_lines(path: Path) -> list[dict[str, Any]]:
    """The objects in a file that has one on each line."""
    return [json.loads(line) for line in path.read_text("utf-8").splitlines() if line.strip()]


def write_json_lines(path: Path, lines: Sequence[Mapping[str, Any]]) -> None:
    """Write one object a line."""
    text = "".join(json.dumps(line, ensure_ascii=False) + "\n" for line in lines)
    write_whole(path, text.encode(), refusal=ExportError)
