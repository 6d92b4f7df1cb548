# MuJoCo tells no types.
# pyright: reportAttributeAccessIssue=false
"""A workcell in motion: physics, controller and wrist sensor behind one `step`."""

from collections.abc import Mapping
from dataclasses import dataclass
from math import isfinite
from typing import TYPE_CHECKING

import mujoco
import numpy as np
from numpy.typing import ArrayLike

from keyphase.demonstration import Array
from keyphase.errors import SimulationError
from keyphase.simulation.contacts import Contacts
from keyphase.simulation.disturbance import Disturbance
from keyphase.simulation.impedance import RATE_HZ, CartesianImpedance, Gains, Reference
from keyphase.simulation.part_shapes import Shape, shapes_in
from keyphase.simulation.robot_scene import TOOL_BODY
from keyphase.simulation.wrist_sensor import (
    Load,
    SensorModel,
    WristSensor,
    about_tool,
    estimated_load,
)

if TYPE_CHECKING:
    from keyphase.simulation.workcells.workcell import Workcell

_CALIBRATION_TILTS_RAD = ((0.0, 0.0), (0.4, 0.0), (-0.4, 0.0), (0.0, 0.4), (0.0, -0.4))
"""Turns of the last two joints but one, from the start: enough tilt to tell weight from bias."""
_CALIBRATION_TICKS, _CALIBRATION_SETTLING_TICKS = 40, 15

_SITE = int(mujoco.mjtObj.mjOBJ_SITE)

_MAX_DISTANCE_M = 5.0
"""A tool that is further away has been thrown there by physics that diverged."""


@dataclass(frozen=True, eq=False)
class Sample:
    """What one 250 Hz tick gives; base frame, torque about the tool point.

    `contact_N` holds the simulator's own normal forces, one per pair of the workcell: ground
    truth, which nothing that controls or segments may read. `gripper` is its opening; None where
    the world has none that opens.
    """

    time_s: float
    position_m: Array
    orientation_wxyz: Array
    joints_rad: Array
    force_N: Array
    torque_Nm: Array
    contact_N: Array
    gripper: float | None = None


