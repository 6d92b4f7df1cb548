"""A plan of skills as a behaviour tree for BehaviorTree.CPP 4.

A sequence with one step per skill. A step asks the skill's preconditions once, then runs its one
stateful node, ExecuteSkill, which steps an executor (`keyphase.skills.Executor`, or the example
interpreter of the skill file) and is over when the skill is. Where a step fails the tool is
retracted, and the plan fails.
"""

from collections.abc import Sequence
from xml.etree import ElementTree
from xml.etree.ElementTree import Element, SubElement

from keyphase.skills.precondition import Precondition
from keyphase.skills.skill import Skill

RETRACT_M = 0.02
"""A plan that failed retracts the tool this far, against the way of the skill that failed."""

_INPUT, _OUTPUT = "input_port", "output_port"
_NUMBERS = "std::vector<double>"

_NODES: dict[tuple[str, str], tuple[tuple[str, str, str], ...]] = {
    ("Action", "ExecuteSkill"): (
        (_INPUT, "library", "std::string"),
        (_INPUT, "skill", "int"),
        (_OUTPUT, "outcome", "std::string"),
        (_OUTPUT, "shift_m", _NUMBERS),
    ),
    ("Action", "Retract"): (
        (_INPUT, "direction", _NUMBERS),
        (_INPUT, "distance_m", "double"),
    ),
    ("Condition", "AtPose"): (
        (_INPUT, "position_m", _NUMBERS),
        (_INPUT, "orientation_wxyz", _NUMBERS),
        (_INPUT, "position_tolerance_m", "double"),
        (_INPUT, "rotation_tolerance_rad", "double"),
        (_INPUT, "shift_m", _NUMBERS),
    ),
    ("Condition", "ContactHeld"): (
        (_INPUT, "direction", _NUMBERS),
        (_INPUT, "least_N", "double"),
    ),
    ("Condition", "GripperIs"): ((_INPUT, "state", "std::string"),),
}
"""Nodes that a robot program has to provide, with their typed ports."""


def behavior_tree(skills: Sequence[Skill], library: str, name: str = "Plan") -> str:
    """XML of the plan; `library` is the skill file the skills are looked up in, by number from 1.

    All nodes and the types of their ports are declared in the TreeNodesModel. `shift_m` on the
    blackboard carries how far what follows a contact is moved against the demonstration.
    """
    root = Element("root", BTCPP_format="4", main_tree_to_execute=name)
    tree = SubElement(root, "BehaviorTree", ID=name)
    sequence = SubElement(tree, "Sequence", name=name)
    SubElement(sequence, "Script", code="shift_m:='0;0;0'")
    for number, skill in enumerate(skills, start=1):
        _add_step(sequence, skill, number, library)
    _add_model(root)
    ElementTree.indent(root)
    return '<?xml version="1.0" encoding="UTF-8"?>\n' + ElementTree.tostring(root, "unicode") + "\n"


def _add_step(parent: Element, skill: Skill, number: int, library: str) -> None:
    """The skill after its preconditions; where one fails, the tool retracts and the step fails."""
    fallback = SubElement(parent, "Fallback", name=_printable(f"{number} {skill.label}"))
    step = SubElement(fallback, "Sequence", name=f"skill {number}")
    if skill.precondition is not None:
        _add_preconditions(step, skill.precondition)
    ports = {
        "ID": "ExecuteSkill",
        "library": _printable(library),
        "skill": str(number),
        "outcome": "{outcome}",
        "shift_m": "{shift_m}",
    }
    SubElement(step, "Action", ports)
    back = skill.travel_direction or (0.0, 0.0, -1.0)
    retract = {
        "ID": "Retract",
        "direction": _numbers([-c for c in back]),
        "distance_m": _number(RETRACT_M),
    }
    failed = SubElement(fallback, "ForceFailure")
    SubElement(failed, "Action", retract)


def _add_preconditions(parent: Element, needs: Precondition) -> None:
    wxyz = needs.orientation_wxyz
    pose = {
        "ID": "AtPose",
        "position_m": _numbers(needs.position_m.tolist()),
        "orientation_wxyz": "" if wxyz is None else _numbers(wxyz.tolist()),
        "position_tolerance_m": _number(needs.position_tolerance_m),
        "rotation_tolerance_rad": _number(needs.rotation_tolerance_rad),
        "shift_m": "{shift_m}",
    }
    SubElement(parent, "Condition", pose)
    for held in needs.contacts:
        contact = {"direction": _numbers(held.direction.tolist()), "least_N": _number(held.least_N)}
        SubElement(parent, "Condition", {"ID": "ContactHeld", **contact})
    if needs.gripper is not None:
        SubElement(parent, "Condition", {"ID": "GripperIs", "state": needs.gripper})


def _add_model(root: Element) -> None:
    model = SubElement(root, "TreeNodesModel")
    for (kind, identifier), ports in _NODES.items():
        node = SubElement(model, kind, ID=identifier)
        for direction, port, type_ in ports:
            SubElement(node, direction, name=port, type=type_)


def _numbers(values: Sequence[float]) -> str:
    """Lists as BehaviorTree.CPP reads them: separated by semicolons."""
    return ";".join(map(_number, values))


def _number(value: float) -> str:
    return f"{value + 0.0:.6g}"


def _printable(text: str) -> str:
    """Without the characters that XML cannot hold at all."""
    return "".join(c if c.isprintable() else " " for c in text)
