"""The paper's set-ups as families: recordings of the scripted operator, with their truth."""

from keyphase.errors import MakingError
from keyphase.making import Made
from keyphase.making.made import Event
from keyphase.making.path import MotionEvent
from keyphase.making.truth import with_truth

SET_UPS = ("setup1", "setup2")
"""Every workcell that can be a family."""

FIRST_SEED = 10_000
"""Far from the seeds that anybody records for a look or a judgement."""

_FELT = {"snap": "contact made", "contact": "contact made", "others": "contact changed"}
_AROUND_S = 0.15
"""The operator's phases change up to this before or after the tool is seen to."""


def recorded_set_up(family: str, seed: int) -> Made:
    """A recording of one of `SET_UPS`; the same seed gives the same bytes on one machine.

    Contact changes are those between two phases: the touch right before the snap and the wall that
    ends the recording are none. Between the others a phase of the operator ends and one begins.
    Raises MakingError for a family that does not exist.
    """
    from keyphase.simulation import record

    if family not in SET_UPS:
        raise MakingError(f"Expected one of the families {', '.join(SET_UPS)}, but got {family!r}.")
    demonstration = record(family, seed=FIRST_SEED + seed)
    truth = demonstration.metadata["ground_truth"]
    onsets = truth["contact_onsets_s"]
    contacts = [
        Event(onsets[name], label, "contact") for name, label in _FELT.items() if name in onsets
    ]
    motion = [
        MotionEvent(phase["end_s"], "motion began", 2.0 * _AROUND_S)
        for phase in truth["phases"][:-1]
    ]
    return with_truth(family, demonstration, contacts, motion)
