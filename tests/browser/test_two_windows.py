"""Two windows on one server, and a window that may only look."""

from pathlib import Path

import numpy as np
from driver import KeyphasePage, Picture, Serve, Visit

OWN = """() => {
  const { document: doc, selected, current, view, clock, dark, hidden, folded } = keyphase.state;
  const own = { doc, selected, current, view, clock, dark, hidden: [...hidden] };
  return JSON.stringify({ ...own, folded: [...folded] });
}"""
"""What a page shows of its own."""


def test_what_is_done_in_one_moves_nothing_in_another_with_another_recording(
    folder: Path, serve: Serve, visit: Visit
) -> None:
    server = serve(folder / "setup1.npz", folder / "synthetic_setup1.npz")
    one, other = visit(server, (1280, 720)), visit(server, (1280, 720), dark=True)
    for page in (one, other):
        page.wait_for_document()
    other.press("PageDown")
    other.until("keyphase.state.document.name.startsWith('synthetic')")
    other.wait_for_document()
    for page in (one, other):
        page.wait_for_scene()
        page.settle()
    seen = _still(other, "other_before")
    shown, scene = other.page.evaluate(OWN), other.box("#scene")
    mine = one.page.evaluate(OWN)

    _go_about(one)

    assert one.page.evaluate(OWN) != mine
    other.wait_for_scene()
    after = _still(other, "other_after")
    assert other.page.evaluate(OWN) == shown
    changed = np.abs(after.pixels - seen.pixels).max(axis=2) > 24
    left, top = int(scene.x), int(scene.y)
    within = changed[top : top + int(scene.height), left : left + int(scene.width)]
    assert within.mean() < 0.001
    journals = [path.name for path in folder.glob(".keyphase/*.journal")]
    assert [name.startswith("setup1") for name in journals] == [True]


def _go_about(page: KeyphasePage) -> None:
    """Chooses, drops, zooms, tunes, hides the robot, turns to the other theme, plays on and on."""
    page.change(lambda: page.press("x"))
    for key in ("]", "]", "+", "+", "End", "n"):
        page.press(key)
    page.page.locator("#theme").click()
    page.until("document.documentElement.dataset.theme === 'dark'")
    page.page.get_by_role("checkbox", name="Robot").uncheck()
    page.set_parameter("force_threshold", 0.9)
    page.settle()


def _still(page: KeyphasePage, name: str) -> Picture:
    """The picture that does not change any more."""
    page.page.mouse.move(0, 0)
    page.settle()
    last = page.picture(name)

    def stands(now: Picture) -> bool:
        nonlocal last
        same, last = bool((now.pixels == last.pixels).all()), now
        return same

    page.page.wait_for_timeout(1500)
    return page.until_seen(name, stands)


def test_two_windows_see_the_same_document_at_once(
    folder: Path, serve: Serve, visit: Visit
) -> None:
    server = serve(folder / "setup1.npz")
    one, other = visit(server, scene=False), visit(server, scene=False)
    one.wait_for_document()
    other.wait_for_document()
    one.press("Home")
    one.press(".")
    other.change(lambda: one.press("Delete"))
    other.until("keyphase.state.current === null")
    one.change(lambda: other.page.locator("#undo").click())

    assert one.document["boundaries"] == other.document["boundaries"]
    assert one.boundaries.count() == other.boundaries.count() == 4

    other.press("]")
    other.until("keyphase.state.selected === 0")
    one.page.locator(".segment-other", has_text="Page 2").wait_for()
    one.settle()
    one.picture("where_the_other_is")
    assert other.page.locator(".segment-other").count() == 0
    other.press("Escape")
    one.until("!document.querySelector('.segment-other')")


def test_a_page_opened_for_looking_looks_and_changes_nothing(
    folder: Path, serve: Serve, visit: Visit
) -> None:
    page = visit(serve(folder / "setup1.npz", read_only=True), scene=False)
    page.wait_for_document()
    page.settle()
    page.picture("looking")
    assert "for looking" in page.text("#banners")
    assert page.text("#saved") == "Read only"
    assert page.page.locator("#add-recording").is_hidden()

    before = page.state("view")
    page.press("+")
    page.until(f"keyphase.state.view.to < {before['to']}")
    for key in ("]", "End", "x", "t", "i", "Control+z"):
        page.press(key)
    _try_to_drag_a_boundary(page)
    assert page.state("selected") == 0
    assert page.page.locator(".notice").count() == 0
    assert page.document["edits"] == 0
    assert not list(folder.glob(".keyphase/*.journal"))


def _try_to_drag_a_boundary(page: KeyphasePage) -> None:
    row = page.row("boundaries")
    start = (page.x(page.document["boundaries"][1]["time_s"]), row.y + row.height / 2)
    page.drag(start, (start[0] + 40, start[1]))
    page.settle()
