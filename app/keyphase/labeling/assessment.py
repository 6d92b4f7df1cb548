"""What a person thinks of a recording, or of one segment: success, how good it is, a note."""

from dataclasses import dataclass
from typing import Literal

from keyphase.errors import LabelingError

Outcome = Literal["success", "failure"]

LOWEST_QUALITY, HIGHEST_QUALITY = 1, 5
MAX_NOTE_LENGTH = 1000


@dataclass(frozen=True)
class Assessment:
    """Outcome, quality from 1 to 5, and a note; nothing is said where nobody has said it."""

    outcome: Outcome | None = None
    quality: int | None = None
    note: str = ""

    def __bool__(self) -> bool:
        """Whether anything is said."""
        return self != Assessment()

    def checked(self) -> "Assessment":
        """With a quality on the scale, and a note of one line that is not too long.

        Raises LabelingError otherwise.
        """
        quality, note = self.quality, " ".join(self.note.split())
        if quality is not None and not LOWEST_QUALITY <= quality <= HIGHEST_QUALITY:
            raise LabelingError(
                f"A quality is {LOWEST_QUALITY} to {HIGHEST_QUALITY}, but {quality} came."
            )
        if len(note) > MAX_NOTE_LENGTH or not note.isprintable():
            raise LabelingError(
                f"A note is plain text of at most {MAX_NOTE_LENGTH} characters; shorten it."
            )
        return Assessment(self.outcome, quality, note)

    def change_from(self, before: "Assessment") -> str:
        """What is said otherwise than before, in a few words."""
        if self.outcome != before.outcome:
            return f"as {self.outcome}" if self.outcome else "neither success nor failure"
        if self.quality != before.quality:
            return f"quality {self.quality}" if self.quality else "no quality"
        return "with a note" if self.note else "without a note"


NOTHING_SAID = Assessment()
