"""What all recordings of a folder share: the vocabulary, the parameters and the tasks."""

import json
from collections.abc import Callable, Mapping
from dataclasses import asdict, dataclass, field, replace
from pathlib import Path
from typing import Any

from filelock import FileLock, Timeout

from keyphase.errors import JournalError
from keyphase.files.reading import read_regular
from keyphase.files.writing import write_whole
from keyphase.labeling.storage.folder_content import VERSION, folder_content
from keyphase.labeling.storage.folder_json import salvaged, settings_json
from keyphase.labeling.storage.old_files import keep_as_old, put_back
from keyphase.labeling.storage.state_folder import StateFolder, state_folder
from keyphase.labeling.tasks.task import Task
from keyphase.labeling.vocabulary import Vocabulary
from keyphase.segmentation.parameters import Parameters

FILE_NAME = "folder.json"

_LIMIT_BYTES = 4 * 1024**2
_PATIENCE_S = 30.0
_ASK_EVERY_S = 0.01
"""Often, so that of two who write again and again neither waits for long."""


@dataclass(frozen=True)
class FolderSettings:
    """What all recordings of a folder share; `notice` says what could not be read.

    later   written by a later version, and so never written over
    others  what the file holds beside, kept as it is
    """

    vocabulary: Vocabulary = field(default_factory=Vocabulary)
    parameters: Parameters = field(default_factory=Parameters)
    tasks: tuple[Task, ...] = ()
    notice: str | None = None
    later: bool = False
    others: Mapping[str, Any] = field(default_factory=dict)


def read_folder_settings(recordings: Path) -> FolderSettings:
    """The settings of a folder of recordings; the defaults where there are none.

    Of settings that are damaged, or of a later version, what can be read holds, and a notice says
    what could not.
    """
    return _read(state_folder(recordings, create=False).newest(FILE_NAME))


def change_folder_settings(
    recordings: Path, change: Callable[[FolderSettings], FolderSettings]
) -> FolderSettings:
    """Make a change to the settings as they are on disk now, and put them there, whole.

    Several programs change them one after another, none over the other's change. A file of which
    something could not be read is kept as `.old-n` first. Raises JournalError where nothing can be
    written, and for settings of a later version.
    """
    folder = state_folder(recordings)
    try:
        path = folder.path / f"{FILE_NAME}.lock"
        with FileLock(path, timeout=_PATIENCE_S, poll_interval=_ASK_EVERY_S):
            return _changed(folder, change)
    except Timeout as error:
        raise JournalError(
            f"{folder.path / FILE_NAME}: another program has been writing it for {_PATIENCE_S:g} "
            "s, so nothing was changed; try again."
        ) from error
    except OSError as error:
        raise JournalError(
            f"{folder.path / FILE_NAME}: the settings cannot be written ({error.strerror}); check "
            "the folder."
        ) from error


def _changed(
    folder: StateFolder, change: Callable[[FolderSettings], FolderSettings]
) -> FolderSettings:
    before = _read(folder.newest(FILE_NAME))
    path = folder.path / FILE_NAME
    if before.later:
        raise JournalError(
            f"{path}: these settings were written by a later version of keyphase and are left as "
            "they are; update keyphase."
        )
    after = replace(change(before), notice=before.notice)
    old = keep_as_old(path) if before.notice else None
    try:
        write_whole(path, _as_json(after), refusal=JournalError)
    except JournalError:
        if old is not None:
            put_back(old, path)
        raise
    if old is None:
        return after
    return replace(after, notice=f"{before.notice} The file as it was is kept as {old.name}.")


def _read(path: Path | None) -> FolderSettings:
    if path is None:
        return FolderSettings()
    try:
        data = read_regular(path, _LIMIT_BYTES)
    except (OSError, ValueError) as error:
        reason = error.strerror if isinstance(error, OSError) else str(error)
        return FolderSettings(notice=f"The settings in {path} cannot be read ({reason}).")
    damage = None
    try:
        content = settings_json(data)
    except ValueError as error:
        damage, content = str(error), salvaged(data)
    read = folder_content(content)
    notice = _notice(path, read.left_out, damage)
    return FolderSettings(
        read.vocabulary, read.parameters, read.tasks, notice, read.later, read.others
    )


def _notice(path: Path, left_out: tuple[str, ...], damage: str | None) -> str | None:
    if damage is not None:
        return f"The settings in {path} are damaged ({damage}); what is whole in them was kept."
    if not left_out:
        return None
    shown = "; ".join(left_out[:5]) + ("; …" if len(left_out) > 5 else "")
    return f"Of the settings in {path} this could not be read: {shown}."


def _as_json(settings: FolderSettings) -> bytes:
    content = {
        **settings.others,
        "version": VERSION,
        "labels": settings.vocabulary.as_json(),
        "parameters": asdict(settings.parameters),
    }
    if settings.tasks:
        content["phases"] = [phase for task in settings.tasks for phase in task.as_json()]
    return f"{json.dumps(content, indent=1, ensure_ascii=False, allow_nan=False)}\n".encode(
        errors="backslashreplace"
    )
