"""Several demonstrations, one skill: their phases aligned, their mean, and how far they spread.

All demonstrations are stretched, phase by phase, to the median duration of each phase, so that a
contact that ends a phase is at the same moment in all. Of what then happens at each moment the mean
is a demonstration as any other, from which skills are made as always.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import Any

import numpy as np

from keyphase.demonstration import Array, Demonstration
from keyphase.errors import SkillError
from keyphase.segmentation.end_condition import ContactEnd, EndCondition
from keyphase.skills.library import PlannedSegment, skills_of
from keyphase.skills.skill import Skill
from keyphase.skills.spread import spread_between

Demonstrated = tuple[Demonstration, Sequence[PlannedSegment]]
"""A demonstration and its segments, in time order."""


@dataclass(frozen=True)
class MeanSegment:
    """A phase of the mean demonstration."""

    start_s: float
    end_s: float
    label: str
    end_condition: EndCondition


@dataclass(frozen=True, eq=False)
class MeanDemonstration:
    """The mean of several demonstrations, its segments, and their spread.

    spread_m  (N,) root mean square distance of the demonstrations' positions from the mean
    count     how many demonstrations it is the mean of
    """

    demonstration: Demonstration
    segments: tuple[MeanSegment, ...]
    spread_m: Array
    count: int

    def spread_on(self, skill: Skill) -> Skill:
        """The skill, one of this demonstration, with how far the demonstrations lie apart in it."""
        if skill.demonstrated_s is None:
            return skill
        time_s = self.demonstration.time_s
        spread = spread_between(time_s, self.spread_m, *skill.demonstrated_s, self.count)
        return replace(skill, spread=spread)


def skills_of_many(demonstrated: Sequence[Demonstrated]) -> tuple[Skill, ...]:
    """The skills of the mean of several demonstrations of the same phases.

    Raises SkillError where they do not have the same phases in the same order.
    """
    return skills_of_mean(mean_of(demonstrated), demonstrated)


def skills_of_mean(
    mean: MeanDemonstration, demonstrated: Sequence[Demonstrated]
) -> tuple[Skill, ...]:
    """The skills of a mean of demonstrations, each with how far these lie apart.

    What a contact is like is sharp in each demonstration and blurred in their mean: how hard it
    was pressed, and how far a part went into its seat, are the medians of all.
    """
    each = [_demonstrated(skills_of(one, segments)) for one, segments in demonstrated]
    singles = iter(zip(*each, strict=True))
    skills = skills_of(mean.demonstration, mean.segments)
    return tuple(
        skill
        if skill.demonstrated_s is None
        else mean.spread_on(_with_contacts_of(skill, next(singles)))
        for skill in skills
    )


def _demonstrated(skills: Sequence[Skill]) -> list[Skill]:
    return [skill for skill in skills if skill.demonstrated_s is not None]


def _with_contacts_of(skill: Skill, singles: Sequence[Skill]) -> Skill:
    """The skill with what most of the same skills, each from one demonstration, press and seek."""
    presses = [one.press.force_N for one in singles if one.press is not None]
    if skill.press is not None and presses:
        skill = replace(skill, press=replace(skill.press, force_N=float(np.median(presses))))
    found = [one.search for one in singles if one.search is not None]
    if 2 * len(found) <= len(singles):
        return replace(skill, search=None)
    typical = skill.search or found[0]
    depth_m = float(np.median([one.depth_m for one in found]))
    press_N = float(np.median([one.press_N for one in found]))
    return replace(skill, search=replace(typical, depth_m=depth_m, press_N=press_N))


def mean_of(demonstrated: Sequence[Demonstrated]) -> MeanDemonstration:
    """The mean of several demonstrations of the same phases. Raises SkillError likewise."""
    _refuse_unlike(demonstrated)
    edges = np.array([_edges(*each) for each in demonstrated])
    lasting = np.median(np.diff(edges, axis=1), axis=0)
    middle = np.concatenate([[0.0], np.cumsum(lasting)])
    rate_hz = max(one.rate_hz for one, _ in demonstrated)
    grid = np.linspace(0.0, middle[-1], max(round(middle[-1] * rate_hz) + 1, 2))
    stretched = [
        _at(one, np.interp(grid, middle, own))
        for (one, _), own in zip(demonstrated, edges, strict=True)
    ]
    shared = [name for name in stretched[0] if _is_alike(name, stretched)]
    mean = {name: np.mean([each[name] for each in stretched], axis=0) for name in shared}
    if "orientation_wxyz" in mean:
        mean["orientation_wxyz"] = _mean_turn([each["orientation_wxyz"] for each in stretched])
    away = [((each["position_m"] - mean["position_m"]) ** 2).sum(axis=1) for each in stretched]
    first = demonstrated[0][0]
    name = f"{first.name} and {len(demonstrated) - 1} more"
    return MeanDemonstration(
        Demonstration(name, grid, metadata=_said_by_all(demonstrated), **mean),
        _segments(demonstrated, middle),
        np.sqrt(np.mean(away, axis=0)),
        len(demonstrated),
    )


def _said_by_all(demonstrated: Sequence[Demonstrated]) -> dict[str, Any]:
    """Robot, workcell and the like, as far as all demonstrations say the same."""
    first, *others = (dict(one.metadata) for one, _ in demonstrated)
    return {
        key: value
        for key, value in first.items()
        if all(key in other and other[key] == value for other in others)
    }


def _refuse_unlike(demonstrated: Sequence[Demonstrated]) -> None:
    if not demonstrated:
        raise SkillError("Expected demonstrations to learn a skill from, but there is none.")
    first, planned = demonstrated[0]
    labels = [segment.label for segment in planned]
    for one, segments in demonstrated:
        theirs = [segment.label for segment in segments]
        if any(later.start_s < before.end_s for before, later in pairwise(segments)):
            raise SkillError(
                f"Expected the phases of {one.name} in the order in which they were recorded, "
                "each once; a plan that repeats or reorders them is learnt from one demonstration."
            )
        if theirs != labels or not labels:
            raise SkillError(
                f"Expected demonstrations of the same phases, but {first.name} has "
                f"{', '.join(labels) or 'none'} and {one.name} has {', '.join(theirs) or 'none'}; "
                "leave out those that differ, or let them get the phases of one that is finished "
                "(keyphase propose)."
            )


def _edges(demonstration: Demonstration, segments: Sequence[PlannedSegment]) -> list[float]:
    """Where phases begin and end, and the ends of the recording; what lies between may be empty."""
    ends = (time for segment in segments for time in (segment.start_s, segment.end_s))
    return [demonstration.start_s, *ends, demonstration.end_s]


def _at(demonstration: Demonstration, time_s: Array) -> dict[str, Array]:
    """What was recorded, at other times (M,)."""
    names = ("position_m", "orientation_wxyz", "force_N", "torque_Nm", "joints_rad")
    recorded = {name: getattr(demonstration, name) for name in names}
    found = {
        name: np.column_stack([np.interp(time_s, demonstration.time_s, c) for c in values.T])
        for name, values in recorded.items()
        if values is not None
    }
    if demonstration.gripper is not None:
        found["gripper"] = np.interp(time_s, demonstration.time_s, demonstration.gripper)
    return found


def _is_alike(name: str, stretched: Sequence[dict[str, Array]]) -> bool:
    """Whether all have a channel, with as many columns."""
    shapes = {each[name].shape if name in each else None for each in stretched}
    return len(shapes) == 1 and None not in shapes


def _mean_turn(turns: Sequence[Array]) -> Array:
    """Mean of unit quaternions (M, 4) that lie near each other, by their sum in one sign."""
    first = turns[0]
    same = [turn * np.sign((turn * first).sum(axis=1, keepdims=True)) for turn in turns]
    total = np.sum(same, axis=0)
    return total / np.linalg.norm(total, axis=1, keepdims=True)


def _segments(demonstrated: Sequence[Demonstrated], middle: Array) -> tuple[MeanSegment, ...]:
    planned, at = demonstrated[0][1], middle.tolist()
    return tuple(
        MeanSegment(
            at[2 * number + 1],
            at[2 * number + 2],
            segment.label,
            _mean_end([segments[number].end_condition for _, segments in demonstrated]),
        )
        for number, segment in enumerate(planned)
    )


def _mean_end(ends: Sequence[EndCondition]) -> EndCondition:
    """The kind most have; of contacts the mean direction and the median threshold."""
    contacts = [end for end in ends if isinstance(end, ContactEnd)]
    if 2 * len(contacts) <= len(ends):
        return next(end for end in ends if not isinstance(end, ContactEnd))
    direction = np.mean([end.direction for end in contacts], axis=0)
    length = float(np.linalg.norm(direction))
    if length < 0.5:
        raise SkillError(
            "Expected contacts from about the same side, but the demonstrations of one phase end "
            "in contacts from opposite ones; leave out those that differ."
        )
    x, y, z = (direction / length).tolist()
    threshold = float(np.median([end.threshold_N for end in contacts]))
    return replace(contacts[0], direction=(x, y, z), threshold_N=threshold, agrees=None)
