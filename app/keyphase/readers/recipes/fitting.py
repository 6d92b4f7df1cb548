"""Whether a recipe can be meant for a file, by what the file's columns are called."""

from collections.abc import Iterable

from keyphase.readers.recipes.columns import Columns
from keyphase.readers.recipes.recipe import RateTime, Recipe, TwoPartTime


def is_meant_for(recipe: Recipe, names: Iterable[str]) -> bool:
    """Whether the columns that it names for time and place, of any of its tools, are there."""
    there = tuple(names)
    return all(
        columns.names_some_of(there)
        for one in (recipe.parts.values() if recipe.parts else (recipe,))
        for columns in _places(one)
    )


def _places(recipe: Recipe) -> tuple[Columns, ...]:
    forms = (recipe.pose, recipe.position, recipe.joints if recipe.robot else None)
    places = tuple(form.columns for form in forms if form is not None)
    if isinstance(recipe.time, RateTime):
        return places
    if isinstance(recipe.time, TwoPartTime):
        return (recipe.time.seconds, recipe.time.nanoseconds, *places)
    return (recipe.time.column, *places)
