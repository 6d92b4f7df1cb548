"""Going back to what the program found."""

from keyphase.labeling.edits.base import BaseEdit, InForce
from keyphase.labeling.labeling import Labeling


class Reset(BaseEdit, frozen=True, tag="reset"):
    """Back to what the program found; all edits before count no more."""

    def enter(self, number: int, in_force: InForce) -> None:
        """All edits before count no more."""
        in_force.begin_again()

    def step_name(self, labeling: Labeling) -> str:
        """As it is offered."""
        return "Reset to automatic"
