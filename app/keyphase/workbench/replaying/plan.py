"""The plan of a labeled recording as skills, each with the entry of the plan it comes from."""

from dataclasses import dataclass, replace

from keyphase.demonstration import Demonstration
from keyphase.labeling.labeling import Labeling
from keyphase.segmentation.end_condition import ConfigurationEnd
from keyphase.simulation.choosing import met_by
from keyphase.simulation.simulated import Cell
from keyphase.skills.library import skills_of
from keyphase.skills.skill import Skill
from keyphase.workbench.replaying.settings import EndBy


@dataclass(frozen=True, eq=False)
class PlannedSkill:
    """One skill of the plan; connecting moves have neither entry nor segment.

    entry     index in the plan
    segment   index of its segment
    color     number of the segment's colour
    proposed  its name is the program's, and no person's
    """

    skill: Skill
    entry: int | None = None
    segment: int | None = None
    color: int | None = None
    proposed: bool = True

    @property
    def name(self) -> str:
        """Number and label as the timeline has them."""
        return (
            self.skill.label if self.segment is None else f"{self.segment + 1} {self.skill.label}"
        )


@dataclass(frozen=True, eq=False)
class ReplayPlan:
    """What is replayed: the demonstration and its skills in order."""

    demonstration: Demonstration
    planned: tuple[PlannedSkill, ...]

    @property
    def skills(self) -> tuple[Skill, ...]:
        """The skills alone."""
        return tuple(one.skill for one in self.planned)

    def begun_with(self, skills: tuple[Skill, ...]) -> "ReplayPlan":
        """The plan as it is replayed, with the moves that were put before it."""
        before = skills[: len(skills) - len(self.planned)]
        return replace(self, planned=(*map(PlannedSkill, before), *self.planned))


def plan_of(labeling: Labeling, end_by: EndBy = "contact", cell: Cell | None = None) -> ReplayPlan:
    """The kept plan entries in their order, made executable, for a workcell where one is given.

    Raises SkillError for a segment that cannot be made executable.
    """
    demonstration = labeling.segmentation.demonstration
    if cell is not None:
        demonstration = met_by(demonstration, cell)
    segments = [labeling.segments[entry.segment] for entry in labeling.plan]
    if end_by == "configuration":
        segments = [replace(one, end_condition=ConfigurationEnd()) for one in segments]
    skills = skills_of(demonstration, segments)
    entries = iter(enumerate(labeling.plan))
    planned: list[PlannedSkill] = []
    for skill in skills:
        if skill.connecting:
            planned.append(PlannedSkill(skill))
            continue
        number, entry = next(entries)
        segment = labeling.segments[entry.segment]
        one = PlannedSkill(skill, number, entry.segment, segment.color, segment.proposed)
        planned.append(one)
    return ReplayPlan(demonstration, tuple(planned))
