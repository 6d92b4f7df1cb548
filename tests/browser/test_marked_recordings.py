"""Success or failure, quality and notes, of a recording or a segment: said, seen and sought."""

from driver import KeyphasePage


def test_a_recording_is_marked_in_the_panel_and_found_by_it_in_the_list(two: KeyphasePage) -> None:
    two.change(lambda: two.panel.get_by_label("Outcome", exact=True).select_option("failure"))
    two.change(lambda: two.panel.get_by_label("Quality", exact=True).select_option("2"))
    note = two.panel.get_by_label("Note", exact=True)
    note.fill("peg dropped")
    two.change(lambda: note.press("Enter"))
    assert two.document["assessment"] == {
        "outcome": "failure",
        "quality": 2,
        "note": "peg dropped",
    }
    mark = two.page.locator(".queue-assessed")
    mark.wait_for()
    assert mark.get_attribute("aria-label") == "failure, quality 2 of 5, peg dropped"
    two.picture("assessment_light")

    rows, field = two.page.locator(".queue-row"), two.page.locator("#queue-filter")
    for sought, found in (("is:failure", 1), ("is:unmarked", 1), ("quality:3", 0), ("dropped", 1)):
        field.fill(sought)
        two.until(f"document.querySelectorAll('.queue-row').length === {found}")
    field.fill("")
    two.until("document.querySelectorAll('.queue-row').length === 2")
    assert rows.count() == 2
    two.page.locator(".surface").focus()
    two.change(lambda: two.press("Control+z"))
    assert two.document["assessment"]["note"] == ""

    two.press("]")
    two.panel.get_by_text("Segment 1", exact=True).click()
    two.change(lambda: two.panel.get_by_label("Outcome of the segment").select_option("failure"))
    two.page.locator(".segment-mark.failure").wait_for()
    two.press("Shift+ArrowRight")
    two.change(lambda: two.panel.get_by_label("Quality of the segment").select_option("4"))
    said = [segment["assessment"] for segment in two.document["segments"][:3]]
    assert [(one["outcome"], one["quality"]) for one in said] == [
        ("failure", 4),
        ("failure", 4),
        (None, None),
    ]
    two.picture("marked_segments")
    for sought, found in (("segment:failure", 1), ("segment:success", 0)):
        field.fill(sought)
        two.until(f"document.querySelectorAll('.queue-row').length === {found}")
    field.fill("")
