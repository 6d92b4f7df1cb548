"""Who is let in: the token, the cookie, Host and Origin, on every route and both websockets."""

import asyncio

import pytest
import viser
from hypothesis import given
from hypothesis import strategies as st
from talking import PAGE, PageClient, StartServer, cookie, get
from websockets.asyncio.client import connect
from websockets.exceptions import InvalidStatus
from websockets.typing import Subprotocol

from keyphase.errors import KeyphaseError, RequestError
from keyphase.web.server import PageServer
from keyphase.web.transport.access import Access, Grant, cookie_name

FRAME = f"/viser/{PAGE}"
SOCKETS = ("/app/ws", f"/app/ws?page={PAGE}", FRAME)
ROUTES = (
    "/",
    "/?token=no",
    "/app/static/index.html",
    "/app/static/js/main.js",
    "/app/static/css/theme.css",
    "/app/static/uPlot.iife.js",
    f"{FRAME}/",
    "/viser/index.html",
    "/nothing",
    *SOCKETS,
)
HOSTS = ("evil.example", "127.0.0.1.evil.example", "", "0.0.0.0", "[::2]")
ORIGINS = ("http://evil.example", "null", "http://127.0.0.1", "https://127.0.0.1:1", "")
UPGRADE = {
    "Upgrade": "websocket",
    "Connection": "Upgrade",
    "Sec-WebSocket-Version": "13",
    "Sec-WebSocket-Key": "dGhlIHNhbXBsZSBub25jZQ==",
}


def _socket_status(server: PageServer, path: str, headers: dict[str, str]) -> int:
    """101 where the websocket opens, else the status of the refusal."""

    async def knock() -> int:
        try:
            async with connect(
                f"ws://127.0.0.1:{server.port}{path}",
                subprotocols=[Subprotocol(f"viser-v{viser.__version__}")],
                additional_headers=headers,
            ):
                return 101
        except InvalidStatus as refusal:
            return refusal.response.status_code

    return asyncio.run(knock())


@pytest.mark.parametrize("path", ROUTES)
@pytest.mark.parametrize(
    "headers",
    [
        {},
        {"Cookie": "keyphase-1=x"},
        {"Cookie": "token"},
        {"Authorization": "Bearer x"},
    ],
)
def test_without_the_token_every_route_is_forbidden(
    server: PageServer, path: str, headers: dict[str, str]
) -> None:
    assert get(server, path, headers)[0].status == 403


@pytest.mark.parametrize("path", ROUTES)
@pytest.mark.parametrize("host", HOSTS)
def test_a_host_that_is_not_ours_is_forbidden(server: PageServer, path: str, host: str) -> None:
    assert get(server, path, {**cookie(server), "Host": host})[0].status == 403


@pytest.mark.parametrize("path", ROUTES)
@pytest.mark.parametrize("origin", ORIGINS)
def test_a_page_from_elsewhere_is_forbidden(server: PageServer, path: str, origin: str) -> None:
    assert get(server, path, {**cookie(server), "Origin": origin})[0].status == 403


@pytest.mark.parametrize("path", SOCKETS)
def test_both_websockets_ask_for_the_same(server: PageServer, path: str) -> None:
    ours = f"http://127.0.0.1:{server.port}"
    good = cookie(server)

    assert _socket_status(server, path, good) == 101
    assert _socket_status(server, path, {**good, "Origin": ours}) == 101
    assert _socket_status(server, path, {}) == 403
    assert _socket_status(server, path, cookie(server, "wrong")) == 403
    assert _socket_status(server, path, {**good, "Origin": "http://evil.example"}) == 403


@pytest.mark.parametrize("path", SOCKETS)
@pytest.mark.parametrize(
    "query", ["", "?token=", "?token=wrong", "?token=%00", "?token=wrong&token="]
)
def test_no_websocket_opens_with_a_token_that_is_missing_or_wrong(
    server: PageServer, path: str, query: str
) -> None:
    path += query.replace("?", "&") if "?" in path else query
    assert get(server, path, UPGRADE)[0].status == 403
    assert get(server, path, {**UPGRADE, **cookie(server, "wrong")})[0].status == 403


@pytest.mark.parametrize("path", SOCKETS)
@pytest.mark.parametrize(
    "wrong",
    [{"Host": host} for host in HOSTS] + [{"Origin": origin} for origin in ORIGINS],
    ids=str,
)
def test_no_websocket_opens_for_a_wrong_host_or_a_page_from_elsewhere(
    server: PageServer, path: str, wrong: dict[str, str]
) -> None:
    assert get(server, path, {**UPGRADE, **cookie(server), **wrong})[0].status == 403


def test_a_websocket_anywhere_else_does_not_open(server: PageServer) -> None:
    for path in (
        "/",
        "/viser",
        "/viser?x=1",
        f"{FRAME}/",
        f"{FRAME}?x=1",
        "/viser/xyz",
        "/app/ws?page=xyz",
        "/app/ws?x=1",
        f"/app/ws?token={server.access.token}",
    ):
        assert _socket_status(server, path, cookie(server)) == 404


def test_the_link_turns_the_token_into_a_cookie_no_script_and_no_other_site_gets(
    server: PageServer,
) -> None:
    response, _ = get(server, server.link.partition(str(server.port))[2])

    assert response.status == 200
    set_cookie = response.getheader("Set-Cookie") or ""
    assert set_cookie.startswith(f"keyphase-{server.port}={server.access.token};")
    assert "HttpOnly" in set_cookie
    assert "SameSite=Strict" in set_cookie


