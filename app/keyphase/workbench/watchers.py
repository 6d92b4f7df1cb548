"""All that watch one view."""

import logging
from collections.abc import Callable

from keyphase.workbench.watcher import Watcher

_log = logging.getLogger(__name__)


class Watchers:
    """Who watches a view. Told from many threads, changed under the lock of the view."""

    def __init__(self) -> None:
        self._watchers: tuple[Watcher, ...] = ()

    def __len__(self) -> int:
        return len(self._watchers)

    def add(self, watcher: Watcher) -> None:
        """Tell `watcher` from now on."""
        self._watchers = (*self._watchers, watcher)

    def remove(self, watcher: Watcher) -> None:
        """Tell `watcher` no more."""
        self._watchers = tuple(one for one in self._watchers if one is not watcher)

    def clear(self) -> None:
        """Tell nobody any more."""
        self._watchers = ()

    def each(self, show: Callable[[Watcher], None]) -> None:
        """Tell all; what goes wrong in one is no other's business."""
        for watcher in self._watchers:
            try:
                show(watcher)
            except Exception as error:
                _log.error("A defect in keyphase", exc_info=error)
