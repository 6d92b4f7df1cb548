"""Open the page: build the workbench, put it behind one port, print the link, wait."""

import signal
import sys
import threading
from collections import deque
from collections.abc import Sequence
from pathlib import Path

from keyphase.errors import KeyphaseError
from keyphase.labeling.labeling import Labeling
from keyphase.readers import find_recordings
from keyphase.robot.arms import robot_arms, yumi_arms
from keyphase.robot.description import RobotDescription
from keyphase.web.memory import keep_few_heaps
from keyphase.web.protocol.conversation import Conversation
from keyphase.web.scene.scenes import Scenes
from keyphase.web.scene.shared import Shared
from keyphase.web.transport.access import Access, Grant
from keyphase.web.transport.lasting_keys import LastingKeys
from keyphase.web.transport.one_port import serve, silent, usable_port
from keyphase.web.transport.opening import BrowserFile, open_in_browser
from keyphase.web.transport.page_sockets import Page, PageSockets
from keyphase.web.transport.proving import prove
from keyphase.web.transport.site import OurSite
from keyphase.web.transport.video_parts import Video
from keyphase.workbench.leftovers import clear_up
from keyphase.workbench.recordings import Recording
from keyphase.workbench.showing.task_spread import finished_beside
from keyphase.workbench.uploads import DEFAULT_LIMIT_BYTES
from keyphase.workbench.workbench import Settings, Workbench


class PageServer:
    """A running server: one workbench behind one port."""

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
        beside: Path | None = None,
    ) -> None:
        arms = tuple(arms or yumi_arms())
        self._folder = folder or recording_folder(paths)
        settings = Settings(
            recipe=recipe,
            read_only=read_only,
            folder=self._folder,
            arms=tuple(arm.tool_frame for arm in arms),
            upload_limit_bytes=upload_limit_bytes,
            beside=beside,
        )
        self.workbench = Workbench(paths, settings)
        for path in paths[:1]:
            self.workbench.library.reading.begin(path)
        self.latencies_ms: deque[float] = deque(maxlen=1000)
        self.sockets = PageSockets(self._begin, self._hear, self._end)
        self._conversations: dict[Page, Conversation] = {}
        self._browser_file: BrowserFile | None = None
        self._grant = Grant.LOOKING if read_only else Grant.EVERYTHING
        try:
            self._listen(host, port)
        except KeyphaseError:
            self.workbench.close()
            raise
        self.shared = Shared(arms, self._finished_beside)
        self.scenes = Scenes(self.viser, self.workbench, self.shared)
        self._site.has_scenes = True
        self._put_in_order_of_need()

    def _finished_beside(self, recording: Recording) -> list[Labeling]:
        lines, look = self.workbench.recordings.recordings, self.workbench.library.look
        return finished_beside(recording, lines, look)

    def _put_in_order_of_need(self) -> None:
        """What is asked for comes first, then what is seen beside it, then other recordings."""
        library, shared = self.workbench.library, self.shared
        shared.paths.gives_way = lambda: not (library.is_free and shared.part_paths.is_free())
        self.workbench.looking.may_look = shared.joints.is_free

    def _listen(self, host: str, port: int) -> None:
        """Listen on the port that this folder's server had before, where none is asked for."""
        self._keys = LastingKeys(self._folder)
        self.port = usable_port(host, port, self._keys.ports())
        keys = self._keys.of(self.port)
        self.access = Access(host, keys.token, keys.looking_token)
        self._site = OurSite(self.access, self.sockets, self._video)
        self.viser = serve(self._site, host, self.port)
        try:
            prove(host, self.port)
        except KeyphaseError:
            with silent():
                self.viser.stop()
            raise

    def _video(self, id: str) -> Video | None:
        """The file that was lent to pages under a name."""
        camera = self.workbench.footage.camera(id)
        return Video(camera.file, camera.media_type) if camera else None

    @property
    def link(self) -> str:
        """The link that opens the page."""
        return self.access.link(self.port, self._grant)

    def open_browser(self) -> bool:
        """Start the browser on the page; whether that was done."""
        link = self.access.link_for_once(self.port, self._grant)
        self._browser_file = open_in_browser(link, self._keys.folder)
        return self._browser_file is not None

    def _begin(self, page: Page) -> None:
        conversation = Conversation(
            self.workbench,
            page.id,
            page.send,
            looking=page.is_looking,
            latency=self.latencies_ms.append,
        )
        self._conversations[page] = conversation

    def _hear(self, page: Page, message: str | bytes) -> None:
        self._conversations[page].hear(message)

    def _end(self, page: Page) -> None:
        conversation = self._conversations.pop(page, None)
        if conversation is not None:
            conversation.end()

    def stop(self) -> None:
        """Stop serving and close the recordings."""
        if self._browser_file is not None:
            self._browser_file.close()
        self.sockets.close()
        self.scenes.close()
        self.workbench.close()
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
    beside: Path | None = None,
) -> None:
    """Serve the page on `paths` (recordings, or folders of them) until told to stop.

    Called from the main thread. Raises RobotError for a robot that cannot be used, KeyphaseError
    if nothing can listen on `host` and `port`.
    """
    keep_few_heaps()
    arms = robot_arms(robot, tool_frame)
    folder = recording_folder(paths)
    if not read_only:
        for line in clear_up([folder, *(path for path in paths if path.is_dir())]):
            print(line, file=sys.stderr)
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
        beside=beside,
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
