"""Zarr's own stores of a folder and a zip file, which hand on no chunk that cannot be unpacked."""

from pathlib import Path, PurePosixPath
from typing import Any

from keyphase.readers.formats.damage import UnfitError
from keyphase.readers.formats.zarr_files.packing import (
    Packing,
    packing_of,
    refuse_large_chunk,
    refuse_unfit_value,
)

_DESCRIPTIONS = (".zarray", "zarr.json")
_MAX_DESCRIPTION_BYTES = 64 << 20
_MAX_DEPTH = 16


class _Packings:
    """How the chunks of a store's arrays are packed, as far as was asked."""

    def __init__(self) -> None:
        self._known: dict[PurePosixPath, Packing | None] = {}

    async def of(self, store: Any, key: str, prototype: Any) -> Packing | None:
        """How a chunk is packed; None for what is none, or lies in no array."""
        name = PurePosixPath(key)
        if _describes(name):
            return None
        for folder in list(name.parents)[:_MAX_DEPTH]:
            if folder in self._known:
                return self._known[folder]
            for description in _DESCRIPTIONS:
                told = await store.get(str(folder / description), prototype)
                if told is not None and (found := packing_of(told.to_bytes())) is not None:
                    self._known[folder] = found
                    return found
        return None


def folder_store(path: Path) -> Any:
    """A folder as a store in which pipes and devices are no chunks; opening one could wait."""
    from zarr.storage import LocalStore

    class SoundFiles(LocalStore):
        def __init__(self, root: Path) -> None:
            super().__init__(root, read_only=True)
            self._packings = _Packings()

        async def get(self, key: str, prototype: Any = None, byte_range: Any = None) -> Any:
            file = Path(self.root, key)
            if not file.is_file():
                return None
            packing = await self._packings.of(self, key, prototype)
            _refuse_large(key, file.stat().st_size, packing)
            value = await super().get(key, prototype, byte_range)
            return _checked(key, value, packing, byte_range)

    return SoundFiles(path)


def zip_store(path: Path) -> Any:
    """A zip file as a store; an entry that unpacks to more than it should is no chunk."""
    from zarr.storage import ZipStore

    class SoundEntries(ZipStore):
        def __init__(self, file: Path) -> None:
            super().__init__(file, mode="r")
            self._packings = _Packings()

        async def get(self, key: str, prototype: Any = None, byte_range: Any = None) -> Any:
            if not self._is_open:
                self._sync_open()
            entry = self._zf.NameToInfo.get(key)
            if entry is None:
                return None
            packing = await self._packings.of(self, key, prototype)
            _refuse_large(key, entry.file_size, packing)
            value = await super().get(key, prototype, byte_range)
            return _checked(key, value, packing, byte_range)

    return SoundEntries(path)


def _describes(name: PurePosixPath) -> bool:
    return name.name.startswith(".z") or name.name == "zarr.json"


def _refuse_large(key: str, size: int, packing: Packing | None) -> None:
    if packing is not None:
        refuse_large_chunk(packing, size, key)
    elif size > _MAX_DESCRIPTION_BYTES:
        raise UnfitError(f"{key} has {size} bytes, more than a description has")


def _checked(key: str, value: Any, packing: Packing | None, byte_range: Any) -> Any:
    if value is not None and packing is not None:
        asked = (byte_range.start, byte_range.end) if hasattr(byte_range, "end") else None
        whole = byte_range is None
        refuse_unfit_value(packing, value.to_bytes(), key, asked, whole=whole)
    return value
