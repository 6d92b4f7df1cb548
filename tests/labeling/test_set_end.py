"""A person says when a segment is over, as any other edit."""

import numpy as np
import pytest

from keyphase.demonstration import Demonstration
from keyphase.errors import LabelingError
from keyphase.labeling.edits import SetEnd, edit_as_json, edit_from_json
from keyphase.labeling.label import label
from keyphase.segmentation import Segmenter
from keyphase.segmentation.end_condition import ConfigurationEnd, ContactEnd

CONTACT = {"kind": "contact", "direction": [0.0, 0.0, 1.0], "threshold_N": 3.0}


@pytest.fixture(scope="module")
def segmenter():
    """Down 0.1 m until 6 N are met, then pressing."""
    time = np.arange(1000) / 250.0
    way = np.clip((time - 0.5) / 1.5, 0.0, 1.0)
    position = np.c_[np.zeros((1000, 2)), 0.3 - 0.1 * way * way * (3.0 - 2.0 * way)]
    force = np.where(time[:, None] > 2.0, (0.0, 0.0, 6.0), 0.0)
    force = force + 0.02 * np.random.default_rng(0).normal(size=force.shape)
    return Segmenter(Demonstration("lowered", time, position, force_N=force))


def labeled(segmenter, *edits):
    segmentation = segmenter.segment()
    made = {}
    for number, edit in enumerate(edits):
        seen = label(segmentation, made, segmenter.segment_between)
        made[number] = edit_from_json(edit_as_json(edit)).anchored(seen)
    return label(segmentation, made, segmenter.segment_between)


def test_a_segment_ends_as_a_person_says(segmenter):
    end = {**CONTACT, "threshold_N": 2.0, "offset_m": 0.005, "timeout_s": 4.0}
    seen = labeled(segmenter, SetEnd(1.5, end))
    segment = seen.segments[seen.segment_at(1.5)]
    expected = ContactEnd((0.0, 0.0, 1.0), 2.0, agrees=True, offset_m=0.005, timeout_s=4.0)
    assert segment.end_condition == expected


def test_a_condition_that_its_demonstration_never_meets_says_so(segmenter):
    seen = labeled(segmenter, SetEnd(1.5, {**CONTACT, "threshold_N": 60.0}))
    condition = seen.segments[seen.segment_at(1.5)].end_condition
    assert isinstance(condition, ContactEnd)
    assert condition.agrees is False


def test_the_latest_one_wins_and_none_gives_back_the_proposed_one(segmenter):
    loose = {"kind": "configuration", "position_tolerance_m": 0.02, "rotation_tolerance_rad": 0.1}
    once = labeled(segmenter, SetEnd(1.5, CONTACT), SetEnd(1.5, loose))
    assert once.segments[once.segment_at(1.5)].end_condition == ConfigurationEnd(0.02, 0.1)
    back = labeled(segmenter, SetEnd(1.5, loose), SetEnd(1.5))
    own = labeled(segmenter)
    at = own.segment_at(1.5)
    assert back.segments[at].end_condition == own.segments[at].end_condition


def test_the_edit_is_named_by_what_it_did(segmenter):
    seen = labeled(segmenter)
    number = seen.segment_at(1.5) + 1
    assert SetEnd(1.5, CONTACT).step_name(seen) == f"End segment {number} at 3.0 N"
    assert SetEnd(1.5).step_name(seen) == f"Give segment {number} its proposed end"


@pytest.mark.parametrize(
    "end",
    [
        {"kind": "other"},
        {"kind": "contact", "threshold_N": 3.0},
        {**CONTACT, "direction": [0.0, 0.0, 2.0]},
        {**CONTACT, "threshold_N": -1.0},
        {**CONTACT, "timeout_s": 0.0},
        {**CONTACT, "threshold_N": "much"},
    ],
)
def test_what_is_no_end_condition_is_refused(end):
    with pytest.raises(LabelingError, match="end condition"):
        edit_from_json({"kind": "end", "time_s": 1.0, "end": end})
