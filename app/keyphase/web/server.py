"""Open the page: build the session, put it behind one port, print the link, wait."""

import threading
import webbrowser
from collections.abc import Sequence
from pathlib import Path

from keyphase import __version__
from keyphase.errors import KeyphaseError
from keyphase.readers import find_recordings
from keyphase.robot.arms import robot_arms, yumi_arms
from keyphase.robot.description import RobotDescription
from keyphase.segmentation.parameters import RANGES
from keyphase.web.access import Access, Grant
from keyphase.web.library import Library
from keyphase.web.one_port import control_of, serve, silent
from keyphase.web.panel import Panel
from keyphase.web.requests import hear
from keyphase.web.robot_view import RobotView
from keyphase.web.scene import Scene
from keyphase.web.session import Session
from keyphase.web.site import OurSite
from keyphase.web.viser_controls import takes


class PageServer:
    """A running server: one session behind one port."""

    def __init__(
        self,
        paths: Sequence[Path],
        *,
        recipe: Path | None = None,
        host: str = "127.0.0.1",
        port: int = 0,
        read_only: bool = False,
        arms: Sequence[RobotDescription] | None = None,
    ) -> None:
        library = Library(recipe, read_only=read_only)
        self.session = Session(paths, library, _hello(), hear)
        self.access = Access(host)
        self._grant = Grant.LOOKING if read_only else Grant.EVERYTHING
        site = OurSite(self.access, self.session.sockets, self.accepts)
        try:
            self.viser = serve(site, host, port)
        except KeyphaseError:
            self.session.close()
            raise
        self.port = self.viser.get_port()
        self.robot = RobotView(self.viser, self.session.telling, arms or yumi_arms())
        self.scene = Scene(self.viser, self.session.select_at, lambda: self.robot.base)
        self.robot.on_stand = self.scene.stand_anew
        self.panel = Panel(self.viser, self.session)
        # The robot first: where it stands decides how the scene is seen.
        self.session.views.add(self.robot)
        self.session.views.add(self.scene)
        self.session.views.add(self.panel)
        if self.session.queue.recordings:
            self.session.queue.open(self.session.queue.recordings[0].id)

    @property
    def link(self) -> str:
        """The link that opens the page."""
        return self.access.link(self.port, self._grant)

    def accepts(self, uuid: str, value: object) -> bool:
        """Whether a browser may set the control it calls `uuid` to `value`."""
        return takes(control_of(self.viser, uuid), value)

    def stop(self) -> None:
        """Stop serving and close the recordings."""
        self.session.close()
        self.robot.close()
        with silent():
            self.viser.stop()


def open_page(
    paths: Sequence[Path],
    *,
    host: str = "127.0.0.1",
    port: int = 0,
    open_browser: bool = True,
    read_only: bool = False,
    recipe: Path | None = None,
    robot: Path | None = None,
    tool_frame: str | None = None,
) -> None:
    """Serve the page on `paths` (recordings, or folders of them) until interrupted.

    Raises RobotError for a robot that cannot be used, KeyphaseError if nothing can listen on
    `host` and `port`.
    """
    arms = robot_arms(robot, tool_frame)
    found = find_recordings(paths, recipe)
    server = PageServer(
        [one.path for one in found],
        recipe=recipe,
        host=host,
        port=port,
        read_only=read_only,
        arms=arms,
    )
    print(server.link, flush=True)
    if open_browser:
        webbrowser.open(server.link)
    try:
        threading.Event().wait()
    except KeyboardInterrupt:
        print()
    finally:
        server.stop()


def _hello() -> dict[str, object]:
    return {
        "type": "hello",
        "version": __version__,
        "theme_default": "light",
        "ranges": {name: list(bounds) for name, bounds in RANGES.items()},
        "labels": [],
    }
