"""Tables of text with the columns of a known recorder: read by its preset, without a recipe."""

from pathlib import Path

from keyphase.errors import RecipeError
from keyphase.files.reading import first_bytes
from keyphase.readers.recipes.file import recipe_of
from keyphase.readers.recipes.presets import fitting_preset, left_open, preset_values
from keyphase.readers.recipes.recipe import Recipe
from keyphase.readers.table import TableForm, header_names

MAX_HEADER_BYTES = 64 * 1024


def preset_of_header(data: bytes) -> str | None:
    """The preset that knows the columns in the first line of a plain table, if one does."""
    return fitting_preset(_header(data))


def begins_known(path: Path) -> bool:
    """Whether a file begins with such a header, and the preset leaves nothing open."""
    return bool(known_header(path))


def known_header(path: Path) -> tuple[str, ...]:
    """The columns in the first line of a table, where a preset leaves nothing of them open."""
    try:
        names = _header(first_bytes(path, MAX_HEADER_BYTES))
    except (OSError, ValueError):
        return ()
    return names if leaves_nothing_open(fitting_preset(names)) else ()


def leaves_nothing_open(preset: str | None) -> bool:
    """Whether there is a preset and it reads without a recipe."""
    return preset is not None and not left_open(preset)


def _header(data: bytes) -> tuple[str, ...]:
    line, _, _ = data[:MAX_HEADER_BYTES].partition(b"\n")
    try:
        return tuple(header_names(line.decode(TableForm.encoding), TableForm()))
    except UnicodeDecodeError:
        return ()


def preset_recipe(name: str, file: str) -> Recipe:
    """A preset as a recipe. Raises RecipeError where it leaves something open."""
    try:
        return recipe_of(preset_values(name, name), f"preset {name}")
    except RecipeError as error:
        said = "; ".join(f"[{section}]" for section in left_open(name))
        raise RecipeError(
            f"{file}: its columns are those of the preset {name!r}, which leaves something open "
            f'({error}); say {said} in a recipe that begins with preset = "{name}", as '
            "`keyphase inspect --write` proposes it."
        ) from error
