"""One port for our page and viser: the only file that touches viser's private parts.

viser serves its client and its websocket with `websockets.asyncio.server.serve`. While its server
is constructed that function is replaced by one that asks a `Site` first, so every request and
every websocket passes our gate before viser sees it. `tests/web/test_one_port.py` fails when this
stops holding with another viser.
"""

import asyncio
import contextlib
import io
import logging
import socket
from collections.abc import Awaitable, Callable, Iterator
from http import HTTPStatus
from typing import Any, Protocol

import viser
import websockets.asyncio.server as websockets_server
from websockets.asyncio.server import ServerConnection
from websockets.exceptions import ConnectionClosed
from websockets.http11 import Request, Response
from websockets.protocol import State

from keyphase.errors import KeyphaseError
from keyphase.web.transport.addresses import PAGE, page_of_frame_socket, page_of_socket
from keyphase.web.transport.budget import Budget
from keyphase.web.transport.head import HEAD_ONLY, JudgedConnection
from keyphase.web.transport.responses import text

PAGE_MESSAGE_BYTES = 1 << 20
VISER_MESSAGE_BYTES = 8 << 20
MAX_QUEUE = 16
"""So many messages of a connection are read ahead; then its sender waits."""

BROKEN = "Something is wrong inside keyphase; its log says what."
"""Why a conversation ends that a defect has broken."""

_LOOK_AGAIN_S = 0.05

_log = logging.getLogger(__name__)

_Handler = Callable[[ServerConnection], Awaitable[None]]
_Process = Callable[[ServerConnection, Request], Response | None]


class Site(Protocol):
    """What answers in front of viser.

    has_scenes  whether scenes are made for viser's clients by now
    """

    has_scenes: bool

    def response(self, request: Request, port: int) -> Response:
        """The answer to a plain request: 403 for whoever may not ask."""
        ...

    def refusal(self, request: Request, port: int) -> Response | None:
        """403 for a websocket that may not be opened; None to let it pass."""
        ...

    async def page_socket(self, connection: ServerConnection) -> None:
        """Talk with one page until it leaves."""
        ...

    def admits(self, connection: ServerConnection, message: bytes) -> bool:
        """Whether a message from viser's client may reach viser."""
        ...


class _Guarded:
    """A connection as viser sees it: messages that are not admitted never arrive, none too fast."""

    def __init__(self, connection: ServerConnection, site: Site) -> None:
        self._connection = connection
        self._site = site
        self._budget = Budget()

    async def recv(self) -> bytes:
        while True:
            message = await self._connection.recv()
            await asyncio.sleep(self._budget.wait_s())
            if isinstance(message, bytes) and self._site.admits(self._connection, message):
                return message

    def __getattr__(self, name: str) -> Any:
        return getattr(self._connection, name)


def serve(site: Site, host: str, port: int) -> viser.ViserServer:
    """A running viser server on `host` and `port`, with `site` in front of it.

    Raises KeyphaseError if nothing can listen there.
    """
    _refuse_unusable(host, port)
    with _in_front_of_viser(site), silent():
        server = viser.ViserServer(host=host, port=port, label="keyphase", verbose=False)
    if server.get_port() != port:
        with silent():
            server.stop()
        raise KeyphaseError(_taken(host, port, "something else has just taken it"))
    return server


def usable_port(host: str, wanted: int, preferred: Iterator[int] | list[int]) -> int:
    """`wanted`, or where that is 0 the first of `preferred` that is free, or a free one.

    Raises KeyphaseError if nothing can listen on `host`.
    """
    if wanted != 0:
        return wanted
    for port in preferred:
        with contextlib.suppress(OSError, OverflowError), _listening(host, port):
            return port
    try:
        with _listening(host, 0) as listener:
            return listener.getsockname()[1]
    except (OSError, OverflowError) as error:
        raise KeyphaseError(_taken(host, wanted, str(error))) from error


@contextlib.contextmanager
def silent() -> Iterator[None]:
    """viser prints a banner when it starts and a line when it stops; ours is the link."""
    with contextlib.redirect_stdout(io.StringIO()):
        yield


