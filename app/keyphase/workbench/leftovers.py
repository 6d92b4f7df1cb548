"""What kills leave behind in folders of recordings: removed where it is nobody's, finished else."""

from collections.abc import Iterable
from pathlib import Path

from keyphase.errors import KeyphaseError
from keyphase.files.leftovers import remove_leftovers
from keyphase.labeling.storage.state_folder import state_folder
from keyphase.simulation.demonstrating.recorder import TAKE_SUFFIX, recover_take


def clear_up(folders: Iterable[Path]) -> tuple[str, ...]:
    """Clear up after kills; what a person should know of it, a sentence each.

    Files that were being written are removed, takes that were being recorded become recordings.
    What cannot be cleared up is told and left, and costs nothing else.
    """
    told: list[str] = []
    for folder in dict.fromkeys(folders):
        state = state_folder(folder, create=False)
        for place in (folder, state.path, state.other):
            removed = remove_leftovers(place)
            if removed:
                files = (
                    "1 file that was" if len(removed) == 1 else f"{len(removed)} files that were"
                )
                told.append(f"{place}: removed {files} being written when keyphase was stopped.")
        told += _takes(folder)
    return tuple(told)


def _takes(folder: Path) -> list[str]:
    told = []
    for take in sorted(folder.glob(f"*{TAKE_SUFFIX}")):
        try:
            told += [
                f"Recovered {one.path} ({one.duration_s:.1f} s)." for one in recover_take(take)
            ]
        except KeyphaseError as error:
            told.append(str(error))
        except OSError as error:
            told.append(f"{take}: it cannot be finished ({error.strerror}); check the folder.")
    return told
