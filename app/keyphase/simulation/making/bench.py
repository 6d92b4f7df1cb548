# MuJoCo tells no types.
# pyright: reportAttributeAccessIssue=false
"""A bench with things on it and a tool that a hand leads as with a spring: no robot, only contact.

What the hand wants is a path of poses. The tool follows it through a spring and a damper, so that
it is stopped, turned aside and dragged by what it meets; forces are the simulator's own.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import mujoco
import numpy as np
from scipy.spatial.transform import Rotation

from keyphase.demonstration import Array

STEP_S = 0.002
RATE_HZ = 1.0 / STEP_S
TIP_M = 0.01
"""Radius of a round tip, half the width of a peg."""

Touching = frozenset[tuple[str, str]]

_MIN_FORCE_N = 0.03
_TURN_NM_PER_RAD = 15.0
_TURN_DAMPING = 0.24
_GRIP_N = 25.0
_FINGER_M = 0.035
_PAD_M = 0.004
_OPEN_M = 2.0 * (_FINGER_M - _PAD_M)
_BENCH = "bench"
_TOOL = "tool"


@dataclass(frozen=True)
class Thing:
    """A box on the bench: centre and half sizes [m]; `mass_kg` 0 stands fast."""

    name: str
    centre_m: tuple[float, float, float]
    half_m: tuple[float, float, float]
    mass_kg: float = 0.0


@dataclass(frozen=True)
class Surroundings:
    """What is there: things, how soft contact is (time constant [s]), friction, the tool's form.

    tool   tip: a ball; peg: a square peg; gripper: two fingers that can close
    """

    things: Sequence[Thing] = ()
    softness_s: float = 0.01
    friction: float = 0.3
    tool: str = "tip"
    stiffness_N_m: float = 800.0


@dataclass(frozen=True, eq=False)
class Led:
    """What came of it, sample by sample at `RATE_HZ`: poses, wrench on the tool, what touches.

    opening_m  (N,) between the fingers, or None where the tool has none
    """

    position_m: Array
    rotation: Rotation
    wrench: Array
    touching: tuple[Touching, ...]
    opening_m: Array | None = None


def lead(around: Surroundings, wanted_m: Array, turns: Rotation, closing: Array) -> Led:
    """Lead the tool along wanted positions (N, 3) [m] and rotations (N); `closing` (N,) 0 to 1."""
    model = _scene(around, wanted_m[0]).compile()
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    tool = model.body(_TOOL).id
    names = [model.body(model.geom(g).bodyid[0]).name for g in range(model.ngeom)]
    ours = {index for index, name in enumerate(names) if name in (_TOOL, "left", "right")}
    speed = np.gradient(wanted_m, STEP_S, axis=0)
    positions, rotations, wrenches, touching, openings = [], [], [], [], []
    fingers = [model.joint(name).qposadr[0] for name in ("left", "right") if model.nu]
    for row in range(len(wanted_m)):
        _pull(model, data, tool, wanted_m[row], speed[row], turns[row], around.stiffness_N_m)
        if model.nu:
            data.ctrl[:] = _GRIP_N * (2.0 * closing[row] - 1.0)
        mujoco.mj_step(model, data)
        wrench, pairs = _contacts(model, data, names, ours, data.xpos[tool])
        positions.append(data.xpos[tool].copy())
        rotations.append(data.xquat[tool].copy())
        wrenches.append(wrench)
        touching.append(pairs)
        openings.append(_OPEN_M - data.qpos[fingers].sum())
    return Led(
        np.array(positions),
        Rotation.from_quat(np.array(rotations), scalar_first=True),
        np.array(wrenches),
        tuple(touching),
        np.array(openings) if fingers else None,
    )


def _scene(around: Surroundings, start_m: Array) -> mujoco.MjSpec:
    spec = mujoco.MjSpec()
    spec.option.timestep = STEP_S
    spec.option.integrator = mujoco.mjtIntegrator.mjINT_IMPLICITFAST
    spec.option.cone = mujoco.mjtCone.mjCONE_ELLIPTIC
    spec.option.jacobian = mujoco.mjtJacobian.mjJAC_DENSE
    spec.option.impratio = 10.0
    bench = Thing(_BENCH, (0.0, 0.0, -0.05), (2.0, 2.0, 0.05))
    for thing in (bench, *around.things):
        body = spec.worldbody.add_body(name=thing.name, pos=thing.centre_m)
        if thing.mass_kg:
            body.add_freejoint()
        _add_box(body, thing.half_m, thing.mass_kg, around)
    _add_tool(spec, around, start_m)
    return spec


def _add_box(body, half_m, mass_kg: float, around: Surroundings, at=(0.0, 0.0, 0.0)) -> None:
    body.add_geom(
        type=mujoco.mjtGeom.mjGEOM_BOX,
        size=half_m,
        pos=at,
        mass=mass_kg,
        friction=[around.friction, 0.005, 0.0001],
        solref=[max(around.softness_s, 2.5 * STEP_S), 1.0],
        condim=4,
    )


def _add_tool(spec: mujoco.MjSpec, around: Surroundings, start_m: Array) -> None:
    tool = spec.worldbody.add_body(name=_TOOL, pos=start_m, gravcomp=1.0)
    tool.add_freejoint()
    tool.mass, tool.inertia, tool.explicitinertial = 0.4, [1e-3, 1e-3, 1e-3], True
    if around.tool == "peg":
        _add_box(tool, (TIP_M, TIP_M, 0.03), 0.1, around)
    elif around.tool == "gripper":
        _add_fingers(spec, tool)
    else:
        tool.add_geom(
            type=mujoco.mjtGeom.mjGEOM_SPHERE,
            size=[TIP_M, 0.0, 0.0],
            mass=0.1,
            friction=[around.friction, 0.005, 0.0001],
            solref=[max(around.softness_s, 2.5 * STEP_S), 1.0],
        )


def _add_fingers(spec: mujoco.MjSpec, tool) -> None:
    for name, side in (("left", -1.0), ("right", 1.0)):
        finger = tool.add_body(name=name, pos=(0.0, side * _FINGER_M, 0.0), gravcomp=1.0)
        finger.add_joint(
            name=name,
            type=mujoco.mjtJoint.mjJNT_SLIDE,
            axis=(0.0, -side, 0.0),
            range=(0.0, 0.03),
            limited=True,
            damping=20.0,
        )
        gripping = Surroundings(softness_s=0.01, friction=1.5)
        _add_box(finger, (0.01, _PAD_M, 0.02), 0.05, gripping)
        motor = spec.add_actuator(name=name, target=name, trntype=mujoco.mjtTrn.mjTRN_JOINT)
        motor.gear[0] = 1.0


def _pull(model, data, tool: int, wanted, speed, turn: Rotation, stiffness: float) -> None:
    """The hand's spring and damper, near critical for the tool's mass, and the same in turning."""
    mass = 0.5 if not model.nu else 0.6
    damping = 2.0 * np.sqrt(stiffness * mass)
    velocity = np.zeros(6)
    mujoco.mj_objectVelocity(model, data, mujoco.mjtObj.mjOBJ_BODY, tool, velocity, 0)
    here = Rotation.from_quat(data.xquat[tool], scalar_first=True)
    force = stiffness * (wanted - data.xpos[tool]) + damping * (speed - velocity[3:])
    torque = _TURN_NM_PER_RAD * (turn * here.inv()).as_rotvec() - _TURN_DAMPING * velocity[:3]
    data.xfrc_applied[tool] = np.concatenate([force, torque])


def _contacts(model, data, names: list[str], ours: set[int], about_m) -> tuple[Array, Touching]:
    """The wrench (6,) on the tool about its point, and which things touch which."""
    total = np.zeros(6)
    pairs = set()
    local = np.zeros(6)
    geoms, frames, places = data.contact.geom, data.contact.frame, data.contact.pos
    for index in range(data.ncon):
        mujoco.mj_contactForce(model, data, index, local)
        if local[0] < _MIN_FORCE_N:
            continue
        first, second = int(geoms[index, 0]), int(geoms[index, 1])
        pairs.add((min(names[first], names[second]), max(names[first], names[second])))
        if (first in ours) != (second in ours):
            force = frames[index].reshape(3, 3).T @ local[:3] * (1.0 if second in ours else -1.0)
            total[:3] += force
            total[3:] += np.cross(places[index] - about_m, force)
    return total, frozenset(pairs)
