"""What shows the session beside the pages: the 3D scene and viser's panel."""

from collections.abc import Callable

from keyphase.workbench.opened import Opened
from keyphase.workbench.playback import Playhead
from keyphase.workbench.worker import Worker


class View:
    """Shows the session; each overrides what concerns it.

    All methods are called from one thread, after the pages have been told.
    """

    def show_document(self, opened: Opened) -> None:
        """The document has changed, or another recording is the current one."""

    def show_playhead(self, playhead: Playhead) -> None:
        """The playhead has moved."""

    def show_selection(self, segment: int | None) -> None:
        """Another segment is selected."""

    def show_parts(self, hidden: frozenset[str]) -> None:
        """Parts of the scene are shown or hidden."""

    def show_theme(self, dark: bool) -> None:
        """The page has become light or dark."""


class Views:
    """All views, served by one thread that skips what is no longer true when its turn comes."""

    def __init__(self, on_error: Callable[[Exception], None]) -> None:
        self._views: tuple[View, ...] = ()
        self._painter = Worker(on_error)

    def add(self, view: View) -> None:
        """Show the session in `view` from now on."""
        self._views = (*self._views, view)

    def show(self, kind: str, show: Callable[[View], None]) -> None:
        """Call `show` with every view, unless something newer of its kind waits by then."""
        for number, view in enumerate(self._views):
            self._painter.submit(lambda view=view: show(view), f"{kind} in {number}")

    def wait_until_shown(self, timeout_s: float) -> bool:
        """Whether the views show everything they were told, within `timeout_s`."""
        return self._painter.wait_until_idle(timeout_s)

    def stop(self) -> None:
        """Show no more."""
        self._painter.stop()
        self._painter.join()
