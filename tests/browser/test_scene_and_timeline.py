"""A segment selected in the timeline is seen in the scene, and the other way round."""

import numpy as np
from driver import SEGMENT_COLORS, KeyphasePage, Picture

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


def _is_drawn_thicker(page: KeyphasePage, before: int) -> None:
    page.until(f"keyphase.state.selected === {_SEGMENT}")
    seen = page.until_seen("selected", lambda now: _thickness(page, now) > 1.2 * before)
    assert _thickness(page, seen) > 1.2 * before
