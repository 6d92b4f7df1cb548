"""The scene as viser is told it: colours of segments, what is shown, what a click selects."""

import asyncio
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
from framing import Frame, frame
from talking import CAMERA, Message, PageClient, StartServer, wait_until

from keyphase.robot.pose import Placement
from keyphase.web.scene.palette import DARK, LIGHT, SEGMENT_RGB, painted
from keyphase.web.scene.recording.path import FAINT
from keyphase.web.scene.recording.viewpoint import viewpoint_with_robot


def _document(page: PageClient) -> Message:
    return next(m for m in page.heard if m["type"] == "document")


@pytest.fixture
def framed(page: PageClient) -> Iterator[Frame]:
    """The frame of that page."""
    with frame(page.server, page.page) as framed:
        yield framed


def _colors(framed: Frame) -> set[tuple[int, ...]]:
    pieces = framed.node("/path/pieces")
    return {tuple(color) for color in np.asarray(pieces.batched_colors).tolist()}


def _paint(color: int) -> tuple[int, int, int]:
    red, green, blue = SEGMENT_RGB[color % len(SEGMENT_RGB)].tolist()
    return painted((red, green, blue))


def test_the_path_has_the_colours_of_the_kept_segments(page: PageClient, framed: Frame) -> None:
    kept = {_paint(s["color"]) for s in _document(page)["segments"] if s["kept"]}

    assert kept <= _colors(framed)
    assert len(_colors(framed)) <= len(kept) + 1


def test_merging_everything_leaves_one_colour(page: PageClient, framed: Frame) -> None:
    document = _document(page)
    before = _colors(framed)
    page.send("edit", edit={"kind": "merge", "from_s": 0.01, "to_s": document["end_s"] - 0.01})
    page.wait_for("document", lambda m: len(m["segments"]) == 1)

    assert len(before) > 1
    assert len(_colors(framed)) == 1


def test_contact_changes_have_arrows(page: PageClient, framed: Frame) -> None:
    contacts = [b for b in _document(page)["boundaries"] if b["contact_change"]]

    assert len(framed.node("/forces/arrows").points) == len(contacts) > 0


def test_of_a_selected_segment_only_its_own_contact_changes_have_arrows(
    page: PageClient, framed: Frame
) -> None:
    before = len(framed.node("/forces/arrows").points)
    page.send("select", segment=0)
    page.wait_for("selection", lambda m: m["segment"] == 0)

    drawn = framed.nodes.get("/forces/arrows")
    assert (0 if drawn is None else len(drawn.points)) < before


def test_several_selected_segments_stand_out_together(page: PageClient, framed: Frame) -> None:
    kept = [k for k, s in enumerate(_document(page)["segments"]) if s["kept"]]
    colors: list[set[tuple[int, ...]]] = []
    for to in (None, kept[1]):
        page.send("select", segment=kept[0], to=to)
        page.wait_for("selection", lambda m: m["segment"] == kept[0])
        drawn = np.asarray(framed.node("/path/selected/pieces").batched_colors)
        colors.append({tuple(color) for color in drawn.reshape(-1, 3)})

    assert len(colors[0]) < len(colors[1])


def test_there_is_an_ellipsoid_for_each_gaussian(page: PageClient, framed: Frame) -> None:
    drawn = framed.node("/gaussians/ellipsoids")

    assert len(drawn.batched_positions) == _document(page)["gaussians"]


def test_the_frame_stands_where_the_tool_was(page: PageClient, framed: Frame) -> None:
    page.send("seek", time_s=1.0)
    page.wait_for("playhead", lambda m: m["time_s"] == 1.0)
    opened = page.server.workbench.find_view(page.page).current()

    tool = framed.node("/frame/tool")

    expected = opened.demonstration.position_m[opened.demonstration.index_at(1.0)]
    np.testing.assert_allclose(tool.position, expected)


def test_the_last_half_second_of_the_way_trails_the_tool(page: PageClient, framed: Frame) -> None:
    page.send("seek", time_s=1.0)
    page.wait_for("playhead", lambda m: m["time_s"] == 1.0)
    recorded = page.server.workbench.find_view(page.page).current().demonstration

    tail = np.asarray(framed.node("/frame/tail").batched_positions)
    opacities = np.asarray(framed.node("/frame/tail").batched_opacities)
    for place, time_s in ((tail[0], 1.0), (tail[-1], 0.5)):
        expected = recorded.position_m[recorded.index_at(time_s)]
        np.testing.assert_allclose(place, expected, atol=2e-3)
    assert (np.diff(opacities) < 0.0).all()
    page.send("seek", time_s=recorded.start_s)
    page.wait_for("playhead", lambda m: m["time_s"] == recorded.start_s)
    np.testing.assert_allclose(
        framed.node("/frame/tail").batched_positions,
        np.broadcast_to(recorded.position_m[0], tail.shape),
        atol=1e-6,
    )


