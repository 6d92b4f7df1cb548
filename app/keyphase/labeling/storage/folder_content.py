"""A folder's settings out of JSON values: what is not as it should be costs only itself."""

import json
from collections.abc import Mapping
from dataclasses import dataclass, field, fields
from typing import Any

from keyphase.errors import KeyphaseError
from keyphase.labeling.colors import SEGMENT_COLORS
from keyphase.labeling.earlier import parameters_as_meant
from keyphase.labeling.tasks.task import Task
from keyphase.labeling.tasks.task_content import tasks_in
from keyphase.labeling.vocabulary import MAX_LABELS, Vocabulary, VocabularyLabel
from keyphase.segmentation.parameters import Parameters

VERSION = 1

_OWN = ("version", "labels", "parameters", "phases")


@dataclass(frozen=True)
class FolderContent:
    """What could be read.

    left_out  what could not be, for people
    later     the version is one this keyphase does not know
    others    fields this version does not know
    """

    vocabulary: Vocabulary = field(default_factory=Vocabulary)
    parameters: Parameters = field(default_factory=Parameters)
    tasks: tuple[Task, ...] = ()
    left_out: tuple[str, ...] = ()
    later: bool = False
    others: Mapping[str, Any] = field(default_factory=dict)


def folder_content(content: Any) -> FolderContent:
    """Read what can be read of the JSON values of a folder's settings."""
    if not isinstance(content, Mapping):
        return FolderContent(left_out=("everything, for it is no object",))
    left_out: list[str] = []
    version = content.get("version")
    later = _is_later(version)
    if version != VERSION:
        left_out.append(f"version {version!r:.20}, where {VERSION} was expected")
    vocabulary = _vocabulary(content.get("labels", []), left_out)
    parameters = _parameters(content.get("parameters", {}), left_out)
    tasks = tasks_in(content.get("phases", []), left_out)
    others = {n: v for n, v in content.items() if n not in _OWN and _is_json(v)}
    return FolderContent(vocabulary, parameters, tasks, tuple(left_out), later, others)


def _is_later(version: Any) -> bool:
    """Whether it is no version of today or before; one that is missing was damaged."""
    try:
        return not isinstance(version, bool) and float(version) > VERSION
    except (TypeError, ValueError, OverflowError):
        # A name of a version, which this keyphase does not know.
        return isinstance(version, str)


def _vocabulary(items: Any, left_out: list[str]) -> Vocabulary:
    if not isinstance(items, list):
        left_out.append("the labels, for they are no list")
        return Vocabulary()
    labels: dict[str, VocabularyLabel] = {}
    for number, item in enumerate(items, start=1):
        label = _label(item, number, left_out)
        if label is not None and len(labels) < MAX_LABELS:
            labels.setdefault(label.name, label)
    return Vocabulary(tuple(labels.values()))


def _label(item: Any, number: int, left_out: list[str]) -> VocabularyLabel | None:
    """A label; one with a bad colour gets another."""
    name = item.get("name") if isinstance(item, Mapping) else None
    color = item.get("color") if isinstance(item, Mapping) else None
    if not isinstance(name, str):
        left_out.append(f"label {number}")
        return None
    try:
        return VocabularyLabel(name, color if isinstance(color, str) else "")
    except KeyphaseError:
        pass
    try:
        label = VocabularyLabel(name, SEGMENT_COLORS[(number - 1) % len(SEGMENT_COLORS)])
    except KeyphaseError:
        left_out.append(f"label {number}")
        return None
    left_out.append(f"the colour of “{name}”")
    return label


def _parameters(values: Any, left_out: list[str]) -> Parameters:
    if not isinstance(values, Mapping):
        left_out.append("the parameters, for they are no object")
        return Parameters()
    known = {each.name for each in fields(Parameters)}
    good: dict[str, Any] = {}
    for name, value in parameters_as_meant(values).items():
        try:
            if name not in known:
                raise ValueError("unknown")
            Parameters(**{**good, name: value})
        except (KeyphaseError, ArithmeticError, TypeError, ValueError):
            left_out.append(f"the parameter {name!r:.40}")
        else:
            good[name] = value
    return Parameters(**good)


def _is_json(value: Any) -> bool:
    """Whether it can be written again: numbers beyond floats cannot."""
    try:
        json.dumps(value, allow_nan=False)
    except (ValueError, RecursionError):
        return False
    return True
