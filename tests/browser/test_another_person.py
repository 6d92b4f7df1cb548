"""Another person's segments beside the recordings: J visits every moment at which two differ."""

import shutil
from pathlib import Path

import pytest
from driver import Serve, Visit

from keyphase.cli import main
from keyphase.files.shipped import shipped


def test_j_visits_every_difference_of_all_recordings(
    tmp_path: Path, serve: Serve, visit: Visit
) -> None:
    mine, other = tmp_path / "mine", tmp_path / "other"
    mine.mkdir()
    for name in ("a", "b", "c"):
        shutil.copy(shipped("data") / "synthetic_setup1.npz", mine / f"{name}.npz")
    with pytest.raises(SystemExit):
        main(["segment", str(mine), "--output", str(other)])
    for name in ("a", "c"):
        file = next(other.rglob(f"{name}.segments.json"))
        text = file.read_text().replace("Move down until contact", "Insert")
        file.write_text(text)
    page = visit(serve(mine, beside=other), size=(1280, 720), scene=False)
    page.wait_for_document()
    page.until("keyphase.state.comparison?.with === 'another person'")
    page.until("document.querySelectorAll('.queue-differs').length === 2")
    page.picture("another_person")
    start = next(s for s in page.document["segments"] if s["label"].startswith("Move down"))
    page.press("j")
    page.until(f"Math.abs(keyphase.state.clock - {start['start_s']}) < 0.01")
    page.press("j")
    page.until("keyphase.state.document.name === 'c'")
    page.until("keyphase.state.comparison?.with === 'another person'")
    page.press("j")
    page.until(f"Math.abs(keyphase.state.clock - {start['start_s']}) < 0.01")
