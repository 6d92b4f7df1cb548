"""A segment selected in the timeline is seen in the scene, and the other way round."""

import numpy as np
from driver import SEGMENT_COLORS, KeyphasePage, Picture

from keyphase.web.server import PageServer

_SEGMENT = 2
_COLOR = SEGMENT_COLORS[1]
"""The third segment of Setup 1, which goes straight down; idle ones before it have no colour."""


def _on_path(page: KeyphasePage) -> tuple[float, float]:
    """A point of the page well inside the segment's path as it is drawn in the scene."""
    view = page.box("#viser")
    seen = page.until_seen("path", lambda now: len(now.places(_COLOR, view)) > 100)
    places = seen.places(_COLOR, view)
    middle = places[np.argsort(places[:, 1])[len(places) // 2]]
    near = places[np.abs(places - middle).max(axis=1) < 4]
    x, y = near.mean(axis=0)
    return float(x), float(y)


def _thickness(page: KeyphasePage, picture: Picture) -> int:
    return picture.count_hue(_COLOR, page.box("#viser"))


_HIDDEN = """names => names.every(name => {
  const node = window.__viserMutable.nodeRefFromName["/" + name];
  return !node || !node.visible;
})"""


def _only_the_path(page: KeyphasePage) -> None:
    """And the robot: without it the camera would look from elsewhere."""
    page.wait_for_scene()
    hidden = ("gaussians", "labels", "forces", "parts")
    for what in hidden:
        page.page.evaluate(
            "what => keyphase.actions.send({ type: 'show', what, visible: false })", what
        )
    page.scene.wait_for_function(_HIDDEN, arg=hidden)
    page.wait_for_scene()


def test_clicking_the_path_selects_its_segment_in_the_timeline(setup1: KeyphasePage) -> None:
    _only_the_path(setup1)
    setup1.click(_on_path(setup1))
    setup1.until(f"keyphase.state.selected === {_SEGMENT}")
    setup1.settle()
    assert setup1.page.locator(".segment-ring").count() == 1


def test_a_segment_selected_in_the_timeline_is_drawn_thicker_in_the_scene(
    setup1: KeyphasePage,
) -> None:
    """Clicked, and then by keys alone."""
    _only_the_path(setup1)
    before = _thickness(setup1, setup1.picture("not_yet_selected"))
    setup1.click(setup1.middle_of(_SEGMENT))
    _is_drawn_thicker(setup1, before)
    setup1.press("Escape")
    setup1.until("keyphase.state.selected === null")
    thin = setup1.until_seen("not_selected", lambda now: _thickness(setup1, now) <= 1.15 * before)
    assert _thickness(setup1, thin) <= 1.15 * before
    for index in range(_SEGMENT + 1):
        setup1.press("]")
        setup1.until(f"keyphase.state.selected === {index}")
    _is_drawn_thicker(setup1, before)


_TOOL_AT = """([x, y, z]) => {
  const at = window.__viserMutable?.nodeRefFromName["/frame/tool"]?.position;
  return at && Math.hypot(at.x - x, at.y - y, at.z - z) < 1e-4;
}"""


def test_what_is_done_while_the_scene_is_put_up_is_seen_in_it(
    setup1: KeyphasePage, scene_server: PageServer
) -> None:
    """The robot is found then, and all is drawn anew from where it is seen with the robot."""
    for what in ("labels", "forces", "gaussians", "parts", "robot"):
        setup1.page.evaluate(
            "what => keyphase.actions.send({ type: 'show', what, visible: false })", what
        )
    setup1.page.evaluate("() => keyphase.actions.seek(3.0)")
    setup1.change(lambda: setup1.page.evaluate("() => keyphase.actions.mergeRange(0, 4)"))
    demonstration = scene_server.workbench.views[-1].current().demonstration
    there = demonstration.position_m[demonstration.index_at(3.0)].tolist()
    setup1.page.evaluate(
        "() => keyphase.actions.send({ type: 'show', what: 'robot', visible: true })"
    )
    setup1.scene.wait_for_function(_TOOL_AT, arg=there)
    assert scene_server.scenes.wait_until_drawn(60.0)
    setup1.page.evaluate(
        "() => keyphase.actions.send({ type: 'show', what: 'robot', visible: false })"
    )
    setup1.scene.wait_for_function(_TOOL_AT, arg=there)
    view = setup1.box("#viser")
    (one,) = setup1.document["segments"]
    color = SEGMENT_COLORS[one["color"]]
    gone = SEGMENT_COLORS[1 if one["color"] == 2 else 2]
    seen = setup1.until_seen("merged", lambda now: now.count_hue(gone, view) < 20)
    assert seen.count_hue(gone, view) < 20
    assert seen.count_hue(color, view) > 100


def _is_drawn_thicker(page: KeyphasePage, before: int) -> None:
    page.until(f"keyphase.state.selected === {_SEGMENT}")
    seen = page.until_seen("selected", lambda now: _thickness(page, now) > 1.2 * before)
    assert _thickness(page, seen) > 1.2 * before
