"""The answer to somebody without the token: a page that explains itself, or a line of text."""

import base64
import hashlib
import html
from http import HTTPStatus
from pathlib import Path

from websockets.http11 import Response

from keyphase.web.transport.responses import answer, text

_HERE = Path(__file__).parent
_LOGO = _HERE.parent / "page" / "logo.svg"


def refused(reason: str, accept: str) -> Response:
    """403: for a person who opens a page a page of ours, for programs the reason as text.

    Nothing else is served without the token, so all of the page is in one file.
    """
    if "text/html" not in accept:
        return text(HTTPStatus.FORBIDDEN, reason)
    style = (_HERE / "refused.css").read_text(encoding="utf-8")
    logo = _LOGO.read_bytes()
    body = (_HERE / "refused.html").read_text(encoding="utf-8")
    for name, value in (
        ("style", style),
        ("logo", logo.decode()),
        ("icon", base64.b64encode(logo).decode()),
        ("reason", html.escape(reason)),
    ):
        body = body.replace(f"{{{name}}}", value)
    digest = base64.b64encode(hashlib.sha256(style.encode()).digest()).decode()
    policy = (
        f"default-src 'none'; style-src 'sha256-{digest}'; img-src data:; "
        "base-uri 'none'; form-action 'none'; frame-ancestors 'self'"
    )
    return answer(HTTPStatus.FORBIDDEN, body.encode(), "text/html; charset=utf-8", policy)
