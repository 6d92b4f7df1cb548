"""A copy of what was recorded, put in place once it is whole; the original is never touched."""

import os
import secrets
import shutil
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from keyphase.errors import ExportError
from keyphase.files.writing import TEMPORARY, sync_folder


@contextmanager
def copy_of(source: Path, target: Path) -> Iterator[Path]:
    """A copy of a file or folder to be changed, which becomes `target` where nothing fails.

    Links in a folder are copied as what they lead to. Raises ExportError where it cannot be
    copied or put in place.
    """
    with in_place_of(target) as working:
        try:
            _copy(source, working)
        except (OSError, shutil.Error) as error:
            raise ExportError(f"{source}: cannot be copied to {target} ({error}).") from error
        yield working


@contextmanager
def in_place_of(target: Path) -> Iterator[Path]:
    """A path to write at, which becomes `target` where nothing fails, and else is removed."""
    working = target.with_name(f"{TEMPORARY}{secrets.token_hex(8)}")
    try:
        yield working
        try:
            _put(working, target)
        except OSError as error:
            raise ExportError(f"{target}: cannot be put in place ({error.strerror}).") from error
    finally:
        _remove(working)


def _copy(source: Path, working: Path) -> None:
    if source.is_dir():
        shutil.copytree(source, working, copy_function=shutil.copyfile)
    else:
        shutil.copyfile(source, working)


def _put(working: Path, target: Path) -> None:
    """Something that is there goes aside first, and comes back where the rename fails."""
    aside = target.with_name(f"{TEMPORARY}{secrets.token_hex(8)}")
    if os.path.lexists(target):
        target.rename(aside)
    try:
        working.rename(target)
    except OSError:
        if os.path.lexists(aside):
            aside.rename(target)
        raise
    sync_folder(target.parent)
    _remove(aside)


def _remove(path: Path) -> None:
    if path.is_dir() and not path.is_symlink():
        shutil.rmtree(path, ignore_errors=True)
    else:
        path.unlink(missing_ok=True)
