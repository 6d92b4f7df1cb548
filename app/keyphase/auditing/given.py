"""What others said about a recording: named stretches of time, made to tile it."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from keyphase.demonstration import Demonstration
from keyphase.labeling.comparing.comparison import Outline

UNLABELLED = "unlabelled"
"""What a stretch is called that nobody named."""

MIN_DURATION_S = 1e-3


@dataclass(frozen=True)
class GivenSegment:
    """A stretch with a name, in the demonstration's clock."""

    start_s: float
    end_s: float
    label: str


@dataclass(frozen=True)
class GivenLabels:
    """Segments that tile the recording, and where they were found, for people."""

    source: str
    segments: tuple[GivenSegment, ...]

    @property
    def outline(self) -> Outline:
        """What is compared of them."""
        return Outline(
            tuple(segment.start_s for segment in self.segments[1:]),
            tuple(segment.label for segment in self.segments),
            (self.segments[0].start_s, self.segments[-1].end_s),
        )


def tiling(demonstration: Demonstration, source: str, named: Iterable[GivenSegment]) -> GivenLabels:
    """The stretches in order, cut to the recording; gaps between them are unlabelled.

    Where two overlap the later one begins when it says.
    """
    start, end = demonstration.start_s, demonstration.end_s
    ordered = sorted(named, key=lambda one: one.start_s)
    tiles: list[GivenSegment] = []
    at = start
    for place, one in enumerate(ordered):
        begin = min(max(one.start_s, at), end)
        following = ordered[place + 1].start_s if place + 1 < len(ordered) else end
        stop = min(one.end_s, max(following, begin), end)
        if stop - begin < MIN_DURATION_S:
            continue
        if begin - at >= MIN_DURATION_S:
            tiles.append(GivenSegment(at, begin, UNLABELLED))
        tiles.append(GivenSegment(at if begin - at < MIN_DURATION_S else begin, stop, one.label))
        at = stop
    if end - at >= MIN_DURATION_S or not tiles:
        tiles.append(GivenSegment(at, end, UNLABELLED))
    else:
        tiles[-1] = GivenSegment(tiles[-1].start_s, end, tiles[-1].label)
    return GivenLabels(source, tuple(tiles))


def runs(labels: Sequence[str], times: Sequence[float], end_s: float) -> tuple[GivenSegment, ...]:
    """The stretches over which a label of each sample stays the same; empty ones are left out."""
    begins = [i for i, label in enumerate(labels) if i == 0 or label != labels[i - 1]]
    ends = [*(times[i] for i in begins[1:]), end_s]
    return tuple(
        GivenSegment(times[i], stop, labels[i])
        for i, stop in zip(begins, ends, strict=True)
        if labels[i].strip()
    )
