# MuJoCo tells no types.
# pyright: reportAttributeAccessIssue=false
"""A workcell of one's own: an MJCF file, and a TOML file that says what success in it is."""

from collections.abc import Mapping
from dataclasses import dataclass
from functools import partial
from pathlib import Path

import mujoco
import numpy as np

from keyphase.errors import SimulationError
from keyphase.simulation.disturbance import NOMINAL, Disturbance
from keyphase.simulation.mjcf import compiled, spec_from
from keyphase.simulation.robot_scene import ArmNames, add_wrist_sensor, set_physics
from keyphase.simulation.simulation import Simulation
from keyphase.simulation.workcells.cell_file import CellFile, read_cell_file
from keyphase.simulation.workcells.expression import Condition, condition
from keyphase.simulation.workcells.workcell import Event, Workcell


def own_cell(path: Path) -> Workcell:
    """The workcell that a TOML file describes; the MJCF file it names is looked up beside it.

    Raises SimulationError for files that cannot be read, name what the scene does not have, or
    hold a condition that is none.
    """
    file = read_cell_file(path)
    spec = spec_from(file.model)
    _refuse_missing(file, spec, compiled(file.model, spec.copy()))
    parts, contacts = frozenset(file.parts), frozenset(file.contacts)
    events = {name: condition(text, parts, contacts) for name, text in file.events.items()}
    success = {name: condition(text, parts, contacts) for name, text in file.success.items()}
    return Workcell(
        name=file.name,
        title=file.title,
        start_joints_rad=tuple(file.joints.values()),
        furnish=partial(_furnish, file),
        parts=file.parts,
        pairs=file.contacts,
        onsets=tuple(file.contacts),
        ends_at_contact=False,
        events=tuple(Event(name, partial(_holds, each)) for name, each in events.items()),
        checks=partial(_checks, success),
        robot=partial(_scene, file),
        arm=ArmNames(tuple(file.joints), file.tool, file.sensor),
    )


def _scene(file: CellFile) -> mujoco.MjSpec:
    """Physics as everywhere, a motor at each driven joint, a sensor at the wrist."""
    spec = spec_from(file.model)
    set_physics(spec)
    for actuator in list(spec.actuators):
        spec.delete(actuator)
    for name in file.joints:
        motor = spec.add_actuator(name=name, target=name, trntype=mujoco.mjtTrn.mjTRN_JOINT)
        motor.set_to_motor()
    add_wrist_sensor(spec, file.sensor)
    return spec


def _furnish(file: CellFile, spec: mujoco.MjSpec, disturbance: Disturbance) -> None:
    """Put the parts where the disturbance has them."""
    x, y = disturbance.part_offset_m
    half = 0.5 * disturbance.part_turn_rad
    turn = np.array([np.cos(half), 0.0, 0.0, np.sin(half)])
    for name in file.parts:
        body = spec.body(name)
        if name == file.held:
            tilt = np.array([np.cos(0.5 * disturbance.tilt_rad), 0.0, 0.0, 0.0])
            tilt[2] = np.sin(0.5 * disturbance.tilt_rad)
            body.quat = _turned(np.array(body.quat), tilt)
            continue
        if body.parent != spec.worldbody:
            continue
        body.pos = np.array(body.pos) + np.array([x, y, disturbance.part_height_m])
        body.quat = _turned(turn, np.array(body.quat))
        for geom in body.geoms:
            geom.mass *= disturbance.mass
            geom.density *= disturbance.mass
            if disturbance.friction != NOMINAL.friction:
                geom.friction = [disturbance.friction, *geom.friction[1:]]


def _turned(first: np.ndarray, second: np.ndarray) -> np.ndarray:
    result = np.empty(4)
    mujoco.mju_mulQuat(result, first, second)
    return result


def _refuse_missing(file: CellFile, spec: mujoco.MjSpec, model: mujoco.MjModel) -> None:
    """Raise SimulationError where the scene lacks what the file names."""
    geoms = [name for pair in file.contacts.values() for group in pair for name in group]
    for kind, wanted, has in (
        ("body", file.parts, spec.body),
        ("site", (file.tool, file.sensor), spec.site),
        ("joint", file.joints, spec.joint),
        ("geom", geoms, spec.geom),
    ):
        for name in wanted:
            if has(name) is None:
                raise SimulationError(
                    f"{file.path}: the scene {file.model.name} must have a {kind} '{name}', but "
                    "has none; name one it has, or add it."
                )
    hinge = mujoco.mjtJoint.mjJNT_HINGE
    for name in file.joints:
        if model.joint(name).type[0] != hinge:
            raise SimulationError(
                f"{file.path}: driven joints must turn, but '{name}' of {file.model.name} does "
                "not; name the hinges of the arm."
            )


def _holds(wanted: Condition, simulation: Simulation) -> bool:
    forces = simulation.contact_forces()

    def ask(name: str, parts: tuple[str, ...]) -> float:
        return _ask(simulation, name, parts) if parts else forces[name]

    return wanted.holds(ask)


def _checks(success: Mapping[str, Condition], simulation: Simulation) -> Mapping[str, bool]:
    return {name: _holds(each, simulation) for name, each in success.items()}


@dataclass(frozen=True, eq=False)
class _Pose:
    """Place (3,) and z axis (3,) of a part."""

    place: np.ndarray
    axis: np.ndarray


def _ask(simulation: Simulation, name: str, parts: tuple[str, ...]) -> float:
    """A function of parts; `expression.FUNCTIONS` says which there are."""
    poses = simulation.body_poses(parts)
    seen = [_pose(*poses[part]) for part in parts]
    first, *others = seen
    if name == "height":
        return float(first.place[2])
    if name == "tilt":
        return _degrees(first.axis, np.array([0.0, 0.0, 1.0]))
    if name == "moved":
        return float(np.linalg.norm(first.place - simulation.start_parts[parts[0]][0]))
    way = first.place - others[0].place
    return {
        "distance": float(np.linalg.norm(way)),
        "aside": float(np.linalg.norm(way[:2])),
        "above": float(way[2]),
        "angle": _degrees(first.axis, others[0].axis),
    }[name]


def _pose(place: np.ndarray, wxyz: np.ndarray) -> _Pose:
    axis = np.empty(3)
    mujoco.mju_rotVecQuat(axis, np.array([0.0, 0.0, 1.0]), wxyz)
    return _Pose(place, axis)


def _degrees(first: np.ndarray, second: np.ndarray) -> float:
    return float(np.degrees(np.arccos(np.clip(first @ second, -1.0, 1.0))))
