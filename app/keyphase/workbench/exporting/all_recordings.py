"""All recordings of the list in one format, one after another; of a dataset together."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from keyphase.errors import FileInTheWayError, KeyphaseError
from keyphase.files.parts import split_part
from keyphase.workbench.desks.library import Library
from keyphase.workbench.exporting.beside import InTheWay, same_names, sharing_names
from keyphase.workbench.exporting.formats import write_in
from keyphase.workbench.recordings import Recording
from keyphase.workbench.tasks import Tasks
from keyphase.writers import Options, SegmentedRecording, Writer, writer_named


@dataclass(frozen=True)
class Exported:
    """What became of it.

    written     how many recordings were written
    paths       the files or datasets they are in now
    refused     what could not be written, and why
    in_the_way  what was not replaced
    """

    written: int
    paths: tuple[Path, ...]
    refused: tuple[str, ...]
    in_the_way: tuple[InTheWay, ...]


def export_all(
    recordings: Sequence[Recording],
    library: Library,
    tasks: Tasks,
    to: str,
    options: Options,
) -> Exported:
    """Write every recording; one that cannot be costs no other its file.

    Raises ExportError for no such format.
    """
    writer = writer_named(to)
    written, paths = 0, list[Path]()
    refused: list[str] = []
    in_the_way: list[InTheWay] = []
    shared = sharing_names(recording.path for recording in recordings)
    groups = _together(recordings, writer)
    with tasks.begin(f"Writing: {writer.title}") as task:
        for number, group in enumerate(groups):
            task.at(number / len(groups), f"{group[0].name}: writing")
            items: list[SegmentedRecording] = []
            for recording in group:
                try:
                    if recording.path in shared:
                        raise same_names(recording.path, shared[recording.path])
                    items.append(_item(recording, library, held=len(group) == 1))
                except KeyphaseError as error:
                    refused.append(f"{recording.name}: {error}")
            try:
                paths += write_in(to, items, options) if items else ()
                written += len(items)
            except FileInTheWayError as error:
                in_the_way.append(InTheWay.of(error))
            except KeyphaseError as error:
                refused.append(f"{group[0].name}: {error}")
    return Exported(written, tuple(paths), tuple(refused), tuple(in_the_way))


def _together(recordings: Sequence[Recording], writer: Writer) -> list[list[Recording]]:
    groups: dict[Path, list[Recording]] = {}
    for one in recordings:
        is_whole = writer.one_for == "container"
        groups.setdefault(split_part(one.path)[0] if is_whole else one.path, []).append(one)
    return list(groups.values())


def _item(recording: Recording, library: Library, held: bool) -> SegmentedRecording:
    """The demonstration is `held` where it is one of few, so that many need little memory."""
    opened = library.look(recording)
    opened.close()
    item = SegmentedRecording.of_labeling(opened.kept_labeling)
    return item if held else replace(item, held=None)
