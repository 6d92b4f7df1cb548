"""Units that tables come in, and their size in the units keyphase computes in."""

import difflib
import math
from collections.abc import Mapping
from typing import Literal

from keyphase.errors import RecipeError

Quantity = Literal["time", "length", "angle", "force", "torque", "opening"]

_SIZES: Mapping[Quantity, Mapping[str, float]] = {
    "time": {"s": 1.0, "ms": 1e-3, "us": 1e-6, "ns": 1e-9, "min": 60.0},
    "length": {"m": 1.0, "dm": 0.1, "cm": 1e-2, "mm": 1e-3, "um": 1e-6, "in": 0.0254},
    "angle": {"rad": 1.0, "mrad": 1e-3, "deg": math.pi / 180},
    "force": {"N": 1.0, "mN": 1e-3, "kN": 1e3, "lbf": 4.4482216152605},
    "opening": {"m": 1.0, "cm": 1e-2, "mm": 1e-3, "fraction": 1.0, "percent": 1e-2},
    "torque": {"Nm": 1.0, "Nmm": 1e-3, "Ncm": 1e-2, "mNm": 1e-3, "kNm": 1e3},
}


def units_of(quantity: Quantity) -> tuple[str, ...]:
    """The units a recipe may name for a quantity."""
    return tuple(_SIZES[quantity])


def unit_size(unit: str, quantity: Quantity, where: str) -> float:
    """The size of a unit in s, m, rad, N or N m; "N mm", "N·mm" and "Nmm" are the same.

    Raises RecipeError for a unit nobody knows, naming the ones that are known.
    """
    sizes = _SIZES[quantity]
    plain = unit.translate({ord(c): None for c in " ·*"})
    if plain in sizes:
        return sizes[plain]
    near = difflib.get_close_matches(plain[:20], sizes, n=1)
    hint = f"; did you mean {near[0]}?" if near else "."
    raise RecipeError(
        f"{where}: expected a unit of {quantity} ({', '.join(sizes)}), "
        f"but found {unit[:40]!r}{hint}"
    )