def test_clicking_the_path_selects_the_segment_there(page: PageClient, framed: Frame) -> None:
    framed.say(_click(framed.scene.client.scene._owner_id))  # pyright: ignore

    assert page.wait_for("selection", lambda m: m["segment"] is not None)["segment"] == 0


def test_nobody_clicks_in_another_pages_scene(page: PageClient, framed: Frame) -> None:
    with frame(page.server, "e" * 32) as other:
        owner = other.scene.client.scene._owner_id  # pyright: ignore
        framed.say(_click(owner))
        framed.say(_click(""))
        page.send("seek", time_s=1.0)
        page.wait_for("playhead", lambda m: m["time_s"] == 1.0)

    assert not [m for m in page.heard if m["type"] == "selection" and m["segment"] is not None]


def _click(owner: str) -> dict[str, object]:
    return {
        "type": "SceneNodeClickMessage",
        "name": "/path/pieces",
        "instance_index": 0,
        "owner": owner,
        "ray_origin": (0.0, 0.0, 1.0),
        "ray_direction": (0.0, 0.0, -1.0),
        "screen_pos": (0.5, 0.5),
        "modifier": None,
    }


def test_a_hidden_part_is_hidden_in_the_scene(page: PageClient, framed: Frame) -> None:
    page.send("show", what="gaussians", visible=False)
    page.wait_for("shown", lambda m: not m["parts"]["gaussians"])

    assert not framed.node("/gaussians").visible
    assert framed.node("/path").visible


def test_how_far_finished_recordings_lie_apart_is_a_sleeve_around_their_mean(
    own_copy: Path, start_server: StartServer
) -> None:
    """The other one is the same recording, a centimetre aside."""
    with np.load(own_copy) as recorded:
        moved = {**recorded, "position_m": recorded["position_m"] + [0.0, 0.01, 0.0]}
    np.savez(own_copy.with_name("other.npz"), **moved)
    server = start_server(own_copy.with_name("other.npz"), own_copy)
    with PageClient(server) as page, frame(server, page.page) as framed:
        page.wait_for("document")
        page.send("done", done=True)
        lines = page.wait_for("recordings", lambda m: m["items"][0]["state"] == "done")["items"]
        page.send("open", id=lines[1]["id"])
        page.wait_for("document", lambda m: m["id"] == lines[1]["id"])
        assert "/spread/balls" not in framed.nodes
        page.send("show", what="spread", visible=True)
        page.wait_for("shown", lambda m: m["parts"]["spread"])

        radii = np.asarray(framed.node("/spread/balls").batched_scales)
        np.testing.assert_allclose(radii, 0.005, atol=1e-4)
        assert framed.node("/spread").visible


def test_nothing_of_a_page_is_sent_to_all_pages(page: PageClient) -> None:
    """Theme, light and background have no owner in the browser: the last message would win."""
    buffer = page.server.viser._websock_server._broadcast_buffer  # pyright: ignore
    before = set(buffer.message_from_id)
    with frame(page.server, page.page) as framed:
        page.send("theme", dark=True)
        framed.settle()

    assert set(buffer.message_from_id) == before


def test_a_frame_that_connects_again_is_drawn_again_and_seen_from_where_it_was(
    page: PageClient,
) -> None:
    with frame(page.server, page.page) as first:
        camera = first.scene.client.camera
        put = {"position": camera.position.tolist(), "look_at": camera.look_at.tolist()}
        first.say({**CAMERA, **put})
        first.say({**CAMERA, "position": (3.0, 2.0, 1.0), "look_at": (0.5, 0.0, 0.0)})
        asyncio.run(wait_until(lambda: camera.position.tolist() == [3.0, 2.0, 1.0]))
    with frame(page.server, page.page) as again:
        camera = again.scene.client.camera
        assert again.node("/path/pieces")
        assert camera.position.tolist() == [3.0, 2.0, 1.0]
        assert camera.look_at.tolist() == [0.5, 0.0, 0.0]


