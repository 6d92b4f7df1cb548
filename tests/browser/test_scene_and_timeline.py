"""A segment selected in the timeline is seen in the scene, and the other way round."""

import numpy as np
from driver import SEGMENT_COLORS, KeyphasePage, Picture

_SEGMENT = 2
_COLOR = SEGMENT_COLORS[1]
"""The third segment of Setup 1, which goes straight down; idle ones before it have no colour."""


def _on_path(page: KeyphasePage) -> tuple[float, float]:
    """A point of the page well inside the segment's path as it is drawn in the scene."""
    view = page.box("#viser")
    places = page.picture("path").places(_COLOR, view)
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

PATIENCE = 40
"""Pictures that are taken, half a second apart, until one shows what is waited for."""


def _thickness_at_rest(page: KeyphasePage) -> int:
    """How much of the picture the segment has, once hiding the robot has moved the camera."""
    seen = [-1]
    while len(seen) < PATIENCE and seen[-1] not in seen[:-1][-2:]:
        page.page.wait_for_timeout(700)
        seen.append(_thickness(page, page.picture("not_selected")))
    return seen[-1]


def _is_drawn_thicker(page: KeyphasePage, before: int) -> bool:
    """Whether the segment gets more of the picture than before, once the scene is drawn."""
    for _ in range(PATIENCE):
        if _thickness(page, page.picture("selected")) > 1.2 * before:
            return True
        page.page.wait_for_timeout(500)
    return False


def _only_the_path(page: KeyphasePage) -> None:
    page.wait_for_scene()
    hidden = ("gaussians", "labels", "forces", "robot", "parts")
    for what in hidden:
        page.page.evaluate(
            "what => keyphase.actions.send({ type: 'show', what, visible: false })", what
        )
    shown = [name for name in hidden if name != "robot"]
    page.scene.wait_for_function(_HIDDEN, arg=shown)
    page.wait_for_scene()


def test_clicking_the_path_selects_its_segment_in_the_timeline(setup1: KeyphasePage) -> None:
    _only_the_path(setup1)
    setup1.click(_on_path(setup1))
    setup1.until(f"keyphase.state.selected === {_SEGMENT}")
    setup1.settle()
    assert setup1.page.locator(".segment-ring").count() == 1


def test_a_segment_clicked_in_the_timeline_is_drawn_thicker_in_the_scene(
    setup1: KeyphasePage,
) -> None:
    _only_the_path(setup1)
    before = _thickness_at_rest(setup1)
    setup1.click(setup1.middle_of(_SEGMENT))
    setup1.until(f"keyphase.state.selected === {_SEGMENT}")
    assert _is_drawn_thicker(setup1, before)


def test_a_segment_selected_by_keys_is_drawn_thicker_in_the_scene(setup1: KeyphasePage) -> None:
    _only_the_path(setup1)
    before = _thickness_at_rest(setup1)
    for index in range(_SEGMENT + 1):
        setup1.press("]")
        setup1.until(f"keyphase.state.selected === {index}")
    assert _is_drawn_thicker(setup1, before)
