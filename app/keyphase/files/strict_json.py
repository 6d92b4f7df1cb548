"""JSON from anywhere: parsed within limits, and checked against a schema without taking minutes."""

import json
from typing import Any

from jsonschema_rs import Draft202012Validator

from keyphase.files.numbers import finite_number, whole_number

MAX_VALUES = 1_000_000
"""In one text; what has more would take far more memory than it has."""

_MAX_MESSAGE = 200


def values_in(data: bytes) -> int:
    """About how many values a JSON text holds: brackets, colons and commas in it."""
    return sum(data.count(mark) for mark in (b"[", b"{", b":", b","))


def parsed_json(data: bytes, most_values: int = MAX_VALUES) -> Any:
    """The values of a JSON text in UTF-8.

    Raises ValueError for what is no JSON, for NaN, numbers that a float does not hold, nesting
    beyond measure, and more values than `most_values`.
    """
    count = values_in(data)
    if count > most_values:
        raise ValueError(f"it holds about {count} values, more than the {most_values} it may have")
    try:
        return json.loads(
            data, parse_constant=finite_number, parse_float=finite_number, parse_int=whole_number
        )
    except RecursionError as error:
        raise ValueError("it is nested too deeply") from error


def violation(content: Any, schema: dict[str, Any]) -> str | None:
    """Where and how JSON values break a schema (2020-12) first, or None where they keep to it."""
    try:
        error = next(iter(Draft202012Validator(schema).iter_errors(content)), None)
    except ValueError as refused:
        return f"the file as a whole: {refused}"
    if error is None:
        return None
    message = error.message
    shown = message if len(message) <= _MAX_MESSAGE else f"{message[:_MAX_MESSAGE]}…"
    return f"{_place(error.instance_path)}: {shown}"


def _place(path: list[str | int]) -> str:
    """For example segments[3].end_s."""
    text = "".join(f"[{step}]" if isinstance(step, int) else f".{step[:60]}" for step in path)
    return text.removeprefix(".") or "the file as a whole"
