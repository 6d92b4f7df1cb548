"""Files sent from a browser: in pieces, straight to disk, under a name made safe.

They lie beside the recordings under a hidden name until they are whole and could be read; only
then they get a name of their own, never that of another file.
"""

import os
import re
import shutil
import tempfile
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import BinaryIO

from keyphase.errors import KeyphaseError, RequestError
from keyphase.files.parts import with_part
from keyphase.files.shipped import shipped
from keyphase.labeling.segment_file import SUFFIX as SEGMENTS
from keyphase.labeling.segment_file import read_segment_file
from keyphase.readers import Recipe, load_recipe, read
from keyphase.readers.finding import parts_of
from keyphase.workbench.apart.apart import Calls, right_here

DEFAULT_LIMIT_BYTES = 2 << 30
"""The largest file a browser may send unless the server is told otherwise."""

SUFFIXES = frozenset(
    {".npz", ".csv", ".tsv", ".txt", ".dat", ".log", ".asc"}
    | {".hdf5", ".h5", ".zarr.zip", ".bag", ".mcap", ".mat", ".npy", ".parquet"}
)
"""How recordings end; a segment file ends as it always does."""

DEMONSTRATION = "setup1.npz"
"""The recording one is shown who has none yet."""

_OF_A_BAG = "it is part of a ROS 2 bag: open the bag's folder in a terminal, `keyphase FOLDER`"
_VIDEO = "a video is shown when it lies beside its recording, under the same name"
_ROBOT = "a robot is given in a terminal, `keyphase RECORDING --robot FILE`"
_WAYS_ON = {
    **dict.fromkeys((".db3", ".yaml"), _OF_A_BAG),
    **dict.fromkeys((".mp4", ".m4v", ".mov", ".webm"), _VIDEO),
    **dict.fromkeys((".urdf", ".xml"), _ROBOT),
}
"""What to do with files that are none of these, but belong to one."""

_MAX_NAME_LENGTH = 80
_RECIPE = ".toml"
_UNSAFE = re.compile(r"[^A-Za-z0-9._-]+")
_SPARE_BYTES = 64 << 20


class Upload:
    """One file on its way; `write` is called with its pieces in order.

    Nothing of it is read before it is whole, and nothing in it is ever executed.
    """

    def __init__(
        self, folder: Path, name: str, size: int, limit_bytes: int = DEFAULT_LIMIT_BYTES
    ) -> None:
        """Raises RequestError for a kind of file that is none of ours, or one too large."""
        self.folder = folder
        self.name = safe_name(name)
        _check_size(self.name, size, limit_bytes, folder)
        self._left = size
        try:
            suffix = _split(self.name)[1]
            descriptor, path = tempfile.mkstemp(prefix=".upload-", suffix=suffix, dir=folder)
        except OSError as error:
            raise RequestError(
                f"Nothing can be written into {folder} ({error.strerror})."
            ) from error
        self._part = Path(path)
        self._file: BinaryIO = os.fdopen(descriptor, "wb")

    @property
    def is_whole(self) -> bool:
        """Whether every byte has come."""
        return self._left == 0

    @property
    def part(self) -> Path:
        """Where its bytes lie until it has a name."""
        return self._part

    @property
    def is_segment_file(self) -> bool:
        """Whether it is another's segmentation, not a recording."""
        return self.name.endswith(SEGMENTS)

    @property
    def is_recipe(self) -> bool:
        """Whether it says how tables are read."""
        return self.name.endswith(_RECIPE)

    def write(self, piece: bytes) -> None:
        """Put the next piece on disk.

        Raises RequestError where more comes than was announced, or the disk is full.
        """
        if len(piece) > self._left:
            self.abandon()
            raise RequestError(f"More of {self.name} came than was announced; send it again.")
        try:
            self._file.write(piece)
        except OSError as error:
            self.abandon()
            raise RequestError(f"{self.name} cannot be written ({error.strerror}).") from error
        self._left -= len(piece)

    def finish(
        self,
        recipe: Recipe | None = None,
        open_sha256: str | None = None,
        calls: Calls = right_here,
    ) -> Path:
        """Read the whole file and give it its name, beside others of that name; where it now is.

        Raises RequestError with the reason where it is no recording, or no segment file of the
        recording with the hash `open_sha256`; `abandon` it then, or try again otherwise.
        """
        try:
            self.settle()
            self._check(recipe, open_sha256, calls)
            return self._named()
        except (KeyphaseError, OSError) as error:
            raise RequestError(str(error).replace(str(self._part), self.name)) from error

    def settle(self) -> None:
        """All of it is on disk; again and again without harm. Raises OSError where it is not."""
        if not self._file.closed:
            self._file.flush()
            os.fsync(self._file.fileno())
            self._file.close()

    def abandon(self) -> None:
        """Forget what has come so far."""
        self._file.close()
        self._part.unlink(missing_ok=True)

    def _check(self, recipe: Recipe | None, open_sha256: str | None, calls: Calls) -> None:
        if self.is_recipe:
            load_recipe(self._part)
            return
        if not self.is_segment_file:
            inner = calls(self._part, parts_of, self._part, recipe)
            calls(
                self._part, read, with_part(self._part, inner[0]) if inner else self._part, recipe
            )
            return
        about = read_segment_file(self._part, check_recording=False).demonstration
        if about.sha256 != open_sha256:
            raise RequestError(
                f"{self.name} is about another recording than the open one, {about.name[:80]!r}; "
                "open that one first."
            )

    def _named(self) -> Path:
        if self.is_recipe and (self.folder / self.name).exists():
            raise RequestError(
                f"{self.name} is there already and is never replaced; move it away first."
            )
        for name in _free_names(self.name):
            path = self.folder / name
            try:
                # Claims the name, so that a file that appears meanwhile is not written over.
                path.open("xb").close()
            except FileExistsError:
                continue
            self._part.chmod(0o644)
            self._part.replace(path)
            return path
        raise AssertionError("names never end")


