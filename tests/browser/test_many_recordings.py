"""A folder of recordings: vocabulary, parameters for all, comparison, files dropped on the page."""

import base64
from pathlib import Path

import pytest
from driver import KeyphasePage, Serve, Visit

from keyphase.shipped import shipped

_DROP = """({ name, data }) => {
  const bytes = Uint8Array.from(atob(data), letter => letter.charCodeAt(0));
  const transfer = new DataTransfer();
  transfer.items.add(new File([bytes], name));
  const drop = new DragEvent('drop', { dataTransfer: transfer, bubbles: true, cancelable: true });
  document.body.dispatchEvent(drop);
}"""


@pytest.fixture
def two(folder: Path, serve: Serve, visit: Visit) -> KeyphasePage:
    """The page on a folder of two recordings, the first of them open."""
    page = visit(serve(folder), scene=False)
    page.wait_for_document()
    return page


def test_a_name_once_given_is_a_number_key_in_the_next_recording(two: KeyphasePage) -> None:
    two.change(lambda: two.page.evaluate("() => keyphase.actions.label('Reach', 0)"))
    two.press("PageDown")
    two.until("keyphase.state.document.name === 'synthetic_setup1'")
    two.until("keyphase.state.labels.some(label => label.name === 'Reach')")
    two.press("]")
    two.until("keyphase.state.selected === 0")
    two.change(lambda: two.press("1"))
    assert two.labels()[0] == "Reach"


def test_parameters_are_given_to_all_after_a_look_at_what_would_change(two: KeyphasePage) -> None:
    two.change(lambda: two.page.evaluate("() => keyphase.actions.setThreshold(1e6, false, null)"))
    two.press("Control+k")
    two.page.keyboard.type("parameters to all")
    two.press("Enter")
    two.page.locator("#spread").wait_for()
    two.picture("spread")
    assert "synthetic_setup1" in two.text("#spread")
    two.page.get_by_role("button", name="Apply to all").click()
    two.press("PageDown")
    two.until("keyphase.state.document.name === 'synthetic_setup1'")
    assert two.document["parameters"]["force_threshold"] == 1e6


def test_a_comparison_shows_what_only_one_of_the_two_has(two: KeyphasePage) -> None:
    two.change(lambda: two.page.evaluate("() => keyphase.actions.addBoundary(0.6)"))
    two.page.get_by_role("button", name="Tracks").click()
    two.page.get_by_role("menuitemcheckbox", name="What the program found").click()
    two.page.locator(".other-segment").first.wait_for()
    two.picture("comparison")
    assert two.page.locator(".only-first").count() == 1
    assert two.text("[data-gutter=comparison]").startswith("Compared F1 0.")


def test_a_dropped_file_opens(two: KeyphasePage) -> None:
    data = base64.b64encode((shipped("data") / "setup2.npz").read_bytes()).decode()
    two.page.evaluate(_DROP, {"name": "setup2.npz", "data": data})
    two.until("keyphase.state.document.name.startsWith('setup2')")
    assert two.page.locator(".queue-row").count() == 3


def test_a_dropped_file_that_is_no_recording_is_refused_with_a_reason(two: KeyphasePage) -> None:
    two.page.evaluate(_DROP, {"name": "run.exe", "data": base64.b64encode(b"MZ").decode()})
    two.page.locator(".notice.warning").wait_for()
    assert "run.exe" in two.text(".notice.warning")
