"""The plans whose margins stand beside each other: as it is, by pose alone, as one skill."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from keyphase.demonstration import Demonstration
from keyphase.segmentation.end_condition import ConfigurationEnd, EndCondition
from keyphase.skills.library import PlannedSegment, skills_of
from keyphase.skills.skill import Skill

PLAN, BY_POSE, AS_ONE = "the plan", "by pose alone", "as one skill"


@dataclass(frozen=True)
class Stretch:
    """A stretch of a demonstration to be made a skill of [s]."""

    start_s: float
    end_s: float
    label: str
    end_condition: EndCondition


def margin_plans(
    demonstration: Demonstration, segments: Sequence[PlannedSegment]
) -> Mapping[str, tuple[Skill, ...]]:
    """Skills of the plan's segments, the same without contact ends, and all of it as one skill.

    Raises SkillError for a segment that cannot be made executable.
    """
    by_pose = [Stretch(s.start_s, s.end_s, s.label, ConfigurationEnd()) for s in segments]
    return {
        PLAN: skills_of(demonstration, segments),
        BY_POSE: skills_of(demonstration, by_pose),
        AS_ONE: skills_of(demonstration, [as_one(segments)]),
    }


def as_one(segments: Sequence[PlannedSegment]) -> Stretch:
    """One stretch from the first start to the last end, which ends as the last one does."""
    first = min(segments, key=lambda segment: segment.start_s)
    last = max(segments, key=lambda segment: segment.end_s)
    return Stretch(first.start_s, last.end_s, "all as one skill", last.end_condition)
