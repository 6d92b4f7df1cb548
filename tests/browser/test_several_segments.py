"""Several segments in a row chosen at once: named, dropped and merged as one step each."""

from driver import KeyphasePage


def _choose(page: KeyphasePage, first: int, last: int) -> None:
    page.click(page.middle_of(first))
    page.page.keyboard.down("Shift")
    page.click(page.middle_of(last))
    page.page.keyboard.up("Shift")
    page.until(f"keyphase.state.selectedTo === {last}")
    page.settle()


def test_a_click_with_shift_chooses_all_between_and_a_name_goes_to_each(
    editor: KeyphasePage,
) -> None:
    before = editor.labels()
    _choose(editor, 1, 3)
    assert editor.page.locator(".segment-ring").count() == 3
    editor.press("l")
    editor.page.locator("#rename input").wait_for()
    editor.page.keyboard.type("Approach")
    editor.change(lambda: editor.press("Enter"))
    assert editor.labels() == [before[0], *["Approach"] * 3, *before[4:]]
    assert editor.document["undo"] == "Label segments 2 to 4 “Approach”"
    editor.change(lambda: editor.press("Control+z"))
    assert editor.labels() == before


def test_shift_and_arrows_choose_and_drop_and_merge_take_all(editor: KeyphasePage) -> None:
    count = len(editor.document["segments"])
    kept = [one["kept"] for one in editor.document["segments"]]
    editor.click(editor.middle_of(0))
    for _ in range(3):
        editor.press("Shift+ArrowRight")
    editor.press("Shift+ArrowLeft")
    editor.until("keyphase.state.selectedTo === 2")
    selected = "[id^=outline-segment][aria-selected=true]"
    editor.until(f"document.querySelectorAll('{selected}').length === 3")

    editor.change(lambda: editor.press("x"))
    assert [one["kept"] for one in editor.document["segments"]] == [*[False] * 3, *kept[3:]]
    editor.change(lambda: editor.press("Control+z"))
    assert [one["kept"] for one in editor.document["segments"]] == kept

    editor.change(lambda: editor.press("m"))
    assert len(editor.document["segments"]) == count - 2
    assert editor.state("selectedTo") is None
    editor.change(lambda: editor.press("Control+z"))
    assert len(editor.document["segments"]) == count


def test_another_choice_or_escape_leaves_one_or_none(editor: KeyphasePage) -> None:
    _choose(editor, 0, 2)
    editor.click(editor.middle_of(1))
    editor.until("keyphase.state.selected === 1 && keyphase.state.selectedTo === null")
    _choose(editor, 1, 3)
    editor.press("Escape")
    editor.until("keyphase.state.selected === null && keyphase.state.selectedTo === null")
