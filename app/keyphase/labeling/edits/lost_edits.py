"""What a person says to an edit whose place is gone: bring it back, or forget it."""

from keyphase.errors import LabelingError
from keyphase.labeling.edits.base import BaseEdit, InForce
from keyphase.labeling.labeling import Labeling


class BringBack(BaseEdit, frozen=True, tag="bring_back"):
    """Make edit number `edit`, whose place is gone, apply again by adding its boundaries."""

    edit: int

    def checked(self) -> "BringBack":
        """With a number that an edit can have."""
        _check_number(self.edit)
        return self

    def anchored(self, labeling: Labeling) -> "BringBack":
        """Refused where that edit has its place."""
        _check_lost(self.edit, labeling)
        return self

    def enter(self, number: int, in_force: InForce) -> None:
        """From here on that edit makes its own place."""
        in_force.insisted.add(self.edit)
        in_force.edits[number] = self

    def step_name(self, labeling: Labeling) -> str:
        """One name for every edit."""
        return "Bring back an edit"


class Forget(BaseEdit, frozen=True, tag="forget"):
    """Leave out edit number `edit`, whose place is gone, from now on."""

    edit: int

    def checked(self) -> "Forget":
        """With a number that an edit can have."""
        _check_number(self.edit)
        return self

    def anchored(self, labeling: Labeling) -> "Forget":
        """Refused where that edit has its place."""
        _check_lost(self.edit, labeling)
        return self

    def enter(self, number: int, in_force: InForce) -> None:
        """That edit counts no more."""
        in_force.forget(self.edit)

    def step_name(self, labeling: Labeling) -> str:
        """One name for every edit."""
        return "Forget an edit"


def _check_number(number: int) -> None:
    if number < 0:
        raise LabelingError(f"Edits are counted from 0, but edit {number} was named.")


def _check_lost(number: int, labeling: Labeling) -> None:
    if all(number != each.edit for each in labeling.inapplicable):
        raise LabelingError(f"Edit {number} has not lost its place; there is nothing to do.")
