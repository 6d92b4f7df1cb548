# MuJoCo tells no types.
# pyright: reportAttributeAccessIssue=false
"""The YuMi as a MuJoCo specification: right arm driven, everything else frozen, a wrist sensor.

Built from the same URDF that is shown and that Pinocchio reads, so there is one robot description.
"""

import xml.etree.ElementTree as ElementTree
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from pathlib import Path

import mujoco
import numpy as np

from keyphase.demonstration import Array
from keyphase.errors import SimulationError
from keyphase.files.shipped import shipped

ARM_JOINTS = tuple(f"yumi_joint_{axis}_r" for axis in "1273456")
"""The driven joints from shoulder to wrist; ABB counts the third one as axis 7."""

TOOL_BODY, TOOL_SITE = "tcp_r", "tool"
SENSOR_BODY, SENSOR_SITE = "ft_r", "wrist"


@dataclass(frozen=True)
class ArmNames:
    """What of a scene is the arm: its driven joints in a row, the tool point, the wrist sensor."""

    joints: tuple[str, ...] = ARM_JOINTS
    tool_site: str = TOOL_SITE
    sensor_site: str = SENSOR_SITE


YUMI_ARM = ArmNames()
"""The YuMi's right arm."""


PHYSICS_STEP_S = 0.002
ROBOT, HELD, SCENE = 1, 2, 4
"""Collision groups: robot and held part meet the scene, the scene meets all, nothing else."""

_LEFT_REST_DEG = (0.0, -130.0, 135.0, 30.0, 0.0, 40.0, 0.0)
_GRIP_HALF_WIDTH_M = 0.018
_ARMATURE = (0.15, 0.15, 0.10, 0.10, 0.03, 0.03, 0.015)
"""Reflected rotor inertias [kg m^2]: estimates, ABB publishes none."""


def robot_spec() -> mujoco.MjSpec:
    """Robot alone, physics options set; scenes add table and parts to it.

    Raises SimulationError where the URDF lacks a body or joint the workcells need.
    """
    spec = mujoco.MjSpec.from_string(_urdf_without_visuals())
    # Both are on for a URDF: they would take the sensor's body and every shape that collides
    # with nothing, its mass included.
    spec.compiler.fusestatic = False
    spec.compiler.discardvisual = False
    set_physics(spec)
    _require(spec)
    _group_collisions(spec)
    for joint in list(spec.joints):
        if joint.name not in ARM_JOINTS:
            _freeze(spec, joint, _frozen_angles().get(joint.name, 0.0))
    for name, armature in zip(ARM_JOINTS, _ARMATURE, strict=True):
        _drive(spec, name, armature)
    _add_sensor(spec)
    return spec


@cache
def _urdf_without_visuals() -> str:
    # MuJoCo reads no GLB, and what the robot looks like is no matter of physics.
    path: Path = shipped("static_robots") / "yumi" / "yumi.urdf"
    tree = ElementTree.parse(path)
    for link in tree.iter("link"):
        for visual in link.findall("visual"):
            link.remove(visual)
    for extension in tree.getroot().findall("mujoco"):
        tree.getroot().remove(extension)
    return ElementTree.tostring(tree.getroot(), encoding="unicode")


def set_physics(spec: mujoco.MjSpec) -> None:
    """Time step, solver and contacts as all scenes have them."""
    option = spec.option
    option.timestep = PHYSICS_STEP_S
    option.integrator = mujoco.mjtIntegrator.mjINT_IMPLICITFAST
    option.solver = mujoco.mjtSolver.mjSOL_NEWTON
    option.cone = mujoco.mjtCone.mjCONE_ELLIPTIC
    option.impratio = 10.0
    option.noslip_iterations = 5
    option.iterations = 50
    option.tolerance = 1e-10
    # What diverges is to be told, not started again in silence.
    option.disableflags |= int(mujoco.mjtDisableBit.mjDSBL_AUTORESET)
    # Parts at rest are computed again when something touches them.
    option.enableflags |= int(mujoco.mjtEnableBit.mjENBL_SLEEP)
    # The sparse factorisation of MuJoCo 4.0.0 is defective.
    option.jacobian = mujoco.mjtJacobian.mjJAC_DENSE


def _require(spec: mujoco.MjSpec) -> None:
    bodies = {body.name for body in spec.bodies}
    joints = {joint.name for joint in spec.joints}
    missing = sorted(({TOOL_BODY, SENSOR_BODY} - bodies) | (set(ARM_JOINTS) - joints))
    if missing:
        raise SimulationError(
            f"The robot description must have {', '.join(missing)}, but it does not; "
            "workcells need the YuMi that comes with keyphase."
        )


def _group_collisions(spec: mujoco.MjSpec) -> None:
    for body in spec.bodies:
        for geom in body.geoms:
            geom.contype, geom.conaffinity, geom.group = ROBOT, 0, 3


def _frozen_angles() -> Mapping[str, float]:
    left = {
        f"yumi_joint_{axis}_l": float(np.radians(degrees))
        for axis, degrees in zip("1273456", _LEFT_REST_DEG, strict=True)
    }
    grip = {"gripper_r_joint": _GRIP_HALF_WIDTH_M, "gripper_r_joint_m": _GRIP_HALF_WIDTH_M}
    return left | grip


def _freeze(spec: mujoco.MjSpec, joint: mujoco.MjsJoint, value: float) -> None:
    """Bake the joint's value into its body and take the joint out."""
    body = joint.parent
    orientation, axis = np.array(body.quat), np.array(joint.axis)
    if joint.type == mujoco.mjtJoint.mjJNT_HINGE:
        body.quat = _turned(orientation, axis, value)
    else:
        offset = np.zeros(3)
        mujoco.mju_rotVecQuat(offset, axis * value, orientation)
        body.pos = np.array(body.pos) + offset
    for equality in list(spec.equalities):
        if joint.name in (equality.name1, equality.name2):
            spec.delete(equality)
    spec.delete(joint)


def _turned(orientation: Array, axis: Array, angle: float) -> Array:
    turn, result = np.zeros(4), np.zeros(4)
    mujoco.mju_axisAngle2Quat(turn, axis, angle)
    mujoco.mju_mulQuat(result, orientation, turn)
    return result


def _drive(spec: mujoco.MjSpec, name: str, armature: float) -> None:
    joint = spec.joint(name)
    joint.armature = armature
    joint.damping = [0.2, 0.0, 0.0]
    joint.frictionloss = 0.0
    # The URDF's efforts are estimates; the controller limits its own Cartesian force instead.
    joint.actfrclimited = mujoco.mjtLimited.mjLIMITED_FALSE
    motor = spec.add_actuator(name=name, target=name, trntype=mujoco.mjtTrn.mjTRN_JOINT)
    motor.set_to_motor()


def _add_sensor(spec: mujoco.MjSpec) -> None:
    spec.body(TOOL_BODY).add_site(name=TOOL_SITE, size=[0.004] * 3)
    spec.body(SENSOR_BODY).add_site(name=SENSOR_SITE, size=[0.004] * 3)
    add_wrist_sensor(spec, SENSOR_SITE)


def add_wrist_sensor(spec: mujoco.MjSpec, site: str) -> None:
    """Sensors of what the body of `site` exerts on its parent: force and torque."""
    for name, kind in (
        ("wrist_force", mujoco.mjtSensor.mjSENS_FORCE),
        ("wrist_torque", mujoco.mjtSensor.mjSENS_TORQUE),
    ):
        spec.add_sensor(name=name, type=kind, objtype=mujoco.mjtObj.mjOBJ_SITE, objname=site)
