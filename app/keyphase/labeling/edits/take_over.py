"""Taking over another's segmentation of the recording as one step."""

from typing import Annotated

import msgspec

from keyphase.labeling.edits.add import Add
from keyphase.labeling.edits.base import BaseEdit, InForce
from keyphase.labeling.edits.contact import Contact
from keyphase.labeling.edits.keep import Keep
from keyphase.labeling.edits.label import Label, check_label, shortened
from keyphase.labeling.edits.plan import Plan
from keyphase.labeling.edits.remove import Remove
from keyphase.labeling.labeling import Labeling
from keyphase.labeling.walk import Walk

MAX_TAKEN_OVER = 100_000
"""Edits of which one taking over consists at most."""

Part = Remove | Add | Contact | Label | Keep | Plan
"""What taking over consists of."""

Share = Annotated[float, msgspec.Meta(ge=0.0, le=1.0)]


class TakeOver(BaseEdit, frozen=True, tag="take_over"):
    """Take over another's segmentation of this recording; edits before count no more.

    source  where it came from, for people
    edits   what makes it of the automatic segmentation, in order; see `taking_over`
    confidences  time and confidence (0 to 1) of boundaries, where the source is not sure of all
    """

    source: str
    edits: Annotated[tuple[Part, ...], msgspec.Meta(max_length=MAX_TAKEN_OVER)]
    confidences: Annotated[
        tuple[tuple[float, Share], ...], msgspec.Meta(max_length=MAX_TAKEN_OVER)
    ] = ()

    def checked(self) -> "TakeOver":
        """With each part checked, and a source that is plain text."""
        return msgspec.structs.replace(
            self,
            source=check_label(self.source),
            edits=tuple(each.checked() for each in self.edits),
        )

    def enter(self, number: int, in_force: InForce) -> None:
        """All edits before count no more."""
        in_force.begin_again()
        in_force.edits[number] = self

    def apply(self, number: int, walk: Walk, insisted: bool) -> None:
        """Its parts one after another."""
        for each in self.edits:
            each.apply(number, walk, insisted)
        for each in self.edits:
            mark = walk.line.find(each.time_s) if isinstance(each, Add) else None
            if mark is not None and mark.by_hand:
                mark.taken_from = self.source
        for time_s, confidence in self.confidences:
            mark = walk.line.find(time_s)
            if mark is not None:
                mark.proposed_confidence = confidence

    def step_name(self, labeling: Labeling) -> str:
        """With where it came from."""
        return f"Take over “{shortened(self.source)}”"
