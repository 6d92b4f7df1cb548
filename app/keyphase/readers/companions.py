"""Files that lie beside recordings and are none: the wrench of another one, notes in prose."""

import os
import re
from collections.abc import Callable, Iterable
from pathlib import Path

from keyphase.errors import KeyphaseError
from keyphase.files.reading import first_bytes
from keyphase.readers.recipes.beside import STEM
from keyphase.readers.recipes.file import load_recipe
from keyphase.readers.recipes.recipe import Recipe

_LOOKED_AT_BYTES = 64 * 1024
_PLACE = 3
_PROSE_SUFFIXES = (".txt", ".log", ".dat", ".asc")
_NUMBER = re.compile(rb"(?<![\w.])[-+]?\d+(?:[.,]\d*)?(?:[eE][-+]?\d+)?(?![\w.])")


def companions_among(
    paths: Iterable[Path], recipe_of: Callable[[Path], Path | None]
) -> frozenset[Path]:
    """Those of some files that lie beside others by the recipe that reads each."""
    loaded = dict[Path, Recipe | None]()
    found = set[Path]()
    for path in paths:
        chosen = recipe_of(path)
        if chosen is None:
            continue
        if chosen not in loaded:
            loaded[chosen] = _recipe(chosen)
        recipe = loaded[chosen]
        if recipe is None:
            continue
        if recipe.wrench_file is not None:
            found.add(path.parent / recipe.wrench_file.path.replace(STEM, path.stem))
        if path.name.lower().endswith(_PROSE_SUFFIXES) and _is_prose(path):
            found.add(path)
    return frozenset(found)


def _recipe(path: Path) -> Recipe | None:
    """A recipe; None where it cannot be read, which reading a recording by it says."""
    try:
        return load_recipe(path)
    except KeyphaseError:
        return None


def _is_prose(path: Path) -> bool:
    """Whether a file of words has no two lines with as many numbers as a place has."""
    try:
        lines = first_bytes(path, _LOOKED_AT_BYTES).split(b"\n") if os.path.isfile(path) else []
    except (OSError, ValueError):
        return False
    # An empty file and one of a header alone are recordings in which nothing was recorded.
    with_numbers = sum(len(_NUMBER.findall(line)) >= _PLACE for line in lines)
    return with_numbers < 2 and sum(bool(line.strip()) for line in lines) > 1
