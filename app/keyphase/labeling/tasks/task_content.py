"""Tasks out of JSON values: a phase that is not as it should be costs only itself."""

from collections.abc import Mapping
from dataclasses import fields
from typing import Any

from keyphase.errors import KeyphaseError
from keyphase.labeling.tasks.task import MAX_PHASES, Task, TaskPhase, named_task

_FIELDS = frozenset(each.name for each in fields(TaskPhase))


def tasks_in(items: Any, left_out: list[str]) -> tuple[Task, ...]:
    """The tasks of a list of phases; what cannot be read is added to `left_out`, for people."""
    if not isinstance(items, list):
        left_out.append("the phases, for they are no list")
        return ()
    tasks: dict[str, Task] = {}
    for number, item in enumerate(items, start=1):
        found = _phase(item) if number <= MAX_PHASES else None
        if found is None:
            left_out.append(f"phase {number}")
            continue
        name, phase = found
        task = named_task(tasks.values(), name) or Task(name, ())
        tasks[name] = task.with_phase(phase)
    return tuple(tasks.values())


def _phase(item: Any) -> tuple[str, TaskPhase] | None:
    if not isinstance(item, Mapping):
        return None
    task = item.get("task")
    try:
        phase = TaskPhase(**{name: value for name, value in item.items() if name in _FIELDS})
        if not isinstance(task, str):
            return None
        Task(task, (phase,))
    except (KeyphaseError, TypeError, ValueError, AttributeError):
        return None
    return task, phase
