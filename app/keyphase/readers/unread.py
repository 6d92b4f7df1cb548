"""Which columns of a recording its recipe, or preset, passes over."""

from collections.abc import Iterator, Mapping
from dataclasses import fields, is_dataclass
from pathlib import Path
from typing import Any

from keyphase.files.parts import split_part
from keyphase.files.reading import DEFAULT_LIMIT_BYTES, read_whole
from keyphase.readers.formats.known import format_of
from keyphase.readers.formats.reader import table_and_recipe
from keyphase.readers.known_tables import preset_of_header, preset_recipe
from keyphase.readers.recipes.columns import Columns
from keyphase.readers.recipes.recipe import Recipe
from keyphase.readers.recipes.several import recipe_of_part
from keyphase.readers.table import Columned, open_table


def unread_columns(
    path: Path, recipe: Recipe | None, limit_bytes: int = DEFAULT_LIMIT_BYTES
) -> tuple[str, ...]:
    """Names of the columns nobody reads; none for keyphase's own files.

    Raises DemonstrationError as `read` does.
    """
    file, part = split_part(path)
    form = format_of(file)
    table: Columned
    if form is not None:
        table, chosen = table_and_recipe(file, part, form, recipe, limit_bytes)
    else:
        whole = read_whole(file, limit_bytes)
        name = preset_of_header(whole.data) if recipe is None else None
        chosen = preset_recipe(name, whole.name) if name else recipe
        if chosen is None or file.suffix.lower() == ".npz":
            return ()
        table = open_table(whole.name, whole.data, chosen.table, limit_bytes)
        chosen = recipe_of_part(chosen, part, whole.name)
    used = {column for columns in _columns_in(chosen) for column in columns.find(table)}
    return tuple(name for i, name in enumerate(table.names) if name and i not in used)


def _columns_in(value: Any) -> Iterator[Columns]:
    """Every choice of columns in a recipe."""
    if isinstance(value, Columns):
        yield value
    elif is_dataclass(value):
        for one in fields(value):
            if one.name != "parts":
                yield from _columns_in(getattr(value, one.name))
    elif isinstance(value, Mapping):
        for inner in value.values():
            yield from _columns_in(inner)
