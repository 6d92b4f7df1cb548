"""What the page asks before anything of a person could be lost, or be mistaken for another's."""

import json
from dataclasses import replace
from pathlib import Path

from driver import KeyphasePage, LookAt

from keyphase.labeling.edits import Add
from keyphase.labeling.label import label
from keyphase.labeling.storage.journal import Journal
from keyphase.readers import read, save_npz
from keyphase.segmentation import segment

THEIRS = "written by somebody else"


def test_a_strangers_file_is_kept_replaced_or_left_as_a_person_says(
    folder: Path, editor: KeyphasePage
) -> None:
    file, both = folder / "setup1.segments.json", folder / "setup1_2.segments.json"
    dialog = editor.page.locator("#in-the-way[open]")

    def answer(how: str) -> None:
        file.write_text(THEIRS)
        editor.press("Control+s")
        dialog.get_by_text("setup1.segments.json").wait_for()
        assert "keyphase did not write it" in dialog.inner_text()
        dialog.get_by_role("button", name=how).click()
        dialog.wait_for(state="detached")

    answer("Cancel")
    assert file.read_text() == THEIRS
    assert not both.exists()
    answer("Keep both")
    editor.page.locator(".notice", has_text="setup1_2.segments.json").wait_for()
    assert file.read_text() == THEIRS
    assert json.loads(both.read_text())["segments"]
    answer("Replace")
    editor.page.locator(".notice", has_text="setup1.segments.json").wait_for()
    assert json.loads(file.read_text())["segments"]


def test_a_recording_that_is_done_gets_the_others_parameters_only_where_the_box_says_so(
    two: KeyphasePage,
) -> None:
    done = "() => keyphase.actions.send({ type: 'done', done: true })"
    two.press("PageDown")
    two.until("keyphase.state.document.name === 'synthetic_setup1'")
    two.change(lambda: two.page.evaluate(done))
    two.press("PageUp")
    two.until("keyphase.state.document.name === 'setup1'")
    two.set_parameter("min_distance_s", 2.0)
    states = "keyphase.state.recordings.items.map(({ state }) => state).join()"

    def apply(*, with_done: bool) -> None:
        two.page.evaluate("() => keyphase.actions.spread('look')")
        box = two.page.get_by_label("Also the 1 that is done")
        box.set_checked(with_done)
        button = two.page.locator("#spread button:enabled", has_text="Apply to all")
        button.wait_for()
        button.click()

    apply(with_done=False)
    two.page.locator(".notice", has_text="All recordings").wait_for()
    assert two.page.evaluate(f"() => {states}") == "touched,done"
    apply(with_done=True)
    two.until(f"{states} === 'touched,touched'")


def test_a_recording_that_is_changed_after_it_was_done_says_so_until_it_is_done_again(
    editor: KeyphasePage,
) -> None:
    badge, row = editor.page.locator("#badge"), editor.page.locator(".queue-row svg.state")
    editor.change(lambda: editor.press("Shift+K"))
    assert badge.inner_text() == "done · 1 edit"
    editor.change(lambda: editor.page.evaluate("() => keyphase.actions.label('reach', 0)"))
    assert badge.inner_text() == "changed since done · 2 edits"
    row.and_(editor.page.get_by_label("changed since done")).wait_for()
    editor.change(lambda: editor.press("Shift+K"))
    assert badge.inner_text().startswith("done")
    row.and_(editor.page.get_by_label("done", exact=True)).wait_for()


def test_edits_of_a_recording_that_was_renamed_are_offered_and_taken_over(
    tmp_path: Path, folder: Path, look_at: LookAt
) -> None:
    # Bytes of its own: to copies of others, in tests that follow, nothing is offered.
    labeled = folder / "own.npz"
    save_npz(replace(read(folder / "setup1.npz"), metadata={"of": "its own"}), labeled)
    demonstration = read(labeled)
    with Journal(demonstration) as journal:
        labeling = label(segment(demonstration))
        journal.save(journal.document.apply(Add(1.0), labeling))
    page = look_at(labeled.rename(tmp_path / "renamed.npz"))
    offer = page.page.locator(".banner", has_text="labeled as own.npz (1 edit)")
    page.change(lambda: offer.get_by_role("button", name="Take the edits over").click())
    offer.wait_for(state="detached")
    assert page.document["edits"] == 1
