"""The LeRobot writer: language columns, SARM stages and RA-BC progress, in a copy."""

import json
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

import numpy as np

from keyphase.errors import ExportError
from keyphase.files.writing import write_whole
from keyphase.writers.carried import Carried
from keyphase.writers.copies import copy_of
from keyphase.writers.lerobot.dataset import EXTRA, Dataset, damage_told, opened, rewrite
from keyphase.writers.lerobot.episode import (
    LabeledEpisode,
    episode_number,
    labeled_episode,
    require_episode,
)
from keyphase.writers.lerobot.frames import Frames
from keyphase.writers.lerobot.language import EVENTS, FEATURE, PERSISTENT
from keyphase.writers.lerobot.metadata import change_episodes
from keyphase.writers.lerobot.stages import HEADS, Stages, progress, proportions, stages_of
from keyphase.writers.lerobot.trimming import cut_episodes
from keyphase.writers.packages import package
from keyphase.writers.writer import Items, Options, Writer

PROGRESS = "sarm_progress.parquet"
"""Where LeRobot looks for the progress that RA-BC weighs frames by."""


def _write(items: Items, target: Path, options: Options) -> tuple[Path, ...]:
    package("pyarrow", EXTRA)
    with copy_of(items[0].container, target) as working, damage_told(items[0].container):
        dataset = opened(working)
        if options.trim_idle and not dataset.is_v3:
            raise ExportError(
                f"{items[0].container}: idle ends are trimmed in LeRobot v3.0, but this is "
                f"{dataset.info.get('codebase_version')}; convert it with lerobot first."
            )
        episodes = {
            episode_number(item.recording): labeled_episode(
                item, dataset.timestamps(episode_number(item.recording)), options.trim_idle
            )
            for item in items
        }
        _write_labels(dataset, episodes)
    return (target,)


def _write_labels(dataset: Dataset, episodes: Mapping[int, LabeledEpisode]) -> None:
    frames = Frames(episodes)
    for file in dataset.data_files():
        rewrite(file, frames.labeled)
    cut = cut_episodes(dataset, episodes) if frames.trims else {}
    stages = {
        head: {number: stages_of(one, head) for number, one in episodes.items()} for head in HEADS
    }
    if dataset.is_v3:
        _write_stages(dataset, stages)
    _write_progress(dataset, stages)
    features = {k: v for k, v in dataset.info["features"].items() if k != "subtask_index"}
    dataset.write_info(features=features | {PERSISTENT: FEATURE, EVENTS: FEATURE}, **cut)


def _write_stages(dataset: Dataset, stages: Mapping[str, Mapping[int, Stages]]) -> None:
    arrow = package("pyarrow", EXTRA)
    times, whole = arrow.list_(arrow.float64()), arrow.list_(arrow.int64())
    columns: dict[str, tuple[Any, dict[int, Any]]] = {}
    for head, of_episodes in stages.items():
        # Before there were two heads the names had no prefix, and LeRobot still reads those.
        for prefix in (f"{head}_", "") if head == "sparse" else (f"{head}_",):
            for field, kind, name in (
                ("names", arrow.list_(arrow.string()), "subtask_names"),
                ("start_times", times, "subtask_start_times"),
                ("end_times", times, "subtask_end_times"),
                ("first_frames", whole, "subtask_start_frames"),
                ("last_frames", whole, "subtask_end_frames"),
            ):
                values = {n: list(getattr(one, field)) for n, one in of_episodes.items()}
                columns[f"{prefix}{name}"] = (kind, values)
        shares = json.dumps(proportions(of_episodes.values()), indent=2, ensure_ascii=False)
        path = dataset.path / "meta" / f"temporal_proportions_{head}.json"
        write_whole(path, shares.encode(), refusal=ExportError)
    change_episodes(dataset, columns)


def _write_progress(dataset: Dataset, stages: Mapping[str, Mapping[int, Stages]]) -> None:
    """One row for each frame of the dataset; frames of unlabelled episodes have no progress."""
    arrow = package("pyarrow", EXTRA)
    parquet = package("pyarrow.parquet", EXTRA)
    names = ["index", "episode_index", "frame_index"]
    tables = [parquet.read_table(file, columns=names) for file in dataset.data_files()]
    table = arrow.concat_tables(tables).select(names)
    numbers, frame = (table[name].to_numpy() for name in names[1:])
    for head, of_episodes in stages.items():
        shares = proportions(of_episodes.values())
        values = np.full(len(numbers), np.nan, dtype=np.float32)
        for number, one in of_episodes.items():
            rows = numbers == number
            values[rows] = progress(one, int(rows.sum()), shares)[frame[rows]]
        table = table.append_column(f"progress_{head}", arrow.array(values))
    parquet.write_table(table, dataset.path / PROGRESS)


def _warn(items: Items, options: Options) -> Iterable[str]:
    for path in sorted({item.container for item in items}):
        dataset = opened(path)
        if not dataset.is_v3:
            yield f"{path.name} is LeRobot v2: it has no place for SARM's stages"
        if options.trim_idle:
            yield (
                "only idle ends are trimmed, and video by where it begins and ends; idle stretches "
                "between kept segments stay"
            )
            yield "the statistics in meta/ are those of all frames; compute them again with lerobot"


LEROBOT = Writer(
    name="lerobot",
    title="LeRobot dataset with language, SARM stages and progress",
    ending="",
    extra=EXTRA,
    carries=frozenset({Carried.NAMES, Carried.MOTIONS, Carried.DROPPED, Carried.SIGNALS}),
    write=_write,
    reads_back=(
        "import pyarrow.parquet as parquet\n"
        'frames = parquet.read_table("PATH/data")\n'
        'print([row["content"] for row in frames["language_persistent"][0].as_py()])'
    ),
    one_for="container",
    copies=True,
    requires=require_episode,
    module="pyarrow",
    remarks=(
        "times are those of frames; a segment shorter than a frame is left out",
        "only SARM's stages and the progress say what is dropped, the language has every segment",
    ),
    warn=_warn,
    trims=True,
)
