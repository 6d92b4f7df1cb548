"""Numbers of the segments' colours, such that an edit leaves the other segments' colours alone."""

from collections.abc import Sequence

from keyphase.segmentation.segmentation import Segment, Segmentation

PALETTE_SIZE = 7
"""Colours repeat after this many, so neighbours must differ in the rest of division by it."""


def colors_of(segmentation: Segmentation, segments: Sequence[Segment]) -> tuple[int, ...]:
    """A number for each of `segments`, different from all others.

    The program's own segments are numbered in the order of time, those that move before the
    idle ones. A segment takes the number of the one its middle lies in; one that finds it taken,
    as after a split, gets a new one.
    """
    automatic = segmentation.segments
    ranked = sorted(range(len(automatic)), key=lambda i: automatic[i].idle)
    number = {segment: rank for rank, segment in enumerate(ranked)}
    colors: list[int] = []
    used: set[int] = set()
    home = 0
    for segment in segments:
        middle = 0.5 * (segment.start_s + segment.end_s)
        while home < len(automatic) - 1 and automatic[home].end_s <= middle:
            home += 1
        color = number[home]
        if color in used:
            color = _new(colors[-1], used, len(automatic))
        used.add(color)
        colors.append(color)
    return tuple(colors)


def _new(neighbour: int, used: set[int], color: int) -> int:
    while color in used or color % PALETTE_SIZE == neighbour % PALETTE_SIZE:
        color += 1
    return color
