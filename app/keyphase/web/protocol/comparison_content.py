"""The `comparison` message."""

from keyphase.web.protocol.list_messages import ComparisonMessage
from keyphase.workbench.desks.desk_state import DeskState
from keyphase.workbench.proposals import Proposal
from keyphase.workbench.showing.comparing import comparison


def comparison_message(
    state: DeskState, other: str | None, proposal: Proposal | None = None
) -> ComparisonMessage:
    """With what a recording can be compared, and how `other` agrees.

    Raises RequestError for a name that is not offered, SegmentFileError and LabelingError for a
    file that cannot be compared.
    """
    found = comparison(state, other, proposal.outline if proposal else None)
    if found.outline is None or found.result is None:
        return ComparisonMessage(state.recording.id, found.options)
    outline, result = found.outline, found.result
    return ComparisonMessage(
        recording=state.recording.id,
        options=found.options,
        other=found.other,
        boundaries_s=tuple(map(float, outline.boundaries_s)),
        labels=tuple(outline.labels),
        shared=tuple((float(pair.first_s), float(pair.second_s)) for pair in result.shared),
        only_first_s=tuple(map(float, result.only_first_s)),
        only_second_s=tuple(map(float, result.only_second_s)),
        f1=float(result.f1),
        same_label=float(result.same_label),
        timing_s=found.timing_s,
    )
