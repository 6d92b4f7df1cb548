"""Recordings in and out of files: `read` for any format, `save_npz` and `save_csv` for our own.

Native are the NPZ archive and the CSV table of `docs/formats.md`; any other table is read through a
recipe (`docs/recipes.md`).
"""

from dataclasses import replace
from pathlib import Path

import numpy as np

from keyphase.demonstration import Demonstration, Source
from keyphase.errors import DemonstrationError
from keyphase.files.parts import sha256_of_part, split_part, with_part
from keyphase.files.reading import DEFAULT_LIMIT_BYTES, WholeFile, read_whole
from keyphase.notices import Caution
from keyphase.readers.finding import (
    FOLDER_RECIPE,
    RECIPE_SUFFIX,
    Found,
    arms_beside,
    find_recordings,
    folder_recipe,
    own_recipe,
    passed_over_recipe,
)
from keyphase.readers.foreign import foreign_kind
from keyphase.readers.formats.known import format_of
from keyphase.readers.formats.reader import fingerprint_of, read_format
from keyphase.readers.known_tables import preset_of_header, preset_recipe
from keyphase.readers.native_csv import has_native_header, read_csv, save_csv
from keyphase.readers.native_npz import MAGIC, npz_data, read_npz, save_npz
from keyphase.readers.recipes.file import load_recipe, parse_recipe
from keyphase.readers.recipes.reader import read_by_recipe
from keyphase.readers.recipes.recipe import Recipe

__all__ = [
    "FOLDER_RECIPE",
    "RECIPE_SUFFIX",
    "Found",
    "Recipe",
    "arms_beside",
    "find_recordings",
    "fingerprint",
    "load_recipe",
    "npz_data",
    "own_or_folder_recipe",
    "parse_recipe",
    "read",
    "save_csv",
    "save_npz",
]


_LOOKED_AT_BYTES = 4096


def read(
    path: Path | str,
    recipe: Recipe | Path | str | None = None,
    *,
    limit_bytes: int = DEFAULT_LIMIT_BYTES,
) -> Demonstration:
    """The demonstration recorded in a file, or one of many in it: `data.hdf5#demo_3`.

    An archive is read as native NPZ, whatever recipe is given. A table or a binary format is read
    through the recipe given, or the one beside it (`<file>.recipe.toml`); without, a native table
    is read as such and anything else through its folder's `recipe.toml`, at last through the preset
    that knows its columns; where one does that leaves nothing open, a folder's recipe for other
    columns is passed over. What was held, resampled, dropped or turned is said
    in the notices. `limit_bytes` bounds what is read and unpacked.

    Raises DemonstrationError for what cannot be read or used, RecipeError where recipe and table
    do not fit; each names file, row, column and what to do.
    """
    path, part = split_part(Path(path))
    form = format_of(path)
    with np.errstate(all="ignore"):
        if form is not None:
            chosen = recipe or own_recipe(path) or folder_recipe(path)
            return _told(path, read_format(path, part, form, _loaded(chosen), limit_bytes), chosen)
        return _read_table(path, part, recipe, limit_bytes)


def fingerprint(path: Path | str, *, limit_bytes: int = DEFAULT_LIMIT_BYTES) -> str:
    """SHA-256 (hex) by which a recording is known again: of the file, or of its part's numbers.

    Raises DemonstrationError as `read` does.
    """
    path, part = split_part(Path(path))
    form = format_of(path)
    if form is not None:
        return fingerprint_of(path, part, form, limit_bytes)
    return sha256_of_part(read_whole(path, limit_bytes).source.sha256, part)


def own_or_folder_recipe(path: Path) -> Path | None:
    """The recipe that would read a recording where none is given: its own, or its folder's."""
    file = split_part(path)[0]
    return own_recipe(file) or folder_recipe(file)


def _read_table(
    path: Path, part: str | None, recipe: Recipe | Path | str | None, limit_bytes: int
) -> Demonstration:
    file = read_whole(path, limit_bytes)
    if part is not None:
        sha256 = sha256_of_part(file.source.sha256, part)
        file = replace(file, source=Source(with_part(path, part), sha256))
    if (foreign := foreign_kind(file.data)) is not None:
        raise DemonstrationError(f"{path}: expected a recording, but {foreign}.")
    if path.suffix.lower() == ".npz" or file.data.startswith(MAGIC):
        _refuse_part(path, part)
        return read_npz(file, limit_bytes)
    chosen = recipe or own_recipe(path)
    if chosen is None and not has_native_header(file.data):
        chosen = folder_recipe(path)
    loaded = _loaded(chosen)
    if loaded is None:
        _refuse_part(path, part)
        return _read_undescribed(file, limit_bytes)
    return read_by_recipe(file, loaded, limit_bytes, part)


def _refuse_part(path: Path, part: str | None) -> None:
    """Without a recipe that says which are in it, a table or an archive is one recording."""
    if part is not None:
        raise DemonstrationError(f"{path}: it is one recording; name it without #{part[:80]}.")


def _read_undescribed(file: WholeFile, limit_bytes: int) -> Demonstration:
    """A table without a recipe; of one that is not native the way to a recipe is told."""
    name = None if has_native_header(file.data) else preset_of_header(file.data)
    if name is not None:
        found = read_by_recipe(file, preset_recipe(name, file.name), limit_bytes)
        return _told(split_part(file.source.path)[0], found, None)
    try:
        return read_csv(file, limit_bytes)
    except DemonstrationError as error:
        if has_native_header(file.data) or b"\0" in file.data[:_LOOKED_AT_BYTES]:
            raise
        path = split_part(file.source.path)[0]
        raise DemonstrationError(
            f"{str(error).removesuffix('.')}; another table is read through a recipe "
            f"{path.name}{RECIPE_SUFFIX} beside it, which `keyphase inspect --write {path}` "
            "proposes, or the page when the file is dropped on it."
        ) from error


def _told(path: Path, found: Demonstration, chosen: object) -> Demonstration:
    """With a notice where a file's folder has a recipe that is not meant for it."""
    other = None if chosen else passed_over_recipe(path)
    if other is None:
        return found
    told = Caution(f"The folder's {other.name} names other columns and was passed over.")
    return replace(found, notices=(*found.notices, told))


def _loaded(recipe: Recipe | Path | str | None) -> Recipe | None:
    return recipe if recipe is None or isinstance(recipe, Recipe) else load_recipe(recipe)
