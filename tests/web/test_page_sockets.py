"""Pages and their threads: each page is heard in order and in a thread of its own."""

import asyncio
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager

import pytest
from talking import wait_until
from websockets.asyncio.client import connect
from websockets.asyncio.server import serve
from websockets.exceptions import ConnectionClosed

from keyphase.web.transport.access import Grant
from keyphase.web.transport.page_sockets import MAX_PAGES, Page, PageSockets


class Heard:
    """What the pages' side was told, and a gate that holds up whoever says "wait"."""

    def __init__(self) -> None:
        self.said: list[tuple[str, object]] = []
        self.left: list[str] = []
        self.go_on = threading.Event()
        self.sockets = PageSockets(self._opened, self._message, self._closed)

    def _opened(self, page: Page) -> None:
        page.send({"type": "hello"})

    def _message(self, page: Page, message: str | bytes) -> None:
        if message == "wait":
            self.go_on.wait()
        self.said.append((page.id, message))

    def _closed(self, page: Page) -> None:
        self.said.append((page.id, "left"))
        self.left.append(page.id)


@contextmanager
def _heard() -> Iterator[Heard]:
    heard = Heard()
    try:
        yield heard
    finally:
        heard.go_on.set()
        heard.sockets.close()


def _talk(heard: Heard, talk: Callable) -> None:
    """Run `talk(open)` against a server of these sockets; `open(id)` is a page's connection."""

    async def run() -> None:
        async def answer(connection):
            await heard.sockets.serve(connection, Grant.EVERYTHING, connection.request.path[1:])

        async with serve(answer, "127.0.0.1", 0) as server:
            port = server.sockets[0].getsockname()[1]
            await talk(lambda page: connect(f"ws://127.0.0.1:{port}/{page}"))

    asyncio.run(run())


def test_a_page_that_is_held_up_holds_up_no_other() -> None:
    with _heard() as heard:

        async def talk(open_page) -> None:
            held = [await open_page(f"held-{k}") for k in range(12)]
            for page in held:
                await page.send("wait")
            async with open_page("quick") as quick:
                await quick.send("seek")
                await wait_until(lambda: ("quick", "seek") in heard.said)
            heard.go_on.set()
            for page in held:
                await page.close()

        _talk(heard, talk)


def test_a_page_is_heard_in_order_and_taken_leave_of_last() -> None:
    with _heard() as heard:

        async def talk(open_page) -> None:
            async with open_page("a") as page:
                for number in range(20):
                    await page.send(str(number))
                await wait_until(lambda: len(heard.said) == 20)
            await wait_until(lambda: heard.left == ["a"])

        _talk(heard, talk)
        assert heard.said == [("a", str(number)) for number in range(20)] + [("a", "left")]


def test_no_thread_is_left_of_pages_that_have_left() -> None:
    with _heard() as heard:

        async def talk(open_page) -> None:
            before = threading.active_count()
            for number in range(5):
                async with open_page(f"page-{number}") as page:
                    await page.recv()
            await wait_until(lambda: len(heard.left) == 5)
            await wait_until(lambda: threading.active_count() <= before)

        _talk(heard, talk)


def test_no_more_pages_than_can_be_served() -> None:
    with _heard() as heard:

        async def talk(open_page) -> None:
            pages = [await open_page(str(number)) for number in range(MAX_PAGES)]
            async with open_page("another") as page:
                with pytest.raises(ConnectionClosed) as refusal:
                    await page.recv()
            await asyncio.gather(*(page.close() for page in pages))
            assert refusal.value.rcvd is not None
            assert refusal.value.rcvd.code == 1013

        _talk(heard, talk)
