"""LeRobot datasets of three episodes as LeRobot 0.6 lays them out, without the frames of videos."""

import json
from pathlib import Path

import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq
from segmented_recordings import RATE_HZ, moving

FPS = RATE_HZ
EPISODES = 3

RECIPE = """
time = {column = "timestamp", unit = "s"}
force = {columns = "observation.wrench[*]", unit = "N"}
wrench = {frame = "base", sign = 1}
[position]
columns = ["observation.state.x", "observation.state.y", "observation.state.z"]
unit = "m"
"""


def frames(number: int, begin: int) -> pa.Table:
    """The frames of one episode; `begin` is the index of the first in the dataset."""
    time, position, _, force = moving()
    count = len(time)

    def wide(values):
        flat = pa.array(values.astype(np.float32).ravel())
        return pa.FixedSizeListArray.from_arrays(flat, values.shape[1])

    return pa.table(
        {
            "observation.state": wide(position + 0.01 * number),
            "observation.wrench": wide(force),
            "action": wide(position),
            "timestamp": time.astype(np.float32),
            "frame_index": np.arange(count),
            "episode_index": np.full(count, number),
            "index": np.arange(begin, begin + count),
            "task_index": np.zeros(count, dtype=np.int64),
        }
    )


def dataset(folder: Path, version="v3.0", video=False) -> Path:
    """A dataset in `folder`, with a recipe beside it."""
    path = folder / "demos"
    tables = []
    for number in range(EPISODES):
        tables.append(frames(number, sum(table.num_rows for table in tables)))
    lengths = [table.num_rows for table in tables]
    (path / "meta").mkdir(parents=True)
    (path / "data/chunk-000").mkdir(parents=True)
    _info(path, version, sum(lengths), video)
    if version == "v3.0":
        _v3(path, tables, lengths, video)
    else:
        _v2(path, tables, lengths)
    (folder / "recipe.toml").write_text(RECIPE)
    return path


def _info(path: Path, version: str, total: int, video: bool) -> None:
    names = ["x", "y", "z"]
    features = {
        name: {"dtype": "float32", "shape": [3], "names": names if "state" in name else None}
        for name in ("observation.state", "observation.wrench", "action")
    }
    if video:
        features["observation.images.top"] = {"dtype": "video", "shape": [4, 4, 3], "names": None}
    v3 = version == "v3.0"
    content = {
        "codebase_version": version,
        "fps": FPS,
        "features": features,
        "chunks_size": 1000,
        "total_episodes": EPISODES,
        "total_frames": total,
        "total_tasks": 1,
        "data_path": "data/chunk-{chunk_index:03d}/file-{file_index:03d}.parquet"
        if v3
        else "data/chunk-{episode_chunk:03d}/episode_{episode_index:06d}.parquet",
    }
    (path / "meta/info.json").write_text(json.dumps(content))


def _v3(path: Path, tables: list[pa.Table], lengths: list[int], video: bool) -> None:
    with pq.ParquetWriter(path / "data/chunk-000/file-000.parquet", tables[0].schema) as writer:
        for table in tables:
            writer.write_table(table)
    ends = np.cumsum(lengths)
    rows = {
        "episode_index": np.arange(EPISODES),
        "data/chunk_index": np.zeros(EPISODES, dtype=np.int64),
        "data/file_index": np.zeros(EPISODES, dtype=np.int64),
        "length": lengths,
        "tasks": [["put it in"]] * EPISODES,
        "dataset_from_index": ends - lengths,
        "dataset_to_index": ends,
    }
    if video:
        seconds = np.array(lengths) / FPS
        rows["videos/observation.images.top/from_timestamp"] = np.cumsum(seconds) - seconds
        rows["videos/observation.images.top/to_timestamp"] = np.cumsum(seconds)
    (path / "meta/episodes/chunk-000").mkdir(parents=True)
    pq.write_table(pa.table(rows), path / "meta/episodes/chunk-000/file-000.parquet")
    tasks = pa.table({"task_index": [0], "task": ["put it in"]})
    pq.write_table(tasks, path / "meta/tasks.parquet")


def _v2(path: Path, tables: list[pa.Table], lengths: list[int]) -> None:
    for number, table in enumerate(tables):
        pq.write_table(table, path / f"data/chunk-000/episode_{number:06d}.parquet")
    (path / "meta/tasks.jsonl").write_text('{"task_index": 0, "task": "put it in"}\n')
    lines = [
        json.dumps({"episode_index": n, "tasks": ["put it in"], "length": length})
        for n, length in enumerate(lengths)
    ]
    (path / "meta/episodes.jsonl").write_text("\n".join(lines) + "\n")


def read_frames(path: Path) -> pa.Table:
    """All frames in the order of the files."""
    files = sorted((path / "data").rglob("*.parquet"))
    return pa.concat_tables([pq.read_table(file) for file in files])


def read_episodes(path: Path) -> list[dict]:
    """The rows of meta/episodes (v3.0)."""
    return pq.read_table(path / "meta/episodes/chunk-000/file-000.parquet").to_pylist()
