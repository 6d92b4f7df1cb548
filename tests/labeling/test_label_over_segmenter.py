"""Edits over what the program really finds, under sliders that really move."""

import pytest

from keyphase.labeling.document import Document
from keyphase.labeling.edits import Add, Label, Move, Remove
from keyphase.labeling.label import label
from keyphase.readers import read
from keyphase.segmentation import Parameters, Segmenter
from keyphase.segmentation.end_condition import ContactEnd


@pytest.fixture(scope="module")
def segmenter(real_data):
    return Segmenter(read(real_data / "hiro_snap_assembly" / "S05.npz"))


def labeled(segmenter, document):
    segmentation = segmenter.segment(document.parameters)
    return label(segmentation, document.edits, segmenter.segment_between)


def test_a_corrected_recording_stays_corrected_when_the_lines_move(segmenter):
    document = Document(segmenter.demonstration)
    seen = labeled(segmenter, document)
    first, second = seen.boundaries[0].time_s, seen.boundaries[1].time_s
    halfway = 0.5 * (seen.segments[0].start_s + first)
    for edit in (Add(halfway), Move(second, second + 0.1), Label(halfway / 2, "reach")):
        document = document.apply(edit, labeled(segmenter, document))
    low = Parameters(force_threshold=0.01, motion_threshold=0.02, turns="all", min_distance_s=0.1)
    many = document.set_parameters(low)
    more = labeled(segmenter, many)
    assert len(more.boundaries) > len(seen.boundaries) + 1
    times = [boundary.time_s for boundary in more.boundaries]
    assert halfway in times
    assert second + 0.1 in times
    assert "reach" in [segment.label for segment in more.segments]
    assert not more.inapplicable
    back = labeled(segmenter, many.undo())
    assert back.segments == labeled(segmenter, document).segments


def test_a_removed_contact_stays_removed_and_the_segment_takes_the_next_one_as_its_end(segmenter):
    document = Document(segmenter.demonstration)
    seen = labeled(segmenter, document)
    contact = next(i for i, b in enumerate(seen.boundaries) if b.contact_change)
    time = seen.boundaries[contact].time_s
    assert isinstance(seen.segments[contact].end_condition, ContactEnd)
    document = document.apply(Remove(time), seen)
    for line in (0.3, 0.1, 0.02):
        under = document.set_parameters(Parameters(force_threshold=line))
        found = segmenter.segment(under.parameters).boundaries
        assert any(abs(b.time_s - time) < 0.05 for b in found)
        after = labeled(segmenter, under)
        assert not [b for b in after.boundaries if abs(b.time_s - time) < 0.05]
    merged = labeled(segmenter, document).segments[contact]
    before, following = seen.segments[contact : contact + 2]
    assert (merged.start_s, merged.end_s) == (before.start_s, following.end_s)
    # The condition belongs to the contact: it ends the longer way to it, too.
    assert isinstance(merged.end_condition, ContactEnd)
    assert merged.end_condition == following.end_condition


def test_edits_cost_the_segmentation_nothing(segmenter):
    """The program's own segments are taken as they are, only changed ones are described anew."""
    asked = []

    def describe(start_s, end_s, contact_change):
        asked.append((start_s, end_s))
        return segmenter.segment_between(start_s, end_s, contact_change)

    segmentation = segmenter.segment()
    seen = label(segmentation, {}, describe)
    assert asked == []
    time = seen.segments[1].middle_s
    label(segmentation, {0: Add(time)}, describe)
    assert asked == [(seen.segments[1].start_s, time), (time, seen.segments[1].end_s)]
