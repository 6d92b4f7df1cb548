"""What one page is told whatever it is about: notices, and what went wrong for it."""

import logging
from collections.abc import Callable
from typing import Literal

from keyphase.errors import KeyphaseError
from keyphase.workbench.tasks import Tasks

_log = logging.getLogger(__name__)

Level = Literal["info", "warning", "error"]


class Telling:
    """Tells one page; `tasks` are those of the whole workbench."""

    def __init__(self, tell: Callable[[Level, str], None], tasks: Tasks) -> None:
        self._tell = tell
        self.tasks = tasks

    def notice(self, level: Level, text: str) -> None:
        """A line of text."""
        self._tell(level, text)

    def report(self, error: Exception) -> None:
        """An error becomes a notice in the page and a line in the log, never silence."""
        self._tell(*in_words(error))


def in_words(error: Exception) -> tuple[Level, str]:
    """An error as people are told of it; what is no refusal is a defect and goes to the log."""
    if isinstance(error, KeyphaseError):
        _log.info("%s", error)
        return "warning", str(error)
    _log.error("A defect in keyphase", exc_info=error)
    return "error", f"Something is wrong inside keyphase: {error!r}. See the log."
