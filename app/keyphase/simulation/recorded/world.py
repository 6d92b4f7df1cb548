"""A world made from a recording, in motion: the tool meets again what the recording says it met."""

from collections.abc import Mapping
from math import exp, inf, isfinite, pi
from typing import TYPE_CHECKING

import numpy as np

from keyphase.demonstration import Array
from keyphase.errors import SimulationError
from keyphase.simulation.disturbance import NOMINAL, Disturbance
from keyphase.simulation.impedance import RATE_HZ, Gains, Reference
from keyphase.simulation.part_shapes import Shape
from keyphase.simulation.recorded.arising import Arising
from keyphase.simulation.recorded.arm_body import ArmBody
from keyphase.simulation.recorded.body import ToolBody
from keyphase.simulation.recorded.meeting import Meeting, made_within
from keyphase.simulation.recorded.repeating import Repeating
from keyphase.simulation.recorded.surfaces import SLIPS, STIFFNESS_N_M
from keyphase.simulation.simulation import Sample

if TYPE_CHECKING:
    from keyphase.simulation.recorded.cell import RecordedCell

DAMPING_NS_M = 40.0
"""Against a surface that gives way as it did under the recorded tool."""

ASIDE_M, BEHIND_M = 0.04, 0.02
"""A surface ends this far aside of where it was touched, and this far behind itself."""

NOISE_N = 0.05
CUTOFF_HZ = 70.0

SUBSTEPS = 2

FIRMER = 1.5
"""A body on its way damps nothing, and pushed further it resists with so much of what it was
recorded resisting, and moves on; what is one in part does so in part."""

Moves = tuple[float, float, float]
"""How fast a surface moves along its normal now [m/s], its damping [N s/m], its greatest force."""

STANDS: Moves = (0.0, DAMPING_NS_M, inf)

Plane = tuple[int, Array, Array, float, Moves, float]
"""Index of its surface, point (3,), normal (3,), friction, how it moves, stiffness [N/m]."""

DISC_M, TIP_M = (0.03, 0.03, 0.001), (0.008, 0.008, 0.008)
GREY, RED = (0.45, 0.47, 0.50, 0.7), (0.80, 0.10, 0.10, 1.0)
_CREEP_M_S = 0.005
_MEASURED_EVERY = 5


