"""A plan carried on elsewhere: behaviour tree and program listing."""

from xml.etree import ElementTree

import pytest
from strokes import lowered, segment

from keyphase.segmentation.end_condition import ContactEnd
from keyphase.skills.exports.behavior_tree import behavior_tree
from keyphase.skills.exports.program import program_listing
from keyphase.skills.library import skills_of

HOSTILE = "a <b>\"&' --> ]]>\x00\x1b[31m\n√"


@pytest.fixture(scope="module")
def skills():
    contact = ContactEnd((0.0, 0.0, 1.0), 3.0)
    plan = [segment(0.0, 1.2, contact, "down until contact"), segment(0.0, 1.2, label="down")]
    return skills_of(lowered(), plan)


def test_the_tree_is_a_sequence_of_skills_with_their_conditions(skills):
    root = ElementTree.fromstring(behavior_tree(skills, "plan.skills.json"))
    assert root.attrib == {"BTCPP_format": "4", "main_tree_to_execute": "Plan"}
    steps = root.findall("./BehaviorTree[@ID='Plan']/Sequence/ReactiveFallback")
    assert [s.get("name") for s in steps] == ["1 down until contact", "2 connect to down", "3 down"]
    assert [s[0].get("ID") for s in steps] == ["ForceRose", "PoseWithin", "PoseWithin"]
    assert [s[1].tag for s in steps] == ["Timeout"] * 3
    assert [s[1][0].get("skill") for s in steps] == ["1", "2", "3"]


def test_a_contact_condition_carries_direction_threshold_and_debounce(skills):
    root = ElementTree.fromstring(behavior_tree(skills, "plan.skills.json"))
    condition = root.find(".//Condition[@ID='ForceRose'][@threshold_N]")
    assert condition is not None
    assert condition.attrib == {
        "ID": "ForceRose",
        "direction": "0;0;1",
        "threshold_N": "3",
        "debounce_s": "0.02",
    }


def test_every_node_and_port_used_is_declared_for_the_editor(skills):
    root = ElementTree.fromstring(behavior_tree(skills, "plan.skills.json"))
    declared = {
        node.get("ID"): {port.get("name") for port in node} for node in root.find("TreeNodesModel")
    }
    for node in root.find("BehaviorTree").iter():
        if node.get("ID") in declared:
            assert set(node.attrib) - {"ID"} == declared[node.get("ID")]
    assert set(declared) == {"FollowSkill", "ForceRose", "PoseWithin"}


def test_any_label_gives_valid_xml():
    skills = skills_of(lowered(), [segment(0.0, 1.2, label=HOSTILE)])
    root = ElementTree.fromstring(behavior_tree(skills, HOSTILE))
    assert "<b>" in root.find(".//ReactiveFallback").get("name")


def test_the_program_says_line_by_line_what_happens_and_until_when(skills):
    lines = program_listing(skills, "lowered").splitlines()
    assert lines[0].startswith("program of lowered: 3 skills, ")
    assert lines[1].startswith("  1  down until contact ")
    assert "until the force along (0.00, 0.00, 1.00) rises by 3.00 N" in lines[1]
    assert lines[1].endswith("or 30 mm beyond")
    assert lines[2].startswith("  2  → connect to down")
    assert len(lines) == 4


def test_a_label_cannot_break_the_listing():
    skills = skills_of(lowered(), [segment(0.0, 1.2, label=HOSTILE)])
    listing = program_listing(skills, HOSTILE)
    assert len(listing.splitlines()) == 2
    assert "\x1b" not in listing


def test_an_empty_plan_is_an_empty_program():
    assert program_listing((), "nothing") == "program of nothing: 0 skills, 0.0 s\n"
    root = ElementTree.fromstring(behavior_tree((), "plan.skills.json"))
    assert root.find(".//Sequence") is not None
