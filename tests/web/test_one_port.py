"""Our page and viser on one port; these fail when the hook stops holding with another viser."""

import asyncio
import contextlib
import gzip
import threading
from collections.abc import Sequence
from typing import Any

import msgspec
import pytest
import viser
from talking import (
    CAMERA,
    PAGE,
    WAIT_S,
    PageClient,
    StartServer,
    cookie,
    get,
    visers_socket,
    wait_until,
)
from websockets.asyncio.client import connect
from websockets.exceptions import ConnectionClosed
from websockets.typing import Subprotocol

from keyphase.robot.description import RobotDescription
from keyphase.web.scene.shared import Shared
from keyphase.web.server import PageServer
from keyphase.web.transport.addresses import PAGE as PAGE_OF_CALLBACK
from keyphase.web.transport.one_port import (
    BROKEN,
    PAGE_MESSAGE_BYTES,
    VISER_MESSAGE_BYTES,
    bound,
)


def test_viser_is_the_version_the_hook_was_written_for() -> None:
    assert viser.__version__ == "1.1.1"


def test_the_root_is_our_page(server: PageServer) -> None:
    response, body = get(server, "/", cookie(server))

    assert response.status == 200
    assert response.getheader("Content-Type") == "text/html; charset=utf-8"
    assert b"/app/static/" in body


def test_below_viser_is_visers_client(server: PageServer) -> None:
    response, body = get(server, f"/viser/{PAGE}/", cookie(server))

    assert response.status == 200
    assert b"<title>Viser</title>" in body


def test_scripts_come_from_our_folder_and_from_uplot(server: PageServer) -> None:
    ours, _ = get(server, "/app/static/js/main.js", cookie(server))
    uplots, body = get(server, "/app/static/uPlot.iife.js", cookie(server))

    assert (ours.status, uplots.status) == (200, 200)
    assert ours.getheader("Content-Type") == "text/javascript; charset=utf-8"
    assert b"uPlot" in body


def test_what_is_nowhere_is_not_found(server: PageServer) -> None:
    paths = (
        "/nothing",
        "/app/static/nothing.js",
        "/app/ws",
        "/viser",
        "/viser/",
        f"/viser/{PAGE}",
        f"/viser/{PAGE}/x.js",
        f"/viser/{PAGE.upper()}/",
        f"/viser/{PAGE[:-1]}/",
        f"/viser/{PAGE}/../{PAGE}/",
    )
    assert [get(server, path, cookie(server))[0].status for path in paths] == [404] * len(paths)


def test_our_websocket_greets(server: PageServer) -> None:
    with PageClient(server) as page:
        hello = page.receive()

    assert isinstance(hello, dict)
    assert hello["type"] == "hello"


def test_visers_websocket_brings_the_scene(server: PageServer) -> None:
    async def first_frame() -> bytes | str:
        async with visers_socket(server) as socket:
            return await asyncio.wait_for(socket.recv(), 20)

    assert len(asyncio.run(first_frame())) > 100


def test_the_frame_may_connect_again_without_the_focus(server: PageServer) -> None:
    """viser's client asks its document, and must hear our answer before it does."""
    _, body = get(server, f"/viser/{PAGE}/", cookie(server))

    assert body.count(b"<script") == 2
    assert 0 < body.find(b"document.hasFocus = () => true;") < 2000


def test_visers_client_is_packed_once_and_not_sent_to_a_browser_that_has_it(
    server: PageServer,
) -> None:
    path = f"/viser/{PAGE}/"
    plain, whole = get(server, path, cookie(server))
    packed, body = get(server, path, {**cookie(server), "Accept-Encoding": "gzip, br"})
    tag = packed.getheader("ETag") or ""
    again, nothing = get(server, path, {**cookie(server), "If-None-Match": tag})

    assert packed.getheader("Content-Encoding") == "gzip"
    assert plain.getheader("Content-Encoding") is None
    assert gzip.decompress(body) == whole
    assert (again.status, nothing) == (304, b"")


def test_an_async_callback_of_visers_knows_whose_frame_it_is(start_server: StartServer) -> None:
    server, pages = start_server(), ("a" * 32, "b" * 32)
    came: dict[int, str | None] = {}
    gone: dict[int, str | None] = {}

    @server.viser.on_client_connect
    async def _(client: viser.ClientHandle) -> None:
        came[client.client_id] = PAGE_OF_CALLBACK.get()

    @server.viser.on_client_disconnect
    async def _(client: viser.ClientHandle) -> None:
        gone[client.client_id] = PAGE_OF_CALLBACK.get()

    async def look(page: str) -> None:
        async with visers_socket(server, page) as socket:
            await socket.send(msgspec.msgpack.encode(CAMERA))
            await wait_until(lambda: page in came.values())

    for page in pages:
        asyncio.run(look(page))
    asyncio.run(wait_until(lambda: len(gone) == 2))

    assert sorted(came.values(), key=str) == list(pages)
    assert gone == came


