"""Writing segments in a format: what would be written and lost, then the writing."""

import os
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

from keyphase.errors import ExportError, FileInTheWayError, KeyphaseError
from keyphase.writers.carried import left_behind
from keyphase.writers.registry import writer_named
from keyphase.writers.segmented import SegmentedRecording
from keyphase.writers.writer import Options, Writer

_NO_OPTIONS = Options()


@dataclass(frozen=True, eq=False)
class PlannedFile:
    """One file or folder to be written, and the recordings in it."""

    target: Path
    items: tuple[SegmentedRecording, ...]


@dataclass(frozen=True, eq=False)
class PlannedExport:
    """What an export would write.

    not_carried  what of these recordings the format leaves behind
    remarks      what else a person should know
    """

    writer: Writer
    options: Options
    files: tuple[PlannedFile, ...]
    not_carried: tuple[str, ...]
    remarks: tuple[str, ...]

    def write(self) -> Iterator[tuple[Path, ...]]:
        """Write one after another; the paths of each as it is done.

        Raises FileInTheWayError where something is at a target that keyphase did not write, unless
        the options say what becomes of it; ExportError where the format cannot hold the recordings;
        MissingPackageError where its package is not installed.
        """
        for file in self.files:
            self._require_free(file)
        for file in self.files:
            yield self._write(file)

    def write_each(self) -> Iterator[tuple[Path, ...] | KeyphaseError]:
        """As `write`, but one that is refused costs no other its file: its refusal is given."""
        for file in self.files:
            try:
                self._require_free(file)
                yield self._write(file)
            except KeyphaseError as error:
                yield error

    def _require_free(self, file: PlannedFile) -> None:
        refuse_in_place(file)
        if self.writer.copies and self.options.if_there != "replace":
            _refuse_replacing(file.target)

    def _write(self, file: PlannedFile) -> tuple[Path, ...]:
        _make_folder(file.target.parent)
        return self.writer.write(file.items, file.target, self.options)


def planned_export(
    items: Sequence[SegmentedRecording],
    to: str,
    output: Path,
    options: Options = _NO_OPTIONS,
) -> PlannedExport:
    """What writing the recordings in the format `to` would write.

    `output` is a folder; where one file comes of it, it may be that file's path, with its ending.
    Recordings of one dataset or file come together where the format is a copy of it. Raises
    ExportError for no recordings, an unknown format, or two recordings for one file.
    """
    writer = writer_named(to)
    if not items:
        raise ExportError("Expected segment files to export, but there are none; segment first.")
    if options.trim_idle and not writer.trims:
        raise ExportError(f"{writer.title} holds all of the time; leave out trimming of idle ends.")
    for item in items:
        writer.requires(item)
    files = _files(writer, items, output)
    remarks = dict.fromkeys((*writer.remarks, *writer.warn(items, options)))
    lost = left_behind(writer.carries, items)
    return PlannedExport(writer, options, files, lost, tuple(remarks))


def _files(
    writer: Writer, items: Sequence[SegmentedRecording], output: Path
) -> tuple[PlannedFile, ...]:
    if len(items) == 1 and writer.ending and output.name.endswith(writer.ending):
        return (PlannedFile(output, tuple(items)),)
    together: dict[str, list[SegmentedRecording]] = {}
    for item in items:
        together.setdefault(os.path.normcase(writer.target(item, output)), []).append(item)
    for group in together.values():
        _refuse_two_for_one(writer, group, output)
    return tuple(
        PlannedFile(writer.target(group[0], output), tuple(group)) for group in together.values()
    )


def _refuse_two_for_one(writer: Writer, group: list[SegmentedRecording], output: Path) -> None:
    """One file holds one recording, or recordings of one file, each once."""
    seen: dict[object, SegmentedRecording] = {}
    for item in group:
        key = item.part if writer.one_for == "container" else None
        other = seen.setdefault(key, item)
        if other is not item or not _same_file(item.container, group[0].container):
            raise ExportError(
                f"{group[0].file.path} and {item.file.path} would both be written to "
                f"{writer.target(item, output)}; export them into different folders."
            )


def _same_file(one: Path, other: Path) -> bool:
    return os.path.realpath(one) == os.path.realpath(other)


def refuse_in_place(file: PlannedFile) -> None:
    """Raise ExportError where the target is a recording, or holds or lies in one."""
    target = Path(os.path.realpath(file.target))
    for item in file.items:
        recorded = Path(os.path.realpath(item.container))
        if target == recorded or recorded in target.parents or target in recorded.parents:
            raise ExportError(
                f"{file.target}: a recording is never modified; choose another folder for --output."
            )


def _refuse_replacing(target: Path) -> None:
    if os.path.lexists(target):
        raise FileInTheWayError(target, "a copy is never written over unasked")


def _make_folder(folder: Path) -> None:
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise ExportError(
            f"{folder}: the folder cannot be made ({error.strerror}); choose another one."
        ) from error
