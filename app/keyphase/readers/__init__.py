"""Recordings in and out of files: `read` for any format, `save_npz` and `save_csv` for our own.

Native are the NPZ archive and the CSV table of `docs/formats.md`; any other table is read through a
recipe (`docs/recipes.md`).
"""

from pathlib import Path

import numpy as np

from keyphase.demonstration import Demonstration
from keyphase.files.reading import DEFAULT_LIMIT_BYTES, read_whole
from keyphase.readers.finding import (
    FOLDER_RECIPE,
    RECIPE_SUFFIX,
    Found,
    find_recordings,
    folder_recipe,
    own_recipe,
)
from keyphase.readers.native_csv import has_native_header, read_csv, save_csv
from keyphase.readers.native_npz import MAGIC, read_npz, save_npz
from keyphase.readers.recipes.file import load_recipe, parse_recipe
from keyphase.readers.recipes.reader import read_by_recipe
from keyphase.readers.recipes.recipe import Recipe

__all__ = [
    "FOLDER_RECIPE",
    "RECIPE_SUFFIX",
    "Found",
    "Recipe",
    "find_recordings",
    "load_recipe",
    "parse_recipe",
    "read",
    "save_csv",
    "save_npz",
]


def read(
    path: Path | str,
    recipe: Recipe | Path | str | None = None,
    *,
    limit_bytes: int = DEFAULT_LIMIT_BYTES,
) -> Demonstration:
    """The demonstration recorded in a file.

    An archive is read as native NPZ, whatever recipe is given. A table is read through the recipe
    given, or the one beside it (`<file>.recipe.toml`); without, a native table is read as such and
    any other through its folder's `recipe.toml`. What was held, resampled, dropped or turned is
    said in the notices. `limit_bytes` bounds what is read and unpacked.

    Raises DemonstrationError for what cannot be read or used, RecipeError where recipe and table
    do not fit; each names file, row, column and what to do.
    """
    path = Path(path)
    file = read_whole(path, limit_bytes)
    with np.errstate(all="ignore"):
        if path.suffix.lower() == ".npz" or file.data.startswith(MAGIC):
            return read_npz(file, limit_bytes)
        chosen = recipe or own_recipe(path)
        if chosen is None and not has_native_header(file.data):
            chosen = folder_recipe(path)
        if chosen is None:
            return read_csv(file, limit_bytes)
        if not isinstance(chosen, Recipe):
            chosen = load_recipe(chosen)
        return read_by_recipe(file, chosen, limit_bytes)
