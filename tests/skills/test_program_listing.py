"""A plan as a listing that people read."""

import pytest
from strokes import lowered, segment

from keyphase.segmentation.end_condition import ContactEnd
from keyphase.skills.exports.program import program_listing
from keyphase.skills.library import skills_of

HOSTILE = "a <b>\"&' --> ]]>\x00\x1b[31m\n√"


@pytest.fixture(scope="module")
def skills():
    contact = ContactEnd((0.0, 0.0, 1.0), 3.0)
    plan = [segment(0.0, 1.2, contact, "down until contact"), segment(0.0, 1.2, label="down")]
    return skills_of(lowered(), plan)


def test_the_program_says_line_by_line_what_happens_and_until_when(skills):
    lines = program_listing(skills, "lowered").splitlines()
    assert lines[0].startswith("program of lowered: 3 skills, ")
    assert lines[1].startswith("  1  down until contact ")
    assert "until the force along (0.00, 0.00, 1.00) rises by 3.00 N" in lines[1]
    assert lines[1].endswith("or 42 mm beyond")
    assert lines[2].startswith("  2  → connect to down")
    assert len(lines) == 4


def test_a_label_cannot_break_the_listing():
    skills = skills_of(lowered(), [segment(0.0, 1.2, label=HOSTILE)])
    listing = program_listing(skills, HOSTILE)
    assert len(listing.splitlines()) == 2
    assert "\x1b" not in listing


def test_an_empty_plan_is_an_empty_program():
    assert program_listing((), "nothing") == "program of nothing: 0 skills, 0.0 s\n"
