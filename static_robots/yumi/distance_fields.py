"""Signed distances from which the shells are modelled: primitives, smooth unions and grooves.

A `Field` maps points (n, 3) in metres to distances (n,), negative inside. Distances of blended
shapes are bounds rather than exact, which is all that meshing needs.
"""

from collections.abc import Callable, Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

Array = NDArray[np.float64]
Field = Callable[[Array], Array]


def round_cone(start: ArrayLike, end: ArrayLike, start_radius: float, end_radius: float) -> Field:
    """Capsule whose radius runs from one end to the other."""
    a, along = np.asarray(start, float), np.subtract(end, start)

    def field(points: Array) -> Array:
        share = np.clip((points - a) @ along / (along @ along), 0, 1)
        radius = start_radius + (end_radius - start_radius) * share
        return np.linalg.norm(points - a - share[:, None] * along, axis=1) - radius

    return field


def cylinder(
    start: ArrayLike, end: ArrayLike, radius: float, rim: float, end_radius: float | None = None
) -> Field:
    """Cylinder or frustum between two points, its rims rounded with radius `rim`."""
    a, along = np.asarray(start, float), np.subtract(end, start)
    length = float(np.linalg.norm(along))
    axis = along / length
    growth = ((radius if end_radius is None else end_radius) - radius) / length

    def field(points: Array) -> Array:
        height = (points - a) @ axis
        out = np.linalg.norm(points - a - height[:, None] * axis, axis=1)
        beyond_side = out - (radius + growth * np.clip(height, 0, length) - rim)
        beyond_end = np.abs(height - length / 2) - (length / 2 - rim)
        return _corner(beyond_side, beyond_end) - rim

    return field


def box(centre: ArrayLike, half: ArrayLike, edge: float) -> Field:
    """Axis-aligned box with rounded edges."""
    c, inner = np.asarray(centre, float), np.asarray(half, float) - edge

    def field(points: Array) -> Array:
        beyond = np.abs(points - c) - inner
        outside = np.linalg.norm(np.maximum(beyond, 0), axis=1)
        return np.minimum(beyond.max(axis=1), 0) + outside - edge

    return field


def ellipsoid(centre: ArrayLike, half: ArrayLike) -> Field:
    """Ellipsoid along the axes; a first-order distance."""
    c, h = np.asarray(centre, float), np.asarray(half, float)

    def field(points: Array) -> Array:
        level = np.linalg.norm((points - c) / h, axis=1)
        slope = np.linalg.norm((points - c) / h**2, axis=1)
        return level * (level - 1) / np.maximum(slope, 1e-9)

    return field


def prism(
    core: Sequence[tuple[float, float]],
    side: tuple[float, float],
    edge: float,
    width: Callable[[Array], Array] | None = None,
) -> Field:
    """Polygon `core` in x and z, grown by `edge`, between two values of y.

    `width` scales y by a factor per point: a waist or a taper.
    """
    middle, half = (side[0] + side[1]) / 2, (side[1] - side[0]) / 2

    def field(points: Array) -> Array:
        beyond_profile = polygon_distance(points[:, [0, 2]], core)
        y = points[:, 1] if width is None else points[:, 1] / width(points)
        beyond_side = np.abs(y - middle) - (half - edge)
        return _corner(beyond_profile, beyond_side) - edge

    return field


def polygon_distance(points: Array, corners: Sequence[tuple[float, float]]) -> Array:
    """Signed distance of points (n, 2) to a simple polygon, negative inside."""
    starts = np.asarray(corners, float)
    nearest = np.full(len(points), np.inf)
    inside = np.zeros(len(points), bool)
    for a, b in zip(starts, np.roll(starts, -1, axis=0), strict=True):
        along, offset = b - a, points - a
        share = np.clip(offset @ along / (along @ along), 0, 1)
        nearest = np.minimum(nearest, np.linalg.norm(offset - share[:, None] * along, axis=1))
        if a[1] != b[1]:
            spans = (a[1] <= points[:, 1]) != (b[1] <= points[:, 1])
            inside ^= spans & (offset[:, 0] < along[0] * offset[:, 1] / along[1])
    return np.where(inside, -nearest, nearest)


def half_space(axis: int, limit: float) -> Field:
    """All points whose coordinate `axis` lies below `limit`."""
    return lambda points: points[:, axis] - limit


def union(*fields: Field, blend: float = 0.0) -> Field:
    """All of the fields, their meeting edges filled smoothly over the width `blend`."""
    return lambda points: _smallest([field(points) for field in fields], blend)


def cut(field: Field, *tools: Field, blend: float = 0.0) -> Field:
    """`field` without the tools, the new edges smoothed over the width `blend`."""

    def remaining(points: Array) -> Array:
        return -_smallest([-field(points), *(tool(points) for tool in tools)], blend)

    return remaining


def _smallest(distances: list[Array], blend: float) -> Array:
    result = distances[0]
    for distance in distances[1:]:
        near = np.zeros_like(result)
        if blend > 0:
            near = np.maximum(blend - np.abs(result - distance), 0) / blend
        result = np.minimum(result, distance) - near**3 * blend / 6
    return result


def _corner(first: Array, second: Array) -> Array:
    inside = np.minimum(np.maximum(first, second), 0)
    return inside + np.hypot(np.maximum(first, 0), np.maximum(second, 0))
