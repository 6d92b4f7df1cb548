"""Contacts that a replay keeps: it presses on in the direction in which a contact was met.

A recorded pose lies on the surface that was touched; the force with which the hand pressed is in
the recorded force alone. Along the direction of a contact the replay therefore follows the
demonstrated force, and everywhere else the demonstrated pose.
"""

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from keyphase.demonstration import Array, Demonstration
from keyphase.segmentation.end_condition import AFTER_S, LAST_S, ContactEnd
from keyphase.skills.coupling import Measured, State
from keyphase.skills.skill import Skill

LEAST_FORCE_N = 0.5
"""A demonstration that presses less than this keeps no contact."""

LARGEST_DEPTH_M, LARGEST_SLOPE = 0.005, 0.1
"""A contact is kept by a skill that moves less than this, or this part of its way, along it."""

STEEPEST = 0.4
"""Largest part of a way that may lie along a contact for the way to have slid on the surface."""

LEAST_SLIDE_M = 0.01
"""A way shorter than this says nothing about the surface."""

STAYED_WITHIN_M = 0.002
"""A demonstration that moved less than this after a contact stayed in it."""

FURTHEST_M = 0.01
"""How far beyond the skill's own path a contact is followed."""

WINDOW_S = 0.2
"""The demonstrated force is averaged over this time: the hand's tremor is not to be repeated."""

_AGAINST_FORCE = 0.5
_GRID = 51


@dataclass(frozen=True, eq=False)
class KeptContact:
    """A contact and the force that is kept up in it.

    direction  (3,) unit vector in which the tool presses, base frame
    force_N    (G,) what to press with, evenly over the demonstrated time of the skill
    """

    direction: Array
    force_N: Array

    def force_at(self, fraction: float) -> float:
        """The force [N] at a fraction (0 to 1) of the demonstrated time."""
        return float(np.interp(fraction, self._fractions, self.force_N))

    @cached_property
    def _fractions(self) -> Array:
        return np.linspace(0.0, 1.0, len(self.force_N))

    def pressed_m(
        self, position_m: Array, own_m: Array, fraction: float, stiffness_N_m: float
    ) -> float:
        """Where along `direction` the reference of a spring presses as wanted [m].

        position_m (3,) is where the tool is, own_m (3,) where the skill's path is.
        """
        here = float(position_m.dot(self.direction)) + self.force_at(fraction) / stiffness_N_m
        return min(here, float(own_m.dot(self.direction)) + FURTHEST_M)


@dataclass(frozen=True, eq=False)
class AfterContact:
    """What a demonstration did right after a contact.

    direction   (3,) unit vector in which it pressed
    force_N     how hard
    position_m  (3,) where the tool was
    stayed      whether it stayed there and pressed; else it moved on in that direction
    """

    direction: Array
    force_N: float
    position_m: Array
    stayed: bool

    def kept(self) -> KeptContact:
        """The contact, pressed as it was demonstrated."""
        return KeptContact(self.direction, np.array([self.force_N]))

    def shift(self, ended_m: Array, shift_m: Array) -> Array:
        """How far (3,) what follows is moved, for a tool that pressed at `ended_m` (3,).

        Like `keyphase.skills.skill.shift_after`, but against where the demonstration pressed:
        that is there to the tenth of a millimetre, whenever exactly the segment was cut.
        """
        away = ended_m - shift_m - self.position_m
        return shift_m + float(away @ self.direction) * self.direction


def pressing_direction(skill: Skill) -> Array:
    """Unit vector (3,) in which a contact-terminated skill presses.

    That of its travel, as friction tilts the force; but where the travel does not go against the
    force at all, against the force.
    """
    assert isinstance(skill.end_condition, ContactEnd)
    against = -np.asarray(skill.end_condition.direction)
    travel = against if skill.travel_direction is None else np.asarray(skill.travel_direction)
    return travel if float(travel @ against) > _AGAINST_FORCE else against


