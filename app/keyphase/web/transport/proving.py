"""The gate proves itself before anybody is told the link: who brings no token must stay outside."""

import secrets
from http import HTTPStatus
from http.client import HTTPConnection, HTTPException

from keyphase.errors import KeyphaseError

_WAIT_S = 10.0

_WEBSOCKET = {
    "Connection": "Upgrade",
    "Upgrade": "websocket",
    "Sec-WebSocket-Version": "13",
    "Sec-WebSocket-Key": "a2V5cGhhc2UgZ2F0ZSBwcg==",
}


def prove(host: str, port: int) -> None:
    """Knock without a token: at the page, at viser's client, and at both websockets.

    Raises KeyphaseError unless each answers 403.
    """
    address = "127.0.0.1" if host in ("0.0.0.0", "") else "::1" if host == "::" else host
    frame = f"/viser/{secrets.token_hex(16)}"
    knocks: tuple[tuple[str, dict[str, str]], ...] = (
        ("/", {}),
        (f"{frame}/", {}),
        (frame, _WEBSOCKET),
        ("/app/ws", _WEBSOCKET),
    )
    for path, headers in knocks:
        came = _status(address, port, path, headers)
        if came != HTTPStatus.FORBIDDEN:
            raise KeyphaseError(
                f"keyphase does not serve: {path} without a token must be answered by 403, but "
                f"{came or 'nothing'} came; reinstall viser and websockets as constraints.txt "
                "has them."
            )


def _status(address: str, port: int, path: str, headers: dict[str, str]) -> int | None:
    connection = HTTPConnection(address, port, timeout=_WAIT_S)
    try:
        connection.request("GET", path, headers=headers)
        return connection.getresponse().status
    except (OSError, HTTPException):
        return None
    finally:
        connection.close()
