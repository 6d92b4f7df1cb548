"""A folder of recordings while it is open: the vocabulary, parameters and task they share."""

import threading
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

from keyphase.labeling.colors import SEGMENT_COLORS
from keyphase.labeling.labeling import Labeling
from keyphase.labeling.storage.folder_settings import (
    FolderSettings,
    change_folder_settings,
    read_folder_settings,
)
from keyphase.labeling.tasks.task import Task, numbered_labels, plain_or, task_of, with_task
from keyphase.labeling.vocabulary import Vocabulary
from keyphase.segmentation import Parameters

FIRST_TASK = "task"
"""What the task of a folder without a name is called."""


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

    @property
    def vocabulary(self) -> Vocabulary:
        """The labels in the order of their number keys: the phases of its tasks first."""
        settings = self._settings
        return settings.vocabulary.led_by(numbered_labels(settings.tasks))

    def learn(self, label: str, color: int) -> None:
        """Put a label into the vocabulary, if it can be in the colour its segment has.

        Raises JournalError where it cannot be kept.
        """
        preferred = SEGMENT_COLORS[color % len(SEGMENT_COLORS)]
        self._change_vocabulary(lambda vocabulary: vocabulary.with_label(label, preferred))

    def show_task(self, labeling: Labeling) -> None:
        """Let a finished recording write the phases of the folder's task, if it has none yet.

        Raises JournalError where they cannot be kept.
        """
        name = plain_or(self.path.name, FIRST_TASK)
        shown = task_of(name, labeling)
        if shown.phases and not (self._settings.tasks or self._settings.later):
            self._change(lambda each: each if each.tasks else replace(each, tasks=(shown,)))

    def write_task(self, task: Task) -> None:
        """Keep these phases as those of the task of that name; an empty one is no task any more.

        Raises LabelingError for too many, JournalError where they cannot be kept.
        """
        if not task.phases:
            kept = tuple(each for each in self._settings.tasks if each.name != task.name)
            self._change(lambda each: replace(each, tasks=kept))
            return
        with_task(self._settings.tasks, task)
        self._change(lambda each: replace(each, tasks=with_task(each.tasks, task)))

    def rename_phase(self, label: str, to: str) -> None:
        """Call a phase of its tasks, and a label of its vocabulary, otherwise."""

        def renamed(each: FolderSettings) -> FolderSettings:
            return replace(
                each,
                tasks=tuple(task.renamed(label, to) for task in each.tasks),
                vocabulary=each.vocabulary.renamed(label, to),
            )

        if renamed(self._settings) != self._settings:
            self._change(renamed)

    def forget(self, label: str) -> None:
        """Take a label out of the vocabulary; segments that have it keep it."""
        self._change_vocabulary(lambda vocabulary: vocabulary.without_label(label))

    def share(self, parameters: Parameters) -> None:
        """Give all its recordings other parameters. Raises JournalError likewise."""
        self._change(lambda settings: replace(settings, parameters=parameters))

    def swap(self, before: Parameters, after: Parameters) -> bool:
        """Give all its recordings `after` if they still have `before`; whether they had."""
        had: list[Parameters] = []

        def swapped(settings: FolderSettings) -> FolderSettings:
            had.append(settings.parameters)
            known = settings.parameters == before
            return replace(settings, parameters=after) if known else settings

        self._change(swapped)
        return had[-1] == before

    def colored(self, labeling: Labeling) -> Labeling:
        """The labeling with segments named by the vocabulary in the colours of their names."""
        colors = {
            label.name: SEGMENT_COLORS.index(label.color.upper())
            for label in self.vocabulary.labels
            if label.color.upper() in SEGMENT_COLORS
        }
        segments = tuple(
            segment
            if segment.proposed
            else replace(segment, color=colors.get(segment.label, segment.color))
            for segment in labeling.segments
        )
        return labeling if segments == labeling.segments else replace(labeling, segments=segments)

    def _change_vocabulary(self, change: Callable[[Vocabulary], Vocabulary]) -> None:
        now = self._settings.vocabulary
        if change(now) is not now:
            self._change(lambda each: replace(each, vocabulary=change(each.vocabulary)))

    def _change(self, change: Callable[[FolderSettings], FolderSettings]) -> None:
        with self._lock:
            self._settings = change_folder_settings(self.path, change)
