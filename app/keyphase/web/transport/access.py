"""Who may talk to the server: the token in the link, the cookie after it, Host and Origin.

The decision is a plain function of a request's headers, so that pages and both websockets are
gated by the same lines. See docs/security.md for what this protects against.
"""

import hmac
import ipaddress
import secrets
from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import Enum
from http.cookies import CookieError, SimpleCookie
from urllib.parse import parse_qs, urlsplit

from keyphase.errors import RequestError


class Grant(Enum):
    """What a visitor may do."""

    EVERYTHING = "everything"
    LOOKING = "looking"


@dataclass(frozen=True)
class Access:
    """The keys of one server.

    host           the address it listens on
    token          opens everything
    looking_token  opens everything to the eye and nothing to the hand
    """

    host: str
    token: str = field(default_factory=lambda: secrets.token_urlsafe(32))
    looking_token: str = field(default_factory=lambda: secrets.token_urlsafe(32))

    def link(self, port: int, grant: Grant) -> str:
        """The link that opens the page with `grant`."""
        host = "127.0.0.1" if self.host in ("0.0.0.0", "::", "") else self.host
        name = f"[{host}]" if ":" in host else host
        return f"http://{name}:{port}/?token={self._token_of(grant)}"

    def grant(self, path: str, headers: Mapping[str, str], port: int) -> Grant:
        """What the sender of a request for `path` may do.

        Raises RequestError for a Host that is not this machine's, an Origin that is not the page
        itself, and a token that is missing or wrong.
        """
        host = headers.get("Host", "")
        if not self._is_ours(host):
            raise RequestError(f"The Host header must name this server, but is {host!r}.")
        origin = headers.get("Origin")
        if origin is not None and origin != f"http://{host}":
            raise RequestError(f"The Origin must be http://{host}, but is {origin!r}.")
        return self._grant_of(
            token_in_link(path) or _token_in_cookie(headers.get("Cookie", ""), port)
        )

    def cookie(self, port: int, grant: Grant) -> str:
        """The Set-Cookie value that remembers `grant`; cookies ignore ports, so its name has it."""
        return (
            f"{cookie_name(port)}={self._token_of(grant)}; Path=/; HttpOnly; SameSite=Strict; "
            "Max-Age=2592000"
        )

    def _token_of(self, grant: Grant) -> str:
        return self.token if grant is Grant.EVERYTHING else self.looking_token

    def _grant_of(self, token: str) -> Grant:
        given = token.encode("utf-8", "surrogateescape")
        if hmac.compare_digest(given, self.token.encode()):
            return Grant.EVERYTHING
        if hmac.compare_digest(given, self.looking_token.encode()):
            return Grant.LOOKING
        raise RequestError("Open the page by the link keyphase printed: it carries the token.")

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


def token_in_link(path: str) -> str:
    """The token in a request's query, or nothing."""
    try:
        return parse_qs(urlsplit(path).query).get("token", [""])[0]
    except ValueError:
        return ""


def _token_in_cookie(header: str, port: int) -> str:
    try:
        morsel = SimpleCookie(header).get(cookie_name(port))
    except CookieError:
        return ""
    return morsel.value if morsel else ""


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
