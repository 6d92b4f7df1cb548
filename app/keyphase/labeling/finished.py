"""Whether a person has finished with a recording, and what was seen then, from its history."""

from keyphase.labeling.edits import Done, Reopen, Reset, TakeOver
from keyphase.labeling.edits.base import BaseEdit
from keyphase.labeling.frozen import Frozen
from keyphase.labeling.history import History

_DECIDES = (Done, Reopen, Reset, TakeOver)


def frozen_of(history: History) -> Frozen | None:
    """What was seen when a person finished with it; None where it is not done."""
    last = next((s.change for s in reversed(history.done) if isinstance(s.change, _DECIDES)), None)
    return last.frozen if isinstance(last, Done) else None


def changed_since_done(history: History) -> bool:
    """Whether segments were changed after a person had finished with it."""
    changed = False
    for step in reversed(history.done):
        if isinstance(step.change, _DECIDES):
            return changed and isinstance(step.change, Done)
        changed |= isinstance(step.change, BaseEdit) and step.change.changes_segments
    return False


def needs_freezing(history: History, *, done_before: bool) -> bool:
    """Whether it was finished by a version that did not keep what was seen."""
    return done_before and not any(isinstance(s.change, _DECIDES) for s in history.done)


def is_done(history: History, *, done_before: bool) -> bool:
    """Whether a person has finished with it."""
    return frozen_of(history) is not None or needs_freezing(history, done_before=done_before)
