"""A segment selected in the timeline is seen in the scene, and the other way round."""

from collections.abc import Callable

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


_FRAME = "() => window.__viserTestpoints.rendererInfo.render.frame"


def _drawn_anew(page: KeyphasePage, act: Callable[[], None]) -> None:
    """Act, and wait until the scene has drawn what came of it."""
    frame = page.scene.evaluate(_FRAME)
    act()
    page.scene.wait_for_function(f"({_FRAME})() > {frame} + 2")
    page.wait_for_scene()


def _only_the_path(page: KeyphasePage) -> None:
    page.wait_for_scene()
    for what in ("gaussians", "labels", "forces", "robot", "parts"):
        page.page.evaluate(
            "what => keyphase.actions.send({ type: 'show', what, visible: false })", what
        )
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
    before = _thickness(setup1, setup1.picture("not_selected"))
    _drawn_anew(setup1, lambda: setup1.click(setup1.middle_of(_SEGMENT)))
    assert setup1.state("selected") == _SEGMENT
    assert _thickness(setup1, setup1.picture("selected")) > 1.2 * before


def test_a_segment_selected_by_keys_is_drawn_thicker_in_the_scene(setup1: KeyphasePage) -> None:
    _only_the_path(setup1)
    before = _thickness(setup1, setup1.picture("not_selected"))
    for index in range(_SEGMENT + 1):
        _drawn_anew(setup1, lambda: setup1.press("]"))
        assert setup1.state("selected") == index
    assert _thickness(setup1, setup1.picture("selected_by_keys")) > 1.2 * before
