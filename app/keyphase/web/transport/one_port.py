"""One port for our page and viser: the only file that touches viser's private parts.

viser serves its client and its websocket with `websockets.asyncio.server.serve`. While its server
is constructed that function is replaced by one that asks a `Site` first, so every request and
every websocket passes our gate before viser sees it. `tests/web/test_one_port.py` fails when this
stops holding with another viser.
"""

import asyncio
import contextlib
import dataclasses
import io
import logging
import socket
from collections.abc import Awaitable, Callable, Iterator
from typing import Any, Protocol

import viser
import websockets.asyncio.server as websockets_server
from viser import _messages
from websockets.asyncio.server import ServerConnection
from websockets.http11 import Request, Response

from keyphase.errors import KeyphaseError
from keyphase.web.transport.budget import Budget

VISER_PREFIX = "/viser"
"""viser's client lies below this path and its websocket at exactly this path."""

_Handler = Callable[[ServerConnection], Awaitable[None]]
_Process = Callable[[ServerConnection, Request], Response | None]

_PAGE_MESSAGE_BYTES = 1 << 20
_VISER_MESSAGE_BYTES = 8 << 20


class Site(Protocol):
    """What answers in front of viser."""

    def refusal(self, request: Request, port: int) -> Response | None:
        """403 for a request that may not pass, whatever its path; None to let it pass."""
        ...

    def response(self, request: Request, port: int) -> Response | None:
        """Our answer to a plain request; None for paths that are viser's."""
        ...

    def finish(self, request: Request, response: Response) -> Response:
        """Put our headers on an answer of viser's."""
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
    """A running viser server on `host` and `port` (0: a free one) with `site` in front of it.

    Raises KeyphaseError if nothing can listen there.
    """
    _refuse_unusable(host, port)
    with _in_front_of_viser(site), silent():
        server = viser.ViserServer(host=host, port=port, label="keyphase", verbose=False)
    _close_tunnel(server)
    return server


def control_of(server: viser.ViserServer, uuid: str) -> Any:
    """The control of the panel that browsers call `uuid`, or None."""
    return server.gui._gui_input_handle_from_uuid.get(uuid)  # type: ignore[reportPrivateUsage]


@contextlib.contextmanager
def silent() -> Iterator[None]:
    """viser prints a banner when it starts and a line when it stops; ours is the link."""
    with contextlib.redirect_stdout(io.StringIO()):
        yield


def _close_tunnel(server: viser.ViserServer) -> None:
    """No browser may ask for a public tunnel or push a file past our checks."""
    for message in (
        _messages.ShareUrlRequest,
        _messages.ShareUrlDisconnect,
        _messages.FileTransferStartUpload,
        _messages.FileTransferPart,
    ):
        server._websock_server._incoming_handlers.pop(message)  # type: ignore[reportPrivateUsage]


def _refuse_unusable(host: str, port: int) -> None:
    """viser tries a thousand ports and then waits for ever; say at once what is wrong."""
    try:
        with socket.create_server((host, port), family=_family(host)):
            pass
    except (OSError, OverflowError) as error:
        raise KeyphaseError(
            f"Nothing can listen on {host} port {port} ({error}); choose another with "
            "--host or --port, or leave the port out."
        ) from error


def _family(host: str) -> socket.AddressFamily:
    return socket.AF_INET6 if ":" in host else socket.AF_INET


@contextlib.contextmanager
def _in_front_of_viser(site: Site) -> Iterator[None]:
    original = websockets_server.serve

    def serve(handler: _Handler, *address: Any, process_request: _Process, **options: Any) -> Any:
        return original(
            _dispatch(site, handler),
            *address,
            process_request=_gate(site, process_request),  # type: ignore[reportArgumentType]
            logger=_quiet_logger(),
            **options,
        )

    websockets_server.serve = serve  # type: ignore[reportAttributeAccessIssue]
    try:
        yield
    finally:
        websockets_server.serve = original


def _gate(site: Site, viser_answers: _Process) -> _Process:
    def process(connection: ServerConnection, request: Request) -> Response | None:
        port = connection.local_address[1]
        refusal = site.refusal(request, port)
        if refusal is not None:
            return refusal
        if request.headers.get("Upgrade", "").lower() == "websocket":
            return _websocket_at(connection, request, site, port)
        ours = site.response(request, port)
        if ours is not None:
            return ours
        below = request.path.partition("?")[0].removeprefix(VISER_PREFIX)
        theirs = viser_answers(connection, dataclasses.replace(request, path=below))
        assert theirs is not None
        return site.finish(request, theirs)

    return process


def _websocket_at(
    connection: ServerConnection, request: Request, site: Site, port: int
) -> Response | None:
    """Let a websocket through at the two paths that have one, with a bound on its messages."""
    bounds = {"/app/ws": _PAGE_MESSAGE_BYTES, VISER_PREFIX: _VISER_MESSAGE_BYTES}
    if request.path not in bounds:
        return site.response(dataclasses.replace(request, path="/no-such-websocket"), port)
    connection.protocol.max_message_size = bounds[request.path]
    return None


def _dispatch(site: Site, viser_handler: _Handler) -> _Handler:
    async def handle(connection: ServerConnection) -> None:
        assert connection.request is not None
        if connection.request.path == "/app/ws":
            await site.page_socket(connection)
        else:
            await viser_handler(_Guarded(connection, site))  # type: ignore[reportArgumentType]

    return handle


def _quiet_logger() -> logging.Logger:
    """Every plain answer is a refused handshake to websockets; only defects are worth a line."""
    logger = logging.getLogger("keyphase.web.connections")
    logger.setLevel(logging.CRITICAL)
    return logger
