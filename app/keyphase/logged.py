"""What a log holds beside pose and wrench: further named channels, and events in words."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from types import MappingProxyType

import numpy as np
from numpy.typing import ArrayLike

from keyphase.arrays import Array
from keyphase.errors import DemonstrationError

MAX_CHANNELS = 200
MAX_EVENTS = 10_000
MAX_NAME_LENGTH = 60
MAX_EVENT_LENGTH = 200

_SWITCHES = 50
"""A channel of two values that changes oftener is no button."""


@dataclass(frozen=True, order=True)
class Event:
    """Something that was logged in words at a time, in the demonstration's clock [s]."""

    time_s: float
    text: str


def checked_channels(
    channels: Mapping[str, ArrayLike], rows: int, name: str
) -> Mapping[str, Array]:
    """Named channels, each (rows,) and finite, read-only.

    Raises DemonstrationError, naming the recording `name`, the channel, and what was expected.
    """
    if len(channels) > MAX_CHANNELS:
        raise DemonstrationError(
            f"{name}: expected at most {MAX_CHANNELS} named channels, but {len(channels)} came; "
            "leave some out."
        )
    return MappingProxyType(
        {key: _checked(key, values, rows, name) for key, values in channels.items()}
    )


def is_channel_name(name: object) -> bool:
    """Whether a channel may be called so: short, printable, no slash."""
    if not isinstance(name, str) or not 0 < len(name) <= MAX_NAME_LENGTH:
        return False
    return name.isprintable() and "/" not in name and name == name.strip()


def _checked(key: str, values: ArrayLike, rows: int, name: str) -> Array:
    if not is_channel_name(key):
        raise DemonstrationError(
            f"{name}: a channel's name must be 1 to {MAX_NAME_LENGTH} printable characters without "
            f"a slash, but is {str(key)[:80]!r}; rename it."
        )
    array = np.array(values, dtype=np.float64)
    if array.shape == (rows, 1):
        array = array[:, 0]
    if array.shape != (rows,):
        raise DemonstrationError(
            f"{name}: the channel {key!r} must have shape ({rows},), one value per time sample, "
            f"but has shape {array.shape}; give each component a name of its own."
        )
    bad = ~np.isfinite(array)
    if bad.any():
        row = int(np.argmax(bad))
        raise DemonstrationError(
            f"{name}: the channel {key!r} must be finite, but row {row} holds {array[row]}; "
            "fill the samples that were not measured or leave the channel out."
        )
    array.flags.writeable = False
    return array


def checked_events(events: Iterable[Event], name: str) -> tuple[Event, ...]:
    """Events in time order. Raises DemonstrationError for what cannot be one."""
    found = tuple(sorted(events))
    if len(found) > MAX_EVENTS:
        raise DemonstrationError(
            f"{name}: expected at most {MAX_EVENTS} events, but {len(found)} came; leave some out."
        )
    for event in found:
        if not np.isfinite(event.time_s) or not _is_words(event.text):
            raise DemonstrationError(
                f"{name}: an event has a finite time and 1 to {MAX_EVENT_LENGTH} printable "
                f"characters, but one is {event.text[:80]!r} at {event.time_s} s; correct it."
            )
    return found


def plain_words(text: str) -> str:
    """A text as an event's may be: what is no plain text in it becomes a question mark."""
    kept = "".join(c if c.isprintable() else "?" for c in text).strip()
    return kept[:MAX_EVENT_LENGTH]


def events_in_words(time_s: Array, texts: Iterable[str]) -> tuple[Event, ...]:
    """An event wherever a column of words changes to a word; empty cells say nothing."""
    found: list[Event] = []
    before = ""
    for time, text in zip(time_s.tolist(), map(plain_words, texts), strict=True):
        if text and text != before:
            found.append(Event(time, text))
        before = text
    return tuple(found)


def switch_events(time_s: Array, channels: Mapping[str, Array]) -> tuple[Event, ...]:
    """When a channel of two values, a button or a digital output, goes up and down."""
    found: list[Event] = []
    for name, values in channels.items():
        levels = np.unique(values)
        rows = np.flatnonzero(np.diff(values)) + 1
        if len(levels) != 2 or not 0 < len(rows) <= _SWITCHES:
            continue
        found += [
            Event(float(time_s[row]), f"{name} {'on' if values[row] == levels[1] else 'off'}")
            for row in rows
        ]
    return tuple(sorted(found))


def _is_words(text: object) -> bool:
    return isinstance(text, str) and 0 < len(text) <= MAX_EVENT_LENGTH and text.isprintable()
