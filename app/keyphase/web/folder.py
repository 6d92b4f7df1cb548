"""A folder of recordings while it is open: the vocabulary and parameters its recordings share."""

import threading
from dataclasses import replace
from pathlib import Path

from keyphase.labeling.folder_settings import (
    FolderSettings,
    read_folder_settings,
    write_folder_settings,
)
from keyphase.labeling.vocabulary import Vocabulary
from keyphase.segmentation import Parameters


class Folder:
    """One folder's settings; every change is on disk on return. Used by several threads."""

    def __init__(self, path: Path) -> None:
        self.path = path
        self._settings = read_folder_settings(path)
        self._lock = threading.Lock()

    @property
    def settings(self) -> FolderSettings:
        """What its recordings share."""
        return self._settings

    def learn(self, label: str) -> None:
        """Put a label into the vocabulary. Raises JournalError where it cannot be kept."""
        self._change_vocabulary(self._settings.vocabulary.with_label(label))

    def forget(self, label: str) -> None:
        """Take a label out of the vocabulary; segments that have it keep it."""
        self._change_vocabulary(self._settings.vocabulary.without_label(label))

    def share(self, parameters: Parameters) -> None:
        """Give all its recordings other parameters. Raises JournalError likewise."""
        self._change(replace(self._settings, parameters=parameters))

    def _change_vocabulary(self, vocabulary: Vocabulary) -> None:
        if vocabulary is not self._settings.vocabulary:
            self._change(replace(self._settings, vocabulary=vocabulary))

    def _change(self, settings: FolderSettings) -> None:
        with self._lock:
            write_folder_settings(self.path, settings)
            self._settings = settings
