"""Which page a request belongs to: every page has an id of its own, and its 3D frame's path has it.

viser's client opens its websocket at the path of its frame and nothing else of ours reaches that
websocket, so the id is in the path; see docs/page.md.
"""

import re
import threading
from contextvars import ContextVar
from urllib.parse import parse_qs, urlsplit

from keyphase.web.transport.access import Grant

PAGE_SOCKET = "/app/ws"

PAGE: ContextVar[str | None] = ContextVar("PAGE", default=None)
"""The page whose frame an async callback of viser's concerns; callbacks that are not async run in
threads of viser's, which do not know it."""

MAX_REMEMBERED = 10_000

_ID = re.compile(r"[0-9a-f]{32}")
_FRAME = re.compile(r"/viser/([0-9a-f]{32})(/?)")


def page_of_socket(path: str) -> str | None:
    """The page that opens its websocket at `path`: "" for one without an id, None elsewhere."""
    try:
        parts = urlsplit(path)
        given = parse_qs(parts.query, keep_blank_values=True)
    except ValueError:
        return None
    if parts.path != PAGE_SOCKET or set(given) - {"page"}:
        return None
    if "page" not in given:
        return ""
    page = given["page"][0]
    return page if _ID.fullmatch(page) else None


def page_of_frame_socket(path: str) -> str | None:
    """The page whose 3D frame opens its websocket at `path`, if that is what it is."""
    found = _FRAME.fullmatch(path)
    return found[1] if found and not found[2] else None


def is_frame(path: str) -> bool:
    """Whether viser's client is to be had at `path`, whose query is not looked at."""
    found = _FRAME.fullmatch(path.partition("?")[0])
    return found is not None and found[2] == "/"


class PageOwners:
    """Which grant each page's id came with first: nobody else may use it with another.

    Else a visitor who may only look could be handed what belongs to a page that may do everything.
    """

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._grants: dict[str, Grant] = {}

    def admits(self, page: str, grant: Grant) -> bool:
        """Whether `page` may be used with `grant`; the first to ask decides."""
        with self._lock:
            while len(self._grants) >= MAX_REMEMBERED and page not in self._grants:
                del self._grants[next(iter(self._grants))]
            return self._grants.setdefault(page, grant) is grant
