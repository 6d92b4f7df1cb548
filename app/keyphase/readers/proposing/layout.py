"""How the text of a table is laid out, found by trying: encoding, separator, decimal, header."""

import re
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass

from keyphase.errors import DemonstrationError
from keyphase.readers.table import TableForm, split_cells
from keyphase.readers.table_lines import lists_apart, without_lost_end

_ASCII = 127
_WORDS = {
    "shift_jis": (
        "時刻",
        "時間",
        "位置",
        "力",
        "トルク",
        "モーメント",
        "角度",
        "姿勢",
        "座標",
        "秒",
    ),
    "gb18030": ("时间", "位置", "力", "扭矩", "角度", "姿态", "坐标", "秒"),
}
"""Words of recordings by which a table in one of these is known: read as Western text it is no less
text, in signs that nobody writes.
"""

_LOOKED_AT_BYTES = 1 << 18
_LOOKED_AT_LINES = 400
_BODY_LINES = 40
_FOLLOWING = 4
_UNIT = re.compile(r"[\[({]?(m|mm|cm|um|s|ms|us|ns|n|nm|nmm|deg|rad|hz|-|°)[\])}]?", re.I)
_RATE = re.compile(r"(rate|freq|hz)\D{0,12}?(\d+(\.\d+)?)|^[\s,;]*(\d+(\.\d+)?)[\s,;]*$", re.I)
_RATES_HZ = (5.0, 10_000.0)

_BOMS = ((b"\xff\xfe", "utf-16"), (b"\xfe\xff", "utf-16"), (b"\xef\xbb\xbf", "utf-8"))
_SEPARATORS = ("\t", ";", ",", "|", None)
_SHOWN = {"\t": "tab", None: "whitespace"}
_POINT = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?|nan|inf", re.I)
_COMMA = re.compile(r"[+-]?(\d+,?\d*|,\d+)(e[+-]?\d+)?|nan|inf", re.I)


_LISTS = re.compile(r"[\[(]\s*[+-]?\d+(\.\d*)?(e[+-]?\d+)?[\s,;]+[+-]?\d")


@dataclass(frozen=True)
class Layout:
    """A layout, its encoding as a recipe writes it, and why each is thought to be so.

    below    what the line below the names says of each column, such as its unit; else none
    rate_hz  the rate that a line above the names seems to state
    """

    form: TableForm
    encoding: str
    evidence: dict[str, str]
    below: tuple[str, ...] = ()
    rate_hz: float | None = None

    @property
    def separator(self) -> str:
        """As a recipe writes it."""
        return _SHOWN.get(self.form.separator, self.form.separator or "")


def layout_of(data: bytes) -> Layout:
    """The layout of a table by its beginning.

    Raises DemonstrationError for what is no text or has no rows of numbers.
    """
    data, _ = without_lost_end(data[:_LOOKED_AT_BYTES])
    encoding, evidence = _encoding(data)
    codec = "utf-8-sig" if encoding == "utf-8" else encoding
    text = data.decode(codec, errors="ignore")
    lines = lists_apart(text.replace("\r\n", "\n").replace("\r", "\n")).split("\n")
    lines = lines[:_LOOKED_AT_LINES]
    found = [_fitted(lines, separator, decimal) for separator, decimal in _choices()]
    best = max(found, key=lambda one: one.worth)
    if best.worth <= 0 and any(_LISTS.search(line) for line in lines):
        raise DemonstrationError(
            "expected a number in each cell, but cells hold lists such as [0.1, 0.2]; write each "
            "number into a column of its own, as x, y and z."
        )
    if best.worth <= 0:
        raise DemonstrationError(
            "expected a table, rows of numbers under one another, but no separator makes one of "
            "this text; check that it is a table."
        )
    header = best.header is not None
    skip = best.header if best.header is not None else best.body
    between = best.body - skip - 1 if header else 0
    form = TableForm(best.separator, skip, header, codec, best.decimal, between)
    evidence |= {
        "separator": f"{best.width} cells in {best.rows} of {best.rows} rows",
        "decimal": best.decimal_evidence,
        "header": f"line {skip + 1} names the columns" if header else "numbers from the first line",
    }
    below = _cells(lines[best.body - 1], best.separator) if between else []
    evidence["below"] = f"line {best.body} says more of the columns"
    told = tuple(cell.strip("[](){} ") for cell in below)
    return Layout(form, encoding, evidence, told, _stated_rate(lines[:skip]))


def _stated_rate(lines: Sequence[str]) -> float | None:
    """The rate in lines above the names: a number of its own, or one beside such a word."""
    for line in lines:
        found = _RATE.search(line)
        rate = float(found[2] or found[4]) if found else 0.0
        if _RATES_HZ[0] <= rate <= _RATES_HZ[1]:
            return rate
    return None


@dataclass(frozen=True)
class _Fit:
    separator: str | None
    decimal: str
    body: int
    header: int | None
    width: int
    rows: int
    worth: float
    decimal_evidence: str


