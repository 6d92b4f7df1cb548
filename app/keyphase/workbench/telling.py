"""What is told to all pages whatever it is about: notices, errors, progress."""

import logging
from collections.abc import Callable, Mapping
from typing import Any, Literal

import msgspec

from keyphase.errors import KeyphaseError
from keyphase.web.transport.page_sockets import PageSockets

_log = logging.getLogger(__name__)

Progress = Callable[[str, float | None], None]
"""Told what is being done, and which fraction of it (None: nobody knows)."""


class Telling:
    """Tells all open pages; `under_way` is what one that comes later has to be told of progress."""

    def __init__(self, sockets: PageSockets) -> None:
        self._sockets = sockets
        self.under_way: Mapping[str, Any] | None = None

    def all(self, message: Mapping[str, Any] | msgspec.Struct, may_drop: bool = False) -> None:
        """A message to every page; `may_drop` where a newer one will follow."""
        self._sockets.broadcast(message, may_drop)

    def notice(self, level: Literal["info", "warning", "error"], text: str) -> None:
        """A line of text."""
        self.all({"type": "notice", "level": level, "text": text})

    def report(self, error: Exception) -> None:
        """An error becomes a notice in the page and a line in the log, never silence."""
        if isinstance(error, KeyphaseError):
            _log.info("%s", error)
            self.notice("warning", str(error))
        else:
            _log.error("A defect in keyphase", exc_info=error)
            self.notice("error", f"Something is wrong inside keyphase: {error!r}. See the log.")

    def progress(self, what: str, fraction: float | None) -> None:
        """How far something is that takes long."""
        self.under_way = {"type": "progress", "what": what, "fraction": fraction, "done": False}
        self.all(self.under_way)

    def progress_done(self) -> None:
        """It is over."""
        self.under_way = None
        self.all({"type": "progress", "what": "", "fraction": 1.0, "done": True})
