"""Labels made shorter, for where there is little room."""

import re
from functools import lru_cache

_MEASURE = re.compile(r"\s*\b\d+(\.\d+)?\s?(mm|cm|m|deg|°)(?!\w)")
_ONE = r"(?:left|right|forward|backward|back|up|down)"
_DIRECTIONS = re.compile(rf"\s+{_ONE}(?:\s+and\s+{_ONE})*\b")
_LONG = 16
"""A label of so many letters is long."""


@lru_cache(maxsize=4096)
def short_labels(label: str) -> tuple[str, str, str]:
    """The label, a shorter one without measures and directions, and its first word.

    Where a direction is all that is said of a movement it stays: "Left and down".
    """
    shorter = unmeasured(label)
    if len(shorter) > _LONG:
        verb, _, said = shorter.partition(" ")
        shorter = _DIRECTIONS.sub("", shorter)
        shorter = said[:1].upper() + said[1:] if shorter == verb else shorter
    first, _, rest = shorter.partition(" ")
    return label, shorter or label, f"{first}…" if rest else shorter or label


def unmeasured(label: str) -> str:
    """The label without measures: "Move down until contact"."""
    return _MEASURE.sub("", label)
