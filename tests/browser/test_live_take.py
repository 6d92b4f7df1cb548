"""While a take is recorded the timeline shows it, and the recording when it has ended."""

from pathlib import Path

from driver import Serve, Visit

from keyphase.readers import read


def test_the_timeline_shows_the_take_while_it_is_recorded_and_it_is_cut_afterwards(
    tmp_path: Path, serve: Serve, visit: Visit
) -> None:
    page = visit(serve(folder=tmp_path), size=(1280, 720), scene=False)
    page.until("keyphase.state.record")
    page.panel.get_by_role("tab", name="Record").click()
    page.page.evaluate("keyphase.store.set({ notice: { level: 'info', text: 'Of before' } })")
    page.page.locator(".notice").wait_for()
    page.panel.get_by_role("button", name="Record", exact=True).click()
    page.until("keyphase.state.take?.times.length > 5")
    live = page.page.locator(".take")
    assert "Recording setup1" in live.inner_text()
    assert "A take is being recorded" in page.text("#plan")
    assert page.page.locator(".notice").count() == 0, "over what is led by hand"
    assert live.locator("polyline").first.get_attribute("points")
    page.picture("live_take")
    row = live.locator(".take-row").first.bounding_box()
    last = live.locator(".take-names").first.locator("span").last.bounding_box()
    assert row
    assert last
    assert last["y"] + last["height"] <= row["y"] + row["height"], "z is cut off"

    live.get_by_role("button", name="Stop").click()
    page.wait_for_document()
    assert live.is_hidden()
    assert page.document["name"] == "setup1_01"
    whole = read(tmp_path / "setup1_01.npz")
    page.page.evaluate(
        "() => keyphase.store.set({ view: { from: 0.2, to: keyphase.state.document.end_s } })"
    )
    page.page.evaluate("() => keyphase.actions.cutToView()")
    page.until("keyphase.state.document.name === 'setup1_01_cut_01'")
    cut = read(tmp_path / "setup1_01_cut_01.npz")
    assert cut.start_s >= 0.2
    assert cut.end_s == whole.end_s
    assert len(read(tmp_path / "setup1_01.npz")) == len(whole)
