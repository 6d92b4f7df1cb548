"""What becomes of the frames: columns added, and rows of idle ends cut."""

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from keyphase.writers.lerobot.dataset import EXTRA
from keyphase.writers.lerobot.episode import LabeledEpisode
from keyphase.writers.lerobot.language import (
    EVENTS,
    PERSISTENT,
    Row,
    language_columns,
    persistent_rows,
    shifted,
)
from keyphase.writers.packages import package

_LEFT_OUT = ("subtask_index", PERSISTENT, EVENTS)
"""Columns that say the same in older words, or are written anew."""


class Frames:
    """Changes the frames of a dataset, group after group in their order."""

    def __init__(self, episodes: Mapping[int, LabeledEpisode]) -> None:
        self._episodes = episodes
        self._rows: dict[int, list[Row]] = {n: persistent_rows(e) for n, e in episodes.items()}
        self._next_index = 0
        self.trims = any(e.end - e.begin < len(e.timestamps) for e in episodes.values())

    def labeled(self, table: Any) -> Any:
        """The group with the language columns, without the rows that are cut."""
        table = self._cut(table) if self.trims else table
        left_out = [name for name in _LEFT_OUT if name in table.column_names]
        numbers = table["episode_index"].to_pylist()
        persistent, events = language_columns(numbers, self._rows)
        table = table.drop_columns(left_out) if left_out else table
        return table.append_column(PERSISTENT, persistent).append_column(EVENTS, events)

    def _cut(self, table: Any) -> Any:
        arrow = package("pyarrow", EXTRA)
        numbers, frames = (table[name].to_numpy() for name in ("episode_index", "frame_index"))
        stays, times = self._staying(numbers, frames, table["timestamp"].to_numpy().copy())
        begins = np.array([self._begin(number) for number in numbers.tolist()], dtype=np.int64)
        columns: dict[str, NDArray[Any]] = {
            "frame_index": frames - begins,
            "timestamp": times,
            "index": np.cumsum(stays) - 1 + self._next_index,
        }
        self._next_index += int(stays.sum())
        for name, values in columns.items():
            kind = table[name].type
            at = table.column_names.index(name)
            table = table.set_column(at, name, arrow.array(values).cast(kind))
        return table.filter(arrow.array(stays))

    def _staying(
        self, numbers: NDArray[Any], frames: NDArray[Any], times: NDArray[np.float32]
    ) -> tuple[NDArray[np.bool_], NDArray[np.float32]]:
        """Which rows stay, and the timestamps they then have."""
        stays = np.ones(len(numbers), dtype=bool)
        for number in np.unique(numbers).tolist():
            episode = self._episodes.get(number)
            if episode is None:
                continue
            rows = np.flatnonzero(numbers == number)
            inside = (frames[rows] >= episode.begin) & (frames[rows] < episode.end)
            stays[rows] = inside
            times[rows[inside]] = shifted(episode)[frames[rows[inside]] - episode.begin]
        return stays, times

    def _begin(self, number: int) -> int:
        episode = self._episodes.get(number)
        return episode.begin if episode else 0
