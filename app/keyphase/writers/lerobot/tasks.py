"""The plainest form that every LeRobot version reads: each frame's task is its segment's name."""

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from keyphase.writers.carried import Carried
from keyphase.writers.copies import copy_of
from keyphase.writers.lerobot.dataset import EXTRA, Dataset, damage_told, opened, rewrite
from keyphase.writers.lerobot.episode import (
    LabeledEpisode,
    episode_number,
    labeled_episode,
    require_episode,
)
from keyphase.writers.lerobot.metadata import (
    EPISODES_V2,
    add_tasks,
    change_episodes,
    json_lines,
    write_json_lines,
)
from keyphase.writers.packages import package
from keyphase.writers.writer import Items, Options, Writer


def _write(items: Items, target: Path, _options: Options) -> tuple[Path, ...]:
    package("pyarrow", EXTRA)
    with copy_of(items[0].container, target) as working, damage_told(items[0].container):
        dataset = opened(working)
        episodes = {
            episode_number(item.recording): labeled_episode(
                item, dataset.timestamps(episode_number(item.recording)), trim=False
            )
            for item in items
        }
        names = dict.fromkeys(span.name for one in episodes.values() for span in one.spans)
        numbers = add_tasks(dataset, list(names))
        for file in dataset.data_files():
            rewrite(file, lambda table: _with_tasks(table, episodes, numbers))
        _name_tasks_of_episodes(dataset, episodes)
        dataset.write_info(total_tasks=len(numbers))
    return (target,)


def _with_tasks(
    table: Any, episodes: Mapping[int, LabeledEpisode], numbers: Mapping[str, int]
) -> Any:
    arrow = package("pyarrow", EXTRA)
    of_rows, frames = (table[name].to_numpy() for name in ("episode_index", "frame_index"))
    tasks = table["task_index"].to_numpy().copy()
    for number in np.unique(of_rows).tolist():
        episode = episodes.get(number)
        for span in episode.spans if episode else ():
            inside = (of_rows == number) & (frames >= span.first) & (frames <= span.last)
            tasks[inside] = numbers[span.name]
    at = table.column_names.index("task_index")
    return table.set_column(at, "task_index", arrow.array(tasks, table["task_index"].type))


def _name_tasks_of_episodes(dataset: Dataset, episodes: Mapping[int, LabeledEpisode]) -> None:
    named = {n: list(dict.fromkeys(s.name for s in one.spans)) for n, one in episodes.items()}
    if dataset.is_v3:
        arrow = package("pyarrow", EXTRA)
        change_episodes(dataset, {"tasks": (arrow.list_(arrow.string()), named)})
        return
    path = dataset.path / EPISODES_V2
    lines = json_lines(path)
    write_json_lines(
        path,
        [{**one, "tasks": named.get(one["episode_index"], one.get("tasks"))} for one in lines],
    )


LEROBOT_TASKS = Writer(
    name="lerobot-tasks",
    title="LeRobot dataset whose frames' tasks are the segments",
    ending="",
    extra=EXTRA,
    carries=frozenset({Carried.NAMES, Carried.SIGNALS}),
    write=_write,
    reads_back=(
        "import pyarrow.parquet as parquet\n"
        'tasks = parquet.read_table("PATH/meta/tasks.parquet").to_pydict()\n'
        'print(tasks, parquet.read_table("PATH/data")["task_index"].to_pylist())'
    ),
    one_for="container",
    copies=True,
    requires=require_episode,
    module="pyarrow",
    remarks=(
        "times are those of frames; a segment shorter than a frame is left out",
        "the task that the labelled frames had before is no longer theirs",
    ),
)
