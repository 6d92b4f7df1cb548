"""Skills come back from their file to the last bit, and files that are none are refused."""

import json
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from jsonschema import Draft202012Validator
from strokes import lowered, segment

from keyphase.errors import SkillError
from keyphase.rotations import quaternions
from keyphase.segmentation.end_condition import ConfigurationEnd, ContactEnd, GripperEnd
from keyphase.segmentation.end_condition.watch import Arming
from keyphase.skills.exports.skill_file import (
    library_of_text,
    read_skills,
    schema,
    skill_text,
    write_skills,
)
from keyphase.skills.exports.skill_library import SkillLibrary, SkillRobot
from keyphase.skills.exports.skill_values import library_values
from keyphase.skills.library import skills_of
from keyphase.skills.precondition import HeldContact, Precondition
from keyphase.skills.pressed import KeptForce, Press
from keyphase.skills.primitive import Constants, Primitive
from keyphase.skills.skill import Skill
from keyphase.skills.squaring import Squaring

finite = st.floats(-1e6, 1e6, allow_nan=False)
positive = st.floats(1e-6, 1e6)
vectors = st.tuples(finite, finite, finite)
unit = st.tuples(*[st.floats(-1.0, 1.0)] * 4).filter(lambda q: np.linalg.norm(q) > 0.1)
wxyz = unit.map(lambda q: quaternions.normalised(np.array(q)))
directions = st.sampled_from([(0.0, 0.0, 1.0), (0.6, -0.8, 0.0), (-1.0, 0.0, 0.0)])
grips = st.builds(GripperEnd, st.sampled_from(("grasp", "release")), positive, positive)
ends = st.builds(ContactEnd, directions, positive) | st.builds(
    ConfigurationEnd, positive, positive, gripper=st.none() | grips
)


@st.composite
def primitives(draw):
    count = draw(st.integers(2, 6))
    rows = st.lists(finite, min_size=count, max_size=count).map(np.array)
    return Primitive(
        duration_s=draw(positive),
        start_position_m=np.array(draw(vectors)),
        goal_position_m=np.array(draw(vectors)),
        start_orientation_wxyz=draw(wxyz),
        goal_orientation_wxyz=draw(wxyz),
        centres=draw(rows),
        widths=np.abs(draw(rows)) + 1e-3,
        weights=np.stack([draw(rows) for _ in range(6)], axis=1),
        scaled=np.array(draw(st.tuples(*[st.booleans()] * 6))),
        oriented=draw(st.booleans()),
        constants=Constants(k_c=draw(positive), alpha_z=draw(positive)),
    )


arrays3 = vectors.map(np.array)
held = st.lists(st.builds(HeldContact, arrays3, finite), max_size=2).map(tuple)
kept = st.builds(
    lambda rows, met, pushes: KeptForce(
        np.array([d for d, _, _ in rows]),
        np.array([f for _, f, _ in rows]),
        met,
        pushed_N=np.array([p for _, _, p in rows]) if pushes else None,
    ),
    st.lists(st.tuples(vectors, finite, vectors), min_size=1, max_size=3),
    st.booleans(),
    st.booleans(),
)
skills = st.builds(
    Skill,
    label=st.text(),
    connecting=st.booleans(),
    primitive=primitives(),
    end_condition=ends,
    end_position_m=vectors.map(np.array),
    end_orientation_wxyz=wxyz,
    met_m=st.none() | arrays3,
    travel_direction=st.none() | directions,
    offset_m=st.floats(0.0, 1.0),
    travel_limit_m=st.floats(0.0, 1.0),
    timeout_s=positive,
    force_limit_N=positive,
    demonstrated_s=st.none() | st.tuples(finite, finite),
    arming=st.none() | st.builds(Arming, positive, st.floats(0.0, 10.0), positive, positive),
    press=st.none() | st.builds(Press, directions.map(np.array), finite, arrays3),
    kept=st.lists(kept, max_size=2).map(tuple),
    shift_beyond_m=st.none() | st.floats(0.0, 1.0),
    precondition=st.none()
    | st.builds(Precondition, arrays3, st.none() | wxyz, positive, positive, held),
    squaring=st.none() | st.builds(Squaring, directions, directions, positive),
    agrees=st.none() | st.booleans(),
)


def as_values(skill):
    """Everything a skill holds, comparable."""
    return library_values(SkillLibrary("", (skill,)))["skills"][0]


