"""A killed server has lost nothing that it had confirmed."""

from pathlib import Path

import pytest
from killing_server import kill_once, write_short_recording
from serving import many_servings


@pytest.mark.slow
def test_a_server_killed_again_and_again_while_edits_stream_in_keeps_all_it_confirmed(
    tmp_path: Path,
) -> None:
    recording = write_short_recording(tmp_path / "run.npz")
    with many_servings() as serve:
        for seed in range(8):
            after = kill_once(recording, seed, serve)
            for left in tmp_path.glob(".keyphase/*.journal*"):
                left.unlink()
            assert after.confirmed > 0
            assert after.is_safe, after
