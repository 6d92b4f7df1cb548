"""The recipe a recording was labeled with: with another, the same bytes are another recording."""

from collections.abc import Mapping
from typing import Any

from keyphase.demonstration import Source


def recipe_of(source: Source) -> Mapping[str, Any]:
    """Name and SHA-256 of the recipe a recording is read with, as a journal keeps them."""
    return {"name": source.recipe, "sha256": source.recipe_sha256}


def read_otherwise(labeled: Mapping[str, Any] | None, source: Source) -> str | None:
    """What a person should know where it is read otherwise than when it was labeled.

    Journals from before recipes stood in them (`labeled` is None) are taken as they are.
    """
    if labeled is None or labeled.get("sha256") == source.recipe_sha256:
        return None
    return (
        f"This was labeled as read with {_called(labeled)}, and is read with "
        f"{_called(recipe_of(source))} now; look whether the labels fit."
    )


def _called(recipe: Mapping[str, Any]) -> str:
    if not recipe.get("sha256"):
        return "no recipe"
    name = recipe.get("name")
    if isinstance(name, str) and name.isprintable():
        return f"the recipe {name[:200]}"
    return "a recipe"
