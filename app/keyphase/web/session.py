"""The session: which recordings are open, what they have become, and where the playhead is.

All state of the server lives here, behind one lock. Whatever changes a document runs in one
worker, in order, and of slider values only the newest. What changed is told to the pages first,
then to the views (the 3D scene and the panel), so that the timeline never waits for the scene.
"""

import logging
import threading
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from keyphase.errors import KeyphaseError, RequestError
from keyphase.segmentation.parameters import Parameters
from keyphase.web.document_message import ghosts
from keyphase.web.exports import Format, export
from keyphase.web.opened import Opened
from keyphase.web.page_sockets import Page, PageSockets
from keyphase.web.playback import Clock, Playhead
from keyphase.web.recordings import Recording, queue, recordings_message
from keyphase.web.worker import Worker

_log = logging.getLogger(__name__)

PARTS = ("path", "gaussians", "forces", "labels", "frame", "grid")
"""Parts of the scene that can be shown and hidden."""

SETTLE_S = 0.4
"""A slider in the panel never says that it was let go; after this long without a change it was."""

Progress = Callable[[str, float | None], None]
Opener = Callable[[Recording, Progress], Opened]


class View:
    """Something beside the pages that shows the session; each shows what concerns it.

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


@dataclass(frozen=True)
class Cause:
    """The page's own input that led to a change; it measures how long that took."""

    event: int
    client: str


