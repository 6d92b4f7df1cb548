"""The labels people use in a folder, each with its colour."""

import re
from collections.abc import Iterable
from dataclasses import dataclass, replace
from typing import Any

from keyphase.errors import LabelingError
from keyphase.labeling.colors import SEGMENT_COLORS
from keyphase.labeling.edits import check_label

MAX_LABELS = 500

_COLOR = re.compile(r"#[0-9A-Fa-f]{6}")


@dataclass(frozen=True)
class VocabularyLabel:
    """A label and its colour, as `#rrggbb`. Raises LabelingError for another form of either."""

    name: str
    color: str

    def __post_init__(self) -> None:
        if not self.name or check_label(self.name) != self.name:
            raise LabelingError("A label of the vocabulary must not be empty or padded.")
        if not _COLOR.fullmatch(self.color):
            raise LabelingError(
                f"Expected a colour such as {SEGMENT_COLORS[0]} for “{self.name}”, "
                f"but got {self.color[:20]!r}."
            )


@dataclass(frozen=True)
class Vocabulary:
    """The labels of a folder in the order of their number keys, each name once."""

    labels: tuple[VocabularyLabel, ...] = ()

    def __post_init__(self) -> None:
        if len({label.name for label in self.labels}) < len(self.labels):
            raise LabelingError("Each label stands in the vocabulary once.")
        if len(self.labels) > MAX_LABELS:
            raise LabelingError(f"A vocabulary has at most {MAX_LABELS} labels.")

    def color(self, name: str) -> str | None:
        """The colour of a label, None for one that is not in the vocabulary."""
        return next((label.color for label in self.labels if label.name == name), None)

    def with_label(self, name: str, color: str | None = None) -> "Vocabulary":
        """With one label more, in `color` where no other has it, else in the colour least used.

        The same if it is there already.
        """
        name = check_label(name)
        if not name or self.color(name) is not None or len(self.labels) == MAX_LABELS:
            return self
        used = [label.color.upper() for label in self.labels]
        if color is None or color.upper() in used:
            color = min(SEGMENT_COLORS, key=used.count)
        return replace(self, labels=(*self.labels, VocabularyLabel(name, color)))

    def without_label(self, name: str) -> "Vocabulary":
        """Without a label; segments that have it keep it."""
        return replace(self, labels=tuple(label for label in self.labels if label.name != name))

    def renamed(self, name: str, to: str) -> "Vocabulary":
        """With a label called otherwise in its place; the same where that name is taken."""
        if self.color(name) is None or self.color(to) is not None:
            return self
        labels = (replace(one, name=to) if one.name == name else one for one in self.labels)
        return replace(self, labels=tuple(labels))

    def led_by(self, first: Iterable[VocabularyLabel]) -> "Vocabulary":
        """With these labels before all others, in their colours."""
        leading = {label.name: label for label in first}
        others = (label for label in self.labels if label.name not in leading)
        return Vocabulary((*leading.values(), *others)[:MAX_LABELS])

    def as_json(self) -> list[dict[str, Any]]:
        """As JSON values."""
        return [{"name": label.name, "color": label.color} for label in self.labels]
