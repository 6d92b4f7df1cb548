"""Whoever opens an odd recording is told on the page, before labeling it."""

from pathlib import Path

from two_pages import TalkingPage

from keyphase.workbench.workbench import Settings, Workbench
from odd_recordings import KINDS, save_odd_recordings


def test_each_oddity_is_told_and_whether_it_is_a_warning(tmp_path: Path) -> None:
    save_odd_recordings(tmp_path)
    workbench = Workbench(sorted(tmp_path.glob("*.npz")), Settings(folder=tmp_path))
    page = TalkingPage(workbench, "page")
    for name, (_, said) in KINDS.items():
        told = [one["severity"] for one in page.open(name)["notices"] if said in one["text"]]
        assert set(told) == {"note" if name == "constant" else "warning"}
    workbench.close()
