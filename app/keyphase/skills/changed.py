"""A value with some fields changed, for values that are stepped hundreds of times a second."""

from typing import Any, TypeVar

_Value = TypeVar("_Value")


def changed(value: _Value, **fields: Any) -> _Value:
    """Like `dataclasses.replace`, many times as fast: nothing is looked up, nothing checked.

    For frozen dataclasses without slots and without `__post_init__`; `fields` must be theirs.
    """
    new = object.__new__(type(value))
    new.__dict__.update(value.__dict__, **fields)
    return new