def test_without_a_token_in_the_link_no_cookie_is_set(server: PageServer) -> None:
    assert get(server, "/", cookie(server))[0].getheader("Set-Cookie") is None


def test_the_cookie_of_another_port_opens_nothing(server: PageServer) -> None:
    other = {"Cookie": f"{cookie_name(server.port + 1)}={server.access.token}"}

    assert get(server, "/", other)[0].status == 403


@pytest.mark.parametrize(
    "foreign",
    [
        'prefs={"theme":"dark","n":[1]}',
        "bare",
        "=no name",
        'quoted="a; b=c"',
        'unclosed="',
        "umlaut=\u00fc\u00e4",
        "keyphase-1=x; keyphase-1=y",
        "; ;; ",
        "long=" + "x" * 100_000,
        "; ".join(f"c{k}={'v' * 400}" for k in range(170)),
    ],
    ids=range(10),
)
def test_cookies_of_other_programs_on_this_host_change_nothing(
    server: PageServer, foreign: str
) -> None:
    """Browsers send cookies to every port of a host, of whatever form their programs like."""
    (ours,) = cookie(server).values()
    for both in (f"{foreign}; {ours}", f"{ours}; {foreign}"):
        assert get(server, "/app/static/js/main.js", {"Cookie": both})[0].status == 200
        assert get(server, FRAME, {**UPGRADE, "Cookie": both})[0].status == 101
    assert get(server, "/", {"Cookie": foreign})[0].status == 403


def test_a_cookie_of_our_name_that_another_program_has_set_shuts_nobody_out(
    server: PageServer,
) -> None:
    (ours,) = cookie(server).values()
    forged = f"{cookie_name(server.port)}=forged"

    assert get(server, "/", {"Cookie": f"{forged}; {ours}"})[0].status == 200
    assert get(server, "/", {"Cookie": forged})[0].status == 403


def test_a_link_for_once_opens_the_page_once(server: PageServer) -> None:
    link = server.access.link_for_once(server.port, Grant.EVERYTHING).partition(str(server.port))[2]

    first, _ = get(server, link)
    second, _ = get(server, link)

    assert first.status == 200
    assert (first.getheader("Set-Cookie") or "").startswith(
        f"{cookie_name(server.port)}={server.access.token};"
    )
    assert second.status == 403
    assert get(server, link, cookie(server))[0].status == 200


def test_a_link_for_once_opens_nothing_but_the_page(server: PageServer) -> None:
    ticket = server.access.link_for_once(server.port, Grant.EVERYTHING).partition("?")[2]

    assert get(server, f"/app/static/js/main.js?{ticket}")[0].status == 403
    assert get(server, f"{FRAME}?{ticket}", UPGRADE)[0].status == 403
    assert get(server, f"/?{ticket}", {"Host": "evil.example"})[0].status == 403
    assert get(server, f"/?{ticket}")[0].status == 200


def test_who_may_only_look_cannot_take_the_place_of_another_page(server: PageServer) -> None:
    page = "5" * 32
    looking = cookie(server, server.access.looking_token)

    assert _socket_status(server, f"/app/ws?page={page}", cookie(server)) == 101
    assert _socket_status(server, f"/viser/{page}", cookie(server)) == 101
    assert _socket_status(server, f"/viser/{page}", looking) == 403
    assert _socket_status(server, f"/app/ws?page={page}", looking) == 403
    assert _socket_status(server, f"/viser/{'6' * 32}", looking) == 101


def test_the_link_for_looking_sees_everything_and_changes_nothing(server: PageServer) -> None:
    with PageClient(server, server.access.looking_token) as page:
        assert page.wait_for("hello")["read_only"]
        page.wait_for("document")
        page.send("set", parameter="force_ratio", value=50.0)
        refusal = page.wait_for("refused")
        page.send("signals", request=1, tracks=["speed"], from_s=0.0, to_s=1.0, width=10)
        header, _ = page.wait_for_signals()

    assert "looking only" in refusal["text"]
    assert header["request"] == 1


def test_a_server_opened_read_only_gives_the_link_for_looking(start_server: StartServer) -> None:
    server = start_server(read_only=True)

    assert server.link.endswith(server.access.looking_token)
    assert server.access.looking_token != server.access.token


def test_tokens_are_long_and_new_each_time() -> None:
    assert Access("127.0.0.1").token != Access("127.0.0.1").token
    assert len(Access("127.0.0.1").token) >= 43


def test_open_to_other_machines_any_address_will_do_but_no_name() -> None:
    access = Access("0.0.0.0")

    def asks(host: str) -> Grant:
        return access.grant(f"/?token={access.token}", {"Host": host}, 80)

    assert asks("192.168.1.7:80") is Grant.EVERYTHING
    assert asks("[fe80::1]:80") is Grant.EVERYTHING
    with pytest.raises(RequestError, match="Host"):
        asks("rebound.example:80")


@given(
    path=st.text(),
    headers=st.dictionaries(st.sampled_from(["Host", "Cookie", "Origin"]), st.text()),
)
def test_whatever_is_sent_is_refused_rather_than_failing(
    path: str, headers: dict[str, str]
) -> None:
    with pytest.raises(RequestError):
        Access("127.0.0.1").grant(path, headers, 80)


def test_an_address_nobody_can_listen_on_is_refused(start_server: StartServer) -> None:
    with pytest.raises(KeyphaseError, match=r"--host or --port"):
        start_server(host="203.0.113.1")


def test_a_port_that_is_taken_is_refused(server: PageServer, start_server: StartServer) -> None:
    with pytest.raises(KeyphaseError, match=str(server.port)):
        start_server(port=server.port)
