"""The elements of a MATLAB file (5 to 7.2), walked through before SciPy reads them.

SciPy's reader trusts the lengths and nesting that a file states, and a crafted one ends the process
in it. So each element is checked against what holds it: the layout is that of MathWorks' "MAT-File
Format". Only variables that are whole and of plain kinds are given to SciPy.
"""

import math
import struct
import zlib
from collections.abc import Iterator
from dataclasses import dataclass

from keyphase.readers.formats.damage import UnfitError

_HEADER = 128
_ENDIANS = {b"IM": "<", b"MI": ">"}
_MATRIX, _COMPRESSED = 14, 15
_SIZES = {1: 1, 2: 1, 3: 2, 4: 2, 5: 4, 6: 4, 7: 4, 9: 8, 12: 8, 13: 8, 16: 1, 17: 2, 18: 4}
"""Bytes of one number, by the type of an element."""
_CELL, _STRUCT, _TEXT, _NUMBERS = 1, 2, 4, range(6, 16)
_COMPLEX = 0x0800
_MAX_DEPTH = 20
_MAX_DIMENSIONS = 16


@dataclass(frozen=True)
class _Element:
    kind: int
    data: memoryview


def plain_variables(data: bytes, limit_bytes: int) -> list[str]:
    """The names of the variables SciPy can be trusted with: numbers, text, cells and structs.

    Raises UnfitError for a file that is not as it says, or unpacks to more than `limit_bytes`.
    """
    endian = _ENDIANS.get(data[126:128])
    if endian is None:
        raise UnfitError("its header says no order of bytes")
    left, names = limit_bytes, list[str]()
    for element in _elements(memoryview(data)[_HEADER:], endian, packed=True):
        if element.kind == _COMPRESSED:
            unpacking = zlib.decompressobj()
            content = unpacking.decompress(element.data, left + 1)
            left -= len(content)
            if left < 0 or not unpacking.eof:
                raise UnfitError("a variable is cut, or larger than the limit")
            inner = list(_elements(memoryview(content), endian))
            if len(inner) != 1:
                raise UnfitError("a packed variable holds more than one")
            element = inner[0]
        if element.kind != _MATRIX:
            raise UnfitError(f"an element of kind {element.kind} stands where a variable must")
        name, is_plain = _checked(element.data, endian, 0)
        names += [name] if is_plain and name else []
    return names


def _elements(data: memoryview, endian: str, packed: bool = False) -> Iterator[_Element]:
    """One element after the other; at the top of a file what is packed is not padded."""
    at = 0
    while at < len(data):
        if at + 8 > len(data):
            raise UnfitError("an element is cut")
        word, length = struct.unpack_from(f"{endian}II", data, at)
        if word >> 16:
            kind, length, begin, following = word & 0xFFFF, word >> 16, at + 4, at + 8
            if length > 4:
                raise UnfitError("a short element is longer than four bytes")
        else:
            kind, begin = word, at + 8
            whole = packed and kind == _COMPRESSED
            following = begin + (length if whole else (length + 7) // 8 * 8)
        if begin + length > len(data):
            raise UnfitError("an element is longer than what holds it")
        size = _SIZES.get(kind)
        if size is None and kind not in (_MATRIX, _COMPRESSED):
            raise UnfitError(f"there is no element of kind {kind}")
        if size is not None and length % size:
            raise UnfitError("an element ends within a number")
        yield _Element(kind, data[begin : begin + length])
        at = following


def _checked(data: memoryview, endian: str, depth: int) -> tuple[str, bool]:
    """The name of a variable, and whether it and all in it are of plain kinds.

    An empty one in a cell has no content at all.
    """
    if depth > _MAX_DEPTH:
        raise UnfitError("its variables are nested too deep")
    if not len(data):
        return "", True
    parts = list(_elements(data, endian))
    if len(parts) < 3 or parts[0].kind != 6 or len(parts[0].data) != 8:
        return "", False
    flags = struct.unpack_from(f"{endian}I", parts[0].data)[0]
    kind = flags & 0xFF
    # A variable of MATLAB's own classes has its name where others have their size.
    if kind not in (_CELL, _STRUCT, _TEXT, *_NUMBERS):
        return "", False
    count, name = _size(parts[1], endian), bytes(parts[2].data).decode("latin-1")
    rest = parts[3:]
    if kind in (_CELL, _STRUCT):
        if kind == _STRUCT:
            rest, fields = rest[2:], _fields(rest, endian)
            count *= fields
        return name, _all_plain(rest, count, endian, depth)
    numbers = 2 if flags & _COMPLEX else 1
    fitting = len(rest) == numbers and all(
        one.kind in _SIZES and (kind == _TEXT or len(one.data) == count * _SIZES[one.kind])
        for one in rest
    )
    if not fitting and not (kind == _TEXT and count == 0):
        raise UnfitError("a variable has another size than it says")
    return name, True


def _size(dimensions: _Element, endian: str) -> int:
    count = len(dimensions.data) // 4
    if dimensions.kind != 5 or not 2 <= count <= _MAX_DIMENSIONS:
        raise UnfitError("a variable has no size")
    sizes = struct.unpack(f"{endian}{count}i", dimensions.data)
    if min(sizes) < 0:
        raise UnfitError("a variable has a size below zero")
    return math.prod(sizes)


def _fields(parts: list[_Element], endian: str) -> int:
    """How many fields a struct has, by the length of each name and all of them."""
    if len(parts) < 2 or len(parts[0].data) != 4 or parts[1].kind != 1:
        raise UnfitError("a struct does not name its fields")
    length = struct.unpack(f"{endian}i", parts[0].data)[0]
    if length <= 0 or len(parts[1].data) % length:
        raise UnfitError("the names of a struct's fields do not have one length")
    return len(parts[1].data) // length


def _all_plain(parts: list[_Element], count: int, endian: str, depth: int) -> bool:
    if len(parts) != count or any(one.kind != _MATRIX for one in parts):
        raise UnfitError("a cell or struct holds another number of values than it says")
    plain = [_checked(one.data, endian, depth + 1)[1] for one in parts]
    return all(plain)
