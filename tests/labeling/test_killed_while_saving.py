"""A writer that is killed loses nothing that it had confirmed."""

import pytest
from handmade import demonstration
from killing import kill_once


@pytest.mark.slow
def test_kills_at_random_moments_lose_at_most_the_edit_under_way(tmp_path):
    recording = tmp_path / "demo.npz"
    demonstration(path=recording)
    saves = 0
    for seed in range(6):
        aftermath = kill_once(recording, seed)
        assert aftermath.is_safe, (seed, aftermath)
        saves += aftermath.saves
    assert saves > 20
