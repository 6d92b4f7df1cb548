"""Two tools in one table: which columns belong to which."""

import re
from collections.abc import Sequence

from keyphase.readers.proposing.columns import Looked
from keyphase.readers.proposing.guess import Guess
from keyphase.readers.proposing.naming import TOOLS
from keyphase.readers.proposing.roles import guesses_of


def sides_of(
    looked: Looked, found: Sequence[Guess], taken: Sequence[int]
) -> dict[str, tuple[Guess, ...]]:
    """What belongs to the left and the right tool, where the table has a place of each."""
    if not any(guess.is_one_of_several for guess in found):
        return {}
    tried = (_sides_by(looked, taken, *tools) for tools in TOOLS)
    return next((sides for sides in tried if sides), {})


def _sides_by(
    looked: Looked,
    taken: Sequence[int],
    one: tuple[str, re.Pattern[str]],
    other: tuple[str, re.Pattern[str]],
) -> dict[str, tuple[Guess, ...]]:
    """What belongs to one tool and what to another, as their columns are called; else none."""
    sides: dict[str, tuple[Guess, ...]] = {}
    for (side, _), (_, others) in ((one, other), (other, one)):
        theirs = [i for i, name in enumerate(looked.names) if others.search(name)]
        sides[side] = tuple(guesses_of(looked.told, looked.values, (*taken, *theirs)))
    roles = ("position", "pose")
    placed = [guess for side in sides.values() for guess in side if guess.role in roles]
    apart = len(placed) == 2 and not set(placed[0].columns) & set(placed[1].columns)
    return sides if apart and not any(one.is_one_of_several for one in placed) else {}
