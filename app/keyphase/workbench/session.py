"""The session: what is open, what it has become, what is selected, where the playhead is.

All of that lives here, behind one lock. Whatever changes a document runs in one worker, in order,
and of slider values only the newest. What changed is told to the pages first, then to the views
(the 3D scene and the panel), so that the timeline never waits for the scene.
"""

import threading
from collections import deque
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Protocol

from keyphase.errors import KeyphaseError, RequestError
from keyphase.segmentation.parameters import Parameters
from keyphase.web.protocol.document_message import ghosts
from keyphase.web.scene.views import Views
from keyphase.web.transport.page_sockets import Page, PageSockets
from keyphase.workbench.exports import export
from keyphase.workbench.library import Library
from keyphase.workbench.opened import Opened
from keyphase.workbench.playback import Clock, Playhead
from keyphase.workbench.recording_queue import RecordingQueue
from keyphase.workbench.recordings import recordings_message
from keyphase.workbench.replay_session import ReplaySession
from keyphase.workbench.telling import Telling
from keyphase.workbench.uploads import DEFAULT_LIMIT_BYTES
from keyphase.workbench.worker import Worker

PARTS = ("path", "gaussians", "forces", "labels", "frame", "grid", "robot", "parts", "shadows")
"""Parts of the scene that can be shown and hidden."""

FIRST_HIDDEN = frozenset({"shadows"})
"""Shadows halve the frames a second where 3D is drawn in software; a page that draws it with a
graphics card asks for them."""

SETTLE_S = 0.4
"""A slider in the panel never says that it was let go; after this long without a change it was."""


class Controlling(Protocol):
    """Recording, replay, trials and robot, as pages control them."""

    def greet(self, tell: Callable[[Any], None]) -> None:
        """Tell a page that has come how all of it stands."""
        ...


@dataclass(frozen=True)
class Cause:
    """The page's own input that led to a change; it measures how long that took."""

    event: int
    client: str


