"""Tables whose cells hold lists, as `[0.1, 0.2, 0.3]`: each number becomes a cell of its own.

`DataFrame.to_csv` writes so what holds arrays. Column `pose` becomes `pose[0]`, `pose[1]`, …
"""

import re
from collections.abc import Sequence

_NUMBER_LIKE = r"[\[\]()\d\s.,;eE+\-aAnNiIfF]*"
_LIST = re.compile(
    rf'"\s*(?:np\.|numpy\.)?(?:array)?(?P<quoted>[\[(]{_NUMBER_LIKE}[\])])\s*"'
    r"|(?P<plain>\[(?:\[[\d .,eE+\-]*\][ ,]*)+\]|\[[\d .,eE+\-]*\])"
)
_NUMBER = re.compile(r"[+-]?(?:\d+\.?\d*(?:[eE][+-]?\d+)?|\.\d+(?:[eE][+-]?\d+)?|nan|inf)", re.I)
_SEPARATORS = (",", ";", "\t", "|")
_WITHIN = "\x1f"
"""Stands between the numbers of one cell until the separator is known; text has no such sign."""


def lists_apart(text: str) -> str:
    """A table's text with every list of numbers as cells of their own, its header likewise.

    Text without lists of at least two numbers is given back as it is.
    """
    if not ("[" in text or '"(' in text) or _WITHIN in text:
        return text
    marked = _LIST.sub(_marked, text)
    if _WITHIN not in marked:
        return text
    lines = marked.split("\n")
    first = next(i for i, line in enumerate(lines) if _WITHIN in line)
    separator = max(_SEPARATORS, key=lines[first].count)
    counts = [cell.count(_WITHIN) + 1 for cell in lines[first].split(separator)]
    named = next((i for i in range(first - 1, -1, -1) if lines[i].strip()), None)
    if named is not None and lines[named].count(separator) + 1 == len(counts):
        lines[named] = separator.join(_names(lines[named].split(separator), counts))
    return "\n".join(lines).replace(_WITHIN, separator)


def _marked(found: re.Match[str]) -> str:
    numbers = _NUMBER.findall(found["quoted"] or found["plain"])
    return _WITHIN.join(numbers) if len(numbers) > 1 else found[0]


def _names(names: Sequence[str], counts: Sequence[int]) -> list[str]:
    grown: list[str] = []
    for name, count in zip(names, counts, strict=True):
        bare = name.strip().strip('"')
        grown += [name] if count == 1 else [f"{bare}[{i}]" for i in range(count)]
    return grown