def _refuse_unusable(host: str, port: int) -> None:
    """viser tries a thousand ports and then waits for ever; say at once what is wrong."""
    try:
        with _listening(host, port):
            pass
    except (OSError, OverflowError) as error:
        raise KeyphaseError(_taken(host, port, str(error))) from error


def _listening(host: str, port: int) -> socket.socket:
    return socket.create_server((host, port), family=_family(host))


def _taken(host: str, port: int, why: str) -> str:
    return (
        f"Nothing can listen on {host} port {port} ({why}); choose another with "
        "--host or --port, or leave the port out."
    )


def _family(host: str) -> socket.AddressFamily:
    return socket.AF_INET6 if ":" in host else socket.AF_INET


@contextlib.contextmanager
def _in_front_of_viser(site: Site) -> Iterator[None]:
    original = websockets_server.serve

    def serve(handler: _Handler, *address: Any, process_request: _Process, **options: Any) -> Any:
        del process_request  # viser's own answers are ours now
        options |= {"max_size": PAGE_MESSAGE_BYTES, "max_queue": MAX_QUEUE}
        return original(
            _dispatch(site, handler),
            *address,
            process_request=_gate(site),
            create_connection=JudgedConnection,
            logger=_quiet_logger(),
            **options,
        )

    websockets_server.serve = serve  # type: ignore[reportAttributeAccessIssue]
    try:
        yield
    finally:
        websockets_server.serve = original


def _gate(site: Site) -> _Process:
    def process(connection: ServerConnection, request: Request) -> Response | None:
        port = connection.local_address[1]
        if request.headers.get("Upgrade", "").lower() != "websocket":
            return _asked_for(request, site.response(request, port))
        return site.refusal(request, port) or _bounded(connection, request)

    return process


def _asked_for(request: Request, response: Response) -> Response:
    """Without its body where only the head was asked for."""
    if HEAD_ONLY in request.headers:
        response.body = b""
    return response


def _bounded(connection: ServerConnection, request: Request) -> Response | None:
    """Let a websocket through where there is one, with a bound on its messages."""
    if page_of_socket(request.path) is not None:
        most = PAGE_MESSAGE_BYTES
    elif page_of_frame_socket(request.path) is not None:
        most = VISER_MESSAGE_BYTES
    else:
        return text(HTTPStatus.NOT_FOUND, "There is no websocket here.")
    bound(connection, most)
    return None


def bound(connection: ServerConnection, most_bytes: int) -> None:
    """Bound a connection's messages; raises where websockets does not know these bounds."""
    limits = (connection.protocol.max_message_size, connection.max_queue_high)
    if limits != (PAGE_MESSAGE_BYTES, MAX_QUEUE):
        raise RuntimeError(f"websockets took the limits {limits} for those that were asked for.")
    connection.protocol.max_message_size = most_bytes


def _dispatch(site: Site, viser_handler: _Handler) -> _Handler:
    async def handle(connection: ServerConnection) -> None:
        assert connection.request is not None
        page = page_of_frame_socket(connection.request.path)
        PAGE.set(page)
        try:
            if page is None:
                await site.page_socket(connection)
            else:
                await _until_there_are_scenes(connection, site)
                await viser_handler(_Guarded(connection, site))  # type: ignore[reportArgumentType]
        except (ConnectionClosed, asyncio.CancelledError):
            raise
        except BaseException as defect:
            # A panic in an extension is no Exception; nobody else would end the conversation.
            _log.error("A conversation with a page broke.", exc_info=defect)
            await connection.close(1011, BROKEN)

    return handle


async def _until_there_are_scenes(connection: ServerConnection, site: Site) -> None:
    """A page of the server before connects early; viser tells of it later, but not whose it is."""
    while not site.has_scenes and connection.state is State.OPEN:
        await asyncio.sleep(_LOOK_AGAIN_S)


def _quiet_logger() -> logging.Logger:
    """Every plain answer is a refused handshake to websockets; only defects are worth a line."""
    logger = logging.getLogger("keyphase.web.connections")
    logger.setLevel(logging.CRITICAL)
    return logger
