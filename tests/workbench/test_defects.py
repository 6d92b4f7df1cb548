"""Whatever one recording leads keyphase to, the others go on, and it is named."""

from pathlib import Path

import pytest

from keyphase.labeling.storage.summary import JournalSummary, summarize
from keyphase.workbench.recording_list import RecordingList


def test_a_defect_over_one_recording_is_told_in_its_line_and_the_list_goes_on(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def fails(path: Path) -> JournalSummary:
        if path.name == "b.npz":
            raise ZeroDivisionError("by nothing")
        return summarize(path)

    monkeypatch.setattr("keyphase.workbench.recordings.summarize", fails)
    found = RecordingList([tmp_path / f"{name}.npz" for name in "abc"], lambda _: None)
    assert [line.error is None for line in found.recordings] == [True, False, True]
    assert "b.npz: something is wrong inside keyphase" in str(found.recordings[1].error)
