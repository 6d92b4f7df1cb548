"""The head of a request, judged before anything else reads it.

Cookies ignore ports, so a browser sends those of every program that was ever opened on this host,
of any form and in any number. Only what the server reads is passed on; what cannot be read in one
way only gets a plain 400.
"""

import asyncio
import re
from http import HTTPStatus

from websockets.asyncio.server import ServerConnection

from keyphase.errors import RequestError
from keyphase.web.transport.access import cookie_name

MAX_HEAD_BYTES = 1 << 18
"""A longer head is refused, wherever it is in it that it does not end."""

MAX_HEADERS = 200

_ONCE = frozenset(
    {
        b"host",
        b"origin",
        b"cookie",
        b"upgrade",
        b"range",
        b"if-none-match",
        b"if-range",
        b"sec-websocket-key",
        b"sec-websocket-version",
    }
)
"""What is read and has one value; given twice, nobody could say which one counts."""

_MORE = frozenset(
    {
        b"accept",
        b"accept-encoding",
        b"connection",
        b"sec-websocket-protocol",
        b"sec-websocket-extensions",
    }
)
"""What is read and may be given in several lines."""

_BODY = frozenset({b"content-length", b"transfer-encoding"})
_TOKEN = re.compile(rb"[-!#$%&'*+.^_`|~0-9a-zA-Z]+")
_VALUE = re.compile(rb"[\x09\x20-\x7e\x80-\xff]*")
_FIRST_LINE = re.compile(rb"(GET|HEAD) (/[\x21-\x7e]*) HTTP/1\.1")
HEAD_ONLY = "keyphase-head-only"
"""What stands in the head of a request that was HEAD; nobody else can put it there."""

_END = b"\r\n\r\n"
_LINGER_S = 1.0


def checked_head(head: bytes, port: int) -> bytes:
    """The head without what nobody reads; of the cookies only those of the server on `port`.

    One that asks for the head alone becomes a GET with `HEAD_ONLY` in it: websockets knows no
    other. Raises RequestError for one that is no GET or HEAD of HTTP/1.1, malformed, doubled where
    one value is meant, or followed by a body.
    """
    first, *lines = head.split(b"\r\n")
    found = _FIRST_LINE.fullmatch(first)
    if not found:
        raise RequestError("Expected GET, a path and HTTP/1.1 in the first line of the request.")
    if len(lines) > MAX_HEADERS:
        raise RequestError(f"Expected at most {MAX_HEADERS} headers, but {len(lines)} came.")
    kept, seen = [b"GET " + found[2] + b" HTTP/1.1"], set[bytes]()
    if found[1] == b"HEAD":
        kept.append(HEAD_ONLY.encode() + b": 1")
    for line in lines:
        name, value = _parts(line)
        if name in _BODY and value != b"0":
            raise RequestError("Expected a request without a body.")
        if name in _ONCE and name in seen:
            raise RequestError(f"Expected one header {name.decode()}, but it came twice.")
        seen.add(name)
        if name == b"cookie":
            value = only_cookies(value, cookie_name(port).encode())
        if name in _ONCE or name in _MORE:
            kept.append(name + b": " + value)
    return b"\r\n".join(kept) + _END


def only_cookies(header: bytes, name: bytes) -> bytes:
    """The cookies of that name, as they stand in a Cookie header among whatever else."""
    pairs = (pair.strip() for pair in header.split(b";"))
    return b"; ".join(pair for pair in pairs if pair.partition(b"=")[0].strip() == name)


def _parts(line: bytes) -> tuple[bytes, bytes]:
    """Name in small letters, and value."""
    name, colon, value = line.partition(b":")
    if not colon or not _TOKEN.fullmatch(name) or not _VALUE.fullmatch(value):
        raise RequestError("Expected headers of the form 'name: value', one in each line.")
    return name.lower(), value.strip(b" \t")


class JudgedConnection(ServerConnection):
    """A connection of which websockets gets the head only after `checked_head`; else it is 400."""

    _head: bytearray | None = None
    _refused = False

    def connection_made(self, transport: asyncio.BaseTransport) -> None:
        """A client has connected."""
        self._head = bytearray()
        super().connection_made(transport)

    def data_received(self, data: bytes) -> None:
        """Collect the head, judge it, and pass on what follows as it comes."""
        if self._head is None:
            super().data_received(data)
        elif not self._refused:
            searched = max(len(self._head) - len(_END) + 1, 0)
            self._head += data
            self._judge(self._head.find(_END, searched))

    def _judge(self, end: int) -> None:
        assert self._head is not None
        if end > MAX_HEAD_BYTES or (end < 0 and len(self._head) > MAX_HEAD_BYTES):
            return self._refuse(f"Expected a head of at most {MAX_HEAD_BYTES} bytes.")
        if end < 0:
            return None
        whole, rest = bytes(self._head[:end]), bytes(self._head[end + len(_END) :])
        try:
            head = checked_head(whole, self.local_address[1])
        except RequestError as error:
            return self._refuse(str(error))
        self._head = None
        return super().data_received(head + rest)

    def _refuse(self, why: str) -> None:
        """Say why, and hear no more; whoever goes on sending is cut off soon."""
        self._refused, self._head = True, bytearray()
        status = HTTPStatus.BAD_REQUEST
        body = f"{why}\n".encode()
        lines = (
            f"HTTP/1.1 {status.value} {status.phrase}",
            "Content-Type: text/plain; charset=utf-8",
            f"Content-Length: {len(body)}",
            "X-Content-Type-Options: nosniff",
            "Connection: close",
        )
        head = "\r\n".join(lines) + "\r\n\r\n"
        self.transport.write(head.encode() + body)
        if self.transport.can_write_eof():
            self.transport.write_eof()
        self.loop.call_later(_LINGER_S, self.transport.abort)
