"""A page's 3D frame without a browser: viser's websocket, and the scene that is drawn for it."""

import contextlib
import threading
from collections.abc import Iterator

import msgspec
import viser
from talking import CAMERA, PAGE, WAIT_S, cookie
from websockets.sync.client import ClientConnection, connect
from websockets.typing import Subprotocol

from keyphase.web.scene.page_scene import PageScene
from keyphase.web.server import PageServer

DRAWN_WITHIN_S = 60.0


def wait_until_free(server: PageServer) -> None:
    """Until no recording is at work."""
    for _ in range(int(DRAWN_WITHIN_S / 0.02)):
        if server.workbench.library.is_free:
            return
        threading.Event().wait(0.02)
    raise AssertionError("a recording is still at work")


class Frame:
    """A page's frame that listens, and what is drawn for it."""

    def __init__(self, server: PageServer, page: str, socket: ClientConnection) -> None:
        self.server, self.page, self._socket = server, page, socket
        self.bytes = 0
        self._listening = threading.Thread(target=self._listen, daemon=True)
        self._listening.start()
        self.say(CAMERA)

    def say(self, message: dict[str, object]) -> None:
        self._socket.send(msgspec.msgpack.encode(message))

    def shout(self, raw: bytes) -> None:
        self._socket.send(raw)

    def wait(self) -> None:
        """Until its scene has come."""
        for _ in range(int(WAIT_S / 0.02)):
            if self.server.scenes.of(self.page) is not None:
                return
            threading.Event().wait(0.02)
        raise AssertionError("no scene came")

    @property
    def scene(self) -> PageScene:
        """What is drawn, when all of it is."""
        self.settle()
        scene = self.server.scenes.of(self.page)
        assert scene is not None
        return scene

    def settle(self) -> None:
        """Until everything the session has said is drawn, and what that needed is worked out.

        A page hears of a change before its scene does, both under one lock of the view's.
        """
        wait_until_free(self.server)
        view = self.server.workbench.find_view(self.page)
        with view._lock, view.scene._lock:  # pyright: ignore
            pass
        assert self.server.scenes.wait_until_drawn(DRAWN_WITHIN_S)

    def node(self, name: str):
        """The handle of a node, which must be there."""
        return self.nodes[name]

    @property
    def nodes(self) -> dict:
        """All nodes of this page's own scene."""
        return self.scene.client.scene._handle_from_node_name  # pyright: ignore

    def _listen(self) -> None:
        with contextlib.suppress(Exception):
            while True:
                self.bytes += len(self._socket.recv())


@contextlib.contextmanager
def frame(server: PageServer, page: str = PAGE) -> Iterator[Frame]:
    """A frame of `page` that is connected."""
    with connect(
        f"ws://127.0.0.1:{server.port}/viser/{page}",
        subprotocols=[Subprotocol(f"viser-v{viser.__version__}")],
        additional_headers=cookie(server),
        max_size=None,
    ) as socket:
        framed = Frame(server, page, socket)
        framed.wait()
        yield framed
