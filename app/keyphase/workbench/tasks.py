"""What takes long, by name: each task tells how far it is, and its end ends no other."""

import itertools
import threading
from collections.abc import Callable
from dataclasses import dataclass, replace
from types import TracebackType


@dataclass(frozen=True)
class TaskState:
    """One task; `fraction` is None where nobody knows how much is left."""

    id: int
    name: str
    fraction: float | None = None
    done: bool = False


class Task:
    """A task under way; use it in a `with` statement, at whose end it is over."""

    def __init__(self, state: TaskState, tell: Callable[[TaskState], None]) -> None:
        self._state = state
        self._tell = tell

    def __enter__(self) -> "Task":
        self._tell(self._state)
        return self

    def __exit__(
        self, _kind: type[BaseException] | None, _error: object, _trace: TracebackType | None
    ) -> None:
        self._state = replace(self._state, done=True)
        self._tell(self._state)

    def at(self, fraction: float | None, name: str | None = None) -> None:
        """It is so far, or does something else by now."""
        self._state = replace(self._state, fraction=fraction, name=name or self._state.name)
        self._tell(self._state)


class Tasks:
    """All tasks of one workbench; `tell` is told of each change, in the task's own thread.

    `cores` is held by the one that works on all cores. Of two at once each would take as long as
    both, and they would share the processes, which giving up the one ends for the other.
    """

    def __init__(self, tell: Callable[[TaskState], None]) -> None:
        self._tell = tell
        self._numbers = itertools.count(1)
        self._lock = threading.Lock()
        self._under_way: dict[int, TaskState] = {}
        self.cores = threading.Lock()

    @property
    def under_way(self) -> tuple[TaskState, ...]:
        """What is not over yet, the oldest first."""
        with self._lock:
            return tuple(self._under_way.values())

    def begin(self, name: str) -> Task:
        """A new task, told of from its `with` statement on."""
        return Task(TaskState(next(self._numbers), name), self._changed)

    def _changed(self, state: TaskState) -> None:
        with self._lock:
            if state.done:
                self._under_way.pop(state.id, None)
            else:
                self._under_way[state.id] = state
        self._tell(state)
