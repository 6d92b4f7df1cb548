"""A plan as a program of a robot's own controller."""

from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
from lark import Lark
from lark.exceptions import LarkError
from strokes import lowered, segment

from keyphase.segmentation.end_condition import ContactEnd
from keyphase.skills.exports.rapid import rapid
from keyphase.skills.exports.robot_moves import CORNER_M, robot_moves
from keyphase.skills.exports.urscript import urscript
from keyphase.skills.library import skills_of
from keyphase.skills.skill import drawn

HOSTILE = 'a"; halt\n! ENDMODULE # end\x00 √'
WRITERS = {"urscript": urscript, "rapid": rapid}


def plan(label="down until contact"):
    contact = ContactEnd((0.0, 0.0, 1.0), 3.0)
    return skills_of(lowered(), [segment(0.0, 1.2, contact, label), segment(0.0, 1.2, label=label)])


def grammar(language):
    return Lark((Path(__file__).parent / f"{language}.lark").read_text("utf-8"), parser="earley")


@pytest.mark.parametrize("language", WRITERS)
@pytest.mark.parametrize("label", ["down until contact", HOSTILE])
def test_a_program_follows_the_grammar_of_its_language(language, label):
    grammar(language).parse(WRITERS[language](plan(label), label))


@pytest.mark.parametrize("language", WRITERS)
def test_the_grammar_refuses_what_is_no_program(language):
    text = WRITERS[language](plan(), "lowered")
    for broken in (text.replace("(", "", 1), text.replace("while", "whilst").replace("WHILE", "W")):
        with pytest.raises(LarkError):
            grammar(language).parse(broken)


@pytest.mark.parametrize("language", WRITERS)
def test_a_program_has_a_contact_move_with_a_branch_for_failure(language):
    text = WRITERS[language](plan(), "lowered").lower().replace("untilcontact", "until_contact")
    call = next(
        line for line in text.splitlines() if "until_contact" in line and '"skill 1"' in line
    )
    assert "3.0000" in call
    assert "fail" in text
    assert 'until_contact("skill 2"' not in text.replace(' "skill 2"', '("skill 2"')


def test_a_move_until_contact_says_how_fast_where_to_and_until_when():
    move = robot_moves(plan())[0]
    assert move.contact is not None
    assert np.allclose(move.contact.travel, (0.0, 0.0, -1.0), atol=1e-6)
    assert move.contact.threshold_N == 3.0
    assert 0.02 <= move.contact.speed_m_s <= 0.04
    # From 30 mm before the contact to 42 mm beyond it.
    assert move.position_m[-1][2] == pytest.approx(0.23, abs=0.003)
    assert move.contact.search_m == pytest.approx(0.072)


def test_the_corners_stay_near_the_path():
    skill = plan()[1]
    path = drawn(skill).position_m
    corners = np.vstack([path[:1], robot_moves([skill])[0].position_m])
    for point in path:
        assert min(off(point, *ends) for ends in pairwise(corners)) < 2.0 * CORNER_M


def off(point, begin, end):
    """How far a point is from the straight line between two others."""
    along = np.clip((point - begin) @ (end - begin) / ((end - begin) @ (end - begin)), 0.0, 1.0)
    return np.linalg.norm(point - begin - along * (end - begin))


@pytest.mark.parametrize("language", WRITERS)
def test_an_empty_plan_is_a_program_too(language):
    grammar(language).parse(WRITERS[language]((), "nothing"))
