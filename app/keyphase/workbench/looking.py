"""Finding out about recordings nobody has asked for, whenever there is time."""

import time
from collections.abc import Callable
from dataclasses import replace

from keyphase.errors import KeyphaseError
from keyphase.workbench.desks.library import Library
from keyphase.workbench.recording_list import RecordingList
from keyphase.workbench.recordings import Recording, defect
from keyphase.workbench.telling import in_words
from keyphase.workbench.worker import Worker

_LOOK_AGAIN_S = 0.05


class Looking:
    """Looks at one recording after another in a thread of its own, while `may_look` says so."""

    def __init__(self, recordings: RecordingList, library: Library) -> None:
        self.may_look: Callable[[], bool] = lambda: True
        self._list, self._library = recordings, library
        self._worker = Worker(in_words)
        self._waiting = iter(recordings.recordings)

    def begin(self) -> None:
        """Look at all of them, from the first."""
        self._waiting = iter(self._list.recordings)
        self._worker.submit(self._next, "look")

    def stop(self) -> None:
        """Look no more."""
        self._worker.stop()
        self._worker.join()

    def _next(self) -> None:
        if not (self._library.is_free and self.may_look()):
            time.sleep(_LOOK_AGAIN_S)
            self._worker.submit(self._next, "look")
            return
        recording = next(self._waiting, None)
        if recording is None:
            return
        if not self._library.has_open(recording.id):
            self._list.update(self._looked_at(recording))
        self._worker.submit(self._next, "look")

    def _looked_at(self, recording: Recording) -> Recording:
        try:
            opened = self._library.look(recording)
            opened.close()
            return opened.state_at(0).line
        except KeyphaseError as error:
            return replace(recording, error=str(error))
        except Exception as error:
            in_words(error)
            return replace(recording, error=defect(recording.path, error))
