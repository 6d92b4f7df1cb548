"""What a packed chunk says of its own size, asked before a codec believes it.

A codec written in C reads as far as a header says, past the end of a damaged chunk, which ends the
whole program; and it takes as much memory as the header says, or as the bytes unpack to.
"""

import json
import zlib
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from math import prod
from typing import Any

import numpy as np

from keyphase.readers.formats.damage import UnfitError

_MOST_OVER = 4
_ROOM_BYTES = 64 << 20
"""A chunk may unpack to so many times its declared size, and so much beside, before it is one that
was made to fill the memory."""

_BLOSC_HEADER, _BLOSC_SIZE, _BLOSC_PACKED = 16, slice(4, 8), slice(12, 16)
_ZSTD_MAGIC = b"\x28\xb5\x2f\xfd"


@dataclass(frozen=True)
class Packing:
    """How the chunks of an array are packed.

    codec  the last step of packing, such as "blosc"; "" where there is none
    bytes  how large a chunk is unpacked
    """

    codec: str
    bytes: int


def packing_of(described: bytes) -> Packing | None:
    """What `.zarray` or `zarr.json` says; None for what is no array, or says nothing usable."""
    try:
        said = json.loads(described)
        if said["zarr_format"] == 2:
            codec, shape = (said["compressor"] or {}).get("id", ""), said["chunks"]
            kind = said["dtype"]
        else:
            codec = _last_packing(said["codecs"])
            shape, kind = said["chunk_grid"]["configuration"]["chunk_shape"], said["data_type"]
        size = prod(int(n) for n in shape) * np.dtype(kind).itemsize
    except (ValueError, KeyError, TypeError, AttributeError, RecursionError, OverflowError):
        return None
    return Packing(str(codec), size)


def _last_packing(codecs: Sequence[Mapping[str, Any]]) -> str:
    """A checksum that stands behind it packs nothing."""
    names = [str(codec["name"]) for codec in codecs if codec["name"] != "crc32c"]
    return names[-1] if names else ""


def refuse_unfit_chunk(packing: Packing, data: bytes, key: str) -> None:
    """Raise UnfitError where a chunk cannot be what the store says, before it is unpacked."""
    told = _SIZES.get(packing.codec)
    if told is None:
        return
    size = told(data, _most(packing))
    if size is None:
        raise UnfitError(f"the chunk {key} is not as long as it says")
    refuse_large_chunk(packing, size, key)


def refuse_large_chunk(packing: Packing, size: int, key: str) -> None:
    """Raise UnfitError where a chunk takes more memory than the store says it holds."""
    if size > _most(packing):
        raise UnfitError(f"the chunk {key} unpacks to more than the {packing.bytes} bytes it holds")


def _most(packing: Packing) -> int:
    return _MOST_OVER * packing.bytes + _ROOM_BYTES


def _blosc(data: bytes, _most: int) -> int | None:
    if len(data) < _BLOSC_HEADER or _number(data[_BLOSC_PACKED]) != len(data):
        return None
    return _number(data[_BLOSC_SIZE])


def _lz4(data: bytes, _most: int) -> int | None:
    return _number(data[:4]) if len(data) >= 4 else None


def _zstd(data: bytes, _most: int) -> int | None:
    """RFC 8878, 3.1.1.1: the content's size, 0 where the frame does not tell."""
    if len(data) < 6 or not data.startswith(_ZSTD_MAGIC):
        return None
    described = data[4]
    one_segment, width = bool(described & 0x20), (0, 2, 4, 8)[described >> 6]
    if one_segment and width == 0:
        width = 1
    at = 5 + (not one_segment) + (0, 1, 2, 4)[described & 3]
    size = _number(data[at : at + width])
    return size + 256 if width == 2 else size


def _deflated(data: bytes, most: int) -> int:
    """How much it unpacks to, no further than just over the most."""
    unpacking, size, rest = zlib.decompressobj(32 + zlib.MAX_WBITS), 0, data
    try:
        while rest and size <= most:
            size += len(unpacking.decompress(rest, 1 << 20))
            rest = unpacking.unconsumed_tail
    except zlib.error:
        return size
    return size


def _number(data: bytes) -> int:
    return int.from_bytes(data, "little")


_SIZES: Mapping[str, Callable[[bytes, int], int | None]] = {
    "blosc": _blosc,
    "lz4": _lz4,
    "zstd": _zstd,
    "gzip": _deflated,
    "zlib": _deflated,
}
