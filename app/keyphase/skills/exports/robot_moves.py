"""A plan as moves that any robot controller knows: straight lines, and moves until a contact.

A primitive is more than its path, but a controller without an executor of skills can follow the
path's corners and stop where the force says so.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from keyphase.demonstration import Array
from keyphase.rotations import quaternions
from keyphase.segmentation.end_condition import ConfigurationEnd, ContactEnd
from keyphase.skills.execution.guard import SPEED_M_S, guarded_speed, guarded_stretch
from keyphase.skills.skill import Skill, by_gripper, drawn

CORNER_M, CORNER_RAD = 0.001, 0.02
"""Corners are kept so that straight lines between them stay so near to the path."""

MAX_CORNERS = 40
MAX_SPEED_M_S, MIN_SPEED_M_S = 0.25, 0.01
RETRACT_M = 0.02

_POINTS = 201
_METRES_PER_RAD = CORNER_M / CORNER_RAD


@dataclass(frozen=True, eq=False)
class UntilContact:
    """Going on in a direction until the force comes.

    travel        (3,) unit vector in which the tool goes on
    speed_m_s     how fast
    force         (3,) unit vector along which the force is to rise
    threshold_N   by how much, against its level as the move begins
    search_m      how far to go at most; beyond it the move has failed
    retract_m     how far to go back then
    """

    travel: Array
    speed_m_s: float
    force: Array
    threshold_N: float
    search_m: float
    retract_m: float = RETRACT_M


@dataclass(frozen=True, eq=False)
class RobotMove:
    """One skill: corners of its path, and the contact it goes on to, if it does.

    position_m (N, 3), orientation_wxyz (N, 4); `contact` begins where the last corner is, and
    `gripper` says what it does there, for the person who writes the call of theirs.
    """

    label: str
    position_m: Array
    orientation_wxyz: Array
    speed_m_s: float
    contact: UntilContact | None
    gripper: str = ""


def robot_moves(skills: Sequence[Skill]) -> tuple[RobotMove, ...]:
    """The moves of a plan, one for each skill."""
    return tuple(map(_move, skills))


def _move(skill: Skill) -> RobotMove:
    path = drawn(skill, _POINTS)
    position, wxyz = path.position_m, path.orientation_wxyz
    contact = _contact(skill)
    if contact is not None:
        travel = np.asarray(skill.travel_direction)
        ahead = (skill.end_position_m - position) @ travel
        # What lies within the guarded stretch is left to the contact move.
        near = np.flatnonzero(ahead <= guarded_stretch(skill))
        last = max(int(near[0]) if len(near) else len(position) - 1, 1)
        position, wxyz = position[: last + 1], wxyz[: last + 1]
    corners = _corners(position, wxyz)
    way = float(np.linalg.norm(np.diff(path.position_m, axis=0), axis=1).sum())
    speed = min(max(way / skill.primitive.duration_s, MIN_SPEED_M_S), MAX_SPEED_M_S)
    end = skill.end_condition
    grip = by_gripper(end) if isinstance(end, ConfigurationEnd) else ""
    return RobotMove(skill.label, position[corners], wxyz[corners], speed, contact, grip)


def _contact(skill: Skill) -> UntilContact | None:
    end = skill.end_condition
    if not isinstance(end, ContactEnd) or skill.travel_direction is None:
        return None
    return UntilContact(
        travel=np.asarray(skill.travel_direction),
        speed_m_s=guarded_speed(skill) or SPEED_M_S[0],
        force=np.asarray(end.direction),
        threshold_N=end.threshold_N,
        search_m=guarded_stretch(skill) + max(skill.travel_limit_m, skill.offset_m),
    )


def _corners(position_m: Array, wxyz: Array) -> list[int]:
    """Rows that are kept, the first not: the worst one is added until all others are near."""
    turn = quaternions.difference(wxyz, wxyz[0])
    path = np.hstack([position_m, _METRES_PER_RAD * turn])
    kept = [0, len(path) - 1]
    while len(kept) < MAX_CORNERS + 1:
        away = _off_the_line(path, kept)
        worst = int(away.argmax())
        if away[worst] <= CORNER_M:
            break
        kept = sorted({*kept, worst})
    return kept[1:]


def _off_the_line(path: Array, kept: Sequence[int]) -> Array:
    """How far each row is from the straight line between the corners around it."""
    away = np.zeros(len(path))
    for first, last in pairwise(kept):
        step = path[last] - path[first]
        length = max(float(step @ step), 1e-18)
        rows = path[first : last + 1] - path[first]
        along = np.clip(rows @ step / length, 0.0, 1.0)
        away[first : last + 1] = np.linalg.norm(rows - along[:, None] * step, axis=1)
    return away
