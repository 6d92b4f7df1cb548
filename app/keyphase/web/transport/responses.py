"""HTTP answers: the page and its files with their headers, and refusals.

Only files of known kinds below the given roots are served; a path is resolved before it is
compared with its root, so neither `..` nor a link leads out.
"""

import gzip
import hashlib
from dataclasses import dataclass, field
from http import HTTPStatus
from importlib.util import find_spec
from pathlib import Path
from urllib.parse import unquote

from websockets.datastructures import Headers
from websockets.http11 import Response

_CONTENT_TYPES = {
    ".css": "text/css; charset=utf-8",
    ".html": "text/html; charset=utf-8",
    ".js": "text/javascript; charset=utf-8",
    ".json": "application/json",
    ".png": "image/png",
    ".svg": "image/svg+xml",
    ".woff2": "font/woff2",
}

_TEXT = frozenset({".css", ".html", ".js", ".json", ".svg"})
"""What becomes much smaller when it is packed."""

_ALWAYS = {
    # Every answer is the last on its connection; who is not told asks again into a closed one.
    "Connection": "close",
    "X-Content-Type-Options": "nosniff",
    "X-Frame-Options": "SAMEORIGIN",
    "Referrer-Policy": "no-referrer",
    "Cross-Origin-Opener-Policy": "same-origin",
    "Cross-Origin-Resource-Policy": "same-origin",
}


def page_policy(host: str) -> str:
    """Content security policy of our own page: its own scripts and styles, nothing inline."""
    return (
        "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' data:; "
        f"media-src 'self'; font-src 'self'; connect-src 'self' ws://{host}; frame-src 'self'; "
        "base-uri 'none'; form-action 'none'; frame-ancestors 'self'"
    )


def viser_policy(host: str) -> str:
    """The same for viser's client, which unpacks and compiles itself in the browser."""
    return (
        "default-src 'none'; script-src 'self' 'unsafe-inline' 'unsafe-eval' blob:; "
        "worker-src 'self' blob:; style-src 'self' 'unsafe-inline'; img-src 'self' data: blob:; "
        f"font-src 'self' data:; connect-src 'self' ws://{host} data: blob:; "
        "base-uri 'none'; form-action 'none'; frame-ancestors 'self'"
    )


def answer(
    status: HTTPStatus, body: bytes, content_type: str, policy: str = "default-src 'none'"
) -> Response:
    """An answer with the headers that every answer has."""
    headers = Headers({"Content-Type": content_type, "Content-Length": str(len(body))})
    return with_headers(Response(status, status.phrase, headers, body), policy)


def with_headers(response: Response, policy: str) -> Response:
    """Put the headers on an answer that every answer has; browsers ask again each time."""
    for name, value in _ALWAYS.items():
        response.headers[name] = value
    response.headers["Content-Security-Policy"] = policy
    response.headers["Cache-Control"] = "no-cache"
    return response


def text(status: HTTPStatus, message: str) -> Response:
    """A refusal in plain text."""
    return answer(status, f"{message}\n".encode(), "text/plain; charset=utf-8")


@dataclass(frozen=True)
class StaticFiles:
    """Files under `prefix`, found in the first of `roots` that has them.

    Text is packed once, until the file becomes another.
    """

    prefix: str
    roots: tuple[Path, ...]
    _packed: dict[Path, tuple[str, bytes]] = field(default_factory=dict)

    def response(self, path: str, policy: str, known_tag: str | None, accepted: str) -> Response:
        """The file at `path`, packed where `accepted` says so and it is text.

        304 where the browser has it, 404 where there is none.
        """
        found = self._find(unquote(path).removeprefix(self.prefix))
        if found is None:
            return text(HTTPStatus.NOT_FOUND, "There is no such file.")
        body, kind = found.read_bytes(), _CONTENT_TYPES[found.suffix]
        tag = f'"{hashlib.sha256(body).hexdigest()[:32]}"'
        if tag == known_tag:
            response = answer(HTTPStatus.NOT_MODIFIED, b"", kind, policy)
        elif found.suffix in _TEXT and "gzip" in accepted:
            response = answer(HTTPStatus.OK, self._pack(found, tag, body), kind, policy)
            response.headers["Content-Encoding"] = "gzip"
        else:
            response = answer(HTTPStatus.OK, body, kind, policy)
        response.headers["ETag"] = tag
        response.headers["Vary"] = "Accept-Encoding"
        return response

    def _pack(self, path: Path, tag: str, body: bytes) -> bytes:
        known = self._packed.get(path)
        if known is None or known[0] != tag:
            known = self._packed[path] = tag, gzip.compress(body, mtime=0)
        return known[1]

    def _find(self, relative: str) -> Path | None:
        if "\0" in relative or "\\" in relative:
            return None
        for root in self.roots:
            path = (root / relative).resolve()
            inside = path.is_relative_to(root.resolve())
            if inside and path.suffix in _CONTENT_TYPES and path.is_file():
                return path
        return None


def page_files() -> StaticFiles:
    """The page's own files, and uPlot's out of its installed package."""
    spec = find_spec("uplot")
    assert spec is not None
    assert spec.submodule_search_locations
    uplot = Path(spec.submodule_search_locations[0]) / "static"
    return StaticFiles("/app/static/", (Path(__file__).parents[1] / "page", uplot))
