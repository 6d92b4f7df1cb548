"""A boundary says where to cut, a contact when the force changed: a skill ends at its contact."""

from functools import cache
from itertools import pairwise

import numpy as np
import pytest
from strokes import lowered, segment

from keyphase.files.shipped import shipped
from keyphase.labeling.edits import Move
from keyphase.labeling.label import label
from keyphase.readers import read
from keyphase.segmentation import Segmenter
from keyphase.segmentation.end_condition import ConfigurationEnd, ContactEnd
from keyphase.skills.library import cut_at_contacts, skills_of

UP = (0.0, 0.0, 1.0)
DOWN = ContactEnd(UP, 3.0)
MOVED_S = [-0.2, -0.15, -0.1, -0.05, 0.05, 0.1, 0.15, 0.2]


@cache
def bundled(name):
    segmenter = Segmenter(read(shipped("data") / f"{name}.npz"))
    return segmenter, segmenter.segment()


def contact_boundaries(name):
    return [each.time_s for each in bundled(name)[1].boundaries if each.contact_change]


def dragged(name, boundary_s, moved_s):
    segmenter, segmentation = bundled(name)
    edits = {0: Move(boundary_s, boundary_s + moved_s)}
    return label(segmentation, edits, segmenter.segment_between).segments


@pytest.mark.parametrize("name", ["setup1", "setup2", "wipe"])
@pytest.mark.parametrize("moved_s", MOVED_S)
def test_a_dragged_contact_boundary_leaves_every_end_condition_as_it_was(name, moved_s):
    proposed = bundled(name)[1].segments
    for boundary_s in contact_boundaries(name):
        moved = dragged(name, boundary_s, moved_s)
        for before, after in zip(proposed, moved, strict=True):
            was, now = before.end_condition, after.end_condition
            assert type(now) is type(was), (boundary_s, after.label)
            if isinstance(was, ContactEnd):
                cosine = float(np.dot(was.direction, now.direction))
                assert np.degrees(np.arccos(min(cosine, 1.0))) < 10.0, (boundary_s, after.label)
                assert now.threshold_N == pytest.approx(was.threshold_N, rel=0.2)
                assert now.agrees


@pytest.mark.parametrize("moved_s", [-0.2, 0.2])
def test_a_skill_is_cut_at_its_contact_where_it_would_not_end_at_a_dragged_boundary(moved_s):
    """A force counts from the last fifth of a short way on: here that is after the contact."""
    demonstration = lowered(contact_s=1.2, depth_m=0.008)
    end = ContactEnd(UP, 5.0, agrees=True)
    (_, ended), (begun, _) = spans(
        demonstration, [segment(0.6, 1.2 + moved_s, end), segment(1.2 + moved_s, 1.5)]
    )
    assert ended == begun == pytest.approx(1.2, abs=0.02)


@pytest.mark.parametrize("name", ["setup1", "setup2"])
@pytest.mark.parametrize("moved_s", [-0.2, -0.1])
def test_a_boundary_dragged_before_its_contact_is_cut_where_it_was(name, moved_s):
    segmenter, _ = bundled(name)
    first = contact_boundaries(name)[0]
    skills = skills_of(segmenter.demonstration, dragged(name, first, moved_s), connect=False)
    ends = [skill.demonstrated_s[1] for skill in skills]
    assert min(abs(end_s - first) for end_s in ends) < 0.05
    assert all(one.demonstrated_s[1] == two.demonstrated_s[0] for one, two in pairwise(skills))
    assert all(skill.agrees is not False for skill in skills)


def spans(demonstration, segments):
    return [(part.start_s, part.end_s) for part in cut_at_contacts(demonstration, segments)]


def lowered_until(boundary_s, end=DOWN):
    """A tool that meets the table at 1.2 s, its boundary elsewhere, and then stays."""
    return lowered(contact_s=1.2), segment(0.0, boundary_s, end), segment(boundary_s, 1.5)


def test_what_follows_begins_at_the_contact():
    demonstration, down, stay = lowered_until(1.05)
    (_, ended), (begun, _) = spans(demonstration, [down, stay])
    assert ended == begun == pytest.approx(1.2, abs=0.01)


def test_a_repeated_segment_is_cut_each_time():
    demonstration, down, stay = lowered_until(1.05)
    once = spans(demonstration, [down, stay])
    assert spans(demonstration, [down, stay, down, stay]) == 2 * once


@pytest.mark.parametrize(
    ("boundary_s", "end"),
    [
        (1.2, DOWN),
        (1.3, DOWN),
        (0.8, DOWN),
        (1.05, ConfigurationEnd()),
        (1.05, ContactEnd(UP, 3.0, agrees=False)),
    ],
    ids=["at it", "after it", "too far before it", "no contact", "one that does not agree"],
)
def test_any_other_boundary_stays_where_it_is(boundary_s, end):
    demonstration, *parts = lowered_until(boundary_s, end)
    assert cut_at_contacts(demonstration, parts) == parts


def test_a_boundary_stays_where_too_little_would_be_left_of_what_follows():
    demonstration, down, _ = lowered_until(1.05)
    parts = [down, segment(1.05, 1.25)]
    assert cut_at_contacts(demonstration, parts) == parts
