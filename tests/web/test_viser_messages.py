"""What viser's client may say to viser: right kinds, finite numbers, values a control can take."""

import asyncio
import math
from typing import Any

import msgspec
import pytest
from hypothesis import given
from hypothesis import strategies as st
from talking import PageClient, control, visers_socket

from keyphase.web.server import PageServer
from keyphase.web.transport.access import Grant
from keyphase.web.transport.viser_messages import admits

CAMERA = {
    "type": "ViewerCameraMessage",
    "wxyz": [1.0, 0.0, 0.0, 0.0],
    "position": [1.0, 1.0, 1.0],
    "fov": 1.0,
}


def _admitted(message: object, grant: Grant = Grant.EVERYTHING, takes: bool = True) -> bool:
    return admits(msgspec.msgpack.encode(message), grant, lambda _uuid, _value: takes)


def _update(**fields: Any) -> dict[str, Any]:
    return {"type": "GuiUpdateMessage", "uuid": "u", "updates": {"value": 1.0}, **fields}


def test_moving_the_camera_and_a_control_is_admitted() -> None:
    assert _admitted(CAMERA)
    assert _admitted(_update())


def test_a_value_its_control_does_not_take_is_not() -> None:
    assert not _admitted(_update(), takes=False)


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
        _update(updates={"removed": True}),
        _update(updates={"value": 1.0, "removed": True}),
        _update(updates={"value": math.nan}),
        _update(updates={"value": math.inf}),
        _update(updates={"value": 1e300}),
        _update(updates={"value": "x" * 5000}),
        _update(updates=[]),
        _update(uuid=7),
        {**CAMERA, "position": [math.nan, 0.0, 0.0]},
        {**CAMERA, "position": [0.0] * 1000},
        {**CAMERA, "position": b"\x00" * 8},
    ],
)
def test_anything_else_is_not(message: object) -> None:
    assert not _admitted(message)


def test_who_may_only_look_moves_the_camera_only() -> None:
    assert _admitted(CAMERA, Grant.LOOKING)
    assert not _admitted(_update(), Grant.LOOKING)


@given(st.binary(max_size=200))
def test_any_bytes_are_judged(raw: bytes) -> None:
    assert admits(raw, Grant.EVERYTHING, lambda _uuid, _value: True) in (True, False)


def test_deep_nesting_is_not_admitted() -> None:
    assert not admits(b"\x91" * 5000 + b"\xc0", Grant.EVERYTHING, lambda _uuid, _value: True)


@pytest.mark.parametrize(
    ("label", "value"),
    [
        ("Ratio", 1e6),
        ("Ratio", -1.0),
        ("Ratio", "20"),
        ("Ratio", True),
        ("Threshold", [1.0, 2.0]),
        ("Threshold", [9.0]),
        ("Threshold", 1.0),
        ("Gaussians", "many"),
        ("Gaussians", 3),
        ("Variant", "keyphase; drop table"),
        ("Ground", "yes"),
        ("Reset to automatic", 3),
    ],
)
def test_a_control_takes_only_what_a_person_could_choose(
    server: PageServer, label: str, value: object
) -> None:
    assert not server.accepts(control(server, label), value)


def test_a_control_takes_what_a_person_chooses(server: PageServer) -> None:
    assert server.accepts(control(server, "Ratio"), 35.5)
    assert server.accepts(control(server, "Threshold"), [2.5])
    assert server.accepts(control(server, "Gaussians"), "7")
    assert server.accepts(control(server, "Ground"), False)
    assert server.accepts(control(server, "Reset to automatic"), True)
    assert not server.accepts("no such control", 1.0)


def test_nonsense_on_visers_websocket_changes_nothing(page: PageClient) -> None:
    server = page.server
    ratio = control(server, "Ratio")

    async def shout() -> None:
        async with visers_socket(server) as socket:
            for message in (
                _update(uuid=ratio, updates={"value": math.nan}),
                _update(uuid=ratio, updates={"value": 1e9}),
                _update(uuid=ratio, updates={"removed": True}),
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