def test_nothing_is_drawn_for_a_page_that_has_left(page: PageClient) -> None:
    server = page.server
    view = server.workbench.find_view(page.page)
    watchers = len(view._watchers)  # pyright: ignore
    with frame(server, page.page) as framed:
        painter = framed.scene._painter  # pyright: ignore
        assert len(view._watchers) == watchers + 1  # pyright: ignore
    asyncio.run(wait_until(lambda: len(view._watchers) == watchers))  # pyright: ignore
    drawn: list[int] = []
    painter.submit(lambda: drawn.append(1)).wait()

    assert server.scenes.all == ()
    assert drawn == []


def test_with_a_segment_selected_the_rest_is_faint(page: PageClient, framed: Frame) -> None:
    assert framed.node("/path/pieces").batched_opacities is None
    page.send("select", segment=0)
    page.wait_for("selection", lambda m: m["segment"] == 0)

    opacities = np.asarray(framed.node("/path/pieces").batched_opacities)
    assert sorted(set(opacities.tolist())) == pytest.approx([FAINT, 1.0])
    assert "/path/selected/pieces" in framed.nodes
    page.send("select", segment=None)
    page.wait_for("selection", lambda m: m["segment"] is None)
    assert framed.node("/path/pieces").batched_opacities is None


def test_only_what_is_in_view_is_drawn(page: PageClient, framed: Frame) -> None:
    whole = len(framed.node("/path/pieces").batched_positions)
    recording = _document(page)["id"]
    page.send("in_view", recording="another", from_s=1.0, to_s=2.0)
    explained = len(framed.node("/gaussians/ellipsoids").batched_positions)
    page.send("in_view", recording=recording, from_s=1.0, to_s=2.0)
    page.send("seek", time_s=1.0)
    page.wait_for("playhead", lambda m: m["time_s"] == 1.0)
    part = len(framed.node("/path/pieces").batched_positions)
    assert len(framed.node("/gaussians/ellipsoids").batched_positions) < explained
    assert "/forces/arrows" not in framed.nodes
    page.send("in_view", recording=recording, from_s=-1.0, to_s=1e9)
    page.send("seek", time_s=2.0)
    page.wait_for("playhead", lambda m: m["time_s"] == 2.0)

    assert 0 < part < whole
    assert len(framed.node("/path/pieces").batched_positions) == whole
    assert len(framed.node("/gaussians/ellipsoids").batched_positions) == explained
    assert "/forces/arrows" in framed.nodes


def test_the_ground_of_what_stands_in_place_of_a_recording_has_the_theme(framed: Frame) -> None:
    """A replay, or a workcell that is led by hand."""
    stage = framed.scene.stage
    view = viewpoint_with_robot(np.array([0.4, 0.0, 0.1]), 0.5, Placement())
    stage.cover(view, np.array([0.4, 0.0, 0.0]), 0.5, Placement(), "workcell")
    light = framed.node("/grid/lines").cell_color
    stage.show_theme(dark=True)

    assert (light, framed.node("/grid/lines").cell_color) == (LIGHT.cell, DARK.cell)


def test_nothing_of_a_recording_is_left_when_another_is_on_its_way(
    page: PageClient, framed: Frame
) -> None:
    framed.settle()
    framed.scene.show_nothing()

    assert not [
        name
        for name in framed.nodes
        if name.startswith(("/path/", "/forces/", "/gaussians/", "/frame/", "/grid/"))
        or name == "/stand"
    ]
    assert not framed.scene.robot.figure.visible


def test_the_longest_arrow_is_a_third_of_the_path(page: PageClient, framed: Frame) -> None:
    points = np.asarray(framed.node("/forces/arrows").points)
    demonstration = page.server.workbench.find_view(page.page).current().demonstration
    size = np.linalg.norm(np.ptp(demonstration.position_m, axis=0))

    longest = np.linalg.norm(points[:, 1] - points[:, 0], axis=1).max()
    assert longest == pytest.approx(size / 3.0, rel=1e-3)


def test_the_more_pages_the_more_rarely_a_running_playhead_is_drawn(page: PageClient) -> None:
    with frame(page.server, page.page) as one:
        alone = one.scene._shared.pace_s  # pyright: ignore
        with frame(page.server, "f" * 32):
            together = one.scene._shared.pace_s  # pyright: ignore

    assert together == 2 * alone > 0
