"""Where the scene is looked at from."""

from dataclasses import dataclass

import numpy as np

from keyphase.demonstration import Array
from keyphase.robot.pose import Placement
from keyphase.web.scene.recording.path_geometry import Path

FIELD_OF_VIEW_RAD = 0.7
"""Vertical; a longer lens than viser's own keeps straight things straight."""

BESIDE_ROBOT_RAD = -0.75
"""How far from straight in front of a robot it is looked at, towards its right arm."""

WITH_ROBOT_M = 0.34
"""With a robot so much is seen at least."""

ABOVE_PATH = -0.03
"""With a robot the picture's middle lies so much higher than the path's, as a share of its size;
lower, since the parts lie there."""

_ELEVATION_RAD = 0.42
_ROOM = 1.35
_ROOM_WITH_ROBOT = 1.15
"""How much more than what is looked at is seen; a robot's view has room around the path anyway."""


@dataclass(frozen=True, eq=False)
class Viewpoint:
    """A camera: where it is, what it looks at, and what is up in its picture."""

    position_m: Array
    look_at_m: Array
    up: Array


def viewpoint_of(path: Path, base: Placement | None = None) -> Viewpoint:
    """Look across the direction in which the path extends most, from the front and above.

    With a robot at `base` look from its front instead, and at more than the path.
    """
    middle = 0.5 * (path.low_m + path.high_m)
    if base is not None:
        return viewpoint_with_robot(middle, path.size_m, base)
    return _viewpoint(middle, _across(path.position_m), path.size_m)


def viewpoint_with_robot(middle_m: Array, size_m: float, base: Placement) -> Viewpoint:
    """Look at something of that size from the front of the robot at `base`, past its tool."""
    raised = middle_m + np.array([0.0, 0.0, ABOVE_PATH * size_m])
    return _viewpoint(raised, _azimuth_of(base) + BESIDE_ROBOT_RAD, size_m, _ROOM_WITH_ROBOT)


def _viewpoint(middle: Array, azimuth: float, size_m: float, room: float = _ROOM) -> Viewpoint:
    towards = np.array(
        [
            np.cos(azimuth) * np.cos(_ELEVATION_RAD),
            np.sin(azimuth) * np.cos(_ELEVATION_RAD),
            np.sin(_ELEVATION_RAD),
        ]
    )
    distance = room * 0.5 * size_m / np.tan(0.5 * FIELD_OF_VIEW_RAD)
    right = np.array([-np.sin(azimuth), np.cos(azimuth), 0.0])
    return Viewpoint(middle + distance * towards, middle, np.cross(towards, right))


def _azimuth_of(base: Placement) -> float:
    forward = base.apply(np.eye(4))[:2, 0]
    return float(np.arctan2(forward[1], forward[0]))


def _across(position_m: Array) -> float:
    """Azimuth at right angles to the main horizontal direction, on the side of +x."""
    flat = position_m[:, :2] - position_m[:, :2].mean(axis=0)
    _, axes = np.linalg.eigh(flat.T @ flat)
    side = axes[:, 0] if axes[0, 0] >= 0 else -axes[:, 0]
    return float(np.arctan2(side[1], side[0]))
