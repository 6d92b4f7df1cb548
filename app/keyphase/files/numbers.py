"""Numbers in JSON that are numbers to everything else, too."""

import math

_MAX_NUMBER = 2**63


def finite_number(text: str) -> float:
    """The number a JSON text writes. Raises ValueError for NaN, Infinity and 1e999."""
    value = float(text)
    if not math.isfinite(value):
        raise ValueError(f"{text[:20]} is no finite number")
    return value


def whole_number(text: str) -> int:
    """The whole number a JSON text writes. Raises ValueError where it is beyond 2^63."""
    value = int(text) if len(text) <= 20 else _MAX_NUMBER + 1
    if abs(value) > _MAX_NUMBER:
        raise ValueError(f"{text[:20]}… is larger than any number here")
    return value
