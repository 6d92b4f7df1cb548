"""`keyphase phases`: the phases of a folder's task, shown or typed."""

from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING

import tyro

from keyphase.commands.saying import say

if TYPE_CHECKING:
    from keyphase.labeling.storage.folder_settings import FolderSettings
    from keyphase.labeling.tasks.task import Task


@dataclass(frozen=True)
class Phases:
    """Show the phases of a folder's task, or write them."""

    folder: tyro.conf.Positional[Path]
    """A folder of recordings."""
    write: tuple[str, ...] = ()
    """The phases in order, each NAME or NAME:END with END of contact, release, configuration or
    gripper, and :optional or :repeated after it."""
    task: str = ""
    """The task's name; the folder's where it is left out."""

    def run(self) -> int:
        """Print the phases as they are kept."""
        from keyphase.errors import LabelingError
        from keyphase.labeling.storage.folder_settings import (
            change_folder_settings,
            read_folder_settings,
        )
        from keyphase.labeling.tasks.task import with_task

        if not self.folder.is_dir():
            raise LabelingError(f"Expected a folder of recordings, but {self.folder} is none.")
        if self.write:
            task = self._typed()
            settings = change_folder_settings(
                self.folder, lambda now: replace(now, tasks=with_task(now.tasks, task))
            )
        else:
            settings = read_folder_settings(self.folder)
        _tell(settings)
        return 0

    def _typed(self) -> "Task":
        from keyphase.labeling.tasks.task import Task
        from keyphase.labeling.tasks.typed import typed_phase

        phases = tuple(typed_phase(text, number) for number, text in enumerate(self.write))
        return Task(self.task or self.folder.resolve().name or "task", phases)


def _tell(settings: "FolderSettings") -> None:
    if settings.notice:
        say(settings.notice)
    if not settings.tasks:
        say("No phases yet; the first recording that is done writes them, or --write.")
    for task in settings.tasks:
        say(task.name)
        for number, phase in enumerate(task.phases, start=1):
            more = [name for name in ("optional", "repeated") if getattr(phase, name)]
            say(f"  {number:2}. {phase.name}  ({', '.join([phase.end, *more])})")
