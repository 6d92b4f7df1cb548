"""One thing about a recording that a person should know before labeling it."""

from dataclasses import dataclass
from typing import Literal

from keyphase.demonstration import Demonstration
from keyphase.notices import Severity

Kind = Literal["time", "gap", "jump", "zero rows", "constant", "saturated", "frozen",
               "still pose", "wander", "sign", "scale", "order"]  # fmt: skip


@dataclass(frozen=True)
class Oddity:
    """What is odd, where, and in words.

    severity  "warning" where labels or replay would probably be wrong, else "note"
    span_s    from when to when [s], None where it is about the whole recording
    """

    kind: Kind
    severity: Severity
    text: str
    span_s: tuple[float, float] | None = None


MAX_NAMED = 5
"""So many of a kind are told one by one."""


def first_few(found: list[Oddity]) -> list[Oddity]:
    """The first of many, the last of them saying how many more there are."""
    if len(found) <= MAX_NAMED:
        return found
    last = found[MAX_NAMED - 1]
    more = f"{last.text.removesuffix('.')}, and {len(found) - MAX_NAMED} more like it."
    return [*found[: MAX_NAMED - 1], Oddity(last.kind, last.severity, more, last.span_s)]


def at_row(demonstration: Demonstration, row: int) -> str:
    """Where a row is, in words."""
    return f"at {demonstration.time_s[row]:.2f} s (row {row + 1})"
