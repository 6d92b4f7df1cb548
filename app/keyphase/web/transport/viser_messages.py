"""What viser's client may say to viser, which checks nothing of it by itself."""

import math
from collections.abc import Callable
from typing import Any

import msgspec

from keyphase.web.transport.access import Grant

_LOOKING = frozenset({"ViewerCameraMessage", "GetRenderResponseMessage"})
_EVERYTHING = _LOOKING | {
    "GuiUpdateMessage",
    "SceneNodeClickMessage",
    "SceneNodeDragMessage",
    "ScenePointerMessage",
    "TransformControlsUpdateMessage",
    "TransformControlsDragStartMessage",
    "TransformControlsDragEndMessage",
}
_LONGEST_TEXT = 2000
_LARGEST_NUMBER = 1e9
_DEEPEST = 6
_MOST_ITEMS = 64

Accepts = Callable[[str, object], bool]
"""Whether the control with a given id may take a given value."""


def admits(raw: bytes, grant: Grant, accepts: Accepts) -> bool:
    """Whether a message from viser's client may pass.

    It must be of a kind the page needs, hold only finite numbers and short texts, and set nothing
    but the value of a control that accepts it. Who may only look moves the camera, no more.
    """
    try:
        message = msgspec.msgpack.decode(raw)
    except (msgspec.MsgspecError, ValueError, TypeError, RecursionError):
        return False
    kind = message.get("type") if isinstance(message, dict) else None
    if not isinstance(kind, str) or kind not in (
        _EVERYTHING if grant is Grant.EVERYTHING else _LOOKING
    ):
        return False
    if kind == "GetRenderResponseMessage":
        return True
    if not _is_plain(message):
        return False
    return kind != "GuiUpdateMessage" or _sets_a_value(message, accepts)


def _sets_a_value(message: dict[str, Any], accepts: Accepts) -> bool:
    uuid, updates = message.get("uuid"), message.get("updates")
    if not isinstance(uuid, str) or not isinstance(updates, dict) or set(updates) != {"value"}:
        return False
    return accepts(uuid, updates["value"])


def _is_plain(value: object, depth: int = 0) -> bool:
    if isinstance(value, bool) or value is None:
        return True
    if isinstance(value, int | float):
        return math.isfinite(value) and abs(value) <= _LARGEST_NUMBER
    if isinstance(value, str):
        return len(value) <= _LONGEST_TEXT
    if isinstance(value, list | dict) and depth < _DEEPEST and len(value) <= _MOST_ITEMS:
        items = value.values() if isinstance(value, dict) else value
        return all(_is_plain(item, depth + 1) for item in items)
    return False
