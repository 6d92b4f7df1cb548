"""Chunks within a shard of Zarr v3, each asked what it says of its own size, too.

A shard is a file of many chunks with an index of where each lies. Zarr asks for the whole of it, or
for the index and then for ranges of it, so that what is looked at here is what was asked for.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from keyphase.readers.formats.damage import UnfitError

CODEC = "sharding_indexed"

_EMPTY = np.iinfo(np.uint64).max
_ENTRY_BYTES, _CHECKSUM_BYTES = 16, 4
_MOST_CHUNKS = 10_000_000


@dataclass(frozen=True)
class ShardIndex:
    """Where the index of a shard's chunks lies: offset and length of each, in 16 bytes."""

    count: int
    size_bytes: int
    at_start: bool

    def spans(self, shard: bytes, key: str) -> NDArray[np.uint64]:
        """First byte and length (K, 2) of the chunks that are there, of a whole shard.

        Raises UnfitError where they do not lie within it.
        """
        if len(shard) < self.size_bytes:
            raise UnfitError(f"the chunk {key} is not as long as it says")
        index = shard[: self.size_bytes] if self.at_start else shard[len(shard) - self.size_bytes :]
        spans = self.of(index, key)
        ends = spans.sum(axis=1)
        if (ends < spans[:, 0]).any() or (ends > len(shard)).any():
            raise UnfitError(f"the chunk {key} is not as long as it says")
        return spans

    def of(self, index: bytes, key: str) -> NDArray[np.uint64]:
        """The same of the index alone; no chunk may lie where it does."""
        if len(index) < self.size_bytes:
            raise UnfitError(f"the chunk {key} is not as long as it says")
        spans = np.frombuffer(index, "<u8", 2 * self.count).reshape(-1, 2).astype(np.uint64)
        spans = spans[(spans != _EMPTY).any(axis=1)]
        if self.at_start and (spans[:, 0] < self.size_bytes).any():
            raise UnfitError(f"chunks of {key} lie over the index of where they are")
        return spans


def shard_index(said: Mapping[str, Any], count: int) -> ShardIndex:
    """What the configuration of shards says of the index of `count` chunks.

    Raises UnfitError for an index that is packed or written in another order of bytes.
    """
    codecs = said["index_codecs"]
    names = [codec["name"] for codec in codecs]
    order = codecs[0].get("configuration", {}).get("endian", "little")
    if names not in (["bytes"], ["bytes", "crc32c"]) or order != "little":
        raise UnfitError("the index of its shards is packed")
    if not 0 < count <= _MOST_CHUNKS:
        raise UnfitError(f"its shards have {count} chunks")
    size = _ENTRY_BYTES * count + _CHECKSUM_BYTES * (len(names) - 1)
    return ShardIndex(count, size, said.get("index_location", "end") == "start")
