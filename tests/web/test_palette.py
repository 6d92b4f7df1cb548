"""Colours of segments are told from the path of what is idle, whatever colours a person sees."""

import re
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

import keyphase.web
from keyphase.web.scene.palette import IDLE, SEGMENT_RGB

Array = NDArray[np.float64]

SEEN = {
    "all colours": np.eye(3),
    "no red": np.array(
        [
            [0.152286, 1.052583, -0.204868],
            [0.114503, 0.786281, 0.099216],
            [-0.003882, -0.048116, 1.051998],
        ]
    ),
    "no green": np.array(
        [
            [0.367322, 0.860646, -0.227968],
            [0.280085, 0.672501, 0.047413],
            [-0.011820, 0.042940, 0.968881],
        ]
    ),
    "no blue": np.array(
        [
            [1.255528, -0.076749, -0.178779],
            [-0.078411, 0.930809, 0.147602],
            [0.004733, 0.691367, 0.303900],
        ]
    ),
}
"""What of linear red, green and blue is seen (Machado, Oliveira, Fernandes, 2009)."""

APART = 8.0
"""In OKLab, times 100: 2 is just seen side by side."""

_TO_CONES = np.array(
    [
        [0.4122214708, 0.5363325363, 0.0514459929],
        [0.2119034982, 0.6806995451, 0.1073969566],
        [0.0883024619, 0.2817188376, 0.6299787005],
    ]
)
_TO_LAB = np.array(
    [
        [0.2104542553, 0.7936177850, -0.0040720468],
        [1.9779984951, -2.4285922050, 0.4505937099],
        [0.0259040371, 0.7827717662, -0.8086757660],
    ]
)


def _oklab(rgb: Array, seen: Array) -> Array:
    """Where a colour lies (Ottosson, 2020)."""
    value = rgb / 255.0
    linear = np.where(value <= 0.04045, value / 12.92, ((value + 0.055) / 1.055) ** 2.4)
    return _TO_LAB @ np.cbrt(_TO_CONES @ np.clip(seen @ linear, 0.0, 1.0))


@pytest.mark.parametrize("seen", SEEN)
@pytest.mark.parametrize("number", range(len(SEGMENT_RGB)))
def test_a_segment_is_told_from_what_is_idle(number: int, seen: str) -> None:
    segment = _oklab(SEGMENT_RGB[number].astype(float), SEEN[seen])
    idle = _oklab(np.array(IDLE, dtype=float), SEEN[seen])

    assert 100.0 * np.linalg.norm(segment - idle) >= APART


def test_the_page_has_the_same_colours() -> None:
    assert keyphase.web.__file__
    theme = (Path(keyphase.web.__file__).parent / "page" / "css" / "theme.css").read_text()
    idle = re.findall(r"--idle: #(\w+);", theme)
    segments = re.findall(r"--segment-\d: #(\w+);", theme)

    assert {bytes.fromhex(code) for code in idle} == {bytes(IDLE)}
    assert [bytes.fromhex(code) for code in segments] == [bytes(one) for one in SEGMENT_RGB]
