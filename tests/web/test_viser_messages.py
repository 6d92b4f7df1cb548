"""What viser's client may say to viser: the kinds the scene needs, with finite numbers."""

import math
from typing import Any

import msgspec
import pytest
from framing import frame
from hypothesis import given
from hypothesis import strategies as st
from talking import PageClient

from keyphase.web.transport.access import Grant
from keyphase.web.transport.viser_messages import admits

CAMERA = {
    "type": "ViewerCameraMessage",
    "wxyz": [1.0, 0.0, 0.0, 0.0],
    "position": [1.0, 1.0, 1.0],
    "fov": 1.0,
}
CLICK = {"type": "SceneNodeClickMessage", "name": "/path/pieces", "owner": "1"}


def _admitted(message: object, grant: Grant = Grant.EVERYTHING) -> bool:
    return admits(msgspec.msgpack.encode(message), grant)


def _moved(**fields: Any) -> dict[str, Any]:
    return {**CAMERA, **fields}


def test_moving_the_camera_and_clicking_is_admitted() -> None:
    assert _admitted(CAMERA)
    assert _admitted(CLICK)


@pytest.mark.parametrize(
    "message",
    [
        {"type": "ShareUrlRequest"},
        {"type": "ShareUrlDisconnect"},
        {"type": "FileTransferStartUpload", "filename": "x"},
        {"type": "FileTransferPart", "content": b"x"},
        {"type": "GuiUpdateMessage", "uuid": "u", "updates": {"value": 1.0}},
        {"type": "RunJavascriptMessage", "source": "alert(1)"},
        {"type": "GuiRemoveMessage", "uuid": "u"},
        {"type": ["ViewerCameraMessage"]},
        {"type": None},
        {},
        [],
        "ViewerCameraMessage",
        _moved(fov=math.nan),
        _moved(fov=math.inf),
        _moved(fov=1e300),
        _moved(fov="x" * 5000),
        _moved(position=[math.nan, 0.0, 0.0]),
        _moved(position=[0.0] * 1000),
        _moved(position=b"\x00" * 8),
    ],
)
def test_anything_else_is_not(message: object) -> None:
    """No tunnel to the outside, no file, no control, no number that is none."""
    assert not _admitted(message)


def test_who_may_only_look_moves_the_camera_only() -> None:
    assert _admitted(CAMERA, Grant.LOOKING)
    assert not _admitted(CLICK, Grant.LOOKING)


@given(st.binary(max_size=200))
def test_any_bytes_are_judged(raw: bytes) -> None:
    assert admits(raw, Grant.EVERYTHING) in (True, False)


def test_deep_nesting_is_not_admitted() -> None:
    assert not admits(b"\x91" * 5000 + b"\xc0", Grant.EVERYTHING)


def test_nonsense_on_visers_websocket_changes_nothing(page: PageClient) -> None:
    with frame(page.server, page.page) as framed:
        for message in (
            {"type": "FileTransferPart", "content": b"x" * 1000},
            {"type": "ShareUrlRequest"},
            {"type": "NoSuchMessage"},
        ):
            framed.say(message)
        framed.shout(b"garbage")
        assert framed.node("/path/pieces")
