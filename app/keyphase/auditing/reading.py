"""The labels that others left in a recording's own file or dataset."""

from collections.abc import Iterator
from pathlib import Path

from keyphase.auditing.given import GivenLabels, GivenSegment, tiling
from keyphase.auditing.hdf5 import hdf5_labels
from keyphase.auditing.lerobot import Named, lerobot_labels
from keyphase.demonstration import Demonstration
from keyphase.errors import ExportError
from keyphase.files.parts import split_part
from keyphase.readers.formats.known import HDF5, LEROBOT, format_of
from keyphase.writers.clock import zero_s


def given_labels(
    recording: Path | str, demonstration: Demonstration, recipe: Path | None = None
) -> GivenLabels:
    """The labels in a recording's own file, in the clock of `demonstration`.

    Read are LeRobot's language rows, SARM stages, subtask numbers and tasks; REASSEMBLE's
    `segments_info`; words for each step such as FMB's `primitive`; and of any other file the words
    that its recipe reads as events. Where there are several the surest is taken, in that order.

    Raises ExportError where the file has none, or they cannot be read; MissingPackageError where
    the format's package is not installed.
    """
    recording = Path(recording)
    for source, named in _found(recording, demonstration, recipe):
        if named:
            return tiling(demonstration, source, named)
    raise ExportError(
        f"{recording}: expected labels that somebody made in the recording itself, as LeRobot, "
        "REASSEMBLE or a column of words hold them, but there are none; name such a column in a "
        'recipe: events = {column = "primitive"}.'
    )


def _found(recording: Path, demonstration: Demonstration, recipe: Path | None) -> Iterator[Named]:
    form = format_of(split_part(recording)[0])
    if form is LEROBOT:
        yield from lerobot_labels(recording, demonstration)
    elif form is HDF5:
        yield from hdf5_labels(recording, demonstration, zero_s(recording, recipe))
    yield "events", tuple(_events(demonstration))


def _events(demonstration: Demonstration) -> Iterator[GivenSegment]:
    """What was logged in words, each of which holds until the next."""
    events = demonstration.events
    ends = [*(event.time_s for event in events[1:]), demonstration.end_s]
    for event, end_s in zip(events, ends, strict=False):
        if event.text.strip():
            yield GivenSegment(event.time_s, end_s, event.text)
