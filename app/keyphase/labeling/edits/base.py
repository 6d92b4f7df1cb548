"""What all kinds of edits share; each kind's own module says what it is and does.

An edit first says what a person wants (`Label(4.2, "insert")`). `anchored` completes it with what
it needs to find its place again when thresholds have moved: exact times of boundaries, spans of
segments. The optional fields are those.
"""

import math
from dataclasses import dataclass, field
from typing import Any, ClassVar, Self

import msgspec

from keyphase.errors import LabelingError
from keyphase.labeling.labeling import Labeling
from keyphase.labeling.walk import Walk

_MAX_TIME_S = 1e10


@dataclass(eq=False)
class InForce:
    """The edits that count: those since the last reset that were not forgotten, in order.

    insisted   numbers of edits that a person brought back after their place had gone
    plan       number of the last plan, the only one that counts
    before_done  edits from before the recording was done, which count again when it is opened
    """

    edits: dict[int, "BaseEdit"] = field(default_factory=dict)
    insisted: set[int] = field(default_factory=set)
    plan: int | None = None
    before_done: dict[int, "BaseEdit"] = field(default_factory=dict)

    def forget(self, number: int) -> None:
        """Leave an edit out from here on."""
        self.edits.pop(number, None)

    def begin_again(self) -> None:
        """Leave all edits before out."""
        self.edits.clear()
        self.insisted.clear()
        self.plan = None
        self.before_done = {}


class BaseEdit(msgspec.Struct, frozen=True, tag_field="kind", forbid_unknown_fields=True,
               omit_defaults=True):  # fmt: skip
    """One thing a person did; the kinds are its subclasses, each in a module of its own.

    changes_segments  whether it does anything to boundaries or segments
    """

    changes_segments: ClassVar[bool] = True

    def checked(self) -> Self:
        """The edit with its values checked and its text without surrounding spaces.

        Raises LabelingError where a value is not finite, too large or too long.
        """
        if not all(math.isfinite(t) and abs(t) <= _MAX_TIME_S for t in times_in(self)):
            raise LabelingError(
                f"The times of an edit of kind {kind_of(self)} must be finite seconds."
            )
        return self

    def anchored(self, labeling: Labeling) -> Self:
        """The edit, completed from the labeling a person saw when making it.

        Raises LabelingError, with the reason, where it cannot be made there or changes nothing.
        """
        return self

    def enter(self, number: int, in_force: InForce) -> None:
        """Take one's place among the edits that count."""
        in_force.edits[number] = self

    def apply(self, number: int, walk: Walk, insisted: bool) -> None:
        """Do to boundaries and decisions what a person wanted; `insisted` makes its place."""


def kind_of(edit: BaseEdit) -> str:
    """The kind of an edit, as JSON names it."""
    return str(edit.__struct_config__.tag)


def times_in(value: Any) -> list[float]:
    """Every floating-point number in an edit: all of them are times."""
    if isinstance(value, float):
        return [value]
    if isinstance(value, BaseEdit):
        value = [getattr(value, name) for name in value.__struct_fields__]
    if isinstance(value, list | tuple):
        return [time for item in value for time in times_in(item)]
    return []
