"""Our page and viser on one port; these fail when the hook stops holding with another viser."""

import asyncio

import msgspec
import viser
from talking import CAMERA, PageClient, StartServer, control, cookie, get, visers_socket
from viser import _messages

from keyphase.web.server import PageServer


def test_viser_is_the_version_the_hook_was_written_for() -> None:
    assert viser.__version__ == "1.1.1"


def test_the_root_is_our_page(server: PageServer) -> None:
    response, body = get(server, "/", cookie(server))

    assert response.status == 200
    assert response.getheader("Content-Type") == "text/html; charset=utf-8"
    assert b"/app/static/" in body


def test_below_viser_is_visers_client(server: PageServer) -> None:
    response, body = get(server, "/viser/", cookie(server))

    assert response.status == 200
    assert b"<title>Viser</title>" in body


def test_scripts_come_from_our_folder_and_from_uplot(server: PageServer) -> None:
    ours, _ = get(server, "/app/static/js/main.js", cookie(server))
    uplots, body = get(server, "/app/static/uPlot.iife.js", cookie(server))

    assert (ours.status, uplots.status) == (200, 200)
    assert ours.getheader("Content-Type") == "text/javascript; charset=utf-8"
    assert b"uPlot" in body


def test_what_is_nowhere_is_not_found(server: PageServer) -> None:
    paths = ("/nothing", "/app/static/nothing.js", "/viser/nothing.js", "/app/ws", "/viser")
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


def test_a_control_moved_in_a_browser_reaches_the_session(page: PageClient) -> None:
    """Through viser's websocket, our filter, viser's panel and the session to the page."""
    server = page.server
    slider = control(server, "Ratio")
    message = {"type": "GuiUpdateMessage", "uuid": slider, "updates": {"value": 35.0}}

    asyncio.run(_say_to_viser(server, message))
    document = page.wait_for("document", lambda m: m["parameters"]["force_ratio"] == 35.0)

    assert document["parameters"]["force_ratio"] == 35.0


def test_nobody_can_ask_for_a_public_tunnel_or_push_a_file(server: PageServer) -> None:
    handlers = server.viser._websock_server._incoming_handlers  # pyright: ignore

    for message in (
        _messages.ShareUrlRequest,
        _messages.ShareUrlDisconnect,
        _messages.FileTransferStartUpload,
        _messages.FileTransferPart,
    ):
        assert message not in handlers
    assert _messages.GuiUpdateMessage in handlers


def test_servers_beside_each_other_have_ports_of_their_own(
    server: PageServer, start_server: StartServer
) -> None:
    assert start_server().port != server.port


def test_starting_again_on_a_port_that_was_left(start_server: StartServer) -> None:
    first = start_server()
    first.viser.stop()

    assert start_server(port=first.port).port == first.port


async def _say_to_viser(server: PageServer, message: dict[str, object]) -> None:
    async with visers_socket(server) as socket:
        await asyncio.wait_for(socket.recv(), 20)
        await socket.send(msgspec.msgpack.encode(CAMERA))
        await socket.send(msgspec.msgpack.encode(message))
        await (await socket.ping())
