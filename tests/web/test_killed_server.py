"""A killed server has lost nothing that it had confirmed."""

from pathlib import Path

import pytest
from killing_server import kill_once
from serving import many_servings


@pytest.mark.slow
def test_a_server_killed_twenty_times_while_edits_stream_in_keeps_all_it_confirmed(
    own_copy: Path,
) -> None:
    with many_servings() as serve:
        for seed in range(20):
            after = kill_once(own_copy, seed, serve)
            for left in own_copy.parent.glob(".keyphase/*.journal*"):
                left.unlink()
            assert after.confirmed > 0
            assert after.is_safe, after
