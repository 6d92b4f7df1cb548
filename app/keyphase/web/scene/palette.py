"""Colours of the scene, as the timeline has them."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from keyphase.labeling.colors import SEGMENT_COLORS

Rgb = tuple[int, int, int]


class Theme(NamedTuple):
    """What differs between light and dark; `shade` is how dark a shadow on the ground is, to 1."""

    sky: Rgb
    ground: Rgb
    cell: Rgb
    section: Rgb
    shade: float
    origins: dict[str, Rgb]


PAINT_GAMMA = 2.6
"""For thin things, of which the lit side is seen."""

PART_GAMMA = 1.7
"""For large things, whose shaded sides are seen as well."""


def _rgb(code: str) -> Rgb:
    return int(code[1:3], 16), int(code[3:5], 16), int(code[5:7], 16)


SEGMENT_RGB: NDArray[np.uint8] = np.array([_rgb(code) for code in SEGMENT_COLORS], np.uint8)

IDLE = _rgb("#6f7780")
"""The path of idle and dropped segments."""

LIGHT = Theme(
    sky=_rgb("#f1f3f5"),
    ground=_rgb("#d9dcdf"),
    cell=_rgb("#cbcfd3"),
    section=_rgb("#bcc1c6"),
    shade=0.30,
    origins={
        "position": _rgb("#7048e8"),
        "force": _rgb("#e8590c"),
        "both": _rgb("#c2255c"),
        "gripper": _rgb("#0b7285"),
        "user": _rgb("#1b1f24"),
    },
)

DARK = Theme(
    sky=_rgb("#141414"),
    ground=_rgb("#24272b"),
    cell=_rgb("#3a3e43"),
    section=_rgb("#4a4f55"),
    shade=0.5,
    origins={
        "position": _rgb("#a78bfa"),
        "force": _rgb("#ff922b"),
        "both": _rgb("#f783ac"),
        "gripper": _rgb("#3bc9db"),
        "user": _rgb("#f1f3f5"),
    },
)


def segment_color(color: int, kept: bool) -> Rgb:
    """Colour of a segment by its number, as it is to be seen."""
    if not kept:
        return IDLE
    red, green, blue = SEGMENT_RGB[color % len(SEGMENT_RGB)].tolist()
    return red, green, blue


def painted(color: Rgb, gamma: float = PAINT_GAMMA) -> Rgb:
    """The paint that looks like `color` in the scene, whose tone mapping takes colour away."""
    red, green, blue = (round(255 * (value / 255) ** gamma) for value in color)
    return red, green, blue
