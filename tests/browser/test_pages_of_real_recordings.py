"""Recordings of real robots open, segment and show."""

import shutil
from pathlib import Path

import pytest
from driver import SEGMENT_COLORS, Serve, Visit

SETS = {
    "lund_yumi": {"force", "position"},
    "hiro_snap_assembly": {"force", "position"},
    "lasa_peeling": {"force", "position"},
}


@pytest.mark.parametrize("name", SETS)
def test_a_real_recording_opens_segments_and_shows(
    name: str, real_data: Path, tmp_path: Path, serve: Serve, visit: Visit
) -> None:
    folder = tmp_path / name
    folder.mkdir()
    for recording in sorted((real_data / name).glob("*.npz"))[:4]:
        shutil.copy(recording, folder)
    page = visit(serve(folder))
    page.page.set_default_timeout(90_000)
    page.wait_for_document()
    page.wait_for_scene()
    page.until("keyphase.state.recordings.items.every(item => item.strip.length || item.error)")
    page.settle()
    picture = page.picture(f"real_{name}")
    document = page.document
    assert set(document["channels"]) >= SETS[name]
    assert page.segments.count() == len(document["segments"]) > 1
    kept = [segment for segment in document["segments"] if segment["kept"]]
    assert kept
    band = page.row("segments")
    for segment in kept:
        color = SEGMENT_COLORS[segment["color"] % len(SEGMENT_COLORS)]
        assert picture.count(color, band) > 20
