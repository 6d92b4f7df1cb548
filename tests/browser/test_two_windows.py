"""Two windows on one server, and a window that may only look."""

from pathlib import Path

from driver import KeyphasePage, Serve, Visit


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
