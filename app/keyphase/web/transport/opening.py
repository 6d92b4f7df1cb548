"""Opening the page in the browser, with nothing on its command line that others could use.

Every user of a machine can read what programs were started with. So the browser is started with
the path of a file that only its owner can read, and the link in that file opens the page once.
"""

import html
import threading
import webbrowser
from pathlib import Path

from keyphase.web.transport.private_files import private_folder, write_private

FORGOTTEN_AFTER_S = 60.0
"""So long a browser has to read the file."""

_SNAPS = Path("/snap/bin")

_PAGE = """<!doctype html>
<html lang="en"><head><meta charset="utf-8"><meta name="referrer" content="no-referrer">
<meta http-equiv="refresh" content="0;url={link}"><title>keyphase</title></head>
<body><p><a href="{link}" rel="noreferrer">Open keyphase</a></p></body></html>
"""


class BrowserFile:
    """The file that leads a browser to the page; gone when closed, or after a minute."""

    def __init__(self, link: str, folder: Path) -> None:
        """Raises OSError where no private file can be made."""
        self.path = _place(folder) / "keyphase-open.html"
        write_private(self.path, _PAGE.format(link=html.escape(link)).encode())
        self._timer = threading.Timer(FORGOTTEN_AFTER_S, self.close)
        self._timer.daemon = True
        self._timer.start()

    def close(self) -> None:
        """Remove the file."""
        self._timer.cancel()
        self.path.unlink(missing_ok=True)


def open_in_browser(link_for_once: str, folder: Path) -> BrowserFile | None:
    """Start the browser on the page; None where that cannot be done without showing the link."""
    try:
        file = BrowserFile(link_for_once, folder)
    except OSError:
        return None
    webbrowser.open(file.path.as_uri())
    return file


def _place(folder: Path) -> Path:
    """The private folder; but browsers from snaps see only what is visible in the home folder."""
    return Path.home() if _SNAPS.is_dir() else private_folder(folder)
