"""viser's client as a page's frame gets it: one file, with a head of ours put into it.

It is read, changed and packed once. What the head does is told in docs/page.md.
"""

import gzip
import hashlib
from dataclasses import dataclass
from http import HTTPStatus
from pathlib import Path

import viser
from websockets.http11 import Response

from keyphase.errors import KeyphaseError
from keyphase.web.transport.responses import answer

INDEX = Path("client", "build", "index.html")
"""Where viser keeps its client, below its package."""

HEAD = """<style>[data-floating-window], [data-dock-region], .mantine-Paper-root,
.mantine-Notifications-root, .mantine-Affix-root { display: none !important; }
canvas[data-engine] { background: #f1f3f5; }
[data-mantine-color-scheme="dark"] canvas[data-engine] { background: #141414; }</style>
<script>
document.hasFocus = () => true;
for (const kind of ["keydown", "keyup"]) window.addEventListener(kind, (event) => {
  event.stopImmediatePropagation();
  const { key, code, ctrlKey, shiftKey, altKey, metaKey, repeat } = event;
  const said = { key, code, ctrlKey, shiftKey, altKey, metaKey, repeat };
  const passed = new parent.KeyboardEvent(kind, { ...said, bubbles: true, cancelable: true });
  if (!frameElement?.dispatchEvent(passed)) event.preventDefault();
}, true);
</script>
"""
"""viser's own panel, hints and sheet are hidden: all that is offered is our page's. Behind the
scene is the sky of its palette, from the first frame on. viser's client
tries to connect again only while its frame has the focus, which the page has. And keys that are
pressed in the frame are the page's, before viser takes them to move the camera."""

_AFTER = "<head>"
_HTML = "text/html; charset=utf-8"


@dataclass(frozen=True)
class ViserPage:
    """viser's client with our head: the file, the same packed, and what tells it from others."""

    plain: bytes
    packed: bytes
    tag: str

    def response(self, policy: str, accepted: str, known_tag: str | None) -> Response:
        """The file, packed where `accepted` says so, 304 where the browser has it."""
        if known_tag == self.tag:
            response = answer(HTTPStatus.NOT_MODIFIED, b"", _HTML, policy)
        elif "gzip" in accepted:
            response = answer(HTTPStatus.OK, self.packed, _HTML, policy)
            response.headers["Content-Encoding"] = "gzip"
        else:
            response = answer(HTTPStatus.OK, self.plain, _HTML, policy)
        response.headers["ETag"] = self.tag
        response.headers["Vary"] = "Accept-Encoding"
        return response


def viser_page(head: str = HEAD) -> ViserPage:
    """Read viser's client out of its package and put `head` into it, before its own scripts.

    Raises KeyphaseError where the client is not as it was in the version this was written for.
    """
    assert viser.__file__ is not None
    path = Path(viser.__file__).parent / INDEX
    try:
        text = path.read_text(encoding="utf-8")
    except OSError as error:
        raise KeyphaseError(f"viser's client is missing at {path}; install viser again.") from error
    if text.count(_AFTER) != 1:
        raise KeyphaseError(f"{path} has no head; install viser as constraints.txt has it.")
    plain = text.replace(_AFTER, _AFTER + head).encode()
    tag = f'"{hashlib.sha256(plain).hexdigest()[:32]}"'
    return ViserPage(plain, gzip.compress(plain, mtime=0), tag)
