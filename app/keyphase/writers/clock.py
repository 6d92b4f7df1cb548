"""From the clock of a demonstration back to that of the file it was read from."""

from pathlib import Path

from keyphase.errors import KeyphaseError
from keyphase.files.parts import split_part
from keyphase.files.reading import DEFAULT_LIMIT_BYTES
from keyphase.readers import load_recipe, own_or_folder_recipe
from keyphase.readers.formats.array_table import ArrayTable
from keyphase.readers.formats.known import format_of
from keyphase.readers.recipes.file import recipe_of
from keyphase.readers.recipes.presets import fitting_preset, preset_values
from keyphase.readers.recipes.recipe import NumberTime, Recipe, TwoPartTime
from keyphase.readers.recipes.several import recipe_of_part


def zero_s(recording: Path, given: Path | None) -> float:
    """What time zero of the demonstration is in the file's own clock [s]; as `zero_ns`."""
    return 1e-9 * zero_ns(recording, given)


def zero_ns(recording: Path, given: Path | None) -> int:
    """What time zero of the demonstration is in the file's own clock [ns], of a bag in that of its
    log; 0 where they are one.

    `given` is the recipe it was read with, where its own or its folder's is not it. Raises
    KeyphaseError where it cannot be read.
    """
    file, part = split_part(recording)
    form = format_of(file)
    if form is None:
        return 0
    chosen = given or own_or_folder_recipe(recording)
    recipe = load_recipe(chosen) if chosen else None
    inner = part
    if recipe is not None and recipe.parts:
        inner, _, side = (part or "").rpartition("+")
        recipe = recipe_of_part(recipe, side or None, str(file))
    table = form.table(file, inner or None, DEFAULT_LIMIT_BYTES)
    return _zero_of(table, recipe or _preset_of(table))


def _preset_of(table: ArrayTable) -> Recipe:
    name = fitting_preset(table.names)
    if name is None:
        raise KeyphaseError(f"{table.file}: expected a recipe or a preset for it; give the recipe.")
    return recipe_of(preset_values(name, name), f"preset {name}")


def _zero_of(table: ArrayTable, recipe: Recipe) -> int:
    form = recipe.time
    if isinstance(form, TwoPartTime):
        seconds = table.numbers(form.seconds.find(table))[0, 0]
        return round(seconds) * 10**9 + round(table.numbers(form.nanoseconds.find(table))[0, 0])
    log = next((zero for zero in table.zeros.values() if not zero.clock), None)
    if not isinstance(form, NumberTime):
        return 0 if log is None else log.log_ns
    column = form.column.find(table)[0]
    zero = table.zeros.get(table.names[column], log)
    began = form.size * float(table.numbers([column])[0, 0]) if form.from_zero else 0.0
    return round(1e9 * began) + (0 if zero is None else zero.log_ns)
