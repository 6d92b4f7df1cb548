"""Segments made executable: movement primitives with end conditions."""

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from keyphase.skills.execution.executor import Executor
    from keyphase.skills.execution.sensed import Sensed

__all__ = ["Executor", "Sensed"]

_WHERE = {"Executor": "executor", "Sensed": "sensed"}


def __getattr__(name: str) -> Any:
    if name not in _WHERE:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    from importlib import import_module

    return getattr(import_module(f"{__name__}.execution.{_WHERE[name]}"), name)
