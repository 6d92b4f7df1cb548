"""From the plan's segments to skills."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import Literal, Protocol

import numpy as np

from keyphase.demonstration import Array, Demonstration
from keyphase.errors import ParameterError
from keyphase.segmentation.end_condition import ContactEnd, EndCondition
from keyphase.segmentation.end_condition.agreement import LEAST_S, met_beside_s
from keyphase.segmentation.end_condition.derived import ALONG_THE_WAY
from keyphase.segmentation.end_condition.watch import Arming, arming_for
from keyphase.segmentation.windows import AFTER_S
from keyphase.skills.agreement import tried
from keyphase.skills.connecting import connecting_skill, is_apart
from keyphase.skills.contacts import with_contacts
from keyphase.skills.fitting import Fit, fit_primitive
from keyphase.skills.path import Path, direction_of_travel, extended, path_of
from keyphase.skills.primitive import Primitive
from keyphase.skills.skill import Skill

BeyondContact = Literal["extended demonstration", "goal shift"]
"""How a skill reaches beyond its contact: our way, or the paper's."""

OFFSET_M = 0.02
"""How far beyond the demonstrated contact a skill goes on, in case the contact comes later."""

FURTHER_M = 0.012
"""How much further it then goes, slowly, where it met nothing: a contact counts from 30 mm before
the demonstrated one, and is looked for as far beyond it, and pressed there."""

TRAVEL_MARGIN_M = 0.01
"""How much further than that it may be pushed before it has failed."""

TIMEOUT_S = (2.0, 5.0)
"""A skill has failed if it does not get on for two of its durations, but so long at least and at
most."""

_TIMEOUT_DURATIONS = 2.0

MIN_FORCE_LIMIT_N = 15.0
FORCE_LIMIT_FACTOR = 2.0
"""A force that changed by more than this many demonstrated changes is not the expected one."""


class PlannedSegment(Protocol):
    """What a skill is made from; times in the demonstration [s]."""

    @property
    def start_s(self) -> float: ...  # noqa: D102

    @property
    def end_s(self) -> float: ...  # noqa: D102

    @property
    def label(self) -> str: ...  # noqa: D102

    @property
    def end_condition(self) -> EndCondition: ...  # noqa: D102


@dataclass(frozen=True)
class Cut:
    """A segment as its skill is cut."""

    start_s: float
    end_s: float
    label: str
    end_condition: EndCondition


def skills_of(
    demonstration: Demonstration,
    segments: Iterable[PlannedSegment],
    *,
    offset_m: float = OFFSET_M,
    beyond_contact: BeyondContact = "extended demonstration",
    fit: Fit = "least squares",
    connect: bool = True,
) -> tuple[Skill, ...]:
    """Skills of `segments` in the order given, which may repeat and reorder them.

    Where a skill starts away from where the one before it ended (5 mm, 3 degrees), a connecting
    move is put in between, unless `connect` is False. Each holds what it is to press. One whose
    boundary lies before its contact is cut at the contact (`cut_at_contacts`).

    Raises SkillError for a segment that cannot be made executable.
    """
    skills = [
        skill_of(demonstration, s, offset_m=offset_m, beyond_contact=beyond_contact, fit=fit)
        for s in cut_at_contacts(demonstration, segments)
    ]
    return with_contacts(demonstration, connected(skills) if connect else skills)


def cut_at_contacts(
    demonstration: Demonstration, segments: Iterable[PlannedSegment]
) -> list[PlannedSegment]:
    """The segments, those whose boundary lies beside their contact cut at the contact instead.

    A boundary says where to cut, a contact is when the force changed. Cut at one that was dragged
    to before its contact, the last way into it would belong to the skill that follows, which knows
    of no contact; cut so long after it that the demonstration does not end at it any more, the
    skill would not either. Whatever starts between the two starts at the contact; where too little
    would be left of it (0.1 s), the boundary stays.
    """
    parts = list(segments)
    moved = list[tuple[float, float]]()
    cut = list[PlannedSegment]()
    for part in parts:
        end_s = part.end_s
        met_s = met_beside_s(demonstration, part.start_s, end_s, part.end_condition)
        if met_s is not None and all(_is_left(one, end_s, met_s) for one in parts):
            moved.append((end_s, met_s))
            part = Cut(part.start_s, met_s, part.label, part.end_condition)
        cut.append(part)
    return [_begun_at_contact(part, moved) for part in cut]


def _is_left(part: PlannedSegment, boundary_s: float, contact_s: float) -> bool:
    between = boundary_s <= part.start_s < contact_s
    return not between or part.end_s - contact_s >= LEAST_S


def _begun_at_contact(part: PlannedSegment, moved: Sequence[tuple[float, float]]) -> PlannedSegment:
    """The segment, begun at the contact if it starts at, or between, a boundary and its contact."""
    met = [
        met_s
        for end_s, met_s in moved
        if end_s <= part.start_s < met_s or met_s < part.start_s == end_s
    ]
    return Cut(max(met), part.end_s, part.label, part.end_condition) if met else part


