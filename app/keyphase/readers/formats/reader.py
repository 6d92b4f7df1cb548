"""One recording of a binary format as a demonstration, through a recipe or a preset."""

from dataclasses import replace
from pathlib import Path

from keyphase.demonstration import Demonstration, Source
from keyphase.errors import RecipeError
from keyphase.files.parts import sha256_of_part, with_part
from keyphase.files.reading import WholeFile
from keyphase.readers.formats.array_table import ArrayTable
from keyphase.readers.formats.known import Format
from keyphase.readers.known_tables import preset_recipe
from keyphase.readers.recipes.presets import fitting_preset
from keyphase.readers.recipes.reader import demonstration_of
from keyphase.readers.recipes.recipe import Recipe
from keyphase.readers.recipes.several import recipe_of_part

_SHOWN_COLUMNS = 40


def read_format(
    path: Path, part: str | None, form: Format, recipe: Recipe | None, limit_bytes: int
) -> Demonstration:
    """The demonstration; without a recipe by the preset whose columns are there.

    Its hash is that of its own numbers, so that a file of many is never read as a whole.

    Raises DemonstrationError for what cannot be read, RecipeError where no preset fits or the
    recipe does not fit, MissingPackageError where the format's package is not installed.
    """
    inner, side = split_side(form, path, part)
    table = form.table(path, inner, limit_bytes)
    chosen = recipe_of_part(recipe or _preset(table), side, str(path))
    source = Source(
        with_part(path, part) if part else path, sha256_of_part(table.fingerprint(), side)
    )
    file = WholeFile(b"", source)
    demonstration = demonstration_of(table, file, chosen, limit_bytes)
    return _with_notices(demonstration, table.notices)


def table_and_recipe(
    path: Path, part: str | None, form: Format, recipe: Recipe | None, limit_bytes: int
) -> tuple[ArrayTable, Recipe]:
    """The columns of a recording and how they are read; errors as in `read_format`."""
    inner, side = split_side(form, path, part)
    table = form.table(path, inner, limit_bytes)
    return table, recipe_of_part(recipe or _preset(table), side, str(path))


def fingerprint_of(path: Path, part: str | None, form: Format, limit_bytes: int) -> str:
    """SHA-256 (hex) of one recording's numbers; errors as in `read_format`."""
    inner, side = split_side(form, path, part)
    return sha256_of_part(form.table(path, inner, limit_bytes).fingerprint(), side)


def split_side(form: Format, path: Path, part: str | None) -> tuple[str | None, str | None]:
    """Which recording of a file is meant, and which tool of it: `demo_3+left`."""
    parts = form.parts(path)
    if part is None or part in parts or (parts and "+" not in part):
        return part, None
    inner, _, side = part.rpartition("+")
    return inner or None, side


def _preset(table: ArrayTable) -> Recipe:
    name = fitting_preset(table.names)
    if name is None:
        raise RecipeError(
            f"{table.file}: no preset knows these columns, so a recipe must say what they are, "
            f"which `keyphase inspect --write` proposes; there are {_shown(table.names)}."
        )
    return preset_recipe(name, table.file)


def _shown(names: tuple[str, ...]) -> str:
    shown = ", ".join(name[:60] for name in names[:_SHOWN_COLUMNS])
    return f"{shown}, … ({len(names)} in all)" if len(names) > _SHOWN_COLUMNS else shown


def _with_notices(demonstration: Demonstration, notices: tuple[str, ...]) -> Demonstration:
    return replace(demonstration, notices=(*notices, *demonstration.notices))