class Session:
    """Everything one server knows. Methods may be called from any thread."""

    def __init__(self, paths: Sequence[Path], opener: Opener) -> None:
        self.lock = threading.RLock()
        self.sockets = PageSockets(self._greet, self._hear)
        self.recordings = queue(paths)
        self.opened: Opened | None = None
        self.playhead = Playhead()
        self.selected: int | None = None
        self.hear: Callable[[Page, str | bytes], None] = lambda _page, _message: None
        self.hello: Mapping[str, Any] = {"type": "hello"}
        self.hidden: frozenset[str] = frozenset()
        self._views: list[View] = []
        self._opener = opener
        self._revision = 0
        self._wanted: Parameters | None = None
        self._let_go = False
        self._settling: threading.Timer | None = None
        self._worker = Worker(self.report)
        self._reader = Worker(self.report)
        self._painter = Worker(self.report)
        self._clock = Clock(self._step)

    def add_view(self, view: View) -> None:
        """Show the session in `view` from now on."""
        with self.lock:
            self._views.append(view)
            self._tell_views()

    # -- opening

    def open(self, recording_id: str) -> None:
        """Make a recording the current one; reading and fitting run in the background."""
        recording = self.recording(recording_id)
        self._reader.submit(lambda: self._read(recording), "open")

    def recording(self, recording_id: str) -> Recording:
        """The line of the queue with that id; RequestError if there is none."""
        for recording in self.recordings:
            if recording.id == recording_id:
                return recording
        raise RequestError(f"There is no recording {recording_id!r} in this folder.")

    def update_recording(self, changed: Recording) -> None:
        """Put a changed line into the queue and tell the pages."""
        with self.lock:
            if changed in self.recordings:
                return
            self.recordings = tuple(
                changed if recording.id == changed.id else recording
                for recording in self.recordings
            )
            self._broadcast_recordings()

    def _read(self, recording: Recording) -> None:
        progress = self._progress(recording)
        try:
            opened = self._opener(recording, progress)
        except KeyphaseError as error:
            self.update_recording(replace(recording, error=str(error)))
            raise
        finally:
            self._progress_done()
        self._worker.submit(lambda: self._show(opened))

    def _progress(self, recording: Recording) -> Progress:
        def tell(what: str, fraction: float | None) -> None:
            text = f"{recording.name}: {what}"
            self.broadcast({"type": "progress", "what": text, "fraction": fraction, "done": False})

        return tell

    def _progress_done(self) -> None:
        self.broadcast({"type": "progress", "what": "", "fraction": None, "done": True})

    def _show(self, opened: Opened) -> None:
        with self.lock:
            self.opened = opened
            self._wanted = opened.parameters
            self.selected = None
            start_s, end_s = opened.demonstration.start_s, opened.demonstration.end_s
            self.playhead = Playhead(start_s, start_s, end_s)
            self._document_changed(None)
            self._broadcast_recordings()
            self.broadcast(self._playhead_message())

    # -- changing the document

    def set_parameters(
        self, change: Callable[[Parameters], Parameters], *, held: bool, cause: Cause | None = None
    ) -> None:
        """Change parameters; while `held` the change is shown but not kept.

        Raises ParameterError for a value that is out of range.
        """
        with self.lock:
            if self._wanted is None:
                raise RequestError("Open a recording before changing parameters.")
            self._wanted = change(self._wanted)
            self._let_go = self._let_go or not held
            self._stop_settling()
        self._worker.submit(lambda: self._recompute(cause), "parameters")

    def reset_parameters(self) -> None:
        """Parameters back to automatic."""
        self.set_parameters(lambda _: Parameters(), held=False)

    def settle_parameters(self) -> None:
        """Keep the parameters that are shown once they have not changed for a moment."""
        with self.lock:
            self._stop_settling()
            self._settling = threading.Timer(
                SETTLE_S, lambda: self.set_parameters(lambda same: same, held=False)
            )
            self._settling.daemon = True
            self._settling.start()

    def _stop_settling(self) -> None:
        if self._settling is not None:
            self._settling.cancel()
            self._settling = None

    def _recompute(self, cause: Cause | None) -> None:
        with self.lock:
            opened, wanted, let_go = self.opened, self._wanted, self._let_go
            self._let_go = False
        if opened is None or wanted is None:
            return
        self._preview(opened, wanted)
        coming = [] if let_go else ghosts(opened.kept_labeling, opened.labeling)
        with self.lock:
            self._document_changed(cause)
            self.broadcast({"type": "ghost", "boundaries": coming})
        if let_go:
            opened.keep_parameters()
            with self.lock:
                self._document_changed(None)

    def _preview(self, opened: Opened, wanted: Parameters) -> None:
        """Show what parameters give; where they give nothing, go back to those before."""
        slow = opened.fits_anew(wanted)
        if slow:
            self._progress(opened.recording)("segmenting", None)
        try:
            opened.preview(wanted)
        except KeyphaseError:
            with self.lock:
                self._wanted = opened.parameters
                self._document_changed(None)
            raise
        finally:
            if slow:
                self._progress_done()

    def change(self, action: Callable[[Opened], None], cause: Cause | None = None) -> None:
        """Apply an edit, undo or redo to the current document, after everything before it."""

        def run() -> None:
            opened = self.opened
            if opened is None:
                raise RequestError("Open a recording before editing.")
            action(opened)
            with self.lock:
                self._wanted = opened.parameters
                self._document_changed(cause)

        self._worker.submit(run)

    def export(self, kind: str) -> None:
        """Write the segment file: `json` or `csv` of the current recording, or of `all`."""
        if kind == "all":
            self._reader.submit(self._export_all)
        elif kind in ("json", "csv"):
            self.change(lambda opened: self._export(opened, kind))
        else:
            raise RequestError(f"A segment file is json, csv or all, but not {kind!r}.")

    def _export(self, opened: Opened, kind: Format) -> None:
        path = export(opened.kept_labeling, opened.recording.path, kind)
        self.broadcast({"type": "saved", "path": str(path)})

    def _export_all(self) -> None:
        """One after another; one that cannot be opened is passed over, its line says why."""
        total = len(self.recordings)
        for number, recording in enumerate(self.recordings):
            self._progress(recording)("writing", number / total)
            try:
                opened = self._opened_for(recording)
                self._export(opened, "json")
            except KeyphaseError as error:
                self.update_recording(replace(recording, error=str(error)))
        self._progress_done()

    def _opened_for(self, recording: Recording) -> Opened:
        opened = self.opened
        if opened is not None and opened.recording.id == recording.id:
            return opened
        return self._opener(recording, lambda _what, _fraction: None)

    def _document_changed(self, cause: Cause | None) -> None:
        """Tell the pages, then the views, what the document now is. Runs under the lock."""
        opened = self.opened
        assert opened is not None
        self._revision += 1
        count = len(opened.labeling.segments)
        if self.selected is not None and self.selected >= count:
            self.selected = None
        self.broadcast(self._document_message(opened, cause))
        self.update_recording(opened.summary())
        self._tell_views()

    def _tell_views(self) -> None:
        opened = self.opened
        if opened is not None:
            self._paint("document", lambda view: view.show_document(opened))
            self._paint_selection()
            self._paint_playhead()

    def _paint_selection(self) -> None:
        selected = self.selected
        self._paint("selection", lambda view: view.show_selection(selected))

    def _paint_playhead(self) -> None:
        playhead = self.playhead
        self._paint("playhead", lambda view: view.show_playhead(playhead))

    def _paint(self, kind: str, show: Callable[[View], None]) -> None:
        """Show something in all views, unless something newer of its kind is waiting."""
        for number, view in enumerate(self._views):
            self._painter.submit(lambda view=view: show(view), f"{kind} in {number}")

    # -- selection and playback

    def select(self, segment: int | None) -> None:
        """Select a segment of the current document, or none."""
        with self.lock:
            count = len(self.opened.labeling.segments) if self.opened else 0
            if segment is not None and segment >= count:
                raise RequestError(f"There are {count} segments, so none has the index {segment}.")
            self.selected = segment
            self.broadcast({"type": "selection", "segment": segment})
            self._paint_selection()

    def select_at(self, time_s: float) -> None:
        """Select the segment around a time, as a click in the scene does."""
        with self.lock:
            if self.opened is not None:
                self.select(self.opened.labeling.segment_at(time_s))

    def move_playhead(self, change: Callable[[Playhead], Playhead]) -> None:
        """Seek, play or pause."""
        with self.lock:
            self.playhead = change(self.playhead)
            self._tell_playhead(may_drop=False)
        self._clock.wake()

    def _step(self, elapsed_s: float) -> bool:
        with self.lock:
            if not self.playhead.playing:
                return False
            self.playhead = self.playhead.advanced(elapsed_s)
            self._tell_playhead(may_drop=self.playhead.playing)
            return self.playhead.playing

    def _tell_playhead(self, may_drop: bool) -> None:
        self.broadcast(self._playhead_message(), may_drop)
        self._paint_playhead()

    # -- the scene

    def show(self, part: str, visible: bool) -> None:
        """Show or hide a part of the scene."""
        if part not in PARTS:
            raise RequestError(f"The scene has the parts {', '.join(PARTS)}, but no {part!r}.")
        with self.lock:
            self.hidden = self.hidden - {part} if visible else self.hidden | {part}
            hidden = self.hidden
            self.broadcast(self._shown_message())
            self._paint("parts", lambda view: view.show_parts(hidden))

    def set_theme(self, dark: bool) -> None:
        """Draw the scene light or dark."""
        self._paint("theme", lambda view: view.show_theme(dark))

    # -- talking

    def broadcast(self, message: Mapping[str, Any], may_drop: bool = False) -> None:
        """Tell all pages."""
        self.sockets.broadcast(message, may_drop)

    def notice(self, level: str, text: str) -> None:
        """A line of text in every page."""
        self.broadcast({"type": "notice", "level": level, "text": text})

    def report(self, error: Exception) -> None:
        """An error becomes a notice in the page and a line in the log, never silence."""
        if isinstance(error, KeyphaseError):
            _log.info("%s", error)
            self.notice("warning", str(error))
        else:
            _log.error("A defect in keyphase", exc_info=error)
            self.notice("error", f"Something is wrong inside keyphase: {error!r}. See the log.")

    def close(self) -> None:
        """Stop all threads and let go of the recording."""
        self._stop_settling()
        self._clock.stop()
        for worker in (self._worker, self._reader, self._painter):
            worker.stop()
        self.sockets.close()

    def _greet(self, page: Page) -> None:
        with self.lock:
            page.send({**self.hello, "read_only": page.grant.name == "LOOKING"})
            page.send(self._shown_message())
            page.send(recordings_message(self.recordings, self._current_id()))
            if self.opened is not None:
                page.send(self._document_message(self.opened, None))
                page.send(self._playhead_message())
                page.send({"type": "selection", "segment": self.selected})
            self.sockets.add(page)

    def _hear(self, page: Page, message: str | bytes) -> None:
        self.hear(page, message)

    def _current_id(self) -> str | None:
        return self.opened.recording.id if self.opened else None

    def _broadcast_recordings(self) -> None:
        self.broadcast(recordings_message(self.recordings, self._current_id()))

    def _document_message(self, opened: Opened, cause: Cause | None) -> dict[str, Any]:
        return {
            "type": "document",
            "revision": self._revision,
            "cause": {"event": cause.event, "client": cause.client} if cause else None,
            "selected": self.selected,
            **opened.message(),
        }

    def _shown_message(self) -> dict[str, Any]:
        return {"type": "shown", "parts": {part: part not in self.hidden for part in PARTS}}

    def _playhead_message(self) -> dict[str, Any]:
        return {
            "type": "playhead",
            "time_s": self.playhead.time_s,
            "playing": self.playhead.playing,
            "speed": self.playhead.speed,
            "loop": self.playhead.loop,
        }