class Session:
    """Everything one server knows. Methods may be called from any thread.

    `hello` is what a new page is told first; `hear` is called with what pages say.
    `latencies_ms` is how long pages say it took from an input to the frame that shows it.
    """

    def __init__(
        self,
        paths: Sequence[Path],
        library: Library,
        hello: Mapping[str, Any],
        hear: Callable[["Session", Page, str | bytes], None],
    ) -> None:
        self.lock = threading.RLock()
        self.sockets = PageSockets(self._greet, lambda page, message: hear(self, page, message))
        self.telling = Telling(self.sockets)
        self.views = Views(self.telling.report)
        self.queue = RecordingQueue(paths, library, self.telling, self._opened, self._emptied)
        self.replay = ReplaySession(self.current, self.queue, self.telling)
        self.controls: Controlling | None = None
        self.opened: Opened | None = None
        self.playhead = Playhead()
        self.selected: int | None = None
        self.hidden = FIRST_HIDDEN
        self.latencies_ms: deque[float] = deque(maxlen=1000)
        self.upload_limit_bytes = DEFAULT_LIMIT_BYTES
        self._hello = hello
        self._revision = 0
        self._wanted = Parameters()
        self._let_go = False
        self._settling: threading.Timer | None = None
        self._worker = Worker(self.telling.report)
        self._clock = Clock(self._step)

    def close(self) -> None:
        """Stop all threads and let go of the recordings."""
        self._stop_settling()
        self._clock.stop()
        self.replay.close()
        self._worker.stop()
        self._worker.join()
        self.queue.stop()
        self.views.stop()
        self.sockets.close()

    @property
    def is_free(self) -> bool:
        """Whether nothing that a person asked for is being worked out."""
        return self._worker.is_free() and self.queue.is_free

    # -- the document

    def change(
        self, action: Callable[[Opened], None], cause: Cause | None = None
    ) -> threading.Event:
        """Change the current document, after everything that was asked before.

        The event is set when that has been done, or will not be.
        """

        def run() -> None:
            opened = self.current()
            before = opened.parameters
            try:
                action(opened)
            finally:
                with self.lock:
                    if opened.parameters != before:
                        self._wanted = opened.parameters
                    self._document_changed(cause)

        return self._worker.submit(run)

    def set_parameters(
        self, change: Callable[[Parameters], Parameters], *, held: bool, cause: Cause | None = None
    ) -> None:
        """Change parameters; while `held` the change is shown but not kept.

        Raises ParameterError for a value that is out of range.
        """
        self.current()
        with self.lock:
            self._wanted = change(self._wanted)
            self._let_go = self._let_go or not held
            self._stop_settling()
        self._worker.submit(lambda: self._recompute(cause), "parameters")

    def settle_parameters(self) -> None:
        """Keep the parameters that are shown once they have not changed for a moment."""
        with self.lock:
            self._stop_settling()
            self._settling = threading.Timer(SETTLE_S, self._settle)
            self._settling.daemon = True
            self._settling.start()

    def export(self, kind: str) -> None:
        """Write the segment file (`json`, `csv`, or of `all` recordings), or the plan."""
        if kind == "all":
            self.queue.export_all()
        elif kind not in ("json", "csv"):
            self._worker.submit(lambda: self.replay.export(kind), f"export {kind}")
        else:
            self._worker.submit(lambda: self._export(kind), f"export {kind}")

    def _opened(self, opened: Opened) -> None:
        """Make a recording that was opened the current one."""
        self._worker.submit(lambda: self._show(opened))

    def _show(self, opened: Opened) -> None:
        opened.recolor()
        with self.lock:
            self.opened = opened
            self._wanted = opened.parameters
            self.selected = None
            start_s, end_s = opened.demonstration.start_s, opened.demonstration.end_s
            self.playhead = Playhead(start_s, start_s, end_s)
            self.queue.current = opened.recording.id
            self._document_changed(None)
            self._show_playhead()
            self.queue.tell()
            self.telling.all(self._playhead_message())

    def _emptied(self) -> None:
        with self.lock:
            self.opened = self.selected = None

    def _settle(self) -> None:
        self.set_parameters(lambda same: same, held=False)

    def _stop_settling(self) -> None:
        if self._settling is not None:
            self._settling.cancel()
            self._settling = None

    def _recompute(self, cause: Cause | None) -> None:
        opened = self.current()
        with self.lock:
            wanted, let_go = self._wanted, self._let_go
            self._let_go = False
        try:
            self._preview(opened, wanted)
            coming = [] if let_go else ghosts(opened.kept_labeling, opened.labeling)
            with self.lock:
                self._document_changed(cause)
                self.telling.all({"type": "ghost", "boundaries": coming})
            if let_go:
                opened.keep_parameters()
        except KeyphaseError:
            opened.preview(opened.document.parameters)
            with self.lock:
                self._wanted = opened.parameters
            raise
        finally:
            if let_go:
                with self.lock:
                    self._document_changed(None)

    def _preview(self, opened: Opened, wanted: Parameters) -> None:
        slow = opened.fits_anew(wanted)
        if slow:
            self.telling.progress(f"{opened.recording.name}: segmenting", None)
        try:
            opened.preview(wanted)
        finally:
            if slow:
                self.telling.progress_done()

    def _export(self, kind: str) -> None:
        opened = self.current()
        path = export(opened.kept_labeling, opened.recording.path, kind)
        self.telling.all({"type": "saved", "path": str(path)})

    def current(self) -> Opened:
        """The open recording. Raises RequestError where there is none."""
        if self.opened is None:
            raise RequestError("No recording is open yet; choose one from the list.")
        return self.opened

    def _document_changed(self, cause: Cause | None) -> None:
        """Tell the pages, then the views, what the document now is. Runs under the lock."""
        opened = self.current()
        self._revision += 1
        if self.selected is not None and self.selected >= len(opened.labeling.segments):
            self.selected = None
        self.telling.all(self._document_message(opened, cause))
        self.queue.update(opened.summary())
        self.views.show("document", lambda view: view.show_document(opened))
        self._show_selection()

    # -- selection, playback, scene

    def select(self, segment: int | None) -> None:
        """Select a segment of the current document, or none."""
        with self.lock:
            count = len(self.opened.labeling.segments) if self.opened else 0
            if segment is not None and segment >= count:
                raise RequestError(f"There are {count} segments, so none has the index {segment}.")
            self.selected = segment
            self.telling.all({"type": "selection", "segment": segment})
            self._show_selection()

    def select_at(self, time_s: float) -> None:
        """Select the segment around a time, as a click in the scene does."""
        with self.lock:
            if self.opened is not None:
                self.select(self.opened.labeling.segment_at(time_s))

    def move_playhead(self, change: Callable[[Playhead], Playhead]) -> None:
        """Seek, play or pause."""
        with self.lock:
            self.playhead = change(self.playhead)
            self.telling.all(self._playhead_message())
            self._show_playhead()
        self._clock.wake()

    def show(self, part: str, visible: bool) -> None:
        """Show or hide a part of the scene."""
        if part not in PARTS:
            raise RequestError(f"The scene has the parts {', '.join(PARTS)}, but no {part!r}.")
        with self.lock:
            self.hidden = self.hidden - {part} if visible else self.hidden | {part}
            hidden = self.hidden
            self.telling.all(self._shown_message())
            self.views.show("parts", lambda view: view.show_parts(hidden))

    def set_theme(self, dark: bool) -> None:
        """Draw the scene light or dark."""
        self.views.show("theme", lambda view: view.show_theme(dark))

    def _step(self, elapsed_s: float) -> bool:
        with self.lock:
            if not self.playhead.playing:
                return False
            self.playhead = self.playhead.advanced(elapsed_s)
            playing = self.playhead.playing
            self.telling.all(self._playhead_message(), may_drop=playing)
            self._show_playhead()
            return playing

    def _show_selection(self) -> None:
        selected = self.selected
        self.views.show("selection", lambda view: view.show_selection(selected))

    def _show_playhead(self) -> None:
        playhead = self.playhead
        self.views.show("playhead", lambda view: view.show_playhead(playhead))

    # -- messages

    def _greet(self, page: Page) -> None:
        """Tell a new page how things stand, then include it in what all are told."""
        with self.lock:
            page.send({**self._hello, "client": page.id, "read_only": page.is_looking})
            page.send(self._shown_message())
            page.send(recordings_message(self.queue.recordings, self.queue.current))
            if self.opened is not None:
                page.send(self._document_message(self.opened, None))
                page.send(self._playhead_message())
            if self.telling.under_way is not None:
                page.send(self.telling.under_way)
            self.sockets.add(page)
            self.replay.greet(page)
            if self.controls is not None:
                self.controls.greet(page.send)

    def _document_message(self, opened: Opened, cause: Cause | None) -> dict[str, Any]:
        return {
            "type": "document",
            "revision": self._revision,
            "cause": {"event": cause.event, "client": cause.client} if cause else None,
            "selected": self.selected,
            "labels": opened.folder.settings.vocabulary.as_json(),
            **opened.message(),
        }

    def _shown_message(self) -> dict[str, Any]:
        return {"type": "shown", "parts": {part: part not in self.hidden for part in PARTS}}

    def _playhead_message(self) -> dict[str, Any]:
        head = self.playhead
        return {
            "type": "playhead",
            "time_s": head.time_s,
            "playing": head.playing,
            "speed": head.speed,
            "loop": head.loop,
        }
