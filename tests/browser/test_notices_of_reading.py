"""What was done on reading, and stretches without data, are seen on the page."""

import numpy as np
from driver import Serve, Visit

from keyphase.demonstration import Demonstration
from keyphase.readers import save_npz


def test_notes_on_reading_are_counted_and_a_gap_is_hatched(tmp_path, serve: Serve, visit: Visit):
    time = np.arange(400) / 100.0
    way = np.column_stack([0.1 * time, 0.0 * time, 0.3 + 0.0 * time])
    gap = Demonstration("gap", time + 1.5 * (time > 2), way)
    save_npz(gap, tmp_path / "gap.npz")

    page = visit(serve(tmp_path / "gap.npz"), scene=False)
    page.wait_for_document()
    assert page.text("#read-notices-count") == "2"
    assert "low" in (page.page.locator("#read-notices").get_attribute("class") or "")
    page.page.locator("#read-notices").click()
    assert "1.51 s without data at 2.00 s" in page.text("#read-notices-list")
    page.page.keyboard.press("Escape")

    row = page.row("segments")
    page.page.mouse.move(page.x(2.7), row.y + row.height / 2)
    page.page.wait_for_selector(".surface[title*='without data']")
    assert page.page.locator("rect.break").count() == 1
    page.picture("gap")
