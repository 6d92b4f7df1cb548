"""A robot description: any URDF, with a named tool frame and the chain of joints that moves it."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import Path
from types import MappingProxyType

import numpy as np
import pinocchio  # pyright: ignore[reportMissingImports]
from numpy.typing import ArrayLike
from yourdfpy import URDF

from keyphase.demonstration import Array
from keyphase.errors import RobotError
from keyphase.robot.shapes import LinkShape, read_display, shapes_of
from keyphase.urdf.checking import MOVING, refuse_bad_urdf


@dataclass(frozen=True)
class Mimic:
    """A joint that follows another: factor times its angle plus offset."""

    joint: str
    factor: float
    offset: float


@dataclass(frozen=True, eq=False)
class RobotDescription:
    """A robot that can be shown and one of its tools moved.

    tool_frame   link whose pose follows a demonstration
    joint_names  (J) joints from the root to the tool frame, in that order
    lower_rad, upper_rad, speed_rad_s  (J,) their limits; infinite where the URDF has none;
                 a sliding joint counts in m and m/s
    start_rad    (J,) posture from which the tool frame is moved, and to which it is drawn back
    rest         value of every other joint that can move, for display
    root         link in whose frame all poses are given
    links        all links, in the order of the file
    shapes       what the links look like
    mimics       joints that follow others
    model        the whole robot in Pinocchio, which must not be changed
    """

    name: str
    path: Path
    root: str
    tool_frame: str
    joint_names: tuple[str, ...]
    lower_rad: Array
    upper_rad: Array
    speed_rad_s: Array
    start_rad: Array
    links: tuple[str, ...]
    shapes: tuple[LinkShape, ...] = field(repr=False)
    model: pinocchio.Model = field(repr=False)
    rest: Mapping[str, float] = field(default_factory=dict)
    mimics: Mapping[str, Mimic] = field(default_factory=dict)

    @cached_property
    def frames(self) -> Mapping[str, int]:
        """Pinocchio's number of every link's frame."""
        kind = pinocchio.FrameType.BODY
        return {link: self.model.getFrameId(link, kind) for link in self.links}

    def starting_at(
        self, start_rad: ArrayLike, rest: Mapping[str, float] | None = None
    ) -> "RobotDescription":
        """The same robot with another start posture (J,) and other joints at `rest`.

        Raises RobotError where the posture has another number of joints or passes a limit.
        """
        start = np.array(start_rad, dtype=np.float64)
        if start.shape != self.start_rad.shape:
            raise RobotError(
                f"{self.name}: a start posture needs {len(self.joint_names)} joint values "
                f"({', '.join(self.joint_names)}), but {start.shape} came."
            )
        outside = (start < self.lower_rad) | (start > self.upper_rad)
        if outside.any():
            at = int(np.argmax(outside))
            raise RobotError(
                f"{self.name}: {self.joint_names[at]} must start within "
                f"[{self.lower_rad[at]:.4g}, {self.upper_rad[at]:.4g}], but {start[at]:.4g} came."
            )
        return replace(
            self, start_rad=_frozen(start), rest=MappingProxyType({**self.rest, **(rest or {})})
        )


def load_description(path: str | Path, tool_frame: str) -> RobotDescription:
    """Read a URDF for display and kinematics; `tool_frame` names the link to be moved.

    The start posture is the middle of each joint's range.

    Raises RobotError where the file is missing, is no XML, no URDF, lacks the frame or a mesh, or
    where no joint moves the frame.
    """
    return load_descriptions(path, (tool_frame,))[0]


def load_descriptions(path: str | Path, tool_frames: Sequence[str]) -> tuple[RobotDescription, ...]:
    """The same robot with one tool frame after the other to be moved, read once.

    Raises RobotError as `load_description` does.
    """
    path = Path(path)
    refuse_bad_urdf(path)
    display, model = read_display(path), _model(path)
    shapes = shapes_of(display)
    return tuple(_described(path, frame, display, shapes, model) for frame in tool_frames)


def _described(
    path: Path,
    tool_frame: str,
    display: URDF,
    shapes: tuple[LinkShape, ...],
    model: pinocchio.Model,
) -> RobotDescription:
    chain = _chain(model, display, tool_frame, path)
    lower, upper, speed = _limits(display, chain)
    return RobotDescription(
        name=display.robot.name,
        path=path,
        root=str(display.base_link),
        tool_frame=tool_frame,
        joint_names=chain,
        lower_rad=_frozen(lower),
        upper_rad=_frozen(upper),
        speed_rad_s=_frozen(speed),
        start_rad=_frozen([_middle(*limits) for limits in zip(lower, upper, strict=True)]),
        links=tuple(display.link_map),
        shapes=shapes,
        model=model,
        rest=MappingProxyType(_rest(display, chain)),
        mimics=MappingProxyType(_mimics(display)),
    )


def _model(path: Path) -> pinocchio.Model:
    try:
        return pinocchio.buildModelFromUrdf(str(path))
    except (ValueError, RuntimeError) as error:
        raise RobotError(
            f"{path}: expected a URDF that Pinocchio can read, but it says: {error}; "
            "check its joints and links."
        ) from error


def _chain(model: pinocchio.Model, display: URDF, tool_frame: str, path: Path) -> tuple[str, ...]:
    # Asked for an unknown frame, Pinocchio answers with a number all the same.
    if tool_frame not in display.link_map:
        raise RobotError(
            f"{path}: expected a tool frame of this robot, but it has none named '{tool_frame}'; "
            f"choose one of {', '.join(display.link_map)}."
        )
    parent = model.frames[model.getFrameId(tool_frame, pinocchio.FrameType.BODY)].parentJoint
    chain = tuple(str(model.names[joint]) for joint in model.supports[parent] if joint > 0)
    if not chain:
        raise RobotError(
            f"{path}: expected joints that move the tool frame '{tool_frame}', but it is rigidly "
            f"connected to '{display.base_link}'; choose a link at the end of an arm."
        )
    for name in chain:
        joint = display.joint_map[name]
        _refuse_locked(display, name, path)
        if joint.type not in MOVING or joint.mimic is not None:
            kind = joint.type if joint.mimic is None else "mimic"
            raise RobotError(
                f"{path}: expected only {', '.join(MOVING)} joints on the way to "
                f"'{tool_frame}', but '{name}' is a {kind} joint; choose another tool frame."
            )
    return chain


def _refuse_locked(display: URDF, name: str, path: Path) -> None:
    lower, upper, _ = _limits(display, (name,))
    if lower[0] == upper[0]:
        raise RobotError(
            f"{path}: joint '{name}' moves the tool frame, so its <limit> must leave it a range, "
            f"but lower and upper end are both {lower[0]:g}; correct them or make it fixed."
        )


def _limits(display: URDF, chain: tuple[str, ...]) -> tuple[Array, Array, Array]:
    lower, upper = np.full(len(chain), -np.inf), np.full(len(chain), np.inf)
    speed = np.full(len(chain), np.inf)
    for number, name in enumerate(chain):
        joint = display.joint_map[name]
        if joint.limit is None:
            continue
        speed[number] = joint.limit.velocity or np.inf
        if joint.type != "continuous":
            lower[number], upper[number] = joint.limit.lower or 0.0, joint.limit.upper or 0.0
    return lower, upper, speed


def _rest(display: URDF, chain: tuple[str, ...]) -> dict[str, float]:
    rest = {}
    for name, joint in display.joint_map.items():
        if joint.type in MOVING and joint.mimic is None and name not in chain:
            lower, upper, _ = _limits(display, (name,))
            rest[name] = float(np.clip(0.0, lower[0], upper[0]))
    return rest


def _mimics(display: URDF) -> dict[str, Mimic]:
    return {
        name: Mimic(
            joint.mimic.joint, _or(joint.mimic.multiplier, 1.0), _or(joint.mimic.offset, 0.0)
        )
        for name, joint in display.joint_map.items()
        if joint.mimic is not None
    }


def _or(value: float | None, default: float) -> float:
    return default if value is None else float(value)


def _middle(lower: float, upper: float) -> float:
    return (lower + upper) / 2 if np.isfinite(lower) and np.isfinite(upper) else 0.0


def _frozen(values: ArrayLike) -> Array:
    array = np.array(values, dtype=np.float64)
    array.flags.writeable = False
    return array
