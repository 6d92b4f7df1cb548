"""The fit of the weights: the same recordings give the same file."""

import json

import pytest

from keyphase.commands.fit import FitWeights


@pytest.mark.slow
def test_the_same_count_and_seed_give_the_same_bytes(tmp_path):
    files = [tmp_path / "once.json", tmp_path / "again.json"]
    for file in files:
        assert FitWeights(file, count=1, seed=3, families=("press", "snap", "reach")).run() == 0
    assert files[0].read_bytes() == files[1].read_bytes()
    content = json.loads(files[0].read_text())
    assert content["provenance"]["recordings"] == 3
    for kind in ("contact", "motion"):
        assert 0.0 < content["calibration"][kind]["line"] < 1.0
