"""A killed server has lost nothing that it had confirmed."""

from pathlib import Path

import pytest
from killing_server import kill_once


@pytest.mark.slow
def test_a_server_killed_while_edits_stream_in_keeps_all_it_confirmed(own_copy: Path) -> None:
    for seed in range(3):
        after = kill_once(own_copy, seed)
        for left in own_copy.parent.glob(".keyphase/*.journal*"):
            left.unlink()
        assert after.confirmed > 0
        assert after.is_safe, after
