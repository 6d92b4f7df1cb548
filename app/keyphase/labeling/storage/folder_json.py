"""The settings of a folder as JSON, and what is whole of them where they are no JSON any more.

Labels, phases and parameters are flat: each label and phase an object of its own, each parameter a
name and a number or word. So all are found in a file that was cut, or in which something else is
by now.
"""

import json
import re
from dataclasses import fields
from typing import Any

from keyphase.files.strict_json import values_in
from keyphase.labeling.storage.folder_content import VERSION
from keyphase.segmentation.parameters import Parameters

_MAX_VALUES = 100_000
_TEXT = r'"(?:[^"\\\n]|\\.)*+"'
_FLAT_OBJECT = re.compile(rf"\{{(?:[^{{}}\"]|{_TEXT})*+\}}")
_VALUE = re.compile(rf"({_TEXT})\s*:\s*({_TEXT}|[-+.\w]+)(?=\s*[,}}])")
_VERSION = re.compile(r'"version"\s*:\s*(\d{1,9})(?=\s*[,}])')


def settings_json(data: bytes) -> Any:
    """The JSON values; numbers beyond what floats hold are infinite.

    Raises ValueError for what is no JSON, is nested beyond measure or has too many values.
    """
    count = values_in(data)
    if count > _MAX_VALUES:
        raise ValueError(f"it holds about {count} values, more than the {_MAX_VALUES} it may have")
    try:
        return json.loads(data, parse_int=_whole)
    except RecursionError as error:
        raise ValueError("it is nested too deeply") from error


def salvaged(data: bytes) -> dict[str, Any]:
    """What is whole in settings that are no JSON: labels, phases in their order, and parameters."""
    if values_in(data) > _MAX_VALUES:
        return {"version": VERSION}
    text = data.decode("utf-8", "replace")
    named = [one for one in map(_json, _FLAT_OBJECT.findall(text)) if isinstance(one, dict)]
    colored = [one for one in named if "name" in one and "color" in one]
    outside = _FLAT_OBJECT.sub(lambda found: "" if '"color"' in found[0] else found[0], text)
    known = {each.name for each in fields(Parameters)}
    pairs = ((_json(name), _json(value)) for name, value in _VALUE.findall(outside))
    parameters = {name: value for name, value in pairs if name in known}
    version = _VERSION.search(outside)
    return {
        "version": int(version[1]) if version else VERSION,
        "labels": [one for one in colored if "task" not in one],
        "phases": [one for one in colored if "task" in one],
        "parameters": parameters,
    }


def _json(text: str) -> Any:
    try:
        return json.loads(text, parse_int=_whole)
    except (ValueError, RecursionError):
        return None


def _whole(digits: str) -> int | float:
    return int(digits) if len(digits) < 400 else float(digits)
