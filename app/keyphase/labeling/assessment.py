"""What a person thinks of a recording as a whole: did it succeed, how good is it, a note."""

from dataclasses import dataclass
from typing import Literal

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


NOTHING_SAID = Assessment()
