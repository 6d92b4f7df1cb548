"""Who may talk to the server: the token in the link, the cookie after it, Host and Origin.

The decision is a plain function of a request's headers, so that pages and both websockets are
gated by the same lines. See docs/security.md for what this protects against.
"""

import hmac
import ipaddress
import secrets
import threading
from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import Enum
from urllib.parse import parse_qs, urlsplit

from keyphase.errors import RequestError

COOKIE_LASTS_S = 30 * 24 * 3600
"""A browser that has followed the link need not do so again for this long."""

_MAX_COOKIES = 16


def new_token() -> str:
    """256 random bits as 43 letters."""
    return secrets.token_urlsafe(32)


class Grant(Enum):
    """What a visitor may do."""

    EVERYTHING = "everything"
    LOOKING = "looking"


class Tickets:
    """Links that open the page once: what a browser is started with may be seen by others."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._open: dict[str, Grant] = {}

    def new(self, grant: Grant) -> str:
        """A ticket that is taken once."""
        ticket = new_token()
        with self._lock:
            self._open[ticket] = grant
        return ticket

    def take(self, ticket: str) -> Grant | None:
        """What the ticket grants, for the first who comes with it."""
        with self._lock:
            return self._open.pop(ticket, None)


@dataclass(frozen=True)
class Entry:
    """What a request is granted, and whether its browser is to remember it by a cookie."""

    grant: Grant
    remember: bool = False


@dataclass(frozen=True)
class Access:
    """The keys of one server.

    host           the address it listens on
    token          opens everything
    looking_token  opens everything to the eye and nothing to the hand
    """

    host: str
    token: str = field(default_factory=new_token)
    looking_token: str = field(default_factory=new_token)
    tickets: Tickets = field(default_factory=Tickets)

    def link(self, port: int, grant: Grant) -> str:
        """The link that opens the page with `grant`."""
        return f"{self._address(port)}/?token={self._token_of(grant)}"

    def link_for_once(self, port: int, grant: Grant) -> str:
        """A link that does so once."""
        return f"{self._address(port)}/?once={self.tickets.new(grant)}"

    def enter(self, path: str, headers: Mapping[str, str], port: int) -> Entry:
        """What the sender of a plain request for `path` may do; a ticket in it is used up.

        Raises RequestError as `grant` does.
        """
        self._check_sender(headers)
        ticket = in_link(path, "once")
        taken = self.tickets.take(ticket) if ticket and urlsplit(path).path == "/" else None
        if taken is not None:
            return Entry(taken, remember=True)
        return Entry(self.grant(path, headers, port), remember=bool(in_link(path, "token")))

    def grant(self, path: str, headers: Mapping[str, str], port: int) -> Grant:
        """What the sender of a request for `path` may do.

        Raises RequestError for a Host that is not this machine's, an Origin that is not the page
        itself, and a token that is missing or wrong.
        """
        self._check_sender(headers)
        given = in_link(path, "token")
        tokens = [given] if given else _tokens_in_cookies(headers.get("Cookie", ""), port)
        grants = {self._grant_of(token) for token in tokens}
        for grant in (Grant.EVERYTHING, Grant.LOOKING):
            if grant in grants:
                return grant
        raise RequestError("Open the page by the link keyphase printed: it carries the token.")

    def cookie(self, port: int, grant: Grant) -> str:
        """The Set-Cookie value that remembers `grant`; cookies ignore ports, so its name has it."""
        return (
            f"{cookie_name(port)}={self._token_of(grant)}; Path=/; HttpOnly; SameSite=Strict; "
            f"Max-Age={COOKIE_LASTS_S}"
        )

    def _address(self, port: int) -> str:
        host = "127.0.0.1" if self.host in ("0.0.0.0", "::", "") else self.host
        name = f"[{host}]" if ":" in host else host
        return f"http://{name}:{port}"

    def _check_sender(self, headers: Mapping[str, str]) -> None:
        host = headers.get("Host", "")
        if not self._is_ours(host):
            raise RequestError(f"The Host header must name this server, but is {host!r}.")
        origin = headers.get("Origin")
        if origin is not None and origin != f"http://{host}":
            raise RequestError(f"The Origin must be http://{host}, but is {origin!r}.")

    def _token_of(self, grant: Grant) -> str:
        return self.token if grant is Grant.EVERYTHING else self.looking_token

    def _grant_of(self, token: str) -> Grant | None:
        given = token.encode("utf-8", "surrogateescape")
        if hmac.compare_digest(given, self.token.encode()):
            return Grant.EVERYTHING
        if hmac.compare_digest(given, self.looking_token.encode()):
            return Grant.LOOKING
        return None

    def _is_ours(self, host: str) -> bool:
        """A name is ours if no DNS answer could have put it there: loopback, or as configured.

        A server opened to other machines is reached under any of its addresses, so any address
        literal will do; a name must be the one it was told.
        """
        name = _host_name(host)
        if name in ("127.0.0.1", "localhost", "::1", self.host):
            return name != ""
        return not _is_loopback(self.host) and _is_address(name)


def cookie_name(port: int) -> str:
    """Name of the cookie of the server on `port`."""
    return f"keyphase-{port}"


def in_link(path: str, name: str) -> str:
    """The value of that name in a request's query, or nothing."""
    try:
        return parse_qs(urlsplit(path).query).get(name, [""])[0]
    except ValueError:
        return ""


def _tokens_in_cookies(header: str, port: int) -> list[str]:
    """The values of our cookie, whatever other programs on this host have set beside it.

    There may be several: another program can set one of the same name for a longer path.
    """
    pairs = (pair.partition("=") for pair in header.split(";"))
    name = cookie_name(port)
    return [value.strip() for key, _, value in pairs if key.strip() == name][:_MAX_COOKIES]


def _host_name(host: str) -> str:
    try:
        return urlsplit(f"//{host}").hostname or ""
    except ValueError:
        return ""


def _is_address(name: str) -> bool:
    try:
        ipaddress.ip_address(name)
    except ValueError:
        return False
    return True


def _is_loopback(host: str) -> bool:
    return host == "localhost" or (_is_address(host) and ipaddress.ip_address(host).is_loopback)