def copy_of_shipped(folder: Path) -> Path:
    """A copy of the demonstration that comes with keyphase; the same one where it is there already.

    Raises RequestError where nothing can be written into the folder.
    """
    source = shipped("data") / DEMONSTRATION
    data = source.read_bytes()
    present = folder / source.name
    if present.is_file() and present.read_bytes() == data:
        return present
    copy = Upload(folder, source.name, len(data))
    copy.write(data)
    return copy.finish()


def safe_name(name: str) -> str:
    """A name without folders, spaces and anything a shell or a browser could read otherwise.

    Raises RequestError for a name that is neither a recording's, a segment file's nor a recipe's.
    """
    last = re.split(r"[/\\]", name)[-1]
    stem, suffix = _split(last)
    if suffix.lower() not in SUFFIXES | {SEGMENTS, _RECIPE}:
        way_on = _WAYS_ON.get(suffix.lower())
        if way_on:
            raise RequestError(f"{last[:80]!r} is no recording by itself: {way_on}.")
        kinds = ", ".join(sorted(SUFFIXES))
        raise RequestError(
            f"Expected a recording ({kinds}), a segment file ({SEGMENTS}) or a recipe "
            f"({_RECIPE}), but got {last[:80]!r}, which is of none of these kinds."
        )
    stem = _UNSAFE.sub("_", stem).strip("._-")[:_MAX_NAME_LENGTH]
    return (stem or "recording") + suffix.lower()


def upload_folder(recordings: Sequence[Path]) -> Path:
    """Where uploads go: beside the first recording, or into the current folder."""
    beside = recordings[0].parent if recordings else Path.cwd()
    return beside if os.access(beside, os.W_OK) else Path.cwd()


def _check_size(name: str, size: int, limit_bytes: int, folder: Path) -> None:
    if size <= 0:
        raise RequestError(f"{name} is empty: there is nothing in it to read.")
    megabytes = size / (1 << 20)
    if size > limit_bytes:
        raise RequestError(
            f"A file sent from the browser has up to {limit_bytes >> 20} MB, but {name} has "
            f"{megabytes:.0f}; put it into the folder by hand."
        )
    if shutil.disk_usage(folder).free < size + _SPARE_BYTES:
        raise RequestError(f"There is no room for the {megabytes:.0f} MB of {name}; make some.")


def _split(name: str) -> tuple[str, str]:
    for ending in (SEGMENTS, ".zarr.zip"):
        if name.lower().endswith(ending):
            return name[: -len(ending)], ending
    return os.path.splitext(name)


def _free_names(name: str) -> Iterator[str]:
    stem, suffix = _split(name)
    yield name
    number = 2
    while True:
        yield f"{stem}_{number}{suffix}"
        number += 1
