"""The scene gives way: to what a hand holds, while something plays and at rest."""

import pytest
from driver import KeyphasePage

_SCENE_FRAME = """() => document.getElementById('viser').contentWindow
  .__viserTestpoints.rendererInfo.render.frame"""
IN_FLIGHT = 1
"""So many frames of the scene may be under way as a hand takes hold."""

HELD_MS = 6000
"""viser draws a frame a second, here with rests between them."""


def test_the_scene_draws_nothing_while_a_hand_moves_the_view(setup1: KeyphasePage) -> None:
    setup1.wait_for_scene()
    for _ in range(3):
        setup1.press("+")
    setup1.wait_for_scene()
    row, mouse = setup1.row("position"), setup1.page.mouse
    y, start = row.y + 0.5 * row.height, setup1.state("view")["from"]
    # No boundary is near either.
    first_s = setup1.document["boundaries"][0]["time_s"]
    held, end = setup1.x(0.7 * first_s), setup1.x(0.2 * first_s)
    mouse.move(held, y)
    mouse.down()
    setup1.settle()
    before = setup1.page.evaluate(_SCENE_FRAME)
    mouse.move(end, y, steps=12)
    setup1.page.wait_for_timeout(HELD_MS)
    assert setup1.page.evaluate(_SCENE_FRAME) - before <= IN_FLIGHT
    mouse.up()
    assert setup1.state("view")["from"] > start


@pytest.mark.slow
def test_while_it_plays_the_threshold_line_can_be_dragged(setup1: KeyphasePage) -> None:
    setup1.wait_for_scene()
    setup1.set_parameter("variant", "paper")
    told = setup1.page.evaluate(
        "() => keyphase.timeline.thresholdY(keyphase.state.document.threshold)"
    )
    row = setup1.row("error")
    x, y = row.x + 0.5 * row.width, setup1.box(".surface").y + told
    setup1.page.evaluate("() => keyphase.actions.setSpeed(0.25)")
    setup1.press("Space")
    setup1.until("keyphase.state.playhead.playing")
    mouse = setup1.page.mouse
    mouse.move(x, y)
    mouse.down()
    mouse.move(x, row.y + 2, steps=8)
    setup1.until("keyphase.state.document.boundaries.every(b => !b.contact_change)")
    setup1.until("keyphase.state.ghost.some(g => g.fate === 'goes')")
    setup1.settle()
    assert setup1.page.locator(".ghost.goes").count() >= 1
    clock = setup1.state("clock")
    setup1.until(f"keyphase.state.clock > {clock} || !keyphase.state.playhead.playing")
    mouse.up()
    setup1.until("keyphase.state.ghost.length === 0")