@given(st.text(), st.lists(skills, max_size=3))
def test_what_is_written_is_read_back(name, some):
    library = SkillLibrary(name, tuple(some))
    text = skill_text(library)
    again = library_of_text(text)
    assert again.demonstration == name
    assert [as_values(s) for s in again.skills] == [as_values(s) for s in some]
    assert skill_text(again) == text


@pytest.fixture(scope="module")
def library():
    contact = ContactEnd((0.0, 0.0, 1.0), 3.0)
    plan = [segment(0.0, 1.2, contact, "down"), segment(1.2, 2.0)]
    return SkillLibrary("lowered", skills_of(lowered(), plan))


def test_a_file_names_the_robot_it_is_for():
    robot = SkillRobot("arm", "left", "flange", "base", ("a", "b"), (0.1, -0.2))
    again = library_of_text(skill_text(SkillLibrary("lowered", (), robot)))
    assert again.robot == robot


def test_the_file_follows_its_published_schema(library):
    Draft202012Validator.check_schema(schema())
    Draft202012Validator(schema()).validate(json.loads(skill_text(library)))


def test_a_library_is_written_whole_and_read_back(library, tmp_path):
    path = tmp_path / "plan.skills.json"
    write_skills(path, library)
    write_skills(path, library)
    assert path.read_text("utf-8") == skill_text(library)
    assert skill_text(read_skills(path)) == skill_text(library)
    assert [p.name for p in tmp_path.iterdir()] == ["plan.skills.json"]


def test_a_folder_that_is_not_there_is_named(library, tmp_path):
    with pytest.raises(SkillError, match="cannot be written"):
        write_skills(tmp_path / "missing" / "plan.json", library)


def test_a_file_that_is_not_there_is_named(tmp_path):
    with pytest.raises(SkillError, match=r"none\.json cannot be read"):
        read_skills(tmp_path / "none.json")


def changed(library, change):
    content = json.loads(skill_text(library))
    change(content)
    return json.dumps(content)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (lambda c: c.update(version=1), "version 1, which says neither"),
        (lambda c: c.update(version=3), "version 2"),
        (lambda c: c["skills"][1]["kept"][0]["force_N"].append(1), "as many directions"),
        (lambda c: c.update(format="other"), "no skill file"),
        (lambda c: c["skills"][0].pop("timeout_s"), "timeout_s"),
        (lambda c: c["skills"][0].update(timeout_s=-1), "timeout_s"),
        (lambda c: c["skills"][0].update(label=7), "label"),
        (lambda c: c["skills"][0]["primitive"]["weights"].pop(), "as many centres"),
        (lambda c: c["skills"][0]["primitive"]["weights"][0].pop(), "weights"),
        (lambda c: c["skills"][0]["primitive"]["constants"].update(alpha_z=0), "alpha_z"),
        (lambda c: c["skills"][0]["primitive"]["constants"].update(other=1), "constants"),
        (lambda c: c["skills"][0].update(end_orientation_wxyz=[1, 1, 0, 0]), "unit quaternion"),
        (lambda c: c["skills"][0]["end_condition"].update(direction=[0, 0, 2]), "unit vector"),
        (lambda c: c["skills"][0]["end_condition"].update(kind="other"), "end_condition"),
    ],
)
def test_content_that_is_no_skill_is_refused_where_it_is_wrong(library, change, message):
    with pytest.raises(SkillError, match=message):
        library_of_text(changed(library, change))


def test_a_file_from_before_its_stages_were_stated_is_read_as_before(library):
    def before(content):
        for skill in content["skills"]:
            del skill["pressing"], skill["seeking"]
            skill["moves"] = {"rocked_rad": [[0.0] * 3], "aside_m": [[0.0] * 4]}
            if skill["guard"]:
                del skill["guard"]["further_m"]

    first = library_of_text(changed(library, before)).skills[0]
    assert library.skills[0].further_m > 0.0
    assert first.further_m == 0.0
    assert first.travel_limit_m == library.skills[0].travel_limit_m


@pytest.mark.parametrize("text", ["", "{", "[]", "null", '{"skills": NaN}', "[" * 100_000])
def test_text_that_is_no_skill_file_is_refused(text):
    with pytest.raises(SkillError, match="again"):
        library_of_text(text)


def test_numbers_that_are_not_finite_are_not_written(library):
    broken = replace(library.skills[0], timeout_s=float("nan"))
    with pytest.raises(ValueError, match="JSON"):
        skill_text(SkillLibrary("broken", (broken,)))
