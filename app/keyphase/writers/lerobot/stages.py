"""SARM: stages of each episode, their mean share of time, and the progress that RA-BC weighs by."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from keyphase.writers.lerobot.episode import LabeledEpisode, Span
from keyphase.writers.names import numbered

HEADS = ("sparse", "dense")
"""SARM's two heads: `sparse` are the person's names, `dense` what each segment does."""


@dataclass(frozen=True)
class Stages:
    """The kept segments of an episode as one head of SARM sees them; frames count from 0."""

    names: tuple[str, ...]
    first_frames: tuple[int, ...]
    last_frames: tuple[int, ...]
    start_times: tuple[float, ...]
    end_times: tuple[float, ...]


def stages_of(episode: LabeledEpisode, head: str) -> Stages:
    """The stages; a name that comes again is numbered, for SARM knows stages by name."""
    kept = [span for span in episode.kept if span.last >= episode.begin]
    time = episode.timestamps.astype(np.float64) - float(episode.timestamps[episode.begin])
    if episode.begin == 0:
        time = episode.timestamps.astype(np.float64)
    return Stages(
        numbered([_called(span, head) for span in kept]),
        tuple(span.first - episode.begin for span in kept),
        tuple(span.last - episode.begin for span in kept),
        tuple(float(time[span.first]) for span in kept),
        tuple(float(time[min(span.last + 1, len(time) - 1)]) for span in kept),
    )


def proportions(stages: Iterable[Stages]) -> dict[str, float]:
    """Each stage's share of an episode's kept time, as the mean over the episodes.

    The stages come in the order in which they first appear; the shares add up to one.
    """
    every = [one for one in stages if one.names]
    shares: dict[str, list[float]] = {}
    for one in every:
        lengths = _lengths(one)
        for name, length in zip(one.names, lengths, strict=True):
            shares.setdefault(name, []).append(float(length / lengths.sum()))
    total = sum(sum(share) for share in shares.values())
    return {name: sum(share) / total for name, share in shares.items()}


def progress(stages: Stages, frames: int, shares: Mapping[str, float]) -> NDArray[np.float32]:
    """How far the task is at each frame (T,), from 0 to 1.

    It grows evenly within a stage, by the stage's share among those of this episode, and stands
    still where a segment was dropped. An episode without stages has no progress: NaN.
    """
    if not stages.names:
        return np.full(frames, np.nan, dtype=np.float32)
    weights = np.array([shares[name] for name in stages.names])
    edges = np.concatenate([[0.0], np.cumsum(weights) / weights.sum()])
    frame = np.arange(frames, dtype=np.float64)
    done = np.zeros(frames)
    for i, (first, last) in enumerate(zip(stages.first_frames, stages.last_frames, strict=True)):
        within = np.clip((frame - first + 1) / (last - first + 1), 0.0, 1.0)
        done += within * (edges[i + 1] - edges[i])
    return done.astype(np.float32)


def _called(span: Span, head: str) -> str:
    return span.name if head == "sparse" else span.motion


def _lengths(stages: Stages) -> NDArray[np.float64]:
    first, last = np.array(stages.first_frames), np.array(stages.last_frames)
    return (last - first + 1).astype(np.float64)
