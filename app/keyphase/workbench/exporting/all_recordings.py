"""Segment files of all recordings of the list, one after another."""

from collections.abc import Sequence
from dataclasses import dataclass

from keyphase.errors import FileInTheWayError, KeyphaseError
from keyphase.labeling.storage.written_files import IfThere
from keyphase.workbench.desks.library import Library
from keyphase.workbench.exporting.beside import InTheWay, same_names, sharing_names
from keyphase.workbench.exporting.segment_files import export
from keyphase.workbench.recordings import Recording
from keyphase.workbench.tasks import Tasks


@dataclass(frozen=True)
class Exported:
    """What became of it: how many were written, what was refused and why, what was in the way."""

    written: int
    refused: tuple[str, ...]
    in_the_way: tuple[InTheWay, ...]


def export_all(
    recordings: Sequence[Recording], library: Library, tasks: Tasks, if_there: IfThere
) -> Exported:
    """Write a segment file for every recording; one that cannot be costs no other its file."""
    written = 0
    refused: list[str] = []
    in_the_way: list[InTheWay] = []
    shared = sharing_names(recording.path for recording in recordings)
    with tasks.begin("Writing segment files") as task:
        for number, recording in enumerate(recordings):
            task.at(number / len(recordings), f"{recording.name}: writing")
            try:
                if recording.path in shared:
                    raise same_names(recording.path, shared[recording.path])
                opened = library.look(recording)
                opened.close()
                export(opened.kept_labeling, recording.path, "json", if_there)
                written += 1
            except FileInTheWayError as error:
                in_the_way.append(InTheWay.of(error))
            except KeyphaseError as error:
                refused.append(f"{recording.name}: {error}")
    return Exported(written, tuple(refused), tuple(in_the_way))
