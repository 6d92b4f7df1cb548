"""A world made from a recording, as a workcell: anything with a force can be replayed in it."""

from collections.abc import Mapping
from dataclasses import replace
from functools import cached_property
from math import sqrt
from pathlib import Path

import numpy as np

from keyphase.demonstration import Array, Demonstration
from keyphase.doubtful_force import doubtful_force
from keyphase.errors import SimulationError
from keyphase.recorded_force import Even, evenly, offset_while_moving
from keyphase.simulation.disturbance import NOMINAL, Disturbance
from keyphase.simulation.impedance import Gains
from keyphase.simulation.recorded.meeting import DUE_S
from keyphase.simulation.recorded.reaching import Pose
from keyphase.simulation.recorded.robot_arm import robot_arm
from keyphase.simulation.recorded.surfaces import Surface, surfaces_of
from keyphase.simulation.recorded.world import RecordedWorld
from keyphase.skills.gains import demonstrated_peak, gains_for

NAME = "recording"

WITHIN_M = 0.005
"""A replay that strays further than this from the recorded path has not repeated it."""

_WINDOW_S = 0.6
_POSES = 12


class RecordedCell:
    """What a recording met, ready to be met again; has the face of a `Workcell`."""

    name = NAME
    title = "The world made from the recording"
    events = ()
    onsets = ()
    ends_at_contact = False

    def __init__(self, demonstration: Demonstration, robot: tuple[Path, str] | None = None) -> None:
        """`robot` is the file of an arm that is to move the tool, and its tool frame.

        Raises SimulationError for a recording without force, and for an arm that cannot be read or
        does not reach it.
        """
        if demonstration.force_N is None:
            raise SimulationError(
                f"A world is made from a recorded force, but {demonstration.name} has none; "
                "choose a workcell with --workcell."
            )
        even = evenly(demonstration)
        free = offset_while_moving(even)
        self.even: Even = replace(even, force_N=even.force_N - free)
        self.demonstration = replace(demonstration, force_N=demonstration.force_N - free)
        self.doubt = doubtful_force(demonstration)
        self.surfaces: tuple[Surface, ...] = surfaces_of(self.even)
        self.arm = None if robot is None else robot_arm(*robot, self._some_poses())
        self.parts = ("held", *(f"surface_{n + 1}" for n in range(len(self.surfaces))))

    @property
    def begins_s(self) -> float:
        """A contact that was made by then is one the recording begins in [s]."""
        return float(self.even.time_s[0]) + DUE_S

    def build(self, disturbance: Disturbance = NOMINAL, seed: int = 0) -> RecordedWorld:
        """The world at the recording's start; `seed` sets the sensor's noise."""
        return RecordedWorld(self, disturbance, seed, self.gains)

    @cached_property
    def gains(self) -> Gains:
        """Those of the skills, and no bound on what the demonstration pressed."""
        of_skills, usual = gains_for(self.demonstration), Gains()
        return replace(
            usual,
            stiffness_N_m=of_skills.stiffness_N_m,
            damping_Ns_m=of_skills.damping_Ns_m,
            greatest_force_N=max(
                usual.greatest_force_N, 2.0 * demonstrated_peak(self.demonstration)
            ),
        )

    def _some_poses(self) -> list[Pose]:
        """Poses spread over the recording, its ends among them."""
        rows = np.unique(np.linspace(0, len(self.even.time_s) - 1, _POSES).astype(int))
        return [(self.even.position_m[row], self.even.orientation_wxyz[row]) for row in rows]

    def placed(self, disturbance: Disturbance) -> tuple[Array, Array]:
        """Shift (3,) and turn (3, 3) of the surfaces: about the vertical through the first one."""
        shift = np.array([*disturbance.part_offset_m, disturbance.part_height_m])
        c, s = np.cos(disturbance.part_turn_rad), np.sin(disturbance.part_turn_rad)
        turn = np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])
        if not self.surfaces:
            return shift, turn
        about = self.surfaces[0].point_m[0]
        return about - turn @ about + shift, turn

    @cached_property
    def gripper(self) -> Array | None:
        """(N,) its opening at the times of `even`; None where none was recorded."""
        gripper = self.demonstration.gripper
        if gripper is None:
            return None
        return np.interp(self.even.time_s, self.demonstration.time_s, gripper)

    def opening_at(self, moment_s: float) -> float | None:
        """The gripper's recorded opening at a moment; None where none was recorded."""
        if self.gripper is None:
            return None
        return float(np.interp(moment_s, self.even.time_s, self.gripper))

    def off_path(self, position_m: Array, moment_s: float) -> float:
        """How far a place (3,) is from the recorded path around a moment [m]."""
        span = (moment_s - _WINDOW_S, moment_s + _WINDOW_S)
        rows = slice(*np.searchsorted(self.even.time_s, span).tolist())
        away = self.even.position_m[rows] - position_m
        if not len(away):
            away = self.even.position_m[-1:] - position_m
        return sqrt(float(np.einsum("ij,ij->i", away, away).min()))

    def checks(self, world: RecordedWorld) -> Mapping[str, bool]:
        """Contacts, path, and whether the force can be what it says."""
        checks = {
            "demonstration repeated": world.repeating.whole,
            "contacts met in order": world.meeting.in_order,
            "contacts pressed": world.meeting.firm,
            f"path within {1e3 * WITHIN_M:.0f} mm": world.furthest_m
            <= WITHIN_M + self._moved_by(world.disturbance),
        }
        return checks | ({} if self.doubt is None else {"a force to be trusted": False})

    def _moved_by(self, disturbance: Disturbance) -> float:
        """How much further off its recorded path a tool may be in a world that was moved [m].

        As far as it was moved, and as far as the tool goes on to meet what it comes to at a slant.
        """
        shift = np.array([*disturbance.part_offset_m, disturbance.part_height_m])
        goes_on = [one.slant * abs(float(shift @ one.normal[0])) for one in self.surfaces]
        return max(float(np.linalg.norm(shift)), *goes_on, 0.0)

    def goals(self, world: RecordedWorld) -> tuple[str, ...]:
        """Names of all that success asks, before anything has happened."""
        return tuple(self.checks(world))
