"""What all recordings of a folder share: the vocabulary and the parameters."""

import json
from collections.abc import Mapping
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import Any

from keyphase.errors import JournalError, KeyphaseError
from keyphase.files.writing import write_whole
from keyphase.labeling.storage.state_folder import state_folder
from keyphase.labeling.vocabulary import Vocabulary, vocabulary_from_json
from keyphase.segmentation.parameters import Parameters

FILE_NAME = "folder.json"
VERSION = 1


@dataclass(frozen=True)
class FolderSettings:
    """What all recordings of a folder share; `notice` says what could not be read."""

    vocabulary: Vocabulary = field(default_factory=Vocabulary)
    parameters: Parameters = field(default_factory=Parameters)
    notice: str | None = None


def read_folder_settings(recordings: Path) -> FolderSettings:
    """The settings of a folder of recordings; the defaults where there are none.

    Settings that are damaged give the defaults and a notice.
    """
    path = state_folder(recordings, create=False).newest(FILE_NAME)
    if path is None:
        return FolderSettings()
    try:
        return _parsed(json.loads(path.read_bytes()))
    except (OSError, ValueError, RecursionError, TypeError, KeyError, KeyphaseError) as error:
        notice = f"The settings in {path} cannot be used ({error}); the defaults hold."
        return FolderSettings(notice=notice)


def write_folder_settings(recordings: Path, settings: FolderSettings) -> None:
    """Put the settings of a folder on disk, whole, before returning.

    Raises JournalError where nothing can be written.
    """
    content = {
        "version": VERSION,
        "labels": settings.vocabulary.as_json(),
        "parameters": asdict(settings.parameters),
    }
    data = f"{json.dumps(content, indent=1, ensure_ascii=False, allow_nan=False)}\n".encode()
    path = state_folder(recordings).path / FILE_NAME
    write_whole(path, data, refusal=JournalError)


def _parsed(content: Any) -> FolderSettings:
    if not isinstance(content, Mapping) or content["version"] != VERSION:
        raise ValueError(f"expected version {VERSION}")
    return FolderSettings(
        vocabulary_from_json(content["labels"]), Parameters(**content["parameters"])
    )
