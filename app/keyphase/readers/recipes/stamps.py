"""Time written as dates and times of day."""

import re
from collections.abc import Callable, Sequence
from datetime import datetime

import numpy as np

from keyphase.demonstration import Array
from keyphase.errors import DemonstrationError
from keyphase.readers.recipes.recipe import ISO


def seconds_from_first(stamps: Sequence[str], form: str, where: Callable[[int], str]) -> Array:
    """Seconds (N,) from the first of `stamps`, which are ISO or in a format of strptime.

    Raises DemonstrationError, naming a row by `where`, for what is no such stamp.
    """
    seconds: list[float] = []
    first: datetime | None = None
    for row, stamp in enumerate(stamps):
        try:
            time = datetime.fromisoformat(stamp) if form == ISO else datetime.strptime(stamp, form)
            first = first or time
            seconds.append((time - first).total_seconds())
        except (ValueError, OverflowError, TypeError, re.error) as error:
            raise DemonstrationError(
                f"{where(row)}: expected a date and time "
                f"({'ISO 8601' if form == ISO else form}), but found {stamp[:40]!r} ({error}); "
                "correct the cell or the format in the recipe."
            ) from error
    return np.array(seconds)
