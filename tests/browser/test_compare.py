"""Two segmentations of one recording on the timeline, and taking the other over."""

from pathlib import Path

import pytest
from driver import KeyphasePage, LookAt

from keyphase.labeling.document import Document
from keyphase.labeling.edits import Add, Edit, Label, Remove
from keyphase.labeling.label import label
from keyphase.labeling.segment_file import write_segment_file
from keyphase.readers import read
from keyphase.segmentation import Segmenter


@pytest.fixture
def annas(folder: Path) -> None:
    """Anna has segmented the recording, too, before it is opened."""
    _write_annas(folder / "setup1.npz", folder / "setup1.anna.segments.json")


@pytest.fixture
def with_annas(annas: None, editor: KeyphasePage) -> KeyphasePage:
    """The page on a recording that Anna has segmented, too."""
    editor.until("keyphase.state.comparison")
    return editor


def _write_annas(recording: Path, path: Path) -> None:
    demonstration = read(recording)
    segmentation = Segmenter(demonstration).segment()
    document, labeling = Document(demonstration), label(segmentation)
    edits: list[Edit] = [
        Remove(labeling.boundaries[1].time_s),
        Add(0.5 * (demonstration.start_s + labeling.boundaries[0].time_s)),
        Label(demonstration.start_s, "wait"),
        Label(demonstration.end_s, "slide"),
    ]
    for edit in edits:
        document = document.apply(edit, labeling)
        labeling = label(segmentation, document.edits)
    write_segment_file(labeling, path)


def test_compared_with_the_program_by_keys(editor: KeyphasePage) -> None:
    editor.change(lambda: editor.page.evaluate("() => keyphase.actions.addBoundary(0.6)"))
    editor.press("g")
    editor.page.locator(".other-segment").first.wait_for()
    assert editor.page.locator(".only-first").count() == 1
    assert editor.text("[data-gutter=comparison]").startswith("Program’s own F1 0.")

    editor.press("j")
    editor.until("Math.abs(keyphase.state.clock - 0.6) < 1e-6")
    editor.press("g")
    editor.until("!keyphase.state.comparison?.with")
    editor.settle()
    assert editor.page.locator(".other-segment").count() == 0


def test_compared_with_another_person_by_mouse(with_annas: KeyphasePage) -> None:
    page = with_annas
    page.page.get_by_role("button", name="Tracks").click()
    page.page.get_by_role("menuitemcheckbox", name="setup1.anna").click()
    page.page.locator(".other-segment").first.wait_for()
    page.settle()
    page.picture("comparison")

    assert page.page.locator(".only-first").count() == 1
    assert page.page.locator(".only-second").count() == 1
    assert "setup1.anna" in page.text("[data-gutter=comparison]")
    page.page.get_by_role("button", name="Compare no longer").click()
    page.until("!keyphase.state.comparison?.with")


def test_an_edit_changes_the_score(with_annas: KeyphasePage) -> None:
    page = with_annas
    page.page.evaluate("() => keyphase.actions.compare('setup1.anna.segments.json')")
    page.until("keyphase.state.comparison?.with")
    before = page.state("comparison")["f1"]
    extra = page.state("comparison")["only_first_s"][0]
    page.page.evaluate(
        "t => keyphase.actions.send({type: 'edit', edit: {kind: 'remove', time_s: t}})", extra
    )
    page.until(f"keyphase.state.comparison.f1 > {before}")


def test_anothers_segmentation_is_taken_over_and_undone_in_one_step(
    with_annas: KeyphasePage,
) -> None:
    page = with_annas
    before = page.labels()
    page.press("Control+k")
    page.page.keyboard.type("compare with setup1.anna")
    page.press("Enter")
    page.until("keyphase.state.comparison?.with")
    page.press("Control+k")
    page.page.keyboard.type("take over")
    page.change(lambda: page.press("Enter"))

    assert page.labels()[0] == "wait"
    assert page.labels()[-1] == "slide"
    page.until("keyphase.state.comparison.f1 === 1")
    page.settle()
    page.picture("taken_over")
    page.change(lambda: page.press("Control+z"))
    assert page.labels() == before


def test_anothers_segmentation_is_taken_over_by_clicks(with_annas: KeyphasePage) -> None:
    page = with_annas
    page.page.get_by_role("button", name="Tracks").click()
    page.page.get_by_role("menuitemcheckbox", name="setup1.anna").click()
    page.until("keyphase.state.comparison?.with")
    page.page.locator("#command-field").click()
    command = page.page.locator("#palette li", has_text="Take over what is compared")
    page.change(lambda: command.click())

    assert page.labels()[0] == "wait"


def test_it_is_readable_in_the_dark_and_small(annas: None, folder: Path, look_at: LookAt) -> None:
    page = look_at(folder / "setup1.npz")
    page.resize(1280, 720)
    page.set_theme(dark=True)
    page.page.evaluate("() => keyphase.actions.compare('setup1.anna.segments.json')")
    page.page.locator(".other-segment").first.wait_for()
    page.settle()
    page.picture("comparison_dark_1280")

    assert page.text("[data-gutter=comparison]").count("F1") == 1
    page.resize(800, 600)
    names = page.page.locator(".other-label").all_text_contents()
    assert any(len(name) > 3 and name.endswith("…") for name in names), names
