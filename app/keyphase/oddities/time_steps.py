"""Time that no recorder has, and stretches without data."""

import numpy as np

from keyphase.demonstration import Demonstration
from keyphase.oddities.oddity import Oddity, first_few

_MIN_RATE_HZ = 0.5
_MAX_RATE_HZ = 50_000.0
_SHOWN_TRAVEL_M = 1e-3
_BRIEF_S = 0.5


def odd_time(demonstration: Demonstration) -> list[Oddity]:
    """A rate no recorder has, as when milliseconds are read as seconds or the other way."""
    rate = demonstration.rate_hz
    if _MIN_RATE_HZ <= rate <= _MAX_RATE_HZ:
        return []
    slow = rate < _MIN_RATE_HZ
    was, read = ("milliseconds", "seconds") if slow else ("seconds", "milliseconds")
    text = (
        f"{rate:.2g} rows a second over {_duration(demonstration.duration_s)}: no recorder does "
        f"that; were {was} read as {read}?"
    )
    return [Oddity("time", "warning", text)]


def too_brief(demonstration: Demonstration) -> list[Oddity]:
    """A recording in which two boundaries would hardly find room."""
    if demonstration.duration_s >= _BRIEF_S or demonstration.rate_hz > _MAX_RATE_HZ:
        return []
    text = (
        f"Only {_duration(demonstration.duration_s)} long: in less than {_BRIEF_S} s hardly a "
        "boundary can be found."
    )
    return [Oddity("time", "warning", text)]


def gaps(demonstration: Demonstration) -> list[Oddity]:
    """The first few stretches without data."""
    return first_few(every_gap(demonstration))


def every_gap(demonstration: Demonstration) -> list[Oddity]:
    """Stretches without data, and how far the tool went in them."""
    found = []
    for start, end in demonstration.gaps_s:
        row = int(np.searchsorted(demonstration.time_s, start))
        here, there = demonstration.position_m[row], demonstration.position_m[row + 1]
        travel = float(np.linalg.norm(there - here))
        moved = f"the tool is {1e3 * travel:.0f} mm further" if travel > _SHOWN_TRAVEL_M else (
            "the tool is where it was"
        )  # fmt: skip
        text = f"{end - start:.2f} s without data at {start:.2f} s, after which {moved}."
        found.append(Oddity("gap", "warning", text, (start, end)))
    return found


def _duration(seconds: float) -> str:
    if seconds < 120:
        return f"{seconds:.3g} s"
    minutes = round(seconds / 60)
    return f"{minutes // 60} h {minutes % 60} min" if minutes >= 60 else f"{minutes} min"
