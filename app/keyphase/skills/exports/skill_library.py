"""What a skill file is about: the skills of a plan, and the robot they are for."""

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np

from keyphase.demonstration import Demonstration
from keyphase.skills.gains import SkillGains, gains_for
from keyphase.skills.skill import Skill


@dataclass(frozen=True)
class SkillRobot:
    """The robot that demonstrated; None where the recording does not say.

    tool_frame    what the poses are of; base_frame: what they are given in
    joints        names, and `start_joints_rad` angles where the plan starts
    """

    name: str | None = None
    arm: str | None = None
    tool_frame: str | None = None
    base_frame: str | None = None
    joints: tuple[str, ...] = ()
    start_joints_rad: tuple[float, ...] = ()


@dataclass(frozen=True, eq=False)
class SkillLibrary:
    """Skills in the order of their plan, and the name of the demonstration they came from."""

    demonstration: str
    skills: tuple[Skill, ...]
    robot: SkillRobot = field(default_factory=SkillRobot)
    gains: SkillGains = field(default_factory=SkillGains)


def library_of(demonstration: Demonstration, skills: Sequence[Skill]) -> SkillLibrary:
    """The plan's skills with the robot of their demonstration and the gains they were made for."""
    return SkillLibrary(
        demonstration.name,
        tuple(skills),
        _robot_of(demonstration, skills),
        gains_for(demonstration),
    )


def _robot_of(demonstration: Demonstration, skills: Sequence[Skill]) -> SkillRobot:
    said = demonstration.metadata
    names = {key: said.get(key) for key in ("robot", "arm", "tool_frame", "base_frame")}
    told = {key: value if isinstance(value, str) else None for key, value in names.items()}
    if isinstance(said.get("workcell"), str) and told["robot"] is None:
        told = {
            "robot": "ABB YuMi",
            "arm": "right",
            "tool_frame": "point of the held part",
            "base_frame": "robot base",
        }
    joints = said.get("joint_names")
    listed = tuple(map(str, joints)) if isinstance(joints, list | tuple) else ()
    return SkillRobot(
        name=told["robot"],
        arm=told["arm"],
        tool_frame=told["tool_frame"],
        base_frame=told["base_frame"],
        joints=listed,
        start_joints_rad=_start_joints(demonstration, skills),
    )


def _start_joints(demonstration: Demonstration, skills: Sequence[Skill]) -> tuple[float, ...]:
    first = next((s.demonstrated_s for s in skills if s.demonstrated_s is not None), None)
    if demonstration.joints_rad is None or first is None:
        return ()
    row = min(int(np.searchsorted(demonstration.time_s, first[0])), len(demonstration) - 1)
    return tuple(demonstration.joints_rad[row].tolist())
