"""Every kind of file keyphase reads, mutated: it is read as others read it, or refused."""

from pathlib import Path

import pytest

BENCHMARKS = Path(__file__).parents[1] / "benchmarks"

pytestmark = pytest.mark.slow


def test_six_hundred_mutated_files_are_read_as_others_do_or_refused_in_a_line(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.syspath_prepend(BENCHMARKS)
    from fuzz_files import fuzz

    counts, faults = fuzz(600, seed=0)

    assert faults == []
    assert sum(counts.values()) == 600
    kinds = {kind for kind, _ in counts}
    assert len(kinds) == 30
    assert sum(counts[kind, "read"] for kind in kinds) > 60
    assert sum(counts[kind, "refused"] for kind in kinds) > 300
