"""How far something varies between disturbed worlds, and how people write it."""

import math
import re
from dataclasses import dataclass

import numpy as np

from keyphase.errors import ParameterError

_UNITS = {"": 1.0, "m": 1.0, "cm": 1e-2, "mm": 1e-3, "deg": math.radians(1.0)}
_NUMBER = re.compile(r"([+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)\s*([a-z]*)")


@dataclass(frozen=True)
class Range:
    """Uniform from `low` to `high`; both ends may be equal."""

    low: float
    high: float

    def drawn(self, random: np.random.Generator) -> float:
        """One value."""
        return float(random.uniform(self.low, self.high))

    @property
    def single(self) -> float | None:
        """The one value it can take, None where there are several."""
        return self.low if self.low == self.high else None


def range_of(text: str, name: str, *, symmetric: bool = False) -> Range:
    """The range in a text: `0.2..0.6` a range, `0.3` that value.

    Where `symmetric`, a single value a is the range from -a to a. Lengths take m, cm or mm and are
    in metres without, angles take deg and are in radians without. `name` is what messages call it.
    Raises ParameterError for anything else.
    """
    low, dots, high = text.partition("..")
    first = _value(low, text, name)
    if not dots:
        return Range(-abs(first), abs(first)) if symmetric else Range(first, first)
    last = _value(high, text, name)
    if last < first:
        raise ParameterError(f"{name} must ascend from a to b in a..b, but is '{text}'.")
    return Range(first, last)


def _value(text: str, whole: str, name: str) -> float:
    match = _NUMBER.fullmatch(text.strip())
    value = float(match[1]) * _UNITS.get(match[2], math.nan) if match else math.nan
    if not math.isfinite(value):
        raise ParameterError(
            f"{name} must be a number or a range a..b, lengths with m, cm or mm, angles with "
            f"deg, but is '{whole}'; write for instance 10mm or 0.2..0.6."
        )
    return value