def skill_of(
    demonstration: Demonstration,
    segment: PlannedSegment,
    *,
    offset_m: float = OFFSET_M,
    beyond_contact: BeyondContact = "extended demonstration",
    fit: Fit = "least squares",
) -> Skill:
    """The skill of one segment.

    A contact-terminated one goes on `offset_m` beyond its contact, unless its end condition says
    how far: either the demonstration is extended before it is fitted, or, as in the paper, only
    the goal is shifted. It is tried on its own demonstration and says whether that ends it.

    Raises SkillError for a segment that cannot be made executable.
    """
    path = path_of(demonstration, segment.start_s, segment.end_s)
    end = segment.end_condition
    direction = direction_of_travel(path, end)[0] if isinstance(end, ContactEnd) else None
    offset_m = beyond_m(end, direction, offset_m)
    asked = isinstance(end, ContactEnd) and end.offset_m is not None
    further_m = FURTHER_M if offset_m > 0.0 and not asked else 0.0
    primitive = _primitive(path, end, offset_m, beyond_contact, fit)
    wxyz = path.orientation_wxyz
    skill = Skill(
        label=segment.label,
        connecting=False,
        primitive=primitive,
        end_condition=end,
        end_position_m=path.position_m[-1].copy(),
        end_orientation_wxyz=(primitive.goal_orientation_wxyz if wxyz is None else wxyz[-1].copy()),
        travel_direction=None if direction is None else _triple(direction),
        offset_m=offset_m,
        travel_limit_m=0.0
        if direction is None
        else _travel_limit(path, direction, offset_m) + further_m,
        timeout_s=end.timeout_s or timeout_for(primitive.duration_s),
        force_limit_N=force_limit(demonstration, segment.start_s, segment.end_s),
        demonstrated_s=(float(segment.start_s), float(segment.end_s)),
        arming=None if direction is None else _arming(path, direction),
        further_m=further_m,
    )
    return tried(skill, demonstration)


def beyond_m(end: EndCondition, travel: Array | None, offset_m: float) -> float:
    """How far a skill goes on beyond where the demonstration ended [m].

    Only beyond a contact that stands in its way: a force that falls, or that pulls along, is not
    looked for where the demonstration never was.

    Raises ParameterError for an offset below zero.
    """
    if not (np.isfinite(offset_m) and offset_m >= 0.0):
        raise ParameterError(f"The offset beyond a contact must not be below zero: {offset_m} m.")
    if not isinstance(end, ContactEnd) or travel is None:
        return 0.0
    if end.offset_m is not None:
        return end.offset_m
    pulled = float(travel @ np.asarray(end.direction)) > ALONG_THE_WAY
    return 0.0 if end.release or pulled else offset_m


def timeout_for(duration_s: float) -> float:
    """How long a skill of this duration may go without progress [s]."""
    least_s, most_s = TIMEOUT_S
    return min(max(_TIMEOUT_DURATIONS * duration_s, least_s), most_s)


def connected(skills: Sequence[Skill]) -> tuple[Skill, ...]:
    """The skills with connecting moves where one starts away from where the one before ended."""
    out = list(skills[:1])
    for before, after in pairwise(skills):
        if move := move_between(before, after):
            out.append(move)
        out.append(after)
    return tuple(out)


def move_between(before: Skill, after: Skill) -> Skill | None:
    """The connecting move from the end of one skill to the start of the next, if one is needed."""
    start = after.primitive
    there = (start.start_position_m, start.start_orientation_wxyz)
    here = (before.end_position_m, before.end_orientation_wxyz)
    if not is_apart(*here, *there):
        return None
    return connecting_skill(
        *here, *there, oriented=start.oriented, label=f"connect to {after.label}"
    )


def force_limit(demonstration: Demonstration, start_s: float, end_s: float) -> float:
    """Twice the largest demonstrated change of the force against the start, 15 N at least [N]."""
    if demonstration.force_N is None:
        return MIN_FORCE_LIMIT_N
    first, last = np.searchsorted(demonstration.time_s, (start_s, end_s + AFTER_S[1])).tolist()
    force = demonstration.force_N[first : max(last, first + 1)]
    change = np.sqrt(((force - force[0]) ** 2).sum(axis=1)).max()
    return max(FORCE_LIMIT_FACTOR * float(change), MIN_FORCE_LIMIT_N)


def _primitive(
    path: Path, end: EndCondition, offset_m: float, beyond_contact: BeyondContact, fit: Fit
) -> Primitive:
    if not isinstance(end, ContactEnd):
        return _fitted(path, fit)
    direction, speed = direction_of_travel(path, end)
    if beyond_contact == "extended demonstration":
        return _fitted(extended(path, direction, speed, offset_m), fit)
    primitive = _fitted(path, fit)
    return replace(primitive, goal_position_m=primitive.goal_position_m + offset_m * direction)


def _fitted(path: Path, fit: Fit) -> Primitive:
    return fit_primitive(path.time_s, path.position_m, path.orientation_wxyz, fit=fit)


def _arming(path: Path, travel: Array) -> Arming:
    way = float((path.position_m[-1] - path.position_m[0]) @ travel)
    return arming_for(way, path.duration_s)


def _travel_limit(path: Path, travel: Array, offset_m: float) -> float:
    """How far beyond the contact is too far: further than the path itself ever was, or goes on."""
    own = float(((path.position_m - path.position_m[-1]) @ travel).max())
    return max(offset_m, OFFSET_M) + TRAVEL_MARGIN_M + max(own, 0.0)


def _triple(vector: Array) -> tuple[float, float, float]:
    x, y, z = vector.tolist()
    return x, y, z
