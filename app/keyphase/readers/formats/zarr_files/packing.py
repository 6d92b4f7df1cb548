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
from keyphase.readers.formats.zarr_files.shards import CODEC, ShardIndex, shard_index

_MOST_OVER = 4
_ROOM_BYTES = 64 << 20
"""A chunk may unpack to so many times its declared size, and so much beside, before it is one that
was made to fill the memory."""
_LARGEST_BYTES = 2 << 30
"""No chunk is larger, whatever its store says; Blosc cannot pack more."""

_BLOSC_HEADER, _BLOSC_SIZE, _BLOSC_PACKED = 16, slice(4, 8), slice(12, 16)
_ZSTD_MAGIC = b"\x28\xb5\x2f\xfd"


@dataclass(frozen=True)
class Packing:
    """How the chunks of an array are packed.

    codec  the last step of packing, such as "blosc"; "" where there is none
    bytes  how large a chunk is unpacked
    shard  where they lie in their file, and how each is packed, where many are in one file
    """

    codec: str
    bytes: int
    shard: "tuple[ShardIndex, Packing] | None" = None


def packing_of(described: bytes) -> Packing | None:
    """What `.zarray` or `zarr.json` says; None for what is no array, or says nothing usable.

    Raises UnfitError for chunks that are packed more than once, or whose size is no chunk's: what
    is inside of them could not be looked at.
    """
    try:
        said = json.loads(described)
        if said["zarr_format"] == 2:
            codecs = [
                *(said.get("filters") or []),
                *([said["compressor"]] if said["compressor"] else []),
            ]
            names, shape, kind = [one["id"] for one in codecs], said["chunks"], said["dtype"]
            return _packed(names, _size(shape, kind))
        shape, kind = said["chunk_grid"]["configuration"]["chunk_shape"], said["data_type"]
        return _of_codecs(said["codecs"], shape, kind)
    except UnfitError:
        raise
    except (ValueError, KeyError, TypeError, AttributeError, RecursionError, OverflowError):
        return None


def _of_codecs(codecs: Sequence[Mapping[str, Any]], shape: Sequence[Any], kind: Any) -> Packing:
    names = [str(codec["name"]) for codec in codecs]
    packing = _packed(names, _size(shape, kind))
    if CODEC not in names:
        return packing
    said = codecs[names.index(CODEC)]["configuration"]
    inner = _of_codecs(said["codecs"], said["chunk_shape"], kind)
    if packing.codec or inner.shard is not None:
        raise UnfitError("its shards are packed, or hold shards")
    each = [int(n) // int(part) for n, part in zip(shape, said["chunk_shape"], strict=True)]
    return Packing("", packing.bytes, (shard_index(said, prod(each)), inner))


def _packed(codecs: Sequence[Any], size: int) -> Packing:
    """What packs by these steps. A checksum or a change of order packs nothing."""
    packers = [str(codec) for codec in codecs if codec in _SIZES]
    if len(packers) > 1:
        raise UnfitError("its chunks are packed more than once")
    if size > _LARGEST_BYTES:
        raise UnfitError(f"its chunks hold {size} bytes each, more than 2 GiB")
    return Packing(packers[0] if packers else "", size)


def _size(shape: Sequence[Any], kind: Any) -> int:
    return prod(int(n) for n in shape) * np.dtype(kind).itemsize


def refuse_unfit_value(
    packing: Packing, data: bytes, key: str, asked: tuple[int, int] | None, *, whole: bool
) -> None:
    """Raise UnfitError where a chunk, or one in a shard, cannot be what the store says.

    `data` is the `whole` file, or the bytes `asked` for, from and to; neither: its last ones.
    """
    if packing.shard is None:
        refuse_unfit_chunk(packing, data, key)
        return
    index, inner = packing.shard
    if whole:
        for first, length in index.spans(data, key).tolist():
            refuse_unfit_chunk(inner, data[first : first + length], key)
    elif asked is not None and not (index.at_start and asked[0] < index.size_bytes):
        refuse_unfit_chunk(inner, data, key)
    elif asked is not None:
        index.of(data, key)


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
