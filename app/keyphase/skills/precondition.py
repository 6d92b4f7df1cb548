"""What must hold before a skill runs: where the tool is, what it presses, what the gripper does."""

from collections.abc import Sequence
from dataclasses import dataclass
from math import radians

from keyphase.demonstration import Array
from keyphase.rotations import quaternions
from keyphase.skills.coupling import Measured
from keyphase.skills.pressed import KeptForce
from keyphase.skills.primitive import Primitive

PRESSED_FROM_N, PRESSED_SHARE = 3.0, 0.2
"""A contact of so many newtons and more is held if this part of its force is felt."""


@dataclass(frozen=True, eq=False)
class HeldContact:
    """A contact that is held: pressed along a unit vector (3,) with `least_N` at least."""

    direction: Array
    least_N: float


@dataclass(frozen=True, eq=False)
class Precondition:
    """What a skill assumes.

    position_m, orientation_wxyz  (3,), (4,) where its demonstration started; no orientation where
                                  none was recorded
    position_tolerance_m, rotation_tolerance_rad  the primitive takes up what lies within
    contacts                      contacts it is to be in already
    gripper                       "open" or "closed"; None where it was not recorded
    """

    position_m: Array
    orientation_wxyz: Array | None
    position_tolerance_m: float = 0.03
    rotation_tolerance_rad: float = radians(15.0)
    contacts: tuple[HeldContact, ...] = ()
    gripper: str | None = None

    def unmet(
        self, measured: Measured, force_N: Array, shift_m: Array, gripper: str | None = None
    ) -> str:
        """What does not hold, in words; nothing where all does.

        `shift_m` (3,) is how far the skill is executed away from its demonstration.
        """
        away = measured.position_m - shift_m - self.position_m
        if float(away.dot(away)) > self.position_tolerance_m**2:
            return f"the tool is {1e3 * float(away.dot(away)) ** 0.5:.0f} mm from its start"
        if self.orientation_wxyz is not None:
            turn = quaternions.shortest_difference(self.orientation_wxyz, measured.orientation_wxyz)
            if float(turn.dot(turn)) > self.rotation_tolerance_rad**2:
                return "the tool is turned away from its start"
        for contact in self.contacts:
            if -float(force_N.dot(contact.direction)) < contact.least_N:
                return "a contact that it needs is not held"
        if None not in (gripper, self.gripper) and gripper != self.gripper:
            return f"the gripper is not {self.gripper}"
        return ""


def precondition_of(primitive: Primitive, kept: Sequence[KeptForce]) -> Precondition:
    """What a skill assumes: to be where it was demonstrated, in the contacts that it keeps up."""
    firm = (force.at(0.0) for force in kept if force.met)
    held = tuple(
        HeldContact(one[0], PRESSED_SHARE * one[1])
        for one in firm
        if one is not None and one[1] >= PRESSED_FROM_N
    )
    wxyz = primitive.start_orientation_wxyz if primitive.oriented else None
    return Precondition(primitive.start_position_m, wxyz, contacts=held)
