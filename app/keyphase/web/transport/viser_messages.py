"""What viser's client may say to viser, which checks nothing of it by itself."""

import math

import msgspec

from keyphase.web.transport.access import Grant

_LOOKING = frozenset({"ViewerCameraMessage", "GetRenderResponseMessage"})
_EVERYTHING = _LOOKING | {
    "SceneNodeClickMessage",
    "SceneNodeDragMessage",
    "ScenePointerMessage",
    "TransformControlsUpdateMessage",
    "TransformControlsDragStartMessage",
    "TransformControlsDragEndMessage",
}
_MAX_TEXT_LENGTH = 2000
_MAX_NUMBER = 1e9
_MAX_DEPTH = 6
_MAX_ITEMS = 64


def admits(raw: bytes, grant: Grant) -> bool:
    """Whether a message from viser's client may pass.

    It must be of a kind the scene needs, and hold only finite numbers and short texts: no tunnel to
    the outside can be asked for, no file sent, and no control set. Who may only look moves the
    camera, no more.
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
    return kind == "GetRenderResponseMessage" or _is_plain(message)


def _is_plain(value: object, depth: int = 0) -> bool:
    if isinstance(value, bool) or value is None:
        return True
    if isinstance(value, int | float):
        return math.isfinite(value) and abs(value) <= _MAX_NUMBER
    if isinstance(value, str):
        return len(value) <= _MAX_TEXT_LENGTH
    if isinstance(value, list | dict) and depth < _MAX_DEPTH and len(value) <= _MAX_ITEMS:
        items = value.values() if isinstance(value, dict) else value
        return all(_is_plain(item, depth + 1) for item in items)
    return False