class Simulation:
    """One workcell being simulated; made by `Workcell.build`."""

    def __init__(
        self, workcell: "Workcell", model: mujoco.MjModel, disturbance: Disturbance, seed: int
    ) -> None:
        self.workcell, self.disturbance = workcell, disturbance
        self.model, self.data = model, mujoco.MjData(model)
        arm = workcell.arm
        joints = np.array([model.joint(name).id for name in arm.joints])
        self._positions = model.jnt_qposadr[joints]
        self._tool, wrist = model.site(arm.tool_site).id, model.site(arm.sensor_site).id
        first = int(model.sensor("wrist_force").adr[0])
        self._exerted = slice(first, first + 6)
        # Views, into which every step of the physics writes.
        self._readings = self.data.sensordata
        places, turns = self.data.site_xpos, self.data.site_xmat
        self._tool_m, self._tool_turn = places[self._tool], turns[self._tool]
        self._wrist_m, self._wrist_turn = places[wrist], turns[wrist].reshape(3, 3)
        self._substeps = round(1.0 / (RATE_HZ * model.opt.timestep))
        bodies = (model.body(index).name for index in range(1, model.nbody))
        links = tuple(name for name in bodies if name not in workcell.parts)
        self.bodies = (*links, *workcell.parts)
        self._links = links
        self._drawn = [model.body(name).id for name in self.bodies]
        self._tool_body = int(model.site_bodyid[self._tool])
        self.controller = CartesianImpedance(model, self._tool, joints, Gains())
        self.contacts = Contacts(model, workcell.pairs)
        sensor = SensorModel().worse(disturbance.sensor_noise, disturbance.sensor_drift)
        self.sensor = WristSensor(sensor, 1.0 / RATE_HZ, seed)
        self.posture_rad = np.array(workcell.start_joints_rad)
        self.load = self._calibrated()
        self.sensor.be_off_by(disturbance.sensor_bias_N)
        self.reset()

    def reset(self) -> None:
        """Back to the start: arm at its start, parts where they belong, time zero."""
        self._place(self.posture_rad)
        self._ticks = 0
        self.start_parts = self.part_poses()

    def step(self, reference: Reference) -> Sample:
        """One control tick of 4 ms towards `reference`.

        Raises SimulationError when the physics diverge.
        """
        wrench, contact_N = self._advance(reference)
        self._ticks += 1
        position, orientation = self.tool_pose()
        if not (isfinite(wrench.dot(wrench)) and position.dot(position) < _MAX_DISTANCE_M**2):
            raise SimulationError(
                f"{self.workcell.name} diverged after {self._ticks / RATE_HZ:.3f} s; "
                "use smaller disturbances or a slower reference."
            )
        measured = self._measured(self.sensor.read(wrench))
        return Sample(
            time_s=self._ticks / RATE_HZ,
            position_m=position,
            orientation_wxyz=orientation,
            joints_rad=self.joints_rad(),
            force_N=measured[:3],
            torque_Nm=measured[3:],
            contact_N=contact_N,
        )

    @property
    def gains(self) -> Gains:
        """Of the impedance."""
        return self.controller.gains

    @property
    def contact_names(self) -> tuple[str, ...]:
        """Names of what `Sample.contact_N` holds."""
        return self.contacts.names

    @property
    def joint_names(self) -> tuple[str, ...]:
        """Of the driven joints, in the order of `Sample.joints_rad`."""
        return self.workcell.arm.joints

    def be_at(self, moment_s: float | None, span_s: tuple[float, float] | None) -> None:
        """Physics does not ask which moment of a demonstration is being repeated."""

    def exert(self, force_N: ArrayLike, torque_Nm: ArrayLike) -> None:
        """A hand on the tool point exerts this (3,), (3,), base frame, until told otherwise.

        It acts as joint torques, so that the wrist sensor reads contact only.
        """
        data = self.data
        data.qfrc_applied[:] = 0.0
        mujoco.mj_applyFT(
            self.model, data, force_N, torque_Nm, self._tool_m, self._tool_body, data.qfrc_applied
        )

    def push(self, body: str, force_N: ArrayLike) -> None:
        """Push a body at its centre of mass with a force, base frame, until told otherwise.

        Pushed above the wrist the sensor does not feel it, below it does. Raises SimulationError
        for a body the workcell does not have.
        """
        index = mujoco.mj_name2id(self.model, mujoco.mjtObj.mjOBJ_BODY, body)
        if index < 0:
            raise SimulationError(
                f"A body to push must be in {self.workcell.name}, but '{body}' is not; "
                f"push one of {', '.join((*self.workcell.parts, TOOL_BODY))}."
            )
        self.data.xfrc_applied[index, :3] = force_N

    def tool_pose(self) -> tuple[Array, Array]:
        """Position (3,) and orientation (4,), w x y z, of the tool point in the base frame."""
        wxyz = np.empty(4)
        mujoco.mju_mat2Quat(wxyz, self._tool_turn)
        return self._tool_m.copy(), wxyz

    def tool_velocity(self) -> Array:
        """Velocity (6,) of the tool point in the base frame: m/s, then rad/s."""
        twist = np.empty(6)
        mujoco.mj_objectVelocity(self.model, self.data, _SITE, self._tool, twist, 0)
        return np.concatenate((twist[3:], twist[:3]))

    def joints_rad(self) -> Array:
        """Angles of the driven joints, in the order of the arm's names."""
        return self.data.qpos.take(self._positions)

    def here(self) -> Reference:
        """The reference that keeps the tool where it is."""
        return Reference(*self.tool_pose())

    def frame(self) -> tuple[Array, Array]:
        """Positions (B, 3) and orientations (B, 4), w x y z, of `bodies`, base frame."""
        return self.data.xpos[self._drawn], self.data.xquat[self._drawn]

    def shapes(self) -> tuple[Shape, ...]:
        """Every shape of every part."""
        return shapes_in(self.model, self.workcell.parts)

    def part_poses(self) -> Mapping[str, tuple[Array, Array]]:
        """Position and orientation of each part the workcell names, by name."""
        return self.body_poses(self.workcell.parts)

    def body_poses(self, names: tuple[str, ...]) -> Mapping[str, tuple[Array, Array]]:
        """Position (3,) and orientation (4,), w x y z, of the bodies named, in the base frame."""
        bodies = ((name, self.data.body(name)) for name in names)
        return {name: (body.xpos.copy(), body.xquat.copy()) for name, body in bodies}

    def link_poses(self) -> Mapping[str, tuple[Array, Array]]:
        """Position and orientation of every body that is no part: the robot's links, by name."""
        return self.body_poses(self._links)

    def contact_forces(self) -> Mapping[str, float]:
        """The simulator's normal force of each pair of parts, by name."""
        forces = self.contacts.normal_forces(self.data.sensordata).tolist()
        return dict(zip(self.contacts.names, forces, strict=True))

    def _advance(self, reference: Reference) -> tuple[Array, Array]:
        """Physics of one tick: mean wrench on the tool, sensor frame, and mean contact forces."""
        data = self.data
        data.ctrl[:] = self.controller.torques(data, reference, self.posture_rad)
        mean = np.zeros(self.model.nsensordata)
        for _ in range(self._substeps):
            mujoco.mj_step(self.model, data)
            mean += self._readings
        mean /= self._substeps
        # The sensor says what the arm exerts on the tool; the load is the opposite.
        return -mean[self._exerted], self.contacts.normal_forces(mean)

    def _measured(self, reading: Array) -> Array:
        wrench = self.load.compensated(reading, self._wrist_turn)
        return about_tool(wrench, self._wrist_turn, self._wrist_m, self._tool_m)

    def _calibrated(self) -> Load:
        """The load on the sensor, from readings at rest in a few tilted poses."""
        readings, rotations = [], []
        for tilt in _CALIBRATION_TILTS_RAD:
            pose = self.posture_rad.copy()
            pose[-3:-1] += tilt
            self._place(pose)
            readings.append(self._reading_at_rest())
            rotations.append(self._wrist_turn.copy())
        self.sensor.settle()
        if not np.isfinite(readings).all():
            raise SimulationError(
                f"{self.workcell.name} must be able to hold its arm still where it starts, but "
                "diverged; check masses, armatures and the joints' ranges (an MJCF file takes "
                'degrees unless its compiler says angle="radian").'
            )
        return estimated_load(np.array(readings), np.array(rotations))

    def _reading_at_rest(self) -> Array:
        here = self.here()
        for _ in range(_CALIBRATION_SETTLING_TICKS):
            self.sensor.read(self._advance(here)[0])
        return np.mean(
            [self.sensor.read(self._advance(here)[0]) for _ in range(_CALIBRATION_TICKS)], axis=0
        )

    def _place(self, joints_rad: Array) -> None:
        mujoco.mj_resetData(self.model, self.data)
        self.data.qpos[self._positions] = joints_rad
        mujoco.mj_forward(self.model, self.data)
