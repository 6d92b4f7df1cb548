"""A task of ten recordings, named by keys alone: what was done to the first arrives on the others.

Each is the bundled demonstration at another pace, in another place and with noise of its own, so
that it is known where its phases end.
"""

from pathlib import Path
from typing import Any

import numpy as np
from driver import KeyphasePage, Serve, Visit
from numpy.typing import NDArray
from ten_recordings import NAMES, paced, ten_recordings

from keyphase.files.shipped import shipped
from keyphase.readers import read

MOST_PRESSES = 4
TOLERANCE_S = 0.15


_COUNTS = """() => {
  window.presses = 0;
  const count = ({ key }) => { if (key !== "Shift") window.presses += 1; };
  addEventListener("keydown", count, true);
}"""


def _name_the_first(page: KeyphasePage) -> None:
    for name in NAMES:
        page.press("]")
        while not page.document["segments"][page.state("selected")]["kept"]:
            page.press("]")
        page.press("l")
        page.until("keyphase.state.renaming !== null && !document.getElementById('rename').hidden")
        page.page.keyboard.type(name)
        page.change(lambda: page.press("Enter"))
    page.change(lambda: page.press("i"))


def _settle(page: KeyphasePage, truth: NDArray[np.float64]) -> tuple[int, dict[str, Any]]:
    """How often a person presses a key in the recording that is open, and what it is then."""
    name = page.document["name"]
    line = f"keyphase.state.recordings.items.find(one => one.name === '{name}')"
    page.until(f"{line}.proposed_from.length")
    page.page.evaluate("() => { window.presses = 0; }")
    page.change(lambda: page.press("Shift+Enter"))
    while any(boundary["unsure"] for boundary in page.document["boundaries"]):
        page.until("keyphase.state.current !== null")
        time_s = page.document["boundaries"][page.state("current")]["time_s"]
        is_there = np.abs(truth - time_s).min() <= TOLERANCE_S
        page.change(lambda key="Enter" if is_there else "Delete": page.press(key))
    settled = page.document
    page.press("k")
    page.until(f"{line}.state === 'done'")
    return page.page.evaluate("() => window.presses"), settled


def test_ten_recordings_of_a_task_take_four_keys_each_after_the_first(
    tmp_path: Path, serve: Serve, visit: Visit
) -> None:
    paces = ten_recordings(tmp_path)
    page = visit(serve(tmp_path), size=(1280, 720), scene=False)
    page.wait_for_document()
    page.page.evaluate(_COUNTS)
    _name_the_first(page)
    first = page.document
    ends = np.array([one["time_s"] for one in first["boundaries"]])
    whole_s = read(shipped("data") / "setup1.npz").duration_s
    page.press("k")
    presses = []
    for number, (pace, uneven) in enumerate(paces[1:], start=1):
        page.until(f"keyphase.state.document.name === 'take_{number:02d}'")
        truth = paced(pace, uneven, ends, whole_s)
        pressed, settled = _settle(page, truth)
        presses.append(pressed)
        found = np.array([one["time_s"] for one in settled["boundaries"]])
        np.testing.assert_allclose(found, truth, atol=TOLERANCE_S)
        for one, same in zip(settled["segments"], first["segments"], strict=True):
            assert one["label"] == same["label"]
            assert one["kept"] == same["kept"]
    assert max(presses) <= MOST_PRESSES
    assert min(presses) < max(presses)
    page.until("keyphase.state.recordings.items.every(one => one.state === 'done')")
