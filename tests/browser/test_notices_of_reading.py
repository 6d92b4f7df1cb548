"""What is odd about a recording, and stretches without data, are seen on the page."""

from pathlib import Path

from driver import KeyphasePage, LookAt

from odd_recordings import KINDS, save_odd_recordings


def _listed(page: KeyphasePage) -> str:
    """The notes on reading, as the count beside the file's facts opens them."""
    page.page.locator("#read-notices").click()
    listed = page.text("#read-notices-list")
    page.press("Escape")
    return listed


def test_every_oddity_is_counted_and_listed(tmp_path: Path, look_at: LookAt) -> None:
    save_odd_recordings(tmp_path)
    page = look_at(*(tmp_path / f"{name}.npz" for name in KINDS))
    for name, (_, said) in KINDS.items():
        page.until(f"keyphase.state.document?.name === '{name}' && keyphase.state.whole")
        count = page.page.locator("#read-notices-count")
        count.wait_for()
        assert int(count.inner_text()) >= 1, name
        assert said in _listed(page), name
        page.press("PageDown")


def test_a_gap_is_hatched_and_says_so_under_the_pointer(tmp_path: Path, look_at: LookAt) -> None:
    save_odd_recordings(tmp_path)
    page = look_at(tmp_path / "gap.npz")
    row = page.row("segments")
    page.page.mouse.move(page.x(4.7), row.y + row.height / 2)
    page.page.wait_for_selector(".surface[title*='without data']")
    assert page.page.locator("rect.break").count() == 1
    page.picture("gap")
