"""When a skill is over, in Chromium: shown, changed, undone, and told where it is doubted."""

from driver import KeyphasePage


def lane(page: KeyphasePage) -> list[str]:
    """What stands above the segments that are executed."""
    return page.page.locator(".skills .skill title").all_text_contents()


def chip(page: KeyphasePage) -> str:
    return page.text("#plan .chip.on .chip-text")


def test_an_end_condition_is_changed_like_anything_else(editor: KeyphasePage) -> None:
    page, segments = editor, editor.document["segments"]
    contact = next(k for k, s in enumerate(segments) if s["end_condition"]["kind"] == "contact")
    page.page.locator(f"#plan .chip >> text={contact + 1}").first.click()
    page.settle()
    proposed = segments[contact]["end_condition"]
    assert f"ends at {proposed['threshold_N']:.1f} N" in chip(page)

    page.panel.get_by_text("Ends when").click()
    threshold = page.panel.get_by_label("Threshold, N")
    page.change(lambda: (threshold.fill("5"), threshold.press("Enter")))
    assert "ends at 5.0 N" in chip(page)
    kept = sum(segment["kept"] for segment in segments)
    assert len(lane(page)) == kept
    assert sum("ends at 5.0 N" in one for one in lane(page)) == 1

    up = page.panel.get_by_label("Direction z")
    page.change(lambda: (up.fill("-1"), up.press("Enter")))
    assert page.document["segments"][contact]["end_condition"]["agrees"] is False
    assert "its demonstration does not" in chip(page)
    assert "does not end so" in page.panel.inner_text()
    page.picture("end_condition")

    page.change(lambda: page.panel.get_by_label("Ends at").select_option("configuration"))
    assert "ends at the pose" in chip(page)
    page.change(lambda: page.panel.get_by_role("button", name="As proposed").click())
    again = page.document["segments"][contact]["end_condition"]
    assert again["threshold_N"] == proposed["threshold_N"]
    page.change(lambda: page.press("Control+z"))
    assert "ends at the pose" in chip(page)
    page.change(lambda: page.press("r"))
    assert lane(page)[1].startswith("Skill 2, 3: ")
