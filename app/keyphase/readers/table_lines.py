"""The lines of a table's text, and which of them hold rows.

Of cells that hold lists, as `[0.1, 0.2, 0.3]`, each number becomes a cell of its own, as column
`pose` becomes `pose[0]`, `pose[1]`, …; `DataFrame.to_csv` writes so what holds arrays. Remarks, a
header that stands again and the zero bytes of a recorder that lost its power are no rows.
"""

import re
from collections.abc import Sequence

from keyphase.errors import DemonstrationError
from keyphase.notices import Caution

_REMARK = ("#", "%")
_SHOWN_REMARK = 60
_TEXT_LINES = 2
"""A file that begins with more lines of text is no binary one, whatever follows."""

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


def without_lost_end(data: bytes) -> tuple[bytes, tuple[str, ...]]:
    """A text without the zero bytes at its end, and what is to be said of them.

    A recorder whose power goes leaves them where its last lines were to be.
    """
    bare = data.rstrip(b"\0")
    if not bare or len(bare) == len(data) or b"\0" in bare:
        return data, ()
    told = (
        f"The file ends in {len(data) - len(bare)} zero bytes, as after a loss of power: what was "
        "recorded last is missing."
    )
    return bare, (Caution(told),)


def refuse_zero_bytes(file: str, text: str) -> None:
    """Raises DemonstrationError for what is no text, or a text with a hole in it."""
    if "\0" not in text:
        return
    line = text[: text.index("\0")].count("\n") + 1
    if line > _TEXT_LINES:
        raise DemonstrationError(
            f"{file}: line {line} holds zero bytes, as after a loss of power; leave it out, or cut "
            "the file there."
        )
    raise DemonstrationError(
        f"{file}: expected a text table, but the file is binary; export it as text or NPZ."
    )


def rows_among(
    lines: Sequence[str], begin: int, header: str | None, separator: str | None
) -> tuple[list[str], Sequence[int], tuple[str, ...]]:
    """The lines from `begin` on that hold rows, their numbers from 1, and what was left out.

    Blank lines are passed over; so are remarks, which have not the cells of a row, and the header
    where it stands again, and the notices say so.
    """
    held = [i for i in range(begin, len(lines)) if lines[i].strip()]
    remarks = [i for i in held if lines[i].lstrip().startswith(_REMARK)]
    if remarks:
        marked = set(remarks)
        row = next((lines[i] for i in held if i not in marked), lines[remarks[0]])
        cells = len(row.split(separator))
        remarks = [i for i in remarks if len(lines[i].split(separator)) != cells]
    again = [i for i in held if header and lines[i] == header]
    notices = (*_told_remarks(lines, remarks), *_told_again(again))
    if notices:
        passed = {*remarks, *again}
        held = [i for i in held if i not in passed]
    if held and len(held) == held[-1] + 1 - begin:
        return list(lines[begin : held[-1] + 1]), range(begin + 1, held[-1] + 2), notices
    return [lines[i] for i in held], [i + 1 for i in held], notices


def _told_remarks(lines: Sequence[str], remarks: Sequence[int]) -> tuple[str, ...]:
    if not remarks:
        return ()
    more = f" and {len(remarks) - 1} more like it" if len(remarks) > 1 else ""
    shown = lines[remarks[0]].strip()[:_SHOWN_REMARK]
    return (f"Line {remarks[0] + 1}, {shown!r}, is a remark and was left out{more}.",)


def _told_again(again: Sequence[int]) -> tuple[str, ...]:
    if not again:
        return ()
    return (Caution(f"The header stands again in line {again[0] + 1}, which was left out."),)
