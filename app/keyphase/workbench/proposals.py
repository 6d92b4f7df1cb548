"""What is proposed for recordings nobody has touched, from those of their folder that are done."""

import threading
import time
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from keyphase.errors import KeyphaseError
from keyphase.labeling.comparing.comparison import Outline
from keyphase.labeling.edits.take_over import TakeOver
from keyphase.labeling.tasks.task import TaskPhase
from keyphase.transfer.as_edit import as_edit
from keyphase.transfer.phase_order import Difference
from keyphase.transfer.proposing import Transfer, propose, usual_cost_of
from keyphase.transfer.taught import Taught, taught_by
from keyphase.workbench.desks.library import Library
from keyphase.workbench.recordings import Recording
from keyphase.workbench.tasks import Tasks
from keyphase.workbench.telling import in_words
from keyphase.workbench.worker import Worker

_LOOK_AGAIN_S = 0.05


@dataclass(frozen=True, eq=False)
class Proposal:
    """What is proposed for one recording.

    teachers    names of the recordings it is proposed from, the best first
    confidence  the least of its boundaries and names, 0 to 1
    edit        makes it the recording's own; None where it is an outlier, which fits none of them
    differs     how its phases differ from theirs; None where they do not
    """

    teachers: tuple[str, ...]
    confidence: float
    outline: Outline | None
    edit: TakeOver | None
    differs: Difference | None = None

    @property
    def is_outlier(self) -> bool:
        """Whether the recording is of another kind than those that are done."""
        return self.edit is None


class Proposals:
    """Proposes in a thread of its own, folder by folder; `tell` is told of each proposal.

    Nothing of a recording changes by it: a proposal counts once a person takes it over.
    """

    def __init__(
        self,
        recordings: Callable[[], Iterable[Recording]],
        library: Library,
        tasks: Tasks,
        tell: Callable[[Mapping[str, Proposal]], None],
    ) -> None:
        self._recordings, self._library, self._tasks = recordings, library, tasks
        self._tell = tell
        self._worker = Worker(in_words)
        self._lock = threading.Lock()
        self._found: dict[str, Proposal] = {}
        self._begun = 0

    def of(self, recording_id: str) -> Proposal | None:
        """What is proposed for a recording; None where nothing is."""
        with self._lock:
            return self._found.get(recording_id)

    def begin(self) -> None:
        """Propose anew: which recordings are done has changed."""
        with self._lock:
            self._begun += 1
            number = self._begun
        self._worker.submit(lambda: self._propose_all(number), "propose")

    def stop(self) -> None:
        """Propose no more."""
        with self._lock:
            self._begun += 1
        self._worker.stop()
        self._worker.join()

    def _propose_all(self, number: int) -> None:
        folders: dict[Path, list[Recording]] = {}
        for recording in self._recordings():
            if recording.error is None:
                folders.setdefault(recording.path.parent, []).append(recording)
        wanted = {line.id for lines in folders.values() for line in _lacking(lines)}
        with self._lock:
            # What was proposed stays until it is proposed anew, so that no key changes its meaning.
            self._found = {id: one for id, one in self._found.items() if id in wanted}
            told = dict(self._found)
        self._tell(told)
        for lines in folders.values():
            self._propose_in(lines, number)

    def _propose_in(self, lines: list[Recording], number: int) -> None:
        done = [line for line in lines if line.state == "done"]
        others = _lacking(lines)
        if not others:
            return
        with self._tasks.begin("Proposing from what is done") as task:
            taught = [one for one in map(self._taught, done) if one is not None]
            usual = usual_cost_of(taught)
            phases = self._phases_of(lines[0].path.parent)
            for at, line in enumerate(others):
                if not taught or self._is_over(number):
                    return
                task.at(at / len(others))
                self._give_way(number)
                self._propose(line, taught, usual, phases)

    def _phases_of(self, folder: Path) -> Sequence[TaskPhase]:
        tasks = self._library.settings_of(folder).tasks
        return [phase for task in tasks for phase in task.phases]

    def _give_way(self, number: int) -> None:
        """What a person asked for comes first."""
        while not (self._library.is_free or self._is_over(number)):
            time.sleep(_LOOK_AGAIN_S)

    def _is_over(self, number: int) -> bool:
        with self._lock:
            return number != self._begun

    def _taught(self, line: Recording) -> Taught | None:
        try:
            opened = self._library.look(line)
        except KeyphaseError:
            return None
        opened.close()
        return taught_by(opened.kept_labeling)

    def _propose(
        self,
        line: Recording,
        taught: list[Taught],
        usual: float | None,
        phases: Sequence[TaskPhase],
    ) -> None:
        try:
            opened = self._library.look(line)
        except KeyphaseError:
            return
        opened.close()
        segmentation = opened.kept_labeling.segmentation
        demonstration = segmentation.demonstration
        transfer = propose(taught, demonstration, segmentation, usual_cost=usual, phases=phases)
        found = Proposal(
            teachers=transfer.teachers,
            confidence=_confidence(transfer),
            outline=None if transfer.outlier else _outline(transfer),
            edit=None if transfer.outlier else as_edit(transfer, segmentation),
            differs=transfer.differs,
        )
        with self._lock:
            self._found = {**self._found, line.id: found}
            told = dict(self._found)
        self._tell(told)


def _lacking(lines: Iterable[Recording]) -> list[Recording]:
    """The recordings of a folder that nobody has touched, where there is one that is done."""
    lines = list(lines)
    if not any(line.state == "done" for line in lines):
        return []
    return [line for line in lines if line.state == "automatic"]


def _confidence(transfer: Transfer) -> float:
    parts = (*transfer.boundaries, *transfer.phases)
    return min((part.confidence for part in parts), default=1.0)


def _outline(transfer: Transfer) -> Outline:
    phases = transfer.phases
    return Outline(
        tuple(boundary.time_s for boundary in transfer.boundaries),
        tuple(phase.name for phase in phases),
        (phases[0].start_s, phases[-1].end_s),
    )
