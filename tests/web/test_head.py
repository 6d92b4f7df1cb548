"""The head of a request: what cannot be read in one way only is answered by a plain 400."""

import socket

import pytest
from hypothesis import given
from hypothesis import strategies as st
from talking import WAIT_S, cookie

from keyphase.errors import RequestError
from keyphase.web.server import PageServer
from keyphase.web.transport.head import MAX_HEAD_BYTES, MAX_HEADERS, checked_head


def _answer(server: PageServer, sent: bytes) -> bytes:
    """Everything that comes back for these bytes, until the server closes."""
    with socket.create_connection(("127.0.0.1", server.port), timeout=WAIT_S) as connection:
        connection.sendall(sent)
        came = bytearray()
        while piece := connection.recv(1 << 16):
            came += piece
        return bytes(came)


def _request(server: PageServer, *lines: str, first: str = "GET / HTTP/1.1") -> bytes:
    host = f"Host: 127.0.0.1:{server.port}"
    ours = f"Cookie: {cookie(server)['Cookie']}"
    return "\r\n".join([first, host, ours, *lines, "", ""]).encode()


def test_a_plain_request_passes(server: PageServer) -> None:
    assert _answer(server, _request(server)).startswith(b"HTTP/1.1 200 ")


@pytest.mark.parametrize(
    "line",
    [
        "Host: 127.0.0.1",
        "host: evil.example",
        "Cookie: a=b",
        "Upgrade: websocket\r\nUpgrade: websocket",
        "Origin: http://a\r\nOrigin: http://b",
        "If-None-Match: a\r\nIf-None-Match: b",
        "Content-Length: 5",
        "Transfer-Encoding: chunked",
        "no colon",
        " folded: line",
        "Bad Name: x",
        "X: \x01",
        "X: bare\nline",
        "\r\n".join(f"X-{k}: y" for k in range(MAX_HEADERS)),
        "X: " + "y" * MAX_HEAD_BYTES,
    ],
)
def test_what_is_doubled_malformed_or_without_end_gets_400(server: PageServer, line: str) -> None:
    assert _answer(server, _request(server, line)).startswith(b"HTTP/1.1 400 ")


@pytest.mark.parametrize(
    "first", ["POST / HTTP/1.1", "GET / HTTP/1.0", "GET /", "GET http://x/ HTTP/1.1", "", "\x16"]
)
def test_anything_but_a_get_gets_400(server: PageServer, first: str) -> None:
    assert _answer(server, _request(server, first=first)).startswith(b"HTTP/1.1 400 ")


def test_headers_without_end_get_400_while_they_are_still_being_sent(server: PageServer) -> None:
    """Nothing is kept of them, and nobody waits for their end."""
    line = b"X: " + b"y" * 8000 + b"\r\n"
    with socket.create_connection(("127.0.0.1", server.port), timeout=WAIT_S) as connection:
        connection.sendall(b"GET / HTTP/1.1\r\n" + line * (MAX_HEAD_BYTES // len(line) + 1))
        assert connection.recv(1 << 16).startswith(b"HTTP/1.1 400 ")


def test_a_head_that_comes_byte_by_byte_is_the_same(server: PageServer) -> None:
    with socket.create_connection(("127.0.0.1", server.port), timeout=WAIT_S) as connection:
        connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        for byte in _request(server):
            connection.sendall(bytes([byte]))
        assert connection.recv(1 << 16).startswith(b"HTTP/1.1 200 ")


def test_what_nobody_reads_is_not_passed_on() -> None:
    head = b"GET / HTTP/1.1\r\nHost: a\r\nX-Forwarded-For: b\r\nCookie: c={}; keyphase-7=d"

    assert checked_head(head, 7) == (b"GET / HTTP/1.1\r\nhost: a\r\ncookie: keyphase-7=d\r\n\r\n")


@given(st.binary(max_size=300))
def test_any_head_is_judged(head: bytes) -> None:
    for start in (b"", b"GET / HTTP/1.1\r\n"):
        try:
            checked = checked_head(start + head, 80)
        except RequestError:
            continue
        assert checked.endswith(b"\r\n\r\n")
