"""Labels made shorter, for where there is little room."""

import re
from functools import lru_cache

_MEASURE = re.compile(r"\s*\b\d+(\.\d+)?\s?(mm|cm|m|deg|°)(?!\w)")
_DIRECTION = re.compile(r"\s+(left|right|forward|backward|back|up|down)\b")


@lru_cache(maxsize=4096)
def short_labels(label: str) -> tuple[str, str, str]:
    """The label, a shorter one without measures and directions, and its first word."""
    without_measure = unmeasured(label)
    shorter = without_measure if len(without_measure) <= 16 else _DIRECTION.sub("", without_measure)
    first, _, rest = shorter.partition(" ")
    return label, shorter or label, f"{first}…" if rest else shorter or label


def unmeasured(label: str) -> str:
    """The label without measures: "Move down until contact"."""
    return _MEASURE.sub("", label)
