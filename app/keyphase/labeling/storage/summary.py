"""What a list of recordings shows of their journals."""

import contextlib
from dataclasses import dataclass
from pathlib import Path

from keyphase.errors import KeyphaseError
from keyphase.labeling.assessment import NOTHING_SAID, Assessment
from keyphase.labeling.edits import Done, DropPhase, RenamePhase
from keyphase.labeling.edits.base import BaseEdit
from keyphase.labeling.edits.beside.assess import assessment_of
from keyphase.labeling.edits.beside.assess_segment import marked
from keyphase.labeling.finished import changed_since_done, is_done, needs_freezing
from keyphase.labeling.frozen import Frozen
from keyphase.labeling.history import History
from keyphase.labeling.storage.readings import longest_journal
from keyphase.labeling.storage.state_folder import journal_path, state_folder


@dataclass(frozen=True)
class JournalSummary:
    """What a list of recordings shows of a journal.

    unfrozen    it was finished by a version that did not keep what was seen
    assessment  what a person thinks of the recording as a whole
    marked      what is said of single segments
    together    steps that were made in other recordings of the folder, too, in force or taken back
    frozen      what was seen when it was done, where nothing was edited since

    changed_since_done  segments were changed after it was done
    """

    touched: bool
    done: bool
    changed_since_done: bool = False
    unfrozen: bool = False
    assessment: Assessment = NOTHING_SAID
    marked: tuple[Assessment, ...] = ()
    together: frozenset[str] = frozenset()
    frozen: Frozen | None = None


def summarize(recording: Path) -> JournalSummary:
    """What the journal of a recording says, without opening it for writing.

    A journal that cannot be read counts as none; opening it says what is wrong.
    """
    folder = state_folder(recording.parent, create=False)
    followed = None
    with contextlib.suppress(KeyphaseError, OSError):
        followed, _ = longest_journal(folder, journal_path(recording, folder.path).name)
    if followed is None:
        return JournalSummary(touched=False, done=False)
    state = followed.state
    done = is_done(state.history, done_before=state.done_before)
    unfrozen = needs_freezing(state.history, done_before=state.done_before)
    edits = {step.number: step.change for step in state.history.done}
    made = {n: edit for n, edit in edits.items() if isinstance(edit, BaseEdit)}
    return JournalSummary(
        bool(state.history.done),
        done,
        changed_since_done(state.history),
        unfrozen,
        assessment_of(made),
        marked(made),
        frozenset(
            step.change.step
            for step in state.history.steps
            if isinstance(step.change, RenamePhase | DropPhase)
        ),
        _as_seen(state.history),
    )


def _as_seen(history: History) -> Frozen | None:
    last = history.last_done
    return last.change.frozen if last and isinstance(last.change, Done) else None
