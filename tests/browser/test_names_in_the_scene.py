"""Names over the 3D scene: beside what they name, never on each other, in the page's own look."""

import random
from itertools import pairwise

import pytest
from driver import SEGMENT_COLORS, Box, KeyphasePage

NEAR_PX = 14

_PLACED = """async ([anchors, canvas]) => {
  const { placed } = await import("/app/static/js/scene/placing.js");
  return placed(anchors.map(([x, y, width]) => ({ anchor: { x, y }, width })), canvas);
}"""


def names(page: KeyphasePage) -> list[str]:
    page.until("document.querySelectorAll('.name').length")
    return page.page.locator("#names .name").all_text_contents()


def anchor_of(page: KeyphasePage, text: str) -> Box:
    """A square of the page around the point that a name is about."""
    dots = page.page.locator("#names circle")
    box = dots.nth(names(page).index(text)).bounding_box()
    assert box
    x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
    return Box(x - NEAR_PX, y - NEAR_PX, 2 * NEAR_PX, 2 * NEAR_PX)


def moved(page: KeyphasePage, before: Box) -> None:
    page.page.wait_for_function(
        "([x, y]) => { const box = document.querySelector('#names circle').getBoundingClientRect();"
        " return Math.hypot(box.x + box.width / 2 - x, box.y + box.height / 2 - y) > 10; }",
        arg=list(before.middle),
    )


@pytest.fixture
def large(setup1: KeyphasePage) -> KeyphasePage:
    """A page with room for all names."""
    setup1.resize(1920, 1080)
    setup1.wait_for_scene()
    return setup1


def test_every_kept_segment_and_contact_change_is_named_at_its_path(large: KeyphasePage) -> None:
    document = large.document
    kept = [f"{k + 1} {s['label']}" for k, s in enumerate(document["segments"]) if s["kept"]]
    times = [b["time_s"] for b in document["boundaries"] if b["contact_change"]]

    assert names(large) == kept + [f"contact change {time:.3f} s" for time in times]

    large.page.evaluate("() => keyphase.actions.seek(keyphase.state.document.end_s)")
    large.wait_for_scene()
    picture = large.picture("names")
    for index in (0, 4):
        text = f"{index + 1} {large.document['segments'][index]['label']}"
        color = SEGMENT_COLORS[large.document["segments"][index]["color"]]
        assert picture.count_hue(color, anchor_of(large, text)) > 40


def test_names_follow_the_camera(setup1: KeyphasePage) -> None:
    setup1.wait_for_scene()
    first = names(setup1)[0]
    before = anchor_of(setup1, first)
    scene = setup1.box("#viser")
    empty = (scene.x + 0.25 * scene.width, scene.y + 0.8 * scene.height)
    setup1.drag(empty, (empty[0] + 60, empty[1] - 20))
    moved(setup1, before)
    setup1.wait_for_scene()
    color = SEGMENT_COLORS[setup1.document["segments"][0]["color"]]
    picture = setup1.picture("names_orbited")
    assert picture.count_hue(color, anchor_of(setup1, first)) > 20


def test_a_click_on_a_name_selects_its_segment_and_names_are_hidden_and_shown_again(
    scene_editor: KeyphasePage,
) -> None:
    scene_editor.wait_for_scene()
    scene_editor.page.locator("#names .name", has_text="5 Slide").click()
    scene_editor.until("keyphase.state.selected === 4")
    scene_editor.page.locator("#names .name.selected", has_text="5 Slide").wait_for()
    for visible, state in ((False, "hidden"), (True, "visible")):
        scene_editor.page.evaluate(
            "visible => keyphase.socket.send({ type: 'show', what: 'labels', visible })", visible
        )
        scene_editor.page.locator("#names").wait_for(state=state)


def test_names_never_cover_each_other_nor_leave_the_scene(editor: KeyphasePage) -> None:
    draw = random.Random(7)
    canvas = {"width": 900, "height": 420}
    for count in range(1, 13):
        asked = [
            (draw.uniform(0, 900), draw.uniform(0, 420), draw.uniform(60, 260))
            for _ in range(count)
        ]
        places = editor.page.evaluate(_PLACED, [asked, canvas])
        for side in ("left", "right"):
            heights = sorted(p["y"] for p in places if p["side"] == side)
            assert all(b - a > 20 for a, b in pairwise(heights))
        for (_, _, width), place in zip(asked, places, strict=True):
            left = place["x"] - (width if place["side"] == "left" else 0)
            assert left >= 0
            assert left + width <= canvas["width"]
            assert 20 < place["y"] < canvas["height"] - 20
