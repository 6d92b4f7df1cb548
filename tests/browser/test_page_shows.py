"""What the page shows of a recording, seen in screenshots."""

import pytest
from driver import ACCENT, SEGMENT_COLORS, Box, KeyphasePage

PANEL_WIDTH = 330


def test_as_many_bands_as_segments_in_their_colors(editor: KeyphasePage) -> None:
    document = editor.document
    assert editor.segments.count() == len(document["segments"]) == 5
    picture = editor.picture("bands")
    band = editor.row("segments")
    kept = {segment["color"] for segment in document["segments"] if segment["kept"]}
    for color in kept:
        assert picture.count(SEGMENT_COLORS[color], band) > 500


def test_segments_have_their_colors_on_the_trajectory_too(scene_editor: KeyphasePage) -> None:
    scene_editor.wait_for_scene()
    whole = scene_editor.box("#viser")
    scene = Box(whole.x, whole.y, whole.width - PANEL_WIDTH, whole.height)
    moving = [
        one for one in scene_editor.document["segments"] if one["label"][:4] in ("Move", "Slid")
    ]
    assert len(moving) == 3
    colors = [SEGMENT_COLORS[segment["color"]] for segment in moving]
    for _ in range(60):
        picture = scene_editor.picture("setup1_scene")
        if all(picture.count_hue(color, scene) > 100 for color in colors):
            return
        scene_editor.page.wait_for_timeout(500)
    pytest.fail("the path does not have the colours of its segments")


def test_threshold_line_lies_where_the_threshold_is(editor: KeyphasePage) -> None:
    editor.set_parameter("variant", "paper")
    picture = editor.picture("threshold")
    row = editor.row("error")
    drawn = picture.rows_with(ACCENT["light"], row, least=int(row.width / 3), tolerance=24)
    told = editor.page.evaluate(
        "() => keyphase.timeline.thresholdY(keyphase.state.document.threshold)"
    )
    assert drawn
    assert abs(sum(drawn) / len(drawn) - (editor.box(".surface").y + told)) < 2


def test_every_boundary_has_its_glyph_its_time_and_its_doubt(editor: KeyphasePage) -> None:
    boundaries = editor.document["boundaries"]
    assert editor.boundaries.count() == len(boundaries)
    times = editor.page.locator(".boundary-time").all_text_contents()
    doubts = [f" {b['confidence']:.2f}" if b["unsure"] else "" for b in boundaries]
    told = [f"{b['time_s']:.3f}{doubt}" for b, doubt in zip(boundaries, doubts, strict=True)]
    assert sorted(times) == sorted(told)
