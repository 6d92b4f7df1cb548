"""One recording of a binary format as a demonstration, through a recipe or a preset."""

from dataclasses import replace
from pathlib import Path

from keyphase.demonstration import Demonstration, Source
from keyphase.errors import RecipeError
from keyphase.files.parts import with_part
from keyphase.files.reading import WholeFile
from keyphase.readers.formats.array_table import ArrayTable
from keyphase.readers.formats.known import Format
from keyphase.readers.recipes.file import recipe_of
from keyphase.readers.recipes.presets import fitting_preset, preset_values
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
    side, inner = _side(recipe, part, path)
    table = form.table(path, inner, limit_bytes)
    chosen = side or _preset(table)
    source = Source(with_part(path, part) if part else path, table.fingerprint())
    file = WholeFile(b"", source)
    demonstration = demonstration_of(table, file, chosen, limit_bytes)
    return _with_notices(demonstration, table.notices)


def fingerprint_of(path: Path, part: str | None, form: Format, limit_bytes: int) -> str:
    """SHA-256 (hex) of one recording's numbers; errors as in `read_format`."""
    parts = form.parts(path)
    inner = part if part is None or part in parts else part.rpartition("+")[0] or None
    return form.table(path, inner, limit_bytes).fingerprint()


def _side(recipe: Recipe | None, part: str | None, path: Path) -> tuple[Recipe | None, str | None]:
    """The recipe of one tool, where a part `demo_3+left` names one beside the others."""
    if recipe is None or not recipe.parts:
        return recipe, part
    inner, _, side = (part or "").rpartition("+")
    return recipe_of_part(recipe, side or None, str(path)), inner or None


def _preset(table: ArrayTable) -> Recipe:
    name = fitting_preset(table.names)
    if name is None:
        raise RecipeError(
            f"{table.file}: no preset knows these columns, so a recipe must say what they are; "
            f"there are {_shown(table.names)}."
        )
    try:
        return recipe_of(preset_values(name, name), f"preset {name}")
    except RecipeError as error:
        raise RecipeError(
            f"{table.file}: its columns are those of the preset {name!r}, which leaves something "
            f'open ({error}); say it in a recipe that begins with preset = "{name}".'
        ) from error


def _shown(names: tuple[str, ...]) -> str:
    shown = ", ".join(name[:60] for name in names[:_SHOWN_COLUMNS])
    return f"{shown}, … ({len(names)} in all)" if len(names) > _SHOWN_COLUMNS else shown


def _with_notices(demonstration: Demonstration, notices: tuple[str, ...]) -> Demonstration:
    return replace(demonstration, notices=(*notices, *demonstration.notices))