def _choices() -> list[tuple[str | None, str]]:
    return [(s, d) for s in _SEPARATORS for d in (".", ",") if s != d]


def _encoding(data: bytes) -> tuple[str, dict[str, str]]:
    for mark, name in _BOMS:
        if data.startswith(mark):
            return name, {"encoding": f"the file begins with the mark of {name.upper()}"}
    if (at := data.find(b"\0")) >= 0:
        if (line := data[:at].count(b"\n") + 1) > 2:
            raise DemonstrationError(f"line {line} holds zero bytes; leave it out.")
        raise DemonstrationError("expected a text table, but the file is binary.")
    cut = data[: data.rfind(b"\n") + 1] or data
    try:
        cut.decode("utf-8")
    except UnicodeDecodeError as error:
        byte = cut[error.start]
        line = cut[: error.start].count(b"\n") + 1
        encoding = _encoding_without_mark(cut)
        odd = cut.split(b"\n")[line - 1].decode(encoding, errors="replace")
        shown = next((one for one in odd if ord(one) > _ASCII), "?")
        told = f"byte {byte:#x} in line {line} is no UTF-8 ({shown!r} here)"
        return encoding, {"encoding": told}
    return "utf-8", {"encoding": "every byte is UTF-8"}


def _encoding_without_mark(data: bytes) -> str:
    """Of the encodings a recipe can name the one in which a table is not gibberish."""
    fits = [encoding for encoding in ("cp1252", *_WORDS) if _is_text(data, encoding)]
    for encoding in fits:
        text = data.decode(encoding)
        if any(word in text for word in _WORDS.get(encoding, ())):
            return encoding
    return fits[0] if fits else "latin-1"


def _is_text(data: bytes, encoding: str) -> bool:
    try:
        data.decode(encoding)
    except UnicodeDecodeError:
        return False
    return True


def _fitted(lines: Sequence[str], separator: str | None, decimal: str) -> _Fit:
    """How well a separator and a decimal mark make rows of numbers of the lines."""
    cells = [_cells(line, separator) if line.strip() else [] for line in lines]
    number = _POINT if decimal == "." else _COMMA
    shares = [_share(row, number) for row in cells]
    widths = Counter(
        len(row) for row, share in zip(cells, shares, strict=True) if share >= 0.5 and len(row) > 1
    )
    if not widths:
        return _Fit(separator, decimal, 0, None, 0, 0, 0.0, "")
    width = widths.most_common(1)[0][0]
    fits = [len(row) == width and share >= 0.5 for row, share in zip(cells, shares, strict=True)]
    body = _first_of_many(fits, cells)
    after = [i for i in range(body, min(len(lines), body + _BODY_LINES)) if cells[i]]
    good = sum(shares[i] for i in after if fits[i])
    marked = sum(decimal in cell for i in after for cell in cells[i])
    header = _header(cells, body, width)
    worth = good / max(len(after), 1) * (1 + 0.02 * min(width, 30)) + 0.1 * (marked > 0)
    shown = f"{marked} cells have a {'comma' if decimal == ',' else 'point'} between digits"
    return _Fit(separator, decimal, body, header, width, sum(fits), worth, shown)


def _first_of_many(fits: Sequence[bool], cells: Sequence[Sequence[str]]) -> int:
    """The first row of numbers that has others below it: a line of numbers stands among words in
    the heads of some exports.
    """
    filled = [i for i, row in enumerate(cells) if row]
    for at, line in enumerate(filled):
        if fits[line] and all(fits[i] for i in filled[at : at + _FOLLOWING]):
            return line
    return fits.index(True)


def _header(cells: Sequence[Sequence[str]], body: int, width: int) -> int | None:
    """The last line with words before the numbers begin, if it has a word for each column.

    Where the last says the same of several columns, such as their unit, and the one before it has
    a word of its own for each, that one names them.
    """
    before = [at for at in range(body) if any(cells[at])]
    if not before:
        return None
    last, fitting = before[-1], (width, width - 1)
    if before[-2:] == [body - 2, body - 1] and len(cells[last]) in fitting:
        names, units = _without_mark(cells[last - 1]), [cell for cell in cells[last] if cell]
        distinct = len(names) in fitting and len(set(names)) == len(names)
        are_units = len(names) in fitting and all(_UNIT.fullmatch(unit) for unit in units)
        if (distinct and len(set(units)) < len(units)) or are_units:
            return last - 1
    return last if len(_without_mark(cells[last])) in fitting else None


def _without_mark(row: Sequence[str]) -> list[str]:
    return [cell for cell in row if cell not in ("#", "%", "")]


def _cells(line: str, separator: str | None) -> list[str]:
    return [cell.strip() for cell in split_cells(line, separator)]


def _share(row: Sequence[str], number: re.Pattern[str]) -> float:
    """The share of cells that are numbers; empty cells do not count."""
    filled = [cell for cell in row if cell]
    return sum(bool(number.fullmatch(cell)) for cell in filled) / len(filled) if filled else 0.0
