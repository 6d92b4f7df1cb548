"""The scene as viser is told it: colours of segments, what is shown, what a click selects."""

import asyncio
from concurrent.futures import ThreadPoolExecutor

import msgspec
import numpy as np
from talking import CAMERA, Message, PageClient, scene_of, visers_socket

from keyphase.web.scene.palette import SEGMENT_COLORS, painted
from keyphase.web.server import PageServer
from keyphase.workbench.playback import Playhead


def _document(page: PageClient) -> Message:
    return next(m for m in page.heard if m["type"] == "document")


def _drawn(server: PageServer) -> None:
    """Wait until the scene shows what the pages were told."""
    assert scene_of(server).wait_until_shown(20)


def _node(server: PageServer, name: str) -> object:
    return server.viser.scene._handle_from_node_name[name]  # pyright: ignore


def _colors(server: PageServer) -> set[tuple[int, ...]]:
    _drawn(server)
    pieces = _node(server, "/path/pieces")
    return {tuple(color) for color in np.asarray(pieces.batched_colors).tolist()}  # type: ignore


def _paint(color: int) -> tuple[int, int, int]:
    red, green, blue = SEGMENT_COLORS[color % len(SEGMENT_COLORS)].tolist()
    return painted((red, green, blue))


def test_the_path_has_the_colours_of_the_kept_segments(page: PageClient) -> None:
    kept = {_paint(s["color"]) for s in _document(page)["segments"] if s["kept"]}

    assert kept <= _colors(page.server)
    assert len(_colors(page.server)) <= len(kept) + 1


def test_merging_everything_leaves_one_colour(page: PageClient) -> None:
    document = _document(page)
    before = _colors(page.server)
    page.send("edit", edit={"kind": "merge", "from_s": 0.01, "to_s": document["end_s"] - 0.01})
    page.wait_for("document", lambda m: len(m["segments"]) == 1)

    assert len(before) > 1
    assert len(_colors(page.server)) == 1


def test_contact_changes_have_arrows_that_go_with_the_threshold(page: PageClient) -> None:
    contacts = [b for b in _document(page)["boundaries"] if b["contact_change"]]
    _drawn(page.server)
    arrows = _node(page.server, "/forces/arrows")
    page.send("set", parameter="force_threshold", value=1e8)
    page.wait_for("document", lambda m: m["threshold"] == 1e8)
    _drawn(page.server)

    assert len(arrows.points) == len(contacts)  # type: ignore
    assert "/forces/arrows" not in page.server.viser.scene._handle_from_node_name  # pyright: ignore


def test_there_is_an_ellipsoid_for_each_gaussian(page: PageClient) -> None:
    _drawn(page.server)
    drawn = _node(page.server, "/gaussians/ellipsoids")

    assert len(drawn.batched_positions) == len(_document(page)["gaussians"])  # type: ignore


def test_the_frame_stands_where_the_tool_was(page: PageClient) -> None:
    page.send("seek", time_s=1.0)
    page.wait_for("playhead", lambda m: m["time_s"] == 1.0)
    _drawn(page.server)
    opened = page.server.workbench.views[0].current()

    frame = _node(page.server, "/frame/tool")

    expected = opened.demonstration.position_m[opened.demonstration.index_at(1.0)]
    np.testing.assert_allclose(frame.position, expected)  # type: ignore


def test_clicking_the_path_selects_the_segment_there(page: PageClient) -> None:
    server = page.server
    _drawn(server)
    click = {
        "type": "SceneNodeClickMessage",
        "name": "/path/pieces",
        "instance_index": 0,
        "owner": server.viser.scene._owner_id,  # pyright: ignore
        "ray_origin": (0.0, 0.0, 1.0),
        "ray_direction": (0.0, 0.0, -1.0),
        "screen_pos": (0.5, 0.5),
        "modifier": None,
    }

    async def click_it() -> None:
        async with visers_socket(server) as socket:
            await asyncio.wait_for(socket.recv(), 10)
            await socket.send(msgspec.msgpack.encode(CAMERA))
            await socket.send(msgspec.msgpack.encode(click))
            await (await socket.ping())
            await asyncio.to_thread(page.wait_for, "selection")

    asyncio.run(click_it())

    assert page.heard[-1]["segment"] == 0


def test_a_hidden_part_is_hidden_in_the_scene(page: PageClient) -> None:
    page.send("show", what="gaussians", visible=False)
    page.wait_for("shown", lambda m: not m["parts"]["gaussians"])
    _drawn(page.server)

    assert not _node(page.server, "/gaussians").visible  # type: ignore
    assert _node(page.server, "/path").visible  # type: ignore


def test_the_scene_is_built_anew_while_other_threads_draw_in_it(page: PageClient) -> None:
    """The robot comes and goes: the ground and the tube are put up again each time."""
    server = page.server
    _drawn(server)
    assert server.scene is not None
    scene, robot = server.scene.scene, server.scene.robot

    def come_and_go(times: int) -> None:
        for _ in range(times):
            robot.show_parts(frozenset({"robot"}))
            robot.show_parts(frozenset())

    def move(times: int) -> None:
        for time_s in np.linspace(0.0, 1.0, times).tolist():
            scene.show_playhead(Playhead(time_s=time_s))
            scene.show_selection(int(10 * time_s) % 2)

    with ThreadPoolExecutor() as threads:
        works = [threads.submit(come_and_go, 4) for _ in range(2)]
        works += [threads.submit(move, 100) for _ in range(2)]
    for work in works:
        work.result()
    assert _node(server, "/path/pieces")
