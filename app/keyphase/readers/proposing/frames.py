"""Which transform of a bag is the tool's: of all chains of links one, and none beside a pose."""

import re
from collections.abc import Sequence

import numpy as np

from keyphase.demonstration import Array
from keyphase.readers.proposing.naming import TOOL

_TRANSFORM = re.compile(r"(/tf\[(.*)>(.*)\])\..*")
_POSE = re.compile(r"(?!/tf\[).*pose.*\.position\.[xyz]$")


def other_transforms(
    names: Sequence[str], values: Array, remarks: Sequence[str]
) -> tuple[int, ...]:
    """Columns of the transforms that are not looked at for where the tool was.

    The one that is ends at the frame some topic is written in, or at one called tool, and begins
    at one called base; where a topic is a pose already, none is.
    """
    matched = {i: match for i, name in enumerate(names) if (match := _TRANSFORM.fullmatch(name))}
    if not matched:
        return ()
    best = None
    if not any(_POSE.match(name) for name in names):
        best = max(
            (match for i, match in matched.items() if _moves(names[i], values[:, i])),
            key=lambda match: _likeliness(match[2], match[3], remarks),
            default=None,
        )
    return tuple(i for i, match in matched.items() if best is None or match[1] != best[1])


def _moves(name: str, values: Array) -> bool:
    return ".translation." in name and bool(np.ptp(values[np.isfinite(values)]) > 0)


def _likeliness(parent: str, child: str, remarks: Sequence[str]) -> tuple[bool, bool, bool]:
    named = any(remark.endswith(f"frame {child!r}") for remark in remarks)
    return named, bool(TOOL.search(child)), "base" in parent.lower()
