"""A page without a browser: plain requests, and the page's websocket."""

import asyncio
import json
import secrets
import struct
from collections.abc import Callable, Mapping
from http.client import HTTPConnection, HTTPResponse
from typing import Any, get_args

import viser
from websockets.asyncio.client import connect as async_connect
from websockets.sync.client import ClientConnection, connect
from websockets.typing import Subprotocol

from keyphase.web.protocol.requests import OnDocument, Request
from keyphase.web.server import PageServer
from keyphase.web.transport.access import cookie_name

Message = dict[str, Any]

StartServer = Callable[..., PageServer]

ABOUT_A_DOCUMENT = {
    tag
    for kind in (*get_args(Request),)
    if issubclass(kind, OnDocument) and isinstance(tag := kind.__struct_config__.tag, str)
} | {"signals"}

WAIT_S = 60.0
"""A test that waits longer than this has failed."""


PAGE = "0123456789abcdef" * 2
"""What a page calls itself where it does not matter."""

CAMERA = {
    "type": "ViewerCameraMessage",
    "wxyz": (1.0, 0.0, 0.0, 0.0),
    "position": (1.0, 1.0, 1.0),
    "image_height": 10,
    "image_width": 10,
    "fov": 1.0,
    "near": 0.1,
    "far": 10.0,
    "look_at": (0.0, 0.0, 0.0),
    "up_direction": (0.0, 0.0, 1.0),
}
"""The first thing viser's client says; without it no control of it is heard."""


def get(
    server: PageServer, path: str, headers: Mapping[str, str] | None = None
) -> tuple[HTTPResponse, bytes]:
    """The answer to GET `path`, sent with exactly these headers beside Host."""
    connection = HTTPConnection("127.0.0.1", server.port, timeout=WAIT_S)
    given = dict(headers or {})
    connection.putrequest("GET", path, skip_host="Host" in given, skip_accept_encoding=True)
    for name, value in given.items():
        connection.putheader(name, value)
    connection.endheaders()
    response = connection.getresponse()
    body = response.read()
    connection.close()
    return response, body


def cookie(server: PageServer, token: str | None = None) -> dict[str, str]:
    """The header a browser sends that has followed the link."""
    return {"Cookie": f"{cookie_name(server.port)}={token or server.access.token}"}


def visers_socket(server: PageServer, page: str = PAGE) -> async_connect:
    """The websocket that viser's client opens in the frame of a page."""
    return async_connect(
        f"ws://127.0.0.1:{server.port}/viser/{page}",
        subprotocols=[Subprotocol(f"viser-v{viser.__version__}")],
        additional_headers=cookie(server),
        max_size=None,
    )


async def wait_until(holds: Callable[[], bool]) -> None:
    """Wait until `holds`, which must come true soon."""
    async with asyncio.timeout(WAIT_S):
        while not holds():
            await asyncio.sleep(0.01)


class PageClient:
    """The page's side of the page's websocket."""

    def __init__(
        self, server: PageServer, token: str | None = None, page: str | None = None
    ) -> None:
        self.server = server
        self.page = page or secrets.token_hex(16)
        self._socket: ClientConnection = connect(
            f"ws://127.0.0.1:{server.port}/app/ws?page={self.page}",
            additional_headers=cookie(server, token),
            max_size=None,
            max_queue=None,
        )
        self.heard: list[Message] = []
        self.told: dict[str, Message] = {}

    def __enter__(self) -> "PageClient":
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def close(self) -> None:
        self._socket.close()

    def send(self, kind: str, /, **fields: object) -> None:
        """Say something; about a document: the one that was heard last, unless `fields` say."""
        self.send_raw(json.dumps({"type": kind, **self._about(kind), **fields}))

    def _about(self, kind: str) -> Message:
        document = self.told.get("document")
        if document is None or kind not in ABOUT_A_DOCUMENT:
            return {}
        about = {"recording": document["id"], "revision": document["revision"]}
        return {"recording": document["id"]} if kind == "signals" else about

    def id(self, line: int) -> str:
        """The id of the recording in a line of the list, counted from 1."""
        return self.told["recordings"]["items"][line - 1]["id"]

    def open(self, line: int) -> None:
        """Look at the recording in that line."""
        self.send("open", id=self.id(line))

    def send_raw(self, data: str | bytes) -> None:
        self._socket.send(data)

    def receive(self) -> Message | bytes:
        data = self._socket.recv(timeout=WAIT_S)
        return data if isinstance(data, bytes) else json.loads(data)

    def wait_for(
        self, kind: str, which: Callable[[Message], bool] = lambda _message: True
    ) -> Message:
        """The next message of a kind for which `which` holds."""
        while True:
            message = self.receive()
            if isinstance(message, bytes):
                continue
            self.heard.append(message)
            self.told[message["type"]] = message
            if message["type"] == kind and which(message):
                return message

    def wait_for_signals(self) -> tuple[Message, list[tuple[list[float], list[float]]]]:
        """Header, and times and values of each series, of the next signals."""
        while not isinstance(frame := self.receive(), bytes):
            pass
        (length,) = struct.unpack_from("<I", frame)
        header = json.loads(frame[4 : 4 + length])
        assert (4 + length) % 8 == 0
        place, series = 4 + length, []
        for rows in [s["rows"] for track in header["tracks"] for s in track["series"]]:
            times = struct.unpack_from(f"<{rows}d", frame, place)
            values = struct.unpack_from(f"<{rows}d", frame, place + 8 * rows)
            series.append((list(times), list(values)))
            place += 16 * rows
        assert place == len(frame)
        return header, series
