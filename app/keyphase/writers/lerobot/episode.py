"""The segments of one episode, as frames."""

from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from keyphase.demonstration import Array, Demonstration
from keyphase.errors import ExportError
from keyphase.files.parts import split_part
from keyphase.writers.lerobot.dataset import opened
from keyphase.writers.segmented import SegmentedRecording


@dataclass(frozen=True)
class Span:
    """A segment as frames `first` to `last`, both of them its own.

    name, motion  what a person calls it, and what it does in keyphase's words
    """

    name: str
    motion: str
    kept: bool
    first: int
    last: int


@dataclass(frozen=True, eq=False)
class LabeledEpisode:
    """An episode's segments; together they are all its frames.

    timestamps  (T,) float32, as the dataset has them
    begin, end  frames from the first to behind the last that stay in the dataset
    """

    number: int
    timestamps: NDArray[np.float32]
    spans: tuple[Span, ...]
    begin: int
    end: int

    @property
    def kept(self) -> tuple[Span, ...]:
        """The spans that were not dropped."""
        return tuple(span for span in self.spans if span.kept)


def labeled_episode(
    item: SegmentedRecording, timestamps: NDArray[np.float32], trim: bool
) -> LabeledEpisode:
    """The segments of an episode on its frames; a segment without a frame is left out.

    Raises ExportError where the recording was not read with the dataset's own times.
    """
    number = episode_number(item.recording)
    times = frame_times(item.recording, item.demonstration(), timestamps)
    starts = [segment.start_s for segment in item.segments]
    firsts = np.searchsorted(times, np.array(starts) - 1e-6).tolist()
    firsts[0] = 0
    ends = [*firsts[1:], len(times)]
    spans = tuple(
        Span(segment.label, motion, segment.kept, first, end - 1)
        for segment, motion, first, end in zip(
            item.segments, item.motions, firsts, ends, strict=True
        )
        if end > first
    )
    begin, end = _trimmed(spans) if trim else (0, len(times))
    return LabeledEpisode(number, timestamps, spans, begin, end)


def episode_number(recording: Path) -> int:
    """Which episode of a dataset a recording is. Raises ExportError where it is none."""
    digits = (split_part(recording)[1] or "").removeprefix("episode_")
    if not digits.isdecimal():
        raise ExportError(
            f"{recording}: expected an episode of a LeRobot dataset, such as "
            "dataset#episode_3; choose another format for it."
        )
    return int(digits)


def require_episode(item: SegmentedRecording) -> None:
    """Raise ExportError unless the recording is an episode of a LeRobot dataset."""
    opened(item.container)
    episode_number(item.recording)


def frame_times(
    recording: Path, demonstration: Demonstration, timestamps: NDArray[np.float32]
) -> Array:
    """The time (T,) of each frame of an episode in the clock of its demonstration.

    Raises ExportError where it was not read with the dataset's own times.
    """
    if len(demonstration) == len(timestamps):
        return demonstration.time_s
    times = timestamps.astype(np.float64)
    slack = 0.51 * float(np.median(np.diff(times))) if len(times) > 1 else 0.0
    if times[0] - slack <= demonstration.start_s and demonstration.end_s <= times[-1] + slack:
        return times
    raise ExportError(
        f"{recording}: its segments lie from {demonstration.start_s:g} to "
        f"{demonstration.end_s:g} s, but its frames from {times[0]:g} to {times[-1]:g} s; read it "
        'with time = {column = "timestamp", unit = "s"} and segment it again.'
    )


def _trimmed(spans: tuple[Span, ...]) -> tuple[int, int]:
    kept = [span for span in spans if span.kept] or list(spans)
    return kept[0].first, kept[-1].last + 1
