"""What viser's client may say to viser: what the scene needs, finite numbers, no controls."""

import asyncio
import math

import msgspec
import pytest
from hypothesis import given
from hypothesis import strategies as st
from talking import PageClient, visers_socket

from keyphase.web.transport.access import Grant
from keyphase.web.transport.viser_messages import admits

CAMERA = {
    "type": "ViewerCameraMessage",
    "wxyz": [1.0, 0.0, 0.0, 0.0],
    "position": [1.0, 1.0, 1.0],
    "fov": 1.0,
}


def _admitted(message: object, grant: Grant = Grant.EVERYTHING) -> bool:
    return admits(msgspec.msgpack.encode(message), grant)


DRAG = {
    "type": "TransformControlsUpdateMessage",
    "name": "/tool",
    "wxyz": [1.0, 0.0, 0.0, 0.0],
    "position": [0.1, 0.2, 0.3],
}


def test_moving_the_camera_and_a_gizmo_is_admitted() -> None:
    assert _admitted(CAMERA)
    assert _admitted(DRAG)


@pytest.mark.parametrize(
    "message",
    [
        {"type": "ShareUrlRequest"},
        {"type": "FileTransferStartUpload", "filename": "x"},
        {"type": "RunJavascriptMessage", "source": "alert(1)"},
        {"type": "GuiRemoveMessage", "uuid": "u"},
        {"type": ["ViewerCameraMessage"]},
        {"type": None},
        {},
        [],
        "ViewerCameraMessage",
        {"type": "GuiUpdateMessage", "uuid": "u", "updates": {"value": 1.0}},
        {**DRAG, "position": [math.inf, 0.0, 0.0]},
        {**DRAG, "position": [1e300, 0.0, 0.0]},
        {**DRAG, "name": "x" * 5000},
        {**CAMERA, "position": [math.nan, 0.0, 0.0]},
        {**CAMERA, "position": [0.0] * 1000},
        {**CAMERA, "position": b"\x00" * 8},
    ],
)
def test_anything_else_is_not(message: object) -> None:
    assert not _admitted(message)


def test_who_may_only_look_moves_the_camera_only() -> None:
    assert _admitted(CAMERA, Grant.LOOKING)
    assert not _admitted(DRAG, Grant.LOOKING)


@given(st.binary(max_size=200))
def test_any_bytes_are_judged(raw: bytes) -> None:
    assert admits(raw, Grant.EVERYTHING) in (True, False)


def test_deep_nesting_is_not_admitted() -> None:
    assert not admits(b"\x91" * 5000 + b"\xc0", Grant.EVERYTHING)


def test_nonsense_on_visers_websocket_changes_nothing(page: PageClient) -> None:
    server = page.server

    async def shout() -> None:
        async with visers_socket(server) as socket:
            for message in (
                {"type": "GuiUpdateMessage", "uuid": "u", "updates": {"value": 1.0}},
                {"type": "GuiRemoveMessage", "uuid": "u"},
                {"type": "FileTransferPart", "content": b"x" * 1000},
                {"type": "NoSuchMessage"},
            ):
                await socket.send(msgspec.msgpack.encode(message))
            await socket.send(b"garbage")
            await (await socket.ping())

    asyncio.run(shout())
    page.send("set", parameter="persistence", value=5.0)
    document = page.wait_for("document", lambda m: m["parameters"]["persistence"] == 5.0)

    assert document["parameters"]["force_ratio"] == 20.0
