"""A plan of skills as a behaviour tree for BehaviorTree.CPP 4.

A sequence with one ReactiveFallback per skill: its condition is asked at every tick, and while it
does not hold the skill is followed; a skill that runs out of time, or of way, fails the sequence.
"""

from collections.abc import Sequence
from xml.etree import ElementTree

from keyphase.segmentation.end_condition import ContactEnd, EndCondition
from keyphase.skills.skill import Skill

_PORTS = {
    ("Action", "FollowSkill"): ("library", "skill", "travel_limit_m", "force_limit_N"),
    ("Condition", "ForceRose"): ("direction", "threshold_N", "debounce_s"),
    ("Condition", "PoseWithin"): (
        "position_m",
        "orientation_wxyz",
        "position_tolerance_m",
        "rotation_tolerance_rad",
        "skill",
    ),
}
"""Input ports of the nodes a robot program has to provide."""


def behavior_tree(skills: Sequence[Skill], library: str, name: str = "Plan") -> str:
    """XML of the plan; `library` is the skill file the skills are looked up in, by number from 1.

    Conditions: ForceRose (contact) and PoseWithin (configuration); action: FollowSkill, which
    stays RUNNING until it is halted. All three are declared in the TreeNodesModel.
    """
    root = ElementTree.Element("root", BTCPP_format="4", main_tree_to_execute=name)
    tree = ElementTree.SubElement(root, "BehaviorTree", ID=name)
    sequence = ElementTree.SubElement(tree, "Sequence", name=name)
    for number, skill in enumerate(skills, start=1):
        _add_skill(sequence, skill, number, library)
    _add_model(root)
    ElementTree.indent(root)
    return '<?xml version="1.0" encoding="UTF-8"?>\n' + ElementTree.tostring(root, "unicode") + "\n"


def _add_skill(parent: ElementTree.Element, skill: Skill, number: int, library: str) -> None:
    fallback = ElementTree.SubElement(
        parent, "ReactiveFallback", name=_printable(f"{number} {skill.label}")
    )
    condition, ports = _condition(skill, number)
    ElementTree.SubElement(fallback, "Condition", {"ID": condition, **ports})
    timeout = ElementTree.SubElement(fallback, "Timeout", msec=f"{1e3 * skill.timeout_s:.0f}")
    follow = {
        "ID": "FollowSkill",
        "library": _printable(library),
        "skill": str(number),
        "travel_limit_m": _number(skill.travel_limit_m),
        "force_limit_N": _number(skill.force_limit_N),
    }
    ElementTree.SubElement(timeout, "Action", follow)


def _condition(skill: Skill, number: int) -> tuple[str, dict[str, str]]:
    end: EndCondition = skill.end_condition
    if isinstance(end, ContactEnd):
        return "ForceRose", {
            "direction": _numbers(end.direction),
            "threshold_N": _number(end.threshold_N),
            "debounce_s": _number(skill.debounce_s),
        }
    return "PoseWithin", {
        "position_m": _numbers(skill.end_position_m.tolist()),
        "orientation_wxyz": _numbers(skill.end_orientation_wxyz.tolist()),
        "position_tolerance_m": _number(end.position_tolerance_m),
        "rotation_tolerance_rad": _number(end.rotation_tolerance_rad),
        "skill": str(number),
    }


def _add_model(root: ElementTree.Element) -> None:
    model = ElementTree.SubElement(root, "TreeNodesModel")
    for (kind, identifier), ports in _PORTS.items():
        node = ElementTree.SubElement(model, kind, ID=identifier)
        for port in ports:
            ElementTree.SubElement(node, "input_port", name=port)


def _numbers(values: Sequence[float]) -> str:
    """Lists as BehaviorTree.CPP reads them: separated by semicolons."""
    return ";".join(_number(v) for v in values)


def _number(value: float) -> str:
    return f"{value:.6g}"


def _printable(text: str) -> str:
    """Without the characters that XML cannot hold at all."""
    return "".join(c if c.isprintable() else " " for c in text)
