"""The number of boundaries that is told for each place of a line is the number that comes."""

from bisect import bisect_left
from dataclasses import replace
from typing import Any

import pytest

from keyphase.files.shipped import shipped
from keyphase.readers import read
from keyphase.segmentation import Parameters, Segmenter

LINES = (0.01, 0.05, 0.2, 0.4, 0.6, 0.8, 0.9, 0.97, 0.99)


@pytest.fixture(scope="module", params=["setup1", "synthetic_setup1", "wipe"])
def segmenter(request: pytest.FixtureRequest) -> Segmenter:
    return Segmenter(read(shipped("data") / f"{request.param}.npz"))


@pytest.mark.slow
@pytest.mark.parametrize("turns", ["none", "all"])
def test_what_is_told_for_a_line_is_what_comes(segmenter: Segmenter, turns: Any) -> None:
    parameters = Parameters(turns=turns)
    told = segmenter.segment(parameters).line_counts
    assert [each.parameter for each in told] == ["force_threshold", "motion_threshold"]
    for each in told:
        assert len(each.counts) == len(each.steps) + 1
        sides = (step + side for step in each.steps for side in (-1e-9, 1e-9))
        for line in (*LINES, *sides):
            moved = replace(parameters, **{each.parameter: line})
            expected = each.counts[bisect_left(each.steps, line)]
            assert len(segmenter.segment(moved).boundaries) == expected


def test_what_a_filter_holds_back_comes_when_it_is_let_go(segmenter: Segmenter) -> None:
    strict = Parameters(turns="none", least_step_N=4.0, force_threshold=0.1, motion_threshold=0.1)
    found = segmenter.segment(strict)
    for each in found.held_back:
        freed = segmenter.segment(replace(strict, **{each.parameter: each.free}))
        assert len(freed.boundaries) == len(found.boundaries) + each.count
    assert segmenter.segment(replace(strict, turns="all", least_step_N=0.0)).held_back == ()
