"""The queue of recordings at work: opening them, looking at the others meanwhile, exporting all."""

import itertools
import threading
import time
from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass, replace
from pathlib import Path
from typing import Any

from keyphase.errors import KeyphaseError, RequestError
from keyphase.labeling.spreading import Change
from keyphase.labeling.storage.journal import summarize
from keyphase.segmentation import Parameters
from keyphase.workbench.exports import export
from keyphase.workbench.library import Library
from keyphase.workbench.opened import Opened
from keyphase.workbench.recordings import Recording, queue, recordings_message
from keyphase.workbench.telling import Progress, Telling
from keyphase.workbench.uploads import Upload
from keyphase.workbench.worker import Worker

_LOOKING = "look"
"""The kind of job that nobody asked for."""

_LOOK_AGAIN_S = 0.05


class RecordingQueue:
    """The recordings of one server; everything slow happens in one thread of its own.

    `on_open` is told of each recording that was opened, `on_empty` when the last one has gone.
    `may_look` says whether there is time to look at recordings that nobody asked for.
    """

    def __init__(
        self,
        paths: Sequence[Path],
        library: Library,
        telling: Telling,
        on_open: Callable[[Opened], None],
        on_empty: Callable[[], None],
    ) -> None:
        self.recordings = tuple(map(_as_journaled, queue(paths)))
        self.current: str | None = None
        self.may_look: Callable[[], bool] = lambda: True
        self._numbers = itertools.count(len(self.recordings) + 1)
        self._previews = itertools.count(1)
        self._library = library
        self._telling = telling
        self._on_open = on_open
        self._on_empty = on_empty
        self._lock = threading.RLock()
        self._worker = Worker(telling.report)
        self._looking = iter(self.recordings)
        self._preview: _Preview | None = None

    @property
    def is_free(self) -> bool:
        """Whether nothing that was asked for is to be done; looking at the others is not."""
        return self._worker.is_free(but_for=_LOOKING)

    def find(self, recording_id: str) -> Recording:
        """The line with that id. Raises RequestError where there is none."""
        for recording in self.recordings:
            if recording.id == recording_id:
                return recording
        raise RequestError("There is no such recording in this list; reload the page.")

    def open(self, recording_id: str) -> None:
        """Open a recording in the background; a later call overtakes one that waits."""
        recording = self.find(recording_id)
        self._worker.submit(lambda: self._read(recording), "open")

    def open_first(self) -> None:
        """Open the first recording that is not done, so that work goes on where it was left."""
        open_ones = (recording for recording in self.recordings if recording.state != "done")
        first = next(open_ones, next(iter(self.recordings), None))
        if first is not None:
            self.open(first.id)

    def look_at_all(self) -> None:
        """Find out about every recording, one by one, whenever nothing else is to be done."""
        self._worker.submit(self._look_at_next, _LOOKING)

    def export_all(self) -> None:
        """Write a segment file for every recording; what cannot be opened says so in its line."""
        self._worker.submit(self._export_all, "export")

    def preview_spread(self, opened: Opened) -> None:
        """Tell what the parameters of an open recording would do to all of its folder.

        One recording after another, so that others can be opened meanwhile.
        """
        self._preview = _Preview(next(self._previews), opened.parameters, self._beside(opened))
        self._telling.all(self._preview.message())
        self._worker.submit(self._preview_next, "preview")

    def leave_spread(self) -> None:
        """Look no further into what would change."""
        self._preview = None

    def follow_folder(self, opened: Opened) -> None:
        """Let the recordings beside an open one follow what their folder's parameters became."""
        self._worker.submit(lambda: self._follow(opened))

    def add(self, path: Path) -> None:
        """A recording more, which is opened."""
        with self._lock:
            recording = Recording(str(next(self._numbers)), path)
            self.recordings = (*self.recordings, recording)
            self.tell()
        self.open(recording.id)

    def take_in(
        self, upload: Upload, beside: Opened | None, answer: Callable[[dict[str, Any]], None]
    ) -> None:
        """Read a file that was sent, put it into the list, and answer what became of it."""
        self._worker.submit(lambda: self._take_in(upload, beside, answer))

    def remove(self, path: Path) -> None:
        """A recording less; where it was the open one, its neighbour is opened."""
        self._worker.submit(lambda: self._remove(path))

    def update(self, changed: Recording) -> None:
        """Put a changed line into the list and tell the pages."""
        with self._lock:
            if changed not in self.recordings:
                self.recordings = tuple(
                    changed if recording.id == changed.id else recording
                    for recording in self.recordings
                )
                self.tell()

    def tell(self) -> None:
        """Tell the pages the list."""
        self._telling.all(recordings_message(self.recordings, self.current))

    def stop(self) -> None:
        """Do no more, and close what is open."""
        self._worker.stop()
        self._worker.join()
        self._library.close()

    def _read(self, recording: Recording) -> None:
        try:
            opened = self._library.open(recording, self._progress(recording))
        except KeyphaseError as error:
            self.update(replace(recording, error=str(error)))
            raise
        finally:
            self._telling.progress_done()
        self._on_open(opened)
        self.look_at_all()

    def _beside(self, opened: Opened) -> tuple[Recording, ...]:
        folder = opened.recording.path.parent
        return tuple(r for r in self.recordings if r.path.parent == folder and not r.error)

    def _preview_next(self) -> None:
        preview = self._preview
        if preview is None or preview.is_whole:
            return
        recording = preview.next
        fraction = len(preview.items) / len(preview.recordings)
        self._telling.progress(f"{recording.name}: trying", fraction)
        try:
            looked = self._library.look(recording)
            looked.close()
            change = looked.preview_shared(preview.parameters)
            item = {"id": recording.id, "name": recording.name, "error": None, **_as_json(change)}
        except KeyphaseError as error:
            item = {"id": recording.id, "name": recording.name, "error": str(error)}
        finally:
            self._telling.progress_done()
        if self._preview is preview:
            self._preview = replace(preview, items=(*preview.items, item))
            self._telling.all(self._preview.message())
            self._worker.submit(self._preview_next, "preview")

    def _follow(self, opened: Opened) -> None:
        for recording in self._beside(opened):
            if recording.id != opened.recording.id:
                self._library.drop(recording.id)
        self._looking = iter(self.recordings)
        self.look_at_all()
        self._telling.notice("info", "All recordings of this folder now have these parameters.")

    def _take_in(
        self, upload: Upload, beside: Opened | None, answer: Callable[[dict[str, Any]], None]
    ) -> None:
        self._telling.progress(f"{upload.name}: reading", None)
        try:
            path = self._library.take_in(upload, beside)
        except KeyphaseError as error:
            answer({"type": "upload_refused", "text": str(error)})
            return
        finally:
            self._telling.progress_done()
        answer({"type": "uploaded", "name": path.name, "compares": upload.is_segment_file})
        if not upload.is_segment_file:
            self.add(path)

    def _remove(self, path: Path) -> None:
        with self._lock:
            gone = [recording.path == path for recording in self.recordings]
            if True not in gone:
                return
            place = gone.index(True)
            removed = self.recordings[place]
            self.recordings = self.recordings[:place] + self.recordings[place + 1 :]
            was_current = removed.id == self.current
            if was_current:
                self.current = None
        self._library.drop(removed.id)
        self.tell()
        if was_current and self.recordings:
            self.open(self.recordings[min(place, len(self.recordings) - 1)].id)
        elif was_current:
            self._on_empty()

    def _look_at_next(self) -> None:
        if not self.may_look():
            time.sleep(_LOOK_AGAIN_S)
            self.look_at_all()
            return
        recording = next(self._looking, None)
        if recording is None:
            return
        if not self._library.has_open(recording):
            self.update(self._looked_at(recording))
        self.look_at_all()

    def _looked_at(self, recording: Recording) -> Recording:
        try:
            opened = self._library.look(recording)
        except KeyphaseError as error:
            return replace(recording, error=str(error))
        opened.close()
        return opened.summary()

    def _export_all(self) -> None:
        total = len(self.recordings)
        written = 0
        for number, recording in enumerate(self.recordings):
            self._telling.progress(f"{recording.name}: writing", number / total)
            try:
                opened = self._library.look(recording)
                opened.close()
                export(opened.kept_labeling, recording.path, "json")
                written += 1
            except KeyphaseError as error:
                self.update(replace(recording, error=str(error)))
        self._telling.progress_done()
        self._telling.notice("info", f"{written} of {total} segment files were written.")

    def _progress(self, recording: Recording) -> Progress:
        return lambda what, fraction: self._telling.progress(f"{recording.name}: {what}", fraction)


@dataclass(frozen=True)
class _Preview:
    """What parameters would do to recordings, as far as that is known; they are numbered."""

    number: int
    parameters: Parameters
    recordings: tuple[Recording, ...]
    items: tuple[dict[str, Any], ...] = ()

    @property
    def is_whole(self) -> bool:
        return len(self.items) == len(self.recordings)

    @property
    def next(self) -> Recording:
        return self.recordings[len(self.items)]

    def message(self) -> dict[str, Any]:
        items = list(self.items)
        return {
            "type": "spread",
            "look": self.number,
            "total": len(self.recordings),
            "items": items,
        }


def _as_json(change: Change) -> dict[str, Any]:
    """A change as JSON takes it, which knows no numbers of numpy's."""
    return {
        **asdict(change),
        "comes_s": list(map(float, change.comes_s)),
        "goes_s": list(map(float, change.goes_s)),
        "moves_s": [(float(a), float(b)) for a, b in change.moves_s],
    }


def _as_journaled(recording: Recording) -> Recording:
    """With what its journal says, before anybody has looked at it."""
    said = summarize(recording.path)
    state = "done" if said.done else "touched" if said.touched else "automatic"
    return replace(recording, state=state)
