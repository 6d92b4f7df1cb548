"""The numbers of a URDF: as many as each attribute takes, finite, and none larger than a robot.

The parsers behind yourdfpy and Pinocchio leave out what they cannot read, and only print why.
"""

from collections.abc import Mapping
from pathlib import Path
from xml.etree import ElementTree

import numpy as np

from keyphase.errors import RobotError

_COUNTS: Mapping[tuple[str, str], int] = {
    ("origin", "xyz"): 3,
    ("origin", "rpy"): 3,
    ("axis", "xyz"): 3,
    ("box", "size"): 3,
    ("mesh", "scale"): 3,
    ("color", "rgba"): 4,
    ("cylinder", "radius"): 1,
    ("cylinder", "length"): 1,
    ("sphere", "radius"): 1,
    ("mass", "value"): 1,
    ("mimic", "multiplier"): 1,
    ("mimic", "offset"): 1,
    **{("limit", key): 1 for key in ("lower", "upper", "velocity", "effort")},
    **{("inertia", key): 1 for key in ("ixx", "ixy", "ixz", "iyy", "iyz", "izz")},
}
_MAX_SIZE = 1e9


def refuse_bad_numbers(path: Path, robot: ElementTree.Element) -> None:
    """Raise RobotError for the first attribute that does not hold the numbers it takes."""
    for part in robot:
        if part.tag not in ("link", "joint"):
            continue
        for element in part.iter():
            for key, text in element.attrib.items():
                count = _COUNTS.get((element.tag, key))
                if count is not None and not _are_numbers(text, count):
                    raise RobotError(
                        f"{path}: {part.tag} '{part.get('name')}' must have {_in_words(count)} for "
                        f"{key} in <{element.tag}>, but has '{text[:60]}'; correct it."
                    )


def _are_numbers(text: str, count: int) -> bool:
    try:
        numbers = [float(word) for word in text.split()]
    except ValueError:
        return False
    return len(numbers) == count and bool(np.all(np.abs(numbers) <= _MAX_SIZE))


def _in_words(count: int) -> str:
    return "a number" if count == 1 else f"{count} numbers"