def after_contact(demonstration: Demonstration, skill: Skill) -> AfterContact:
    """What the demonstration did right after the contact that ends `skill`.

    Judged over the time that its end condition's force step was, too.
    """
    assert skill.demonstrated_s is not None
    direction = pressing_direction(skill)
    end_s = skill.demonstrated_s[1]
    inside = _inside(demonstration, (end_s + AFTER_S[0], end_s + AFTER_S[1]))
    if inside.stop <= inside.start:
        inside = _inside(demonstration, (end_s + LAST_S[0], end_s))
    path, force = demonstration.position_m[inside], demonstration.force_N
    if force is None or not len(path):
        return AfterContact(direction, 0.0, skill.end_position_m, stayed=False)
    pressed = -float((force[inside] @ direction).mean())
    stayed = pressed >= LEAST_FORCE_N and float(np.ptp(path @ direction)) <= STAYED_WITHIN_M
    return AfterContact(direction, pressed, path.mean(axis=0), stayed)


def kept_contact(
    contact: KeptContact, demonstration: Demonstration, skill: Skill
) -> KeptContact | None:
    """The contact as the next skill keeps it; None where the demonstration had left it.

    It had if it did not press most of the time, or moved along the contact's direction.
    """
    if skill.demonstrated_s is None:
        return None
    inside = _inside(demonstration, skill.demonstrated_s)
    path = demonstration.position_m[inside]
    direction = _off_the_way(contact.direction, path)
    if demonstration.force_N is None or direction is None:
        return None
    force = -(demonstration.force_N[inside] @ direction)
    if float(np.median(force)) < LEAST_FORCE_N:
        return None
    smooth = _smoothed(force, demonstration.rate_hz)
    grid = np.linspace(0, len(smooth) - 1, _GRID)
    profile = np.interp(grid, np.arange(len(smooth)), smooth)
    return KeptContact(direction, np.maximum(profile, LEAST_FORCE_N))


def square(contact: KeptContact, others: tuple[KeptContact, ...]) -> KeptContact | None:
    """The contact with its direction at right angles to those of `others`; None if it lies in them.

    Forces along directions at right angles do not disturb each other.
    """
    direction = contact.direction
    for other in others:
        direction = direction - float(direction @ other.direction) * other.direction
    length = float(np.linalg.norm(direction))
    return replace(contact, direction=direction / length) if length > _AGAINST_FORCE else None


def given_way(measured: Measured, state: State, contacts: tuple[KeptContact, ...]) -> Measured:
    """What was measured, with the primitive's own motion along the contacts' directions.

    Where a force is followed, the pose is whatever it is, and no error of the coupling.
    """
    if not contacts:
        return measured
    position, velocity = measured.position_m, measured.velocity.copy()
    for contact in contacts:
        d = contact.direction
        position = position + float((state.position_m - position).dot(d)) * d
        velocity[:3] += float((state.reference_velocity[:3] - velocity[:3]).dot(d)) * d
    return Measured(position, measured.orientation_wxyz, velocity)


def _off_the_way(direction: Array, path: Array) -> Array | None:
    """The direction of a contact, made square to a way along its surface; None if it left it.

    The way that was slid tells the surface better than the way into the contact does.
    """
    if len(path) < 2:
        return None
    slid = path[-1] - path[0]
    length = float(np.linalg.norm(slid))
    if length > LEAST_SLIDE_M:
        slope = float(direction @ slid) / length
        if abs(slope) > STEEPEST:
            return None
        direction = direction - slope * slid / length
        direction = direction / np.linalg.norm(direction)
    way = float(np.linalg.norm(np.diff(path, axis=0), axis=1).sum())
    deep = float(np.ptp(path @ direction)) > max(LARGEST_DEPTH_M, LARGEST_SLOPE * way)
    return None if deep else direction


def _inside(demonstration: Demonstration, span_s: tuple[float, float]) -> slice:
    first, last = np.searchsorted(demonstration.time_s, span_s).tolist()
    return slice(first, last)


def _smoothed(values: Array, rate_hz: float) -> Array:
    """Running mean; at the ends over what is there."""
    window = np.ones(min(max(1, round(WINDOW_S * rate_hz)), len(values)))
    return np.convolve(values, window, "same") / np.convolve(np.ones(len(values)), window, "same")
