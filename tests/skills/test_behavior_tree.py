"""The behaviour tree is loaded and run by BehaviorTree.CPP itself.

Its Python binding has no way to declare the ports of a node. So the ports of ours are read from the
tree by the type that its model declares, and handed to the node by its name.
"""

from xml.etree import ElementTree

import behaviortreepy as bt
import pytest
from point_mass import PointMass
from strokes import lowered, segment

from keyphase.segmentation.end_condition import ContactEnd
from keyphase.skills import Executor
from keyphase.skills.exports.behavior_tree import behavior_tree
from keyphase.skills.library import skills_of

HOSTILE = "a <b>\"&' --> ]]>\x00\x1b[31m\n√"


def plan():
    down = segment(0.0, 1.2, ContactEnd((0.0, 0.0, 1.0), 3.0), "down until contact")
    return skills_of(lowered(), [down, segment(1.2, 2.0, label="press")])


TYPES = {
    "int": int,
    "double": float,
    "std::string": str,
    "std::vector<double>": lambda text: [float(c) for c in text.split(";") if c],
}


def ports_apart(text):
    """The tree with its own nodes named instead of having ports, and their ports by that name."""
    root = ElementTree.fromstring(text)
    model = root.find("TreeNodesModel")
    assert model is not None
    types = {
        node.get("ID"): {port.get("name"): port.get("type") for port in node} for node in model
    }
    ports = {}
    for number, node in enumerate(root.findall("./BehaviorTree//*[@ID]")):
        if declared := types.get(node.get("ID")):
            values = {name: node.attrib.pop(name) for name in declared}
            typed = {k: v if v[:1] == "{" else TYPES[declared[k]](v) for k, v in values.items()}
            node.set("name", f"node {number}")
            ports[f"node {number}"] = typed
    root.remove(model)
    return ElementTree.tostring(root, "unicode"), ports


class Robot:
    """The nodes that a robot program provides, over one mass and one executor."""

    def __init__(self, skills, floor_m, at_pose=True):
        self.robot = PointMass((0.0, 0.0, 0.3), floor_m)
        self.executor = Executor(skills, self.robot.sense())
        self.asked, self.retracted, self.at_pose = [], 0, at_pose
        self.factory = bt.BehaviorTreeFactory()
        self.factory.register_simple_stateful_action("ExecuteSkill", self.run, self.run)
        self.factory.register_simple_action("Retract", self.retract)
        self.factory.register_simple_condition("AtPose", self.is_at_pose)
        for given in ("ContactHeld", "GripperIs"):
            self.factory.register_simple_condition(given, lambda _: bt.NodeStatus.SUCCESS)

    def run(self, node):
        skill = self.ports[node.name()]["skill"]
        if len(self.executor.results) < skill:
            self.executor.step(self.robot.follow(self.executor.reference))
        if len(self.executor.results) < skill:
            return bt.NodeStatus.RUNNING
        outcome = self.executor.results[skill - 1].outcome
        good = outcome in ("reached", "contact")
        return bt.NodeStatus.SUCCESS if good else bt.NodeStatus.FAILURE

    def retract(self, node):
        assert self.ports[node.name()]["distance_m"] > 0.0
        self.retracted += 1
        return bt.NodeStatus.SUCCESS

    def is_at_pose(self, node):
        self.asked.append(self.ports[node.name()]["position_m"])
        return bt.NodeStatus.SUCCESS if self.at_pose else bt.NodeStatus.FAILURE

    def loaded(self, text):
        named, self.ports = ports_apart(text)
        return self.factory.create_tree_from_text(named)

    def tick(self, text, most=5000):
        tree = self.loaded(text)
        for _ in range(most):
            status = tree.tick_exactly_once()
            if status != bt.NodeStatus.RUNNING:
                return status
        raise AssertionError("the tree does not end")


def test_the_tree_runs_the_plan_to_its_end():
    robot = Robot(plan(), floor_m=0.2)
    assert robot.tick(behavior_tree(plan(), "plan.skills.json")) == bt.NodeStatus.SUCCESS
    assert [result.outcome for result in robot.executor.results] == ["contact", "reached"]
    assert robot.retracted == 0
    assert robot.asked == [pytest.approx((0.0, 0.0, 0.3)), pytest.approx((0.0, 0.0, 0.2), abs=1e-3)]


@pytest.mark.slow
def test_a_skill_that_fails_retracts_and_fails_the_plan():
    robot = Robot(plan(), floor_m=-1.0)
    assert robot.tick(behavior_tree(plan(), "plan.skills.json")) == bt.NodeStatus.FAILURE
    assert [result.outcome for result in robot.executor.results] == ["timeout"]
    assert robot.retracted == 1


def test_a_skill_whose_precondition_does_not_hold_is_not_run():
    robot = Robot(plan(), floor_m=0.2, at_pose=False)
    assert robot.tick(behavior_tree(plan(), "plan.skills.json")) == bt.NodeStatus.FAILURE
    assert robot.executor.elapsed_s == 0.0


def test_there_is_one_stateful_node_for_each_skill():
    root = ElementTree.fromstring(behavior_tree(plan(), "plan.skills.json"))
    nodes = root.findall("./BehaviorTree//Action[@ID='ExecuteSkill']")
    assert [node.get("skill") for node in nodes] == ["1", "2"]
    assert {node.get("library") for node in nodes} == {"plan.skills.json"}


def test_every_node_and_port_used_is_declared_with_its_type():
    root = ElementTree.fromstring(behavior_tree(plan(), "plan.skills.json"))
    model = root.find("TreeNodesModel")
    assert model is not None
    declared = {node.get("ID"): {port.get("name") for port in node} for node in model}
    assert all(port.get("type") for node in model for port in node)
    used = [node for node in root.findall("./BehaviorTree//*[@ID]") if node.get("ID") in declared]
    assert len(used) == 7
    for node in used:
        assert set(node.attrib) - {"ID"} == declared[node.get("ID")]


@pytest.mark.parametrize("skills", [(), None])
def test_any_plan_and_any_label_give_a_tree_that_loads(skills):
    named = skills_of(lowered(), [segment(0.0, 1.2, label=HOSTILE)]) if skills is None else skills
    Robot(plan(), 0.2).loaded(behavior_tree(named, HOSTILE))
