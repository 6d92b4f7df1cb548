"""The websockets of all open pages: sending to one or all of them, and hearing them in order."""

import asyncio
import logging
import secrets
import threading
from collections import deque
from collections.abc import Callable, Mapping
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field
from typing import Any

import msgspec
from websockets.asyncio.server import ServerConnection
from websockets.exceptions import ConnectionClosed

from keyphase.web.transport.access import Grant
from keyphase.web.transport.budget import Budget
from keyphase.workbench.uploads import Upload

_log = logging.getLogger(__name__)

MOST_PAGES = 100
"""So many pages at once; the next one is turned away."""

MOST_CHANGES = 1
"""So many changes of one page may wait to be made; with more, the page itself waits."""

_LAGGING_BYTES = 1 << 20
_LOST_BYTES = 64 << 20


@dataclass(eq=False)
class Page:
    """One open page, the file it is sending, if any, and the changes it waits for."""

    id: str
    grant: Grant
    connection: ServerConnection
    loop: asyncio.AbstractEventLoop
    upload: Upload | None = None
    changes: deque[threading.Event] = field(default_factory=deque)

    @property
    def is_looking(self) -> bool:
        """Whether it was opened by the link for looking only."""
        return self.grant is Grant.LOOKING

    def send(self, message: Mapping[str, Any] | msgspec.Struct | bytes) -> None:
        """Send a message from any thread."""
        data = message if isinstance(message, bytes) else encode(message)
        call_soon(self.loop, lambda: _push(self, data, may_drop=False))

    def wait_for(self, change: threading.Event) -> None:
        """Wait until few of this page's changes are still to be made, so that others' are, too."""
        self.changes.append(change)
        while len(self.changes) > MOST_CHANGES:
            self.changes.popleft().wait()


class PageSockets:
    """All open pages. `on_open` greets a page and adds it, `on_message` hears it.

    Both run outside the loop, for one page one after another.
    """

    def __init__(
        self, on_open: Callable[[Page], None], on_message: Callable[[Page, str | bytes], None]
    ) -> None:
        self._on_open = on_open
        self._on_message = on_message
        self._pages: set[Page] = set()
        self._pool = ThreadPoolExecutor(max_workers=8, thread_name_prefix="page")

    def __len__(self) -> int:
        return len(self._pages)

    async def serve(
        self, connection: ServerConnection, grant: Grant, id: str | None = None
    ) -> None:
        """Greet a page, then hear its messages one after another until it leaves.

        `id` is what the page calls itself, as its 3D frame does; without one it gets one.
        """
        if len(self._pages) >= MOST_PAGES:
            await connection.close(1013, f"No more than {MOST_PAGES} pages at once.")
            return
        loop = asyncio.get_running_loop()
        page = Page(id or secrets.token_hex(16), grant, connection, loop)
        budget = Budget()
        try:
            await loop.run_in_executor(self._pool, self._on_open, page)
            async for message in connection:
                await asyncio.sleep(budget.wait_s())
                await loop.run_in_executor(self._pool, self._on_message, page, message)
        except ConnectionClosed:
            pass
        finally:
            self._pages.discard(page)
            if page.upload is not None:
                page.upload.abandon()

    def add(self, page: Page) -> None:
        """Include a page in broadcasts, once it has been told how things stand."""
        self._pages.add(page)

    def broadcast(
        self, message: Mapping[str, Any] | msgspec.Struct, may_drop: bool = False
    ) -> None:
        """Send to every page, from any thread; `may_drop` spares pages that lag behind."""
        pages = tuple(self._pages)
        if pages:
            data = encode(message)
            call_soon(pages[0].loop, lambda: [_push(page, data, may_drop) for page in pages])

    def close(self) -> None:
        """Stop hearing."""
        self._pool.shutdown(wait=False, cancel_futures=True)


def encode(message: Mapping[str, Any] | msgspec.Struct) -> str:
    """A message as JSON text."""
    return msgspec.json.encode(message).decode()


def call_soon(loop: asyncio.AbstractEventLoop, action: Callable[[], object]) -> None:
    """Run `action` in the loop's thread; nothing where the loop has stopped."""
    try:
        loop.call_soon_threadsafe(action)
    except RuntimeError:
        _log.debug("The server has stopped; a message was not sent.")


def _push(page: Page, data: str | bytes, may_drop: bool) -> None:
    """Write without waiting; a page that does not read is spared, and in the end cut off."""
    from websockets.asyncio.server import broadcast

    waiting = page.connection.transport.get_write_buffer_size()
    if waiting > _LOST_BYTES:
        page.connection.transport.abort()
    elif not (may_drop and waiting > _LAGGING_BYTES):
        broadcast([page.connection], data)
