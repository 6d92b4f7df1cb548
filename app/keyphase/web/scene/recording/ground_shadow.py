"""The soft shadow that a robot's feet throw on the ground.

Shadows that follow every movement halve the frames a second where 3D is drawn in software; what
stands still can throw one that was painted once.
"""

from dataclasses import dataclass

import numpy as np
import trimesh
from scipy.ndimage import gaussian_filter

from keyphase.demonstration import Array
from keyphase.robot.description import RobotDescription

SUN_M = (2.0, 1.0, 4.0)
"""Where the light comes from, seen from the origin."""

PIXEL_M = 0.01
"""A side of a cell of the shadow."""

_SOFT_M = 0.025
_POINTS = 100_000
_SEED = 0


@dataclass(frozen=True, eq=False)
class GroundShadow:
    """`cover` (H, W), 0 to 1, over a rectangle of the ground; rows along y, columns along x.

    middle_m  (2,) of the rectangle, in the frame of the robot's root; size_m  (2,) along x and y
    """

    cover: Array
    middle_m: Array
    size_m: Array


def shadow_of(robot: RobotDescription) -> GroundShadow | None:
    """What the links that cannot move throw on the ground at their root's height; None without."""
    meshes = [
        shape.mesh.copy().apply_transform(_fixed_frame(robot, shape.link) @ shape.origin)
        for shape in robot.shapes
        if _stands(robot, shape.link)
    ]
    if not meshes:
        return None
    points = np.asarray(
        trimesh.sample.sample_surface(trimesh.util.concatenate(meshes), _POINTS, seed=_SEED)[0]
    )
    return thrown(points[points[:, 2] >= 0.0])


def thrown(points_m: Array) -> GroundShadow | None:
    """The shadow of points (N, 3) at heights of zero and more; None where there are none."""
    if len(points_m) == 0:
        return None
    on_ground = points_m[:, :2] - points_m[:, 2:] * np.array(SUN_M[:2]) / SUN_M[2]
    low = on_ground.min(axis=0) - 4 * _SOFT_M
    cells = np.ceil((on_ground.max(axis=0) + 4 * _SOFT_M - low) / PIXEL_M).astype(int)
    x, y = np.floor((on_ground - low) / PIXEL_M).astype(int).T
    covered = np.zeros((cells[1], cells[0]))
    covered[y, x] = 1.0
    soft = gaussian_filter(covered, _SOFT_M / PIXEL_M)
    size = cells * PIXEL_M
    return GroundShadow(np.clip(soft, 0.0, 1.0), low + 0.5 * size, size)


def _stands(robot: RobotDescription, link: str) -> bool:
    return robot.model.frames[robot.frames[link]].parentJoint == 0


def _fixed_frame(robot: RobotDescription, link: str) -> Array:
    """(4, 4) of a link that cannot move, in the frame of the root."""
    frames = robot.model.frames
    root = frames[robot.frames[robot.root]].placement
    return (root.inverse() * frames[robot.frames[link]].placement).homogeneous
