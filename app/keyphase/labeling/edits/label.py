"""Naming a segment, and what may stand in a name."""

import unicodedata

import msgspec

from keyphase.errors import LabelingError
from keyphase.labeling.edits.base import BaseEdit
from keyphase.labeling.edits.places import segments_numbered, stretch_at
from keyphase.labeling.labeling import Labeling
from keyphase.labeling.spans import Span
from keyphase.labeling.walk import Walk

MAX_LABEL_LENGTH = 200
"""Characters."""

_MAX_SHOWN_LENGTH = 24
_NOT_TEXT = frozenset({"Cc", "Cf", "Cs", "Co", "Cn", "Zl", "Zp"})


class Label(BaseEdit, frozen=True, tag="label"):
    """Name the segment around `time_s`, or all from there to the one around `to_s`.

    An empty label gives back the proposed one.
    """

    time_s: float
    label: str
    span_s: Span | None = None
    to_s: float | None = None

    def checked(self) -> "Label":
        """With a label that is plain text."""
        return msgspec.structs.replace(super().checked(), label=check_label(self.label))

    def anchored(self, labeling: Labeling) -> "Label":
        """At the middle of its segment, with the span of all it is about."""
        first, *more = stretch_at(self.time_s, self.to_s, labeling)
        last = more[-1] if more else first
        span, to_s = (first.start_s, last.end_s), last.middle_s if more else None
        return Label(first.middle_s, check_label(self.label), span, to_s)

    def apply(self, number: int, walk: Walk, insisted: bool) -> None:
        """The latest label of a segment wins."""
        walk.decide_label(number, walk.held(self.time_s, self.span_s, insisted), self.label)

    def step_name(self, labeling: Labeling) -> str:
        """With the label as it was given."""
        named = segments_numbered(self.time_s, self.to_s, labeling)
        if not self.label:
            whose = "its proposed label" if self.to_s is None else "their proposed labels"
            return f"Give {named} {whose}"
        return f"Label {named} “{shortened(self.label)}”"


def check_label(label: str) -> str:
    """The label without surrounding spaces.

    Raises LabelingError where it is too long or holds anything but text, such as line breaks and
    marks that turn the writing direction.
    """
    label = label.strip()
    if len(label) > MAX_LABEL_LENGTH:
        raise LabelingError(
            f"A label has at most {MAX_LABEL_LENGTH} characters, but this one has {len(label)}; "
            "shorten it."
        )
    strange = next((c for c in label if unicodedata.category(c) in _NOT_TEXT), None)
    if strange is not None:
        raise LabelingError(
            f"A label must be plain text in one line, but this one holds U+{ord(strange):04X}; "
            "leave that character out."
        )
    return label


def shortened(text: str) -> str:
    """A label as the name of a step shows it."""
    return text if len(text) <= _MAX_SHOWN_LENGTH else f"{text[: _MAX_SHOWN_LENGTH - 1]}…"