class RecordedWorld:
    """One world being simulated; made by `RecordedCell.build`."""

    def __init__(
        self, cell: "RecordedCell", disturbance: Disturbance, seed: int, gains: Gains
    ) -> None:
        self.workcell, self.disturbance = cell, disturbance
        self.gains = gains
        self.contact_names = ()
        self.joint_names = cell.arm.joints if cell.arm else ()
        self.bodies = cell.parts
        self._random = np.random.default_rng(seed)
        self._place = cell.placed(disturbance)
        self._rougher = max(disturbance.friction - NOMINAL.friction, 0.0)
        drawn = self._random.standard_normal(3)
        self._bias = disturbance.sensor_bias_N * drawn / np.linalg.norm(drawn)
        self._gain = 1.0 - exp(-2.0 * pi * CUTOFF_HZ / RATE_HZ)
        self.reset()

    def reset(self) -> None:
        """Back to the recording's start, under the force that was recorded there."""
        even, start = self.workcell.even, self.workcell.even.time_s[0]
        if self.workcell.arm is not None:
            self.body = ArmBody(self.workcell.arm, self.gains)
        else:
            at = even.position_m[0], even.orientation_wxyz[0]
            self.body = ToolBody(*at, np.zeros(3), np.zeros(3))
        self.repeating = Repeating(self.workcell.even, self.workcell.gripper)
        self.meeting = Meeting(self.workcell.surfaces, self.workcell.begins_s)
        self._late_s: dict[int, float] = {}
        self._arising = Arising()
        self._span_s: tuple[float, float] | None = None
        self.furthest_m = 0.0
        self._ticks, self._pushed = 0, (np.zeros(3), np.zeros(3))
        self._moment: float | None = float(start)
        self._opening = self.workcell.opening_at(float(start))
        self._pace = 0.0
        self._on_path = True
        self._planes = self._standing()
        self._force = self._contact()[0]
        self._passed = self._force
        self.start_parts = self.part_poses()

    def be_at(self, moment_s: float | None, span_s: tuple[float, float] | None = None) -> None:
        """The moment of the demonstration that is being repeated; None: nothing of it is.

        `span_s` is the stretch that the skill repeats: what was met in it is to be met again, and
        what is met late becomes what it became so much later. None while a skill seeks, or squares
        a part, and so is on no recorded path. Who led the robot also moved its gripper: it opens
        and closes as it then did.
        """
        if span_s is not None and span_s != self._span_s:
            self._span_s = span_s
            self._late_s.clear()
        self._pace = _pace(self._moment, moment_s)
        self._moment, self._on_path = moment_s, span_s is not None
        if moment_s is not None:
            self._opening = self.workcell.opening_at(moment_s)
        if moment_s is not None and span_s is not None:
            self.repeating.begin(span_s)
            self.meeting.repeat(moment_s, span_s)

    def step(self, reference: Reference) -> Sample:
        """One control tick of 4 ms towards `reference`.

        Raises SimulationError when the tool is thrown away.
        """
        self._planes = self._standing()
        h, mean = 1.0 / (SUBSTEPS * RATE_HZ), np.zeros(3)
        for _ in range(SUBSTEPS):
            force, torque = self.body.pull(reference, self.gains)
            contact, _ = self._contact()
            mean += contact / SUBSTEPS
            pushed, twisted = self._pushed
            self.body.advance(force + contact + pushed, torque + twisted, h)
        self._ticks += 1
        self._force = mean
        if not isfinite(mean.dot(mean)) or np.abs(self.body.position_m).max() > 50.0:
            raise SimulationError(
                f"{self.workcell.name} diverged after {self._ticks / RATE_HZ:.3f} s; "
                "use smaller disturbances."
            )
        self._note()
        return self._sample()

    def exert(self, force_N: Array, torque_Nm: Array) -> None:
        """A hand on the tool exerts this (3,), (3,), base frame, until told otherwise."""
        self._pushed = (force_N, torque_Nm)

    def tool_pose(self) -> tuple[Array, Array]:
        """Position (3,) and orientation (4,), w x y z, of the tool point in the base frame."""
        return self.body.position_m.copy(), self.body.orientation_wxyz.copy()

    def tool_velocity(self) -> Array:
        """Velocity (6,) of the tool point in the base frame: m/s, then rad/s."""
        return np.concatenate((self.body.velocity_m_s, self.body.angular_velocity_rad_s))

    def here(self) -> Reference:
        """The reference that keeps the tool where it is, under the force that it is under."""
        position, wxyz = self.tool_pose()
        return Reference(position - self._force / self.gains.stiffness_N_m, wxyz)

    def part_poses(self) -> Mapping[str, tuple[Array, Array]]:
        """The tool, and the surfaces where they are met."""
        poses = {"held": self.tool_pose()}
        standing = {index: (point, normal) for index, point, normal, *_ in reversed(self._planes)}
        for index, name in enumerate(self.workcell.parts[1:]):
            surface = self.workcell.surfaces[index]
            at = standing.get(index, self._moved(surface.point_m[0], surface.normal[0]))
            poses[name] = (at[0], _upright(at[1]))
        return poses

    def frame(self) -> tuple[Array, Array]:
        """Positions (B, 3) and orientations (B, 4) of the parts; there is no robot."""
        positions, orientations = zip(*self.part_poses().values(), strict=True)
        return np.array(positions), np.array(orientations)

    def shapes(self) -> tuple[Shape, ...]:
        """The tool's point as a ball-like cylinder, each surface as a disc."""
        return tuple(_disc(name, name != "held") for name in self.workcell.parts)

    def _standing(self) -> list[Plane]:
        """What the tool could meet now."""
        if self._moment is None:
            return []
        found = []
        for index, surface in enumerate(self.workcell.surfaces):
            if not surface.stands(self._moment):
                continue
            point, normal, friction, moves = self._plane(index)
            away = self.body.position_m - point
            depth = -float(away.dot(normal))
            aside = away + depth * normal
            if depth >= BEHIND_M or aside.dot(aside) >= ASIDE_M**2:
                self._arising.absent(index)
                continue
            pressed_m = surface.pressed_with(self._moment) / STIFFNESS_N_M
            point = point - self._arising.back_m(index, depth, pressed_m) * normal
            found.append((index, point, normal, friction, moves, STIFFNESS_N_M))
            found += self._stops_of(index, self._moment)
        return found

    def _stops_of(self, index: int, moment_s: float) -> list[Plane]:
        """What ends a slide on a surface now, as further planes of it."""
        stops = self.workcell.surfaces[index].stops
        now = (stop for stop in stops if stop.from_s <= moment_s <= stop.to_s)
        return [
            (index, *self._moved(stop.point_m, stop.normal), SLIPS, STANDS, stop.stiffness_N_m)
            for stop in now
        ]

    def _plane(self, index: int) -> tuple[Array, Array, float, Moves]:
        assert self._moment is not None
        surface, moment = self.workcell.surfaces[index], self._moment - self._late_s.get(index, 0.0)
        if index not in self.meeting.touched and self._is_made_now(index):
            # Until then it is what was met first, and not what it became under the tool.
            moment = min(moment, surface.made_s)
        shift, turn = self._place
        here = turn.T @ (self.body.position_m - shift)
        plane = surface.plane(here, moment)
        most_N = FIRMER * plane.force_N / plane.leaps if plane.leaps > 0.0 else inf
        moves = self._pace * plane.closing_m_s, (1.0 - plane.leaps) * DAMPING_NS_M, most_N
        return *self._moved(plane.point_m, plane.normal), plane.friction + self._rougher, moves

    def _is_made_now(self, index: int) -> bool:
        """Whether the contact was made within the stretch that is repeated, not before it."""
        return made_within(self.workcell.surfaces[index].made_s, self._span_s)

    def _moved(self, point: Array, normal: Array) -> tuple[Array, Array]:
        shift, turn = self._place
        return turn @ point + shift, turn @ normal

    def _contact(self) -> tuple[Array, dict[int, float]]:
        """Force (3,) of all surfaces on the tool, and of each along its normal."""
        total, each = np.zeros(3), {}
        velocity = self.body.velocity_m_s
        for index, point, normal, friction, (gives, damping, most_N), stiffness in self._planes:
            depth = float((point - self.body.position_m).dot(normal))
            if depth <= 0.0:
                continue
            closing = float(velocity.dot(normal))
            damped = damping * (closing - gives)
            pressed = min(max(stiffness * depth - damped, 0.0), most_N)
            slip = velocity - closing * normal
            speed = max(float(np.sqrt(slip.dot(slip))), _CREEP_M_S)
            total += pressed * (normal - (friction / speed) * slip)
            each[index] = max(pressed, each.get(index, 0.0))
        return total, each

    def _note(self) -> None:
        for index in self.meeting.press(self._contact()[1], self._ticks / RATE_HZ):
            if self._is_made_now(index):
                late_s = (self._moment or 0.0) - self.workcell.surfaces[index].made_s
                self._late_s[index] = max(late_s, 0.0)
        on_path = self._moment is not None and self._on_path
        if on_path and self._ticks % _MEASURED_EVERY == 0:
            away = self.workcell.off_path(self.body.position_m, self._moment or 0.0)
            self.furthest_m = max(self.furthest_m, away)

    def _sample(self) -> Sample:
        self._passed = self._passed + self._gain * (self._force - self._passed)
        noise = NOISE_N * self.disturbance.sensor_noise * self._random.standard_normal(3)
        position, wxyz = self.tool_pose()
        return Sample(
            time_s=self._ticks / RATE_HZ,
            position_m=position,
            orientation_wxyz=wxyz,
            joints_rad=self.body.joints_rad,
            force_N=self._passed + noise + self._bias,
            torque_Nm=np.zeros(3),
            contact_N=np.zeros(0),
            gripper=self._opening,
        )


def _pace(before_s: float | None, now_s: float | None) -> float:
    """How much of the demonstration is repeated in the time that a tick takes, 0 to 1."""
    if before_s is None or now_s is None:
        return 0.0
    return min(max((now_s - before_s) * RATE_HZ, 0.0), 1.0)


def _disc(name: str, is_surface: bool) -> Shape:
    size, color = (DISC_M, GREY) if is_surface else (TIP_M, RED)
    down = -0.5 * size[2] if is_surface else 0.0
    return Shape(
        name=name,
        body=name,
        kind="cylinder",
        size_m=np.array(size),
        position_m=np.array([0.0, 0.0, down]),
        orientation_wxyz=np.array([1.0, 0.0, 0.0, 0.0]),
        rgba=color,
    )


def _upright(normal: Array) -> Array:
    """Quaternion that turns the z axis into `normal`."""
    axis, w = np.array([-normal[1], normal[0], 0.0]), 1.0 + float(normal[2])
    wxyz = np.array([w, *axis]) if w > 1e-9 else np.array([0.0, 1.0, 0.0, 0.0])
    return wxyz / np.linalg.norm(wxyz)