def test_a_frame_that_connects_before_there_are_scenes_gets_its_own(
    start_server: StartServer, monkeypatch: pytest.MonkeyPatch
) -> None:
    """As pages do that were left open, when their server is started again."""
    seen, sent = threading.Event(), threading.Event()

    async def look(server: PageServer) -> None:
        async with visers_socket(server) as socket:
            await socket.send(msgspec.msgpack.encode(CAMERA))
            await (await socket.ping())
            sent.set()
            await asyncio.to_thread(seen.wait, WAIT_S)

    def shared(arms: Sequence[RobotDescription], finished_beside: Any) -> Shared:
        looking = look(finished_beside.__self__)
        threading.Thread(target=lambda: asyncio.run(looking), daemon=True).start()
        assert sent.wait(WAIT_S)
        return Shared(arms, finished_beside)

    monkeypatch.setattr("keyphase.web.server.Shared", shared)
    server = start_server()
    try:
        asyncio.run(wait_until(lambda: server.scenes.of(PAGE) is not None))
    finally:
        seen.set()


def test_limits_that_websockets_does_not_know_are_a_defect() -> None:
    """Were an option renamed there, it would be taken in silence and hold nothing back."""

    class Other:
        max_message_size = None

    class Connection:
        protocol = Other()
        max_queue_high = 16

    with pytest.raises(RuntimeError, match="limits"):
        bound(Connection(), 1)  # pyright: ignore


@pytest.mark.parametrize(
    ("path", "most"),
    [("/app/ws", PAGE_MESSAGE_BYTES), (f"/viser/{PAGE}", VISER_MESSAGE_BYTES)],
)
def test_a_message_that_is_too_long_ends_the_conversation(
    server: PageServer, path: str, most: int
) -> None:
    async def shout() -> int | None:
        async with connect(
            f"ws://127.0.0.1:{server.port}{path}",
            subprotocols=[Subprotocol(f"viser-v{viser.__version__}")],
            additional_headers=cookie(server),
            max_size=None,
        ) as socket:
            # The head of a message that would be so long; none of it follows.
            socket.transport.write(b"\x82\xff" + (most + 1).to_bytes(8) + bytes(4))
            with contextlib.suppress(ConnectionClosed):
                while True:
                    await asyncio.wait_for(socket.recv(), WAIT_S)
            return socket.close_code

    assert asyncio.run(shout()) == 1009


class Panic(BaseException):
    """What a panic in an extension is to Python: no Exception."""


@pytest.mark.parametrize("defect", [Panic, ValueError])
def test_a_defect_ends_a_conversation_with_a_word(
    start_server: StartServer,
    monkeypatch: pytest.MonkeyPatch,
    caplog: pytest.LogCaptureFixture,
    defect: type[BaseException],
) -> None:
    server = start_server()

    def panic(_page: object, _message: object) -> None:
        raise defect("index out of bounds")

    with PageClient(server) as page:
        page.wait_for("hello")
        monkeypatch.setattr(server.sockets, "_on_message", panic)
        page.send("next", direction=1)
        with pytest.raises(ConnectionClosed) as ended:
            page.wait_for("nothing more")

    assert ended.value.rcvd is not None
    assert (ended.value.rcvd.code, ended.value.rcvd.reason) == (1011, BROKEN)
    assert "index out of bounds" in caplog.text


def test_a_curve_of_one_pixel_is_refused_and_the_page_hears_on(page: PageClient) -> None:
    page.send("signals", request=1, tracks=["force"], from_s=0.0, to_s=10.0, width=1)
    refusal = page.wait_for("refused")
    page.send("signals", request=2, tracks=["force"], from_s=0.0, to_s=10.0, width=2)
    header, _ = page.wait_for_signals()

    assert "width" in refusal["text"]
    assert header["request"] == 2


def test_servers_beside_each_other_have_ports_of_their_own(
    server: PageServer, start_server: StartServer
) -> None:
    assert start_server().port != server.port


def test_starting_again_on_a_port_that_was_left(start_server: StartServer) -> None:
    first = start_server()
    first.viser.stop()

    assert start_server(port=first.port).port == first.port
