# MuJoCo tells no types.
# pyright: reportAttributeAccessIssue=false
"""Another arm, given as URDF or MJCF, for a world made from a recording."""

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import mujoco
import numpy as np

from keyphase.demonstration import Array
from keyphase.errors import SimulationError
from keyphase.simulation.mjcf import compiled, spec_from
from keyphase.simulation.recorded.reaching import Pose, reached_from
from keyphase.simulation.robot_scene import set_physics

TOOL_SITE = "keyphase_tool"
MAX_REACH_M = 20.0
"""An arm that reaches further was written in other units."""

LEAST_JOINTS = 6
"""An arm with fewer axes cannot hold a tool in every orientation."""

TURNS_RAD = tuple(np.radians([0, 90, -90, 180, 45, -45, 135, -135]).tolist())
AHEAD, DOWN = (0.55, 0.7, 0.4), (0.0, 0.15, -0.2)
"""Where a recording is put that the arm does not reach: so much of its reach ahead, and below."""

_ARMATURE, _WRIST_ARMATURE = 0.1, 0.02
_WRIST = 3
_DAMPING = 0.2
_MASS_KG, _INERTIA_KG_M2 = 0.05, 1e-4


@dataclass(frozen=True, eq=False)
class RobotArm:
    """An arm that stands where it reaches a recording.

    model      of the arm alone; its driven joints are all joints it has
    joints     their names, from shoulder to wrist
    start_rad  (J,) where the recording starts
    """

    name: str
    model: mujoco.MjModel
    joints: tuple[str, ...]
    start_rad: Array


def robot_arm(path: Path, tool_frame: str, poses: Sequence[Pose]) -> RobotArm:
    """The arm in a file, its tool frame a body, link or site, placed so that it reaches `poses`.

    It stays where its file has it if it reaches all of them from there; else it is put elsewhere
    and turned about the vertical. Raises SimulationError for a file that is no arm, and for a
    recording that it reaches from nowhere.
    """
    spec = _prepared(path, tool_frame)
    joints = tuple(joint.name for joint in spec.joints)
    reach = _reach(compiled(path, spec.copy()))
    if not 0.0 < reach < MAX_REACH_M:
        raise SimulationError(
            f"{path.name} must be an arm that reaches less than {MAX_REACH_M:g} m, but reaches "
            f"{reach:.3g} m with its frame '{tool_frame}'; its lengths are in metres."
        )
    furthest = 0
    for place, turn in _places(poses, reach):
        model = compiled(path, _moved(spec, place, turn))
        reached, start = reached_from(model, model.site(TOOL_SITE).id, poses)
        if reached == len(poses):
            return RobotArm(path.stem, model, joints, start)
        furthest = max(furthest, reached)
    raise SimulationError(
        f"{path.name} must reach all of the recording with its frame '{tool_frame}', but reaches "
        f"{furthest} of {len(poses)} poses spread over it, wherever it is put; take an arm with "
        "more reach."
    )


def _prepared(path: Path, tool_frame: str) -> mujoco.MjSpec:
    """The arm alone: nothing collides, nothing but its own joints moves, and they have inertia."""
    spec = spec_from(path)
    spec.compiler.fusestatic = False
    spec.compiler.boundmass, spec.compiler.boundinertia = _MASS_KG, _INERTIA_KG_M2
    set_physics(spec)
    own = _chain(path, spec, _with_site(path, spec, tool_frame))
    for several in (spec.equalities, spec.tendons, spec.actuators, spec.sensors, spec.keys):
        for one in list(several):
            spec.delete(one)
    for joint in list(spec.joints):
        if joint.name not in own:
            spec.delete(joint)
    for geom in spec.geoms:
        geom.contype = geom.conaffinity = 0
    for number, name in enumerate(own):
        joint = spec.joint(name)
        least = _WRIST_ARMATURE if number >= len(own) - _WRIST else _ARMATURE
        joint.armature = max(float(joint.armature), least)
        joint.damping = [_DAMPING, 0.0, 0.0]
        joint.frictionloss = 0.0
        joint.actfrclimited = mujoco.mjtLimited.mjLIMITED_FALSE
        if not joint.range[0] < joint.range[1]:
            joint.range = [-2.0 * np.pi, 2.0 * np.pi]
    return spec


def _with_site(path: Path, spec: mujoco.MjSpec, tool_frame: str) -> mujoco.MjsBody:
    """The body that carries the tool frame; the site TOOL_SITE lies in it."""
    site, body = spec.site(tool_frame), spec.body(tool_frame)
    if site is None and body is None:
        names = [each.name for each in (*spec.bodies, *spec.sites) if each.name]
        raise SimulationError(
            f"{path.name} must have a body, link or site '{tool_frame}', but has "
            f"{', '.join(names[-12:])}; name one of these with --tool-frame."
        )
    if body is not None:
        body.add_site(name=TOOL_SITE)
        return body
    assert site is not None
    site.parent.add_site(name=TOOL_SITE, pos=site.pos, quat=site.quat)
    return site.parent


def _chain(path: Path, spec: mujoco.MjSpec, body: mujoco.MjsBody) -> tuple[str, ...]:
    """Names of the joints from the world to the tool."""
    found: list[str] = []
    while body is not None and body.name != spec.worldbody.name:
        for joint in reversed(list(body.joints)):
            if joint.type != mujoco.mjtJoint.mjJNT_HINGE or not joint.name:
                raise SimulationError(
                    f"{path.name} must move its tool by hinges that have names, but "
                    f"'{joint.name or body.name}' is none; give an arm of revolute joints."
                )
            found.insert(0, joint.name)
        body = body.parent
    if len(found) < LEAST_JOINTS:
        raise SimulationError(
            f"{path.name} must have {LEAST_JOINTS} joints or more between its base and the tool "
            f"frame, but has {len(found)}; name a frame at the end of the arm with --tool-frame."
        )
    return tuple(found)


def _reach(model: mujoco.MjModel) -> float:
    """Sum of the ways from joint to joint [m]."""
    at = int(model.site_bodyid[model.site(TOOL_SITE).id])
    total = float(np.linalg.norm(model.site_pos[model.site(TOOL_SITE).id]))
    while model.body_parentid[at] != 0:
        total += float(np.linalg.norm(model.body_pos[at]))
        at = int(model.body_parentid[at])
    return total


def _places(poses: Sequence[Pose], reach_m: float) -> list[tuple[Array, float]]:
    """Where the arm's base may stand (3,), and how it is turned; first where it is."""
    middle = np.mean([place for place, _ in poses], axis=0)
    places = [(np.zeros(3), 0.0)]
    for ahead, down in zip(AHEAD, DOWN, strict=True):
        for turn in TURNS_RAD:
            way = np.array([np.cos(turn), np.sin(turn), 0.0]) * ahead * reach_m
            places.append((middle - way - [0.0, 0.0, down * reach_m], turn))
    return places


def _moved(spec: mujoco.MjSpec, place_m: Array, turn_rad: float) -> mujoco.MjSpec:
    moved = spec.copy()
    turn = np.array([np.cos(turn_rad / 2), 0.0, 0.0, np.sin(turn_rad / 2)])
    for body in moved.worldbody.bodies:
        at, wxyz = np.empty(3), np.empty(4)
        mujoco.mju_rotVecQuat(at, np.array(body.pos), turn)
        mujoco.mju_mulQuat(wxyz, turn, np.array(body.quat))
        body.pos, body.quat = at + place_m, wxyz
    return moved
