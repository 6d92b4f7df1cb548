"""What a person should know about a recording: sentences, some of which are a caution.

A notice is text wherever it is printed or kept; a caution says so of itself, so that a page need
not guess from its words.
"""

from typing import Literal

Severity = Literal["note", "warning"]


class Caution(str):
    """A notice that labels or replay may be wrong: data was left out, held, filled or mended, is
    odd, or is not kept as usual."""

    __slots__ = ()


def severity_of(notice: str) -> Severity:
    """How much a notice matters."""
    return "warning" if isinstance(notice, Caution) else "note"
