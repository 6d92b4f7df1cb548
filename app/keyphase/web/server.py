"""Open the page: build the session, put it behind one port, print the link, wait."""

import signal
import sys
import threading
from collections.abc import Sequence
from pathlib import Path

import viser

from keyphase import __version__
from keyphase.errors import KeyphaseError
from keyphase.readers import find_recordings
from keyphase.robot.arms import robot_arms, yumi_arms
from keyphase.robot.description import RobotDescription
from keyphase.segmentation.parameters import RANGES
from keyphase.simulation.demonstrating.recorder import recover
from keyphase.web.protocol.controls import Controls, RecordTeller
from keyphase.web.protocol.dispatch import hear
from keyphase.web.scene.ground_shadow import shadow_of
from keyphase.web.scene.parts_view import PartsView
from keyphase.web.scene.replay_scene import ReplayCloser, ReplayScene
from keyphase.web.scene.robot_view import RobotView
from keyphase.web.scene.scene import Scene
from keyphase.web.scene.workcell_scene import WorkcellCloser, WorkcellScene
from keyphase.web.transport.access import Access, Grant
from keyphase.web.transport.lasting_keys import LastingKeys
from keyphase.web.transport.one_port import serve, silent, usable_port
from keyphase.web.transport.opening import BrowserFile, open_in_browser
from keyphase.web.transport.proving import prove
from keyphase.web.transport.site import OurSite
from keyphase.workbench.lead_through_session import LeadThroughSession
from keyphase.workbench.library import Library
from keyphase.workbench.session import Session
from keyphase.workbench.uploads import DEFAULT_LIMIT_BYTES


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
        upload_limit_bytes: int = DEFAULT_LIMIT_BYTES,
        arms: Sequence[RobotDescription] | None = None,
        folder: Path | None = None,
    ) -> None:
        library = Library(recipe, read_only=read_only)
        self.session = Session(paths, library, _hello(), hear)
        self.session.upload_limit_bytes = upload_limit_bytes
        self._browser_file: BrowserFile | None = None
        self._folder = folder or recording_folder(paths)
        self._grant = Grant.LOOKING if read_only else Grant.EVERYTHING
        try:
            self._listen(host, port)
        except KeyphaseError:
            self.session.close()
            raise
        arms = arms or yumi_arms()
        self.robot = RobotView(self.viser, self.session.telling, arms)
        self.scene = Scene(
            self.viser, self.session.select_at, lambda: self.robot.base, shadow_of(arms[0])
        )
        self.parts = PartsView(self.viser, self.session.telling)
        self.robot.on_stand = self.scene.stand_anew
        self._put_in_order_of_need()
        # The robot first: where it stands decides how the scene is seen.
        self.session.views.add(self.robot)
        self.session.views.add(self.scene)
        self.session.views.add(self.parts)
        self.lead_through = LeadThroughSession(
            self._folder, self.session.queue, self.session.telling
        )
        if not read_only:
            self._offer_recording()
        self._offer_replay()
        self._offer_controls()
        self.session.queue.open_first()

    def _listen(self, host: str, port: int) -> None:
        """Listen on the port that this folder's server had before, where none is asked for."""
        self._keys = LastingKeys(self._folder)
        self.port = usable_port(host, port, self._keys.ports())
        keys = self._keys.of(self.port)
        self.access = Access(host, keys.token, keys.looking_token)
        site = OurSite(self.access, self.session.sockets)
        self.viser = serve(site, host, self.port)
        try:
            prove(host, self.port)
        except KeyphaseError:
            with silent():
                self.viser.stop()
            raise

    @property
    def link(self) -> str:
        """The link that opens the page."""
        return self.access.link(self.port, self._grant)

    def open_browser(self) -> bool:
        """Start the browser on the page; whether that was done."""
        link = self.access.link_for_once(self.port, self._grant)
        self._browser_file = open_in_browser(link, self._keys.folder)
        return self._browser_file is not None

    def _put_in_order_of_need(self) -> None:
        """What is asked for comes first, then what is seen beside it, then other recordings."""
        self.robot.paths.gives_way = lambda: not (self.session.is_free and self.parts.is_free)
        self.session.queue.may_look = lambda: self.robot.is_free

    def _offer_recording(self) -> None:
        lead = self.lead_through
        lead.add(WorkcellScene(self.viser, self.scene, self.robot, lead))
        self.session.views.add(WorkcellCloser(lead))

        @self.viser.on_client_disconnect
        def _(_client: viser.ClientHandle) -> None:
            if not self.viser.get_clients():
                lead.close()

    def _offer_controls(self) -> None:
        replay = self.session.replay
        controls = Controls(
            self.session.telling.all, self.lead_through, replay, self._replay_scene, self.robot
        )
        self.lead_through.add(RecordTeller(self.session.telling.all))
        replay.add(controls)
        self.session.controls = controls

    def _offer_replay(self) -> None:
        replay, telling = self.session.replay, self.session.telling
        self._replay_scene = ReplayScene(self.viser, self.scene, self.robot, replay, telling)
        replay.add(self._replay_scene)
        self.session.views.add(ReplayCloser(replay))

    def stop(self) -> None:
        """Stop serving and close the recordings."""
        if self._browser_file is not None:
            self._browser_file.close()
        self.lead_through.close()
        self.session.close()
        self._replay_scene.close()
        self.robot.close()
        self.parts.close()
        with silent():
            self.viser.stop()


def open_page(
    paths: Sequence[Path],
    *,
    host: str = "127.0.0.1",
    port: int = 0,
    open_browser: bool = True,
    read_only: bool = False,
    upload_limit_bytes: int = DEFAULT_LIMIT_BYTES,
    recipe: Path | None = None,
    robot: Path | None = None,
    tool_frame: str | None = None,
) -> None:
    """Serve the page on `paths` (recordings, or folders of them) until told to stop.

    Called from the main thread. Raises RobotError for a robot that cannot be used, KeyphaseError
    if nothing can listen on `host` and `port`.
    """
    arms = robot_arms(robot, tool_frame)
    folder = recording_folder(paths)
    if not read_only:
        for take in recover(folder):
            print(f"Recovered {take.path} ({take.duration_s:.1f} s)", file=sys.stderr)
    found = find_recordings(paths, recipe)
    server = PageServer(
        [one.path for one in found],
        recipe=recipe,
        host=host,
        port=port,
        read_only=read_only,
        upload_limit_bytes=upload_limit_bytes,
        arms=arms,
        folder=folder,
    )
    told = _told_to_stop()
    print(server.link, flush=True)
    if open_browser and not server.open_browser():
        print("Follow this link: the browser cannot be opened from here.", file=sys.stderr)
    try:
        while not told.wait(0.5):
            continue
    finally:
        server.stop()


def _told_to_stop() -> threading.Event:
    """Set by Ctrl-C, or when the system asks; a second time ends the program at once."""
    told = threading.Event()

    def stop(_number: int, _frame: object) -> None:
        told.set()
        for number, handler in before.items():
            signal.signal(number, handler)

    before = {number: signal.signal(number, stop) for number in (signal.SIGINT, signal.SIGTERM)}
    return told


def recording_folder(paths: Sequence[Path]) -> Path:
    """Where new recordings are put: beside those that are open, or into the current folder."""
    if not paths:
        return Path.cwd()
    return paths[0] if paths[0].is_dir() else paths[0].parent


def _hello() -> dict[str, object]:
    return {
        "type": "hello",
        "version": __version__,
        "theme_default": "light",
        "ranges": {name: list(bounds) for name, bounds in RANGES.items()},
        "labels": [],
    }
