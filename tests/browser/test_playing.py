"""Playback beside everything else one does."""

import pytest
from driver import KeyphasePage


@pytest.mark.slow
def test_while_it_plays_the_threshold_line_can_be_dragged(setup1: KeyphasePage) -> None:
    setup1.wait_for_scene()
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
    assert setup1.page.locator(".ghost.goes").count() >= 1
    clock = setup1.state("clock")
    setup1.until(f"keyphase.state.clock > {clock} || !keyphase.state.playhead.playing")
    mouse.up()
    setup1.until("keyphase.state.ghost.length === 0")
