"""What is held while another document comes: it is let go, or is still the same thing."""

from driver import KeyphasePage

from keyphase.web.server import PageServer


def _take_boundary(page: KeyphasePage, index: int) -> tuple[float, float]:
    """Holds a boundary, 30 px from where it was; the button stays down."""
    row = page.row("boundaries")
    x, y = page.x(page.document["boundaries"][index]["time_s"]), row.y + row.height / 2
    page.page.mouse.move(x, y)
    page.page.mouse.down()
    page.page.mouse.move(x + 30, y, steps=4)
    page.until("keyphase.state.drag !== null")
    return x + 30, y


def _edit(page: KeyphasePage, change: str) -> None:
    """An edit as another page's person would make it: no key, no pointer."""
    page.page.evaluate(f"() => keyphase.actions.send({{type: 'edit', event: 0, edit: {change}}})")


def test_a_boundary_that_is_held_while_another_recording_opens_is_let_go(
    two: KeyphasePage, editor_server: PageServer
) -> None:
    x, y = _take_boundary(two, 1)
    two.page.evaluate("() => keyphase.actions.nextRecording(1)")
    two.until("keyphase.state.document.name === 'synthetic_setup1'")
    two.page.mouse.move(x + 20, y, steps=3)
    two.page.mouse.up()
    two.settle()

    assert two.state("drag") is None
    assert not two.state("holding")
    assert two.document["edits"] == 0
    assert two.page.locator(".notice").count() == 0


def test_a_boundary_that_somebody_took_out_is_not_moved(two: KeyphasePage) -> None:
    x, y = _take_boundary(two, 1)
    gone = two.document["boundaries"][1]["time_s"]
    two.change(lambda: _edit(two, f"{{kind: 'remove', time_s: {gone}}}"))
    left = two.document
    two.page.mouse.move(x + 20, y, steps=3)
    two.page.mouse.up()
    two.settle()

    assert two.state("drag") is None
    assert two.document["boundaries"] == left["boundaries"]
    assert two.document["edits"] == 1


def test_a_name_goes_to_the_segment_it_was_typed_for_when_others_are_cut(
    two: KeyphasePage,
) -> None:
    meant = two.document["segments"][2]
    two.click(two.middle_of(2), count=2)
    two.until("!document.getElementById('rename').hidden")
    two.page.keyboard.type("Push do")
    two.change(lambda: _edit(two, "{kind: 'add', time_s: 0.5}"))
    two.page.keyboard.type("wn")
    two.change(lambda: two.press("Enter"))

    named = [one for one in two.document["segments"] if one["label"] == "Push down"]
    assert [(one["start_s"], one["end_s"]) for one in named] == [(meant["start_s"], meant["end_s"])]
