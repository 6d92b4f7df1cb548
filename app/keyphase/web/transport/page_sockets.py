"""The websockets of all open pages: sending to one or all of them, and hearing them in order."""

import asyncio
import logging
import secrets
from collections.abc import Callable, Mapping
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from typing import Any

import msgspec
from websockets.asyncio.server import ServerConnection
from websockets.exceptions import ConnectionClosed

from keyphase.web.transport.access import Grant
from keyphase.web.transport.budget import Budget

_log = logging.getLogger(__name__)

MAX_PAGES = 100
"""So many pages at once; the next one is turned away."""

_LAGGING_BYTES = 1 << 20
_LOST_BYTES = 64 << 20


@dataclass(eq=False)
class Page:
    """One open page."""

    id: str
    grant: Grant
    connection: ServerConnection
    loop: asyncio.AbstractEventLoop

    @property
    def is_looking(self) -> bool:
        """Whether it was opened by the link for looking only."""
        return self.grant is Grant.LOOKING

    def send(
        self, message: Mapping[str, Any] | msgspec.Struct | str | bytes, may_drop: bool = False
    ) -> None:
        """Send a message from any thread; `may_drop` spares a page that lags behind.

        Text and bytes go as they are, so that what many pages get is encoded once.
        """
        data = message if isinstance(message, str | bytes) else encode(message)
        call_soon(self.loop, lambda: _push(self, data, may_drop))


class PageSockets:
    """All open pages. `on_open` greets a page, `on_message` hears it.

    `on_close` is told when it has left. All run outside the loop, for each page in a thread of its
    own, one after another: nobody waits for another page's turn.
    """

    def __init__(
        self,
        on_open: Callable[[Page], None],
        on_message: Callable[[Page, str | bytes], None],
        on_close: Callable[[Page], None] = lambda _page: None,
    ) -> None:
        self._on_open = on_open
        self._on_message = on_message
        self._on_close = on_close
        self._threads: set[ThreadPoolExecutor] = set()
        self._closed = False

    def __len__(self) -> int:
        return len(self._threads)

    async def serve(
        self, connection: ServerConnection, grant: Grant, id: str | None = None
    ) -> None:
        """Greet a page, then hear its messages one after another until it leaves.

        `id` is what the page calls itself, as its 3D frame does; without one it gets one.
        """
        if self._closed or len(self._threads) >= MAX_PAGES:
            await connection.close(1013, f"No more than {MAX_PAGES} pages at once.")
            return
        page = Page(id or secrets.token_hex(16), grant, connection, asyncio.get_running_loop())
        thread = ThreadPoolExecutor(max_workers=1, thread_name_prefix="page")
        self._threads.add(thread)
        try:
            await self._hear(page, thread)
        except ConnectionClosed:
            pass
        finally:
            self._threads.discard(thread)
            if not self._closed:
                thread.submit(self._leave, page)
            thread.shutdown(wait=False)

    async def _hear(self, page: Page, thread: ThreadPoolExecutor) -> None:
        budget = Budget()
        await page.loop.run_in_executor(thread, self._on_open, page)
        async for message in page.connection:
            await asyncio.sleep(budget.wait_s())
            if self._closed:
                return
            await page.loop.run_in_executor(thread, self._on_message, page, message)

    def _leave(self, page: Page) -> None:
        """The last thing in a page's thread, after what it was doing when it left."""
        try:
            self._on_close(page)
        except Exception:
            _log.exception("A page that left could not be taken leave of.")

    def close(self) -> None:
        """Stop hearing."""
        self._closed = True
        for thread in tuple(self._threads):
            thread.shutdown(wait=False, cancel_futures=True)


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
