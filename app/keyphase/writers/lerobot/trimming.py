"""Idle ends cut from a LeRobot v3.0 dataset: where episodes and their videos begin and end.

LeRobot shows the frame at `from_timestamp + timestamp` of a video, so that a later beginning needs
no new video.
"""

from collections.abc import Mapping
from typing import Any

from keyphase.writers.lerobot.dataset import EXTRA, Dataset
from keyphase.writers.lerobot.episode import LabeledEpisode
from keyphase.writers.lerobot.metadata import change_episodes
from keyphase.writers.packages import package


def cut_episodes(dataset: Dataset, episodes: Mapping[int, LabeledEpisode]) -> dict[str, int]:
    """Write lengths, indices and video times of all episodes anew; the changes of the info."""
    arrow = package("pyarrow", EXTRA)
    rows = _episode_rows(dataset)
    lengths = {n: _length(episodes.get(n), int(row["length"])) for n, row in rows.items()}
    begins: dict[int, int] = {}
    total = 0
    for number in sorted(rows):
        begins[number] = total
        total += lengths[number]
    ends = {number: begins[number] + lengths[number] for number in rows}
    whole, seconds = arrow.int64(), arrow.float64()
    changes: dict[str, tuple[Any, Mapping[int, Any]]] = {
        "length": (whole, lengths),
        "dataset_from_index": (whole, begins),
        "dataset_to_index": (whole, ends),
    }
    for name in _video_columns(rows):
        at_end = name.endswith("/to_timestamp")
        changes[name] = (seconds, _moved(rows, episodes, name, at_end))
    change_episodes(dataset, changes)
    return {"total_frames": total}


def _episode_rows(dataset: Dataset) -> dict[int, dict[str, Any]]:
    parquet = package("pyarrow.parquet", EXTRA)
    found = {}
    for file in sorted((dataset.path / "meta" / "episodes").rglob("*.parquet")):
        names = parquet.read_schema(file).names
        wanted = [n for n in names if n in ("episode_index", "length") or n.startswith("videos/")]
        for row in parquet.read_table(file, columns=wanted).to_pylist():
            found[int(row["episode_index"])] = row
    return found


def _length(episode: LabeledEpisode | None, before: int) -> int:
    return before if episode is None else episode.end - episode.begin


def _video_columns(rows: Mapping[int, Mapping[str, Any]]) -> list[str]:
    first = next(iter(rows.values()), {})
    return [n for n in first if n.endswith(("/from_timestamp", "/to_timestamp"))]


def _moved(
    rows: Mapping[int, Mapping[str, Any]],
    episodes: Mapping[int, LabeledEpisode],
    name: str,
    at_end: bool,
) -> dict[int, float]:
    moved = {}
    for number, episode in episodes.items():
        times, before = episode.timestamps, float(rows[number][name])
        if at_end:
            cut = float(times[-1]) - float(times[episode.end - 1])
            moved[number] = before - cut
        else:
            moved[number] = before + float(times[episode.begin]) - float(times[0])
    return moved
