"""What was done to a recording under another name or in another folder, found by its hash.

It is offered, never assumed, and only where the recording is gone from where it was labeled:
whoever renamed a file wants its labels, whoever copied it may not.
"""

import contextlib
import os
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from keyphase.errors import KeyphaseError
from keyphase.files.parts import split_part
from keyphase.files.reading import read_regular
from keyphase.labeling.finished import is_done
from keyphase.labeling.storage.readings import Reading, read_journal
from keyphase.labeling.storage.records import decode, encode
from keyphase.labeling.storage.state_folder import (
    NAME,
    journal_path,
    own_state,
    state_folder,
)
from keyphase.labeling.storage.summary import summarize
from keyphase.readers import fingerprint

FOLDERS = "folders"
"""List of the folders in which this user has labeled, among the user's own state."""

MAX_LOOKED_AT_BYTES = 64 * 1024**2
"""So much of other journals is looked through for one recording."""

MAX_LIST_BYTES = 1024**2


@dataclass(frozen=True)
class Elsewhere:
    """Another journal about the same bytes.

    path   of that journal
    name   of the recording as it was called there
    steps  how many steps it has in force
    done   a person had finished with it
    """

    path: Path
    name: str
    steps: int
    done: bool


def journal_elsewhere(recording: Path, sha256: str, own: Path) -> Elsewhere | None:
    """The journal with most history about the recording's bytes, apart from its `own`.

    Looked for in its folder, the folders around it, and all where this user has labeled.
    """
    readings = list(_about(recording, sha256, own))
    longest = max(readings, key=lambda reading: reading.length, default=None)
    if longest is None:
        return None
    history = longest.state.history
    done = is_done(history, done_before=longest.state.done_before)
    return Elsewhere(longest.path, _name(longest), len(history.done), done)


def edits_elsewhere(recording: Path) -> Elsewhere | None:
    """The same for a recording that is not open; None where it has edits of its own.

    Raises KeyphaseError where the recording cannot be read.
    """
    if summarize(recording).touched:
        return None
    own = journal_path(recording, state_folder(recording.parent, create=False).path)
    return journal_elsewhere(recording, fingerprint(recording), own)


def remember_folder(recordings: Path) -> None:
    """Keep in mind that recordings of a folder are labeled; without that less is found later."""
    folder = os.path.realpath(recordings)
    path = own_state() / FOLDERS
    with contextlib.suppress(OSError, ValueError):
        if folder in _folders(path):
            return
        path.parent.mkdir(parents=True, exist_ok=True)
        with path.open("ab") as file:
            # A line that a kill cut off must not spoil the next.
            file.write(b"\n" + encode({"folder": folder}))


def _about(recording: Path, sha256: str, own: Path) -> Iterator[Reading]:
    """Journals with steps that are about these bytes; a damaged one is passed over."""
    left, known = MAX_LOOKED_AT_BYTES, sha256.encode()
    for path, folder in _journals(recording.parent):
        if path == own:
            continue
        with contextlib.suppress(KeyphaseError, OSError, ValueError):
            data = read_regular(path, left)
            left -= len(data)
            if known not in data:
                continue
            reading = read_journal(path)
            is_about = reading.state.sha256 == sha256 and reading.state.history.steps
            # Of a copy the labels stay with what was copied.
            labeled, _ = split_part(folder / _name(reading))
            if is_about and not os.path.lexists(labeled):
                yield reading
        if left <= 0:
            return


def _journals(folder: Path) -> Iterator[tuple[Path, Path]]:
    """Journals, each with the folder its recording was in."""
    for state, recordings in dict.fromkeys(_places(folder)):
        with contextlib.suppress(OSError):
            yield from ((path, recordings) for path in sorted(state.glob("*.journal")))


def _places(folder: Path) -> Iterator[tuple[Path, Path]]:
    """State folders with their folders of recordings, the likeliest first."""
    yield from _of(folder)
    yield from _of(folder.parent)
    for around in (folder, folder.parent):
        with contextlib.suppress(OSError):
            for entry in sorted(os.scandir(around), key=lambda entry: entry.name):
                if entry.is_dir() and entry.name != NAME:
                    yield from _of(Path(entry.path))
    for known in _folders(own_state() / FOLDERS):
        yield from _of(Path(known))


def _of(folder: Path) -> tuple[tuple[Path, Path], ...]:
    state = state_folder(folder, create=False)
    return (state.path, folder), (state.other, folder)


def _folders(path: Path) -> list[str]:
    with contextlib.suppress(OSError):
        records = decode(read_regular(path, MAX_LIST_BYTES)).records
        return [str(record["folder"]) for record in records if "folder" in record]
    return []


def _name(reading: Reading) -> str:
    return reading.state.name or reading.path.stem
