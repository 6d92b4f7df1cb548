"""The language columns of LeRobot: rows that hold from their timestamp until the next of a style.

`subtask` is what a person calls the segment, `motion` what it does. Every frame of an episode has
the same list; timestamps are the dataset's own, bit by bit.
"""

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from keyphase.writers.lerobot.episode import LabeledEpisode
from keyphase.writers.packages import package

PERSISTENT = "language_persistent"
EVENTS = "language_events"
FEATURE = {"dtype": "language", "shape": [1], "names": None}
EXTRA = "lerobot"

Row = dict[str, Any]


def persistent_rows(episode: LabeledEpisode) -> list[Row]:
    """The rows of an episode in LeRobot's order, by timestamp and then by style.

    Where idle ends are cut, timestamps count from the first frame that stays.
    """
    rows = []
    for span in episode.spans:
        if span.last < episode.begin or span.first >= episode.end:
            continue
        at = shifted(episode)[max(span.first, episode.begin) - episode.begin]
        rows += [_row("motion", span.motion, at), _row("subtask", span.name, at)]
    return rows


def shifted(episode: LabeledEpisode) -> Any:
    """Timestamps (float32) of the frames that stay, counted from the first of them."""
    stay = episode.timestamps[episode.begin : episode.end]
    if episode.begin == 0:
        return stay
    return (stay.astype(np.float64) - float(stay[0])).astype(np.float32)


def language_columns(numbers: Sequence[int], rows: Mapping[int, list[Row]]) -> tuple[Any, Any]:
    """Both columns for frames whose episode numbers are given; unlabelled ones have empty lists."""
    arrow = package("pyarrow", EXTRA)
    there = sorted(set(numbers))
    counts = {number: len(rows.get(number, ())) for number in there}
    starts = dict(zip(there, np.cumsum([0, *counts.values()])[:-1].tolist(), strict=True))
    flat = [row for number in there for row in rows.get(number, ())]
    values = _structs(flat, arrow)
    at = np.concatenate(
        [np.arange(starts[n], starts[n] + counts[n]) for n in numbers] or [np.zeros(0)]
    ).astype(np.int64)
    offsets = np.cumsum([0, *(counts[n] for n in numbers)]).astype(np.int32)
    persistent = arrow.ListArray.from_arrays(arrow.array(offsets), values.take(arrow.array(at)))
    nothing = arrow.array(np.zeros(len(numbers) + 1, dtype=np.int32))
    events = arrow.ListArray.from_arrays(nothing, _events(arrow))
    return persistent, events


def _row(style: str, content: str, timestamp: Any) -> Row:
    return {"role": "assistant", "content": content, "style": style, "timestamp": timestamp}


def _structs(rows: Sequence[Row], arrow: Any) -> Any:
    def texts(key: str) -> Any:
        return arrow.array([row[key] for row in rows], arrow.string())

    times = arrow.array(np.array([row["timestamp"] for row in rows], dtype=np.float32))
    columns = {
        "role": texts("role"),
        "content": texts("content"),
        "style": texts("style"),
        "timestamp": times,
        "camera": arrow.nulls(len(rows), arrow.string()),
        "tool_calls": arrow.nulls(len(rows), arrow.list_(arrow.string())),
    }
    return arrow.StructArray.from_arrays(list(columns.values()), list(columns))


def _events(arrow: Any) -> Any:
    kinds = {
        "role": arrow.string(),
        "content": arrow.string(),
        "style": arrow.string(),
        "camera": arrow.string(),
        "tool_calls": arrow.list_(arrow.string()),
    }
    return arrow.array([], arrow.struct(list(kinds.items())))
