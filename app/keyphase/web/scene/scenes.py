"""The scenes of all pages: each is made when its frame connects, and made again when it does so.

Only async callbacks of viser's know whose frame they concern; what takes time is not done in them,
for they run in the one event loop of all pages.
"""

import logging
import threading
from dataclasses import dataclass, field

import viser

from keyphase.web.scene.camera import LastCamera
from keyphase.web.scene.page_scene import PageScene
from keyphase.web.scene.shared import Shared
from keyphase.web.transport.addresses import PAGE
from keyphase.workbench.workbench import Workbench

_log = logging.getLogger(__name__)

MAX_REMEMBERED = 1000
"""So many pages' cameras are remembered."""


@dataclass
class _Remembered:
    """What of a page's scene outlives its client."""

    camera: LastCamera = field(default_factory=LastCamera)
    scene: PageScene | None = None


class Scenes:
    """Makes a scene for each client that connects, of the view of the page in whose frame it is.

    A page may have two clients for a moment, where a broken connection is not known to be broken:
    the newest counts.
    """

    def __init__(self, server: viser.ViserServer, workbench: Workbench, shared: Shared) -> None:
        self._server, self._workbench, self._shared = server, workbench, shared
        self._lock = threading.RLock()
        self._pages: dict[str, _Remembered] = {}
        server.on_client_connect(self._came)
        server.on_client_disconnect(self._went)

    def of(self, page: str) -> PageScene | None:
        """The scene of a page, while its frame is connected."""
        with self._lock:
            remembered = self._pages.get(page)
            return remembered.scene if remembered else None

    @property
    def all(self) -> tuple[PageScene, ...]:
        """Every scene that is shown."""
        with self._lock:
            return tuple(one.scene for one in self._pages.values() if one.scene is not None)

    def wait_until_drawn(self, timeout_s: float) -> bool:
        """Whether all scenes show what they were told, and what had to be worked out for that."""
        scenes = self.all
        return (
            all(scene.wait_until_drawn(timeout_s) for scene in scenes)
            and self._shared.wait_until_idle(timeout_s)
            and all(scene.wait_until_drawn(timeout_s) for scene in scenes)
        )

    def close(self) -> None:
        """Draw no more."""
        for page in tuple(self._pages):
            self._end(page, None)
        self._shared.close()

    async def _came(self, client: viser.ClientHandle) -> None:
        page = PAGE.get()
        if page is not None:
            # Making a scene draws it, outside of the loop: in a thread of its own.
            threading.Thread(target=self._begin, args=(page, client), daemon=True).start()

    async def _went(self, client: viser.ClientHandle) -> None:
        page = PAGE.get()
        if page is not None:
            threading.Thread(target=self._end, args=(page, client), daemon=True).start()

    def _begin(self, page: str, client: viser.ClientHandle) -> None:
        try:
            self._end(page, None)
            view = self._workbench.enter(page)
            with self._lock:
                remembered = self._pages.setdefault(page, _Remembered())
                self._forget_oldest()
                scene = PageScene(self._server, client, self._shared, view, remembered.camera)
                remembered.scene = scene
                self._shared.pages = len(self.all)
            view.watch(scene)
        except Exception:
            _log.exception("The scene of a page could not be made.")

    def _end(self, page: str, client: viser.ClientHandle | None) -> None:
        """The client has gone; it may have been followed by another one already."""
        with self._lock:
            remembered = self._pages.get(page)
            scene = remembered.scene if remembered else None
            if remembered is None or scene is None or client not in (None, scene.client):
                return
            remembered.scene = None
            self._shared.pages = len(self.all)
        scene.close()
        self._workbench.leave(page)

    def _forget_oldest(self) -> None:
        idle = [page for page, one in self._pages.items() if one.scene is None]
        for page in idle[: max(len(self._pages) - MAX_REMEMBERED, 0)]:
            del self._pages[page]
