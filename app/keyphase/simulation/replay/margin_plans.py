"""The plans whose margins stand beside each other: as it is, by pose alone, as one skill."""

from collections.abc import Mapping, Sequence
from dataclasses import replace

from keyphase.demonstration import Demonstration
from keyphase.labeling.segment_file import FiledSegment
from keyphase.simulation.replay.input import with_configuration_ends
from keyphase.skills.library import skills_of
from keyphase.skills.skill import Skill

PLAN, BY_POSE, AS_ONE = "the plan", "by pose alone", "as one skill"


def margin_plans(
    demonstration: Demonstration, segments: Sequence[FiledSegment]
) -> Mapping[str, tuple[Skill, ...]]:
    """Skills of the plan's segments, the same without contact ends, and all of it as one skill.

    Raises SkillError for a segment that cannot be made executable.
    """
    return {
        PLAN: skills_of(demonstration, segments),
        BY_POSE: skills_of(demonstration, with_configuration_ends(segments)),
        AS_ONE: skills_of(demonstration, [as_one(segments)]),
    }


def as_one(segments: Sequence[FiledSegment]) -> FiledSegment:
    """One segment from the first start to the last end, which ends as the last one does."""
    first = min(segments, key=lambda segment: segment.start_s)
    last = max(segments, key=lambda segment: segment.end_s)
    return replace(
        first, end_s=last.end_s, end_condition=last.end_condition, label="all as one skill"
    )
