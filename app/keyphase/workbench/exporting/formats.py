"""Every format beside the recordings: what it would write, and writing it."""

import itertools
import os
from collections.abc import Iterator, Sequence
from dataclasses import replace
from pathlib import Path

from keyphase.labeling.labeling import Labeling
from keyphase.readers.finding import EXPORTS_FOLDER
from keyphase.workbench.exporting.beside import Beside
from keyphase.writers import (
    Offer,
    Options,
    SegmentedRecording,
    Writer,
    offers,
    planned_export,
    writer_named,
)


def offered(labeling: Labeling, recording: Path) -> tuple[Offer, ...]:
    """What can be written of a recording, beside it or, copies of it, in a folder of their own.

    Raises SegmentFileError where the recording was never saved.
    """
    folder = Beside(recording).folder
    return offers(labeling, folder, folder / EXPORTS_FOLDER)


def write_in(to: str, items: Sequence[SegmentedRecording], options: Options) -> Iterator[Path]:
    """Write recordings, of one file or dataset where the format is a copy of it; where each is now.

    Raises FileInTheWayError where something else is there, unless the options say what becomes of
    it; ExportError and MissingPackageError where it cannot be written.
    """
    writer, first = writer_named(to), items[0]
    folder = Beside(first.recording).folder
    if writer.one_for == "container":
        folder = folder / EXPORTS_FOLDER / writer.name
    if writer.copies and options.if_there == "keep both":
        folder, options = _free(writer, first, folder), replace(options, if_there="ask")
    for paths in planned_export(items, to, folder, options).write():
        yield paths[0]


def _free(writer: Writer, item: SegmentedRecording, folder: Path) -> Path:
    """Where the copy has room beside an earlier one: another folder, or a file's name."""
    if not os.path.lexists(writer.target(item, folder)):
        return folder
    numbers = itertools.count(2)
    if writer.one_for == "container":
        folders = (folder.with_name(f"{folder.name}_{number}") for number in numbers)
        return next(one for one in folders if not os.path.lexists(writer.target(item, one)))
    files = (folder / f"{item.name}_{number}{writer.ending}" for number in numbers)
    return next(one for one in files if not os.path.lexists(one))
