"""Which values a control of viser's panel may take from a browser."""

import math
from typing import Any

import viser


def takes(control: Any, value: object) -> bool:
    """Whether a browser may set `control` to `value`: of the right kind, and in its range."""
    match control:
        case viser.GuiButtonHandle() | viser.GuiCheckboxHandle():
            return isinstance(value, bool)
        case viser.GuiSliderHandle() | viser.GuiNumberHandle():
            return _in_range(value, control.min, control.max)
        case viser.GuiMultiSliderHandle():
            return (
                isinstance(value, list)
                and len(value) == len(control.value)
                and all(_in_range(item, control.min, control.max) for item in value)
            )
        case viser.GuiDropdownHandle() | viser.GuiButtonGroupHandle():
            return isinstance(value, str) and value in control.options
        case viser.GuiTextHandle():
            return isinstance(value, str)
    return False


def _in_range(value: object, low: float | None, high: float | None) -> bool:
    """Sliders send their ends with rounding errors."""
    if isinstance(value, bool) or not isinstance(value, int | float) or not math.isfinite(value):
        return False
    lowest = -math.inf if low is None else low - 1e-9 * max(abs(low), 1.0)
    highest = math.inf if high is None else high + 1e-9 * max(abs(high), 1.0)
    return lowest <= value <= highest
