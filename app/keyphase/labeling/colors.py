"""The colours of segments, and their numbers: an edit leaves the other segments' colours alone."""

from collections.abc import Sequence

from keyphase.segmentation.segmentation import Segment

SEGMENT_COLORS = ("#58A2F2", "#EFB63A", "#26C397", "#CA71B6", "#A7A425", "#8FDDE8", "#B98A63")
"""In the order in which they are given out, the same in light and dark. They repeat, so neighbours
must differ in the rest of division by their count."""


def ranked_colors(automatic: Sequence[Segment]) -> tuple[int, ...]:
    """Numbers of the program's own segments: in the order of time, idle ones after the others."""
    ranked = sorted(range(len(automatic)), key=lambda i: automatic[i].idle)
    number = {segment: rank for rank, segment in enumerate(ranked)}
    return tuple(number[i] for i in range(len(automatic)))


def colors_of(
    known: Sequence[Segment], numbers: Sequence[int], segments: Sequence[Segment]
) -> tuple[int, ...]:
    """A number for each of `segments`, different from all others.

    A segment takes the number of the known one its middle lies in; one that finds it taken, as
    after a split, gets a new one.
    """
    colors: list[int] = []
    used: set[int] = set()
    home = 0
    for segment in segments:
        middle = 0.5 * (segment.start_s + segment.end_s)
        while home < len(known) - 1 and known[home].end_s <= middle:
            home += 1
        color = numbers[home]
        if color in used:
            color = _new(colors[-1], used, max(numbers, default=0) + 1)
        used.add(color)
        colors.append(color)
    return tuple(colors)


def _new(neighbour: int, used: set[int], color: int) -> int:
    while color in used or color % len(SEGMENT_COLORS) == neighbour % len(SEGMENT_COLORS):
        color += 1
    return color
