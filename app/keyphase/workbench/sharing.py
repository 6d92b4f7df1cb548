"""What changes all recordings of a folder: made, taken back and made again, as one step.

What is done is left alone, unless it is to be opened again with the step.
"""

import threading
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

from keyphase.labeling.document import FOR_ALL
from keyphase.labeling.edits import PhaseInAll
from keyphase.labeling.history import FolderChange
from keyphase.labeling.storage.summary import summarize
from keyphase.segmentation import Parameters
from keyphase.workbench.desks.asked import Asked
from keyphase.workbench.desks.desk import Desk
from keyphase.workbench.desks.library import Library
from keyphase.workbench.desks.open_recording import OpenRecording
from keyphase.workbench.grid.for_all import ForAll
from keyphase.workbench.recording_list import RecordingList
from keyphase.workbench.recordings import Recording
from keyphase.workbench.spread import beside
from keyphase.workbench.view import View


@dataclass(frozen=True)
class Sharing:
    """Changes whole folders. For many threads; what takes long runs among a page's errands."""

    library: Library
    recordings: RecordingList
    for_all: ForAll

    def share(self, desk: Desk, asked: Asked, view: View, *, include_done: bool) -> threading.Event:
        """Give the folder of a recording the parameters it has; its others follow.

        With `include_done` those that are done are opened again.
        """
        over, refused = threading.Event(), list[Exception]()
        # On loan from here on, so that it is still this desk when its turn comes.
        lent = self.library.lend(desk.recording)

        def refuse(error: Exception) -> None:
            refused.append(error)
            asked.refuse(error)

        def act() -> None:
            try:
                others = [one for one in self._beside(desk) if one.id != desk.recording.id]
                self._freeze(others, asked)
                done = [one for one in others if one.state == "done"] if include_done else []
                names = tuple(one.path.name for one in done)
                lent.share_parameters(replace(asked, refuse=refuse), names).wait()
                if refused:
                    return
                self._each(done, lambda opened: opened.reopen(FOR_ALL), asked)
                self._wait_for_others(desk)
                view.tell("info", "All recordings of this folder now have these parameters.")
            finally:
                self.library.give_back(lent)
                over.set()

        view.errands.submit(act)
        return over

    def undo(self, desk: Desk, asked: Asked, view: View) -> threading.Event:
        """Take the last step of a recording back, and what it did to its folder."""

        def told(change: FolderChange | PhaseInAll | None) -> None:
            if isinstance(change, FolderChange):
                view.errands.submit(lambda: self._close_again(desk, change, asked, view))
            elif change is not None:
                self.for_all.take_back(desk, change, asked, view)

        return desk.undo(asked, told)

    def redo(self, desk: Desk, asked: Asked, view: View) -> threading.Event:
        """Make the next step again, likewise."""

        def told(change: FolderChange | PhaseInAll | None) -> None:
            if isinstance(change, FolderChange):
                view.errands.submit(lambda: self._reopen(desk, change, asked))
            elif change is not None:
                self.for_all.make_again(desk, change, asked, view)

        return desk.redo(asked, told)

    def _close_again(self, desk: Desk, change: FolderChange, asked: Asked, view: View) -> None:
        named = self._named(desk, change)
        self._each(named, lambda opened: opened.close_again(FOR_ALL), asked)
        self._wait_for_others(desk)
        if desk.state is not None and desk.state.document.shared == Parameters(**change.before):
            view.tell("info", "All recordings of this folder have their former parameters again.")

    def _reopen(self, desk: Desk, change: FolderChange, asked: Asked) -> None:
        self._each(self._named(desk, change), lambda opened: opened.reopen(FOR_ALL), asked)

    def _beside(self, desk: Desk) -> tuple[Recording, ...]:
        return beside(desk.recording, self.recordings.recordings)

    def _named(self, desk: Desk, change: FolderChange) -> Sequence[Recording]:
        return [one for one in self._beside(desk) if one.path.name in change.reopened]

    def _freeze(self, others: Sequence[Recording], asked: Asked) -> None:
        """Of those an older version finished what is seen now is kept, before that changes."""
        unfrozen = [one for one in others if summarize(one.path).unfrozen]
        self._each(unfrozen, _nothing, asked)

    def _each(
        self, recordings: Sequence[Recording], action: Callable[[OpenRecording], None], asked: Asked
    ) -> None:
        """One after another; what is refused is told, and costs no other."""
        for recording in recordings:
            desk = self.library.lend(recording)
            try:
                desk.change(action, replace(asked, event=None)).wait()
            finally:
                self.library.give_back(desk)

    def _wait_for_others(self, desk: Desk) -> None:
        """Until the step is made, and those that are open have taken the parameters up."""
        desk.change(_nothing, None).wait()
        for waited in [other.change(_nothing, None) for other in self.library.beside(desk)]:
            waited.wait()


def _nothing(_opened: OpenRecording) -> None:
    """Opening it, and all that was asked of it before, is enough."""
