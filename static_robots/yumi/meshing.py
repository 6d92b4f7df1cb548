"""From a signed distance to a light, smoothly shaded mesh."""

import fast_simplification
import numpy as np
import trimesh
from distance_fields import Array, Field
from skimage.measure import marching_cubes

BLOCK = 8
"""Cells along one side of a block; blocks away from the surface are not evaluated finely."""


AGREEMENT = float(np.cos(np.radians(50)))
"""A face further turned than this from a vertex's normal has no say in its shading."""
FLAT_AREA = 8e-4
"""Square metres of faces around a vertex from which on they alone decide its shading."""
MARGIN = 0.008
"""Metres around the given corners, for what the blends add."""


def mesh_of(field: Field, low: Array, high: Array, cell: float, faces: int) -> trimesh.Trimesh:
    """Surface of `field` between two corners: marching cubes of `cell` metres, then at most
    `faces` triangles, pulled back onto the surface, with vertex normals for smooth shading.
    """
    low, high = np.asarray(low) - MARGIN, np.asarray(high) + MARGIN
    values = _sampled(field, low, high, cell)
    vertices, triangles, _, _ = marching_cubes(
        values, 0.0, spacing=(cell,) * 3, gradient_direction="descent"
    )
    vertices = _onto_surface(field, vertices + low)
    if len(triangles) > faces:
        vertices, triangles = _simplified(vertices, triangles, faces)
        vertices = _onto_surface(field, vertices)
    mesh = trimesh.Trimesh(vertices, triangles, process=False)
    return trimesh.Trimesh(
        mesh.vertices, mesh.faces, vertex_normals=_shading_normals(field, mesh), process=False
    )


def _sampled(field: Field, low: Array, high: Array, cell: float) -> Array:
    blocks = np.ceil((high - low) / (cell * BLOCK)).astype(int)
    values = np.empty(blocks * BLOCK, np.float32)
    centres = _grid(low + cell * (BLOCK - 1) / 2, blocks, cell * BLOCK)
    at_centre = field(centres.reshape(-1, 3)).reshape(blocks)
    reach = 1.5 * cell * BLOCK * np.sqrt(3.0)
    for block in np.ndindex(*blocks):
        corner = np.array(block) * BLOCK
        inside = tuple(slice(c, c + BLOCK) for c in corner)
        if abs(at_centre[block]) > reach:
            values[inside] = at_centre[block]
            continue
        points = _grid(low + corner * cell, np.full(3, BLOCK), cell)
        values[inside] = field(points.reshape(-1, 3)).reshape((BLOCK,) * 3)
    return values


def _grid(start: Array, count: Array, step: float) -> Array:
    axes = [start[i] + step * np.arange(count[i]) for i in range(3)]
    return np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1)


def _simplified(vertices: Array, triangles: Array, faces: int) -> tuple[Array, Array]:
    # The simplifier stops early at low aggression, so it is asked again, harder each time.
    for aggression in (4, 6, 8, 10):
        if len(triangles) > faces * 1.02:
            vertices, triangles = fast_simplification.simplify(
                vertices, triangles, target_count=faces, agg=aggression
            )
    return vertices, triangles


def _gradient(field: Field, points: Array, step: float = 1e-4) -> Array:
    steps = np.eye(3) * step
    return np.stack([field(points + s) - field(points - s) for s in steps], axis=1) / (2 * step)


def _onto_surface(field: Field, points: Array) -> Array:
    points = np.asarray(points, float)
    for _ in range(3):
        gradient = _gradient(field, points)
        slope = np.maximum(np.sum(gradient**2, axis=1), 0.25)
        points = points - (field(points) / slope)[:, None] * gradient
    return points


def _shading_normals(field: Field, mesh: trimesh.Trimesh) -> Array:
    """The field's normals, leaning towards large flat faces so that these stay flat."""
    exact = _gradient(field, np.asarray(mesh.vertices))
    exact /= np.maximum(np.linalg.norm(exact, axis=1, keepdims=True), 1e-9)
    corners = mesh.faces.ravel()
    faces = np.repeat(mesh.face_normals, 3, axis=0)
    agrees = np.sum(exact[corners] * faces, axis=1) > AGREEMENT
    weights = np.repeat(mesh.area_faces, 3) * agrees
    normals = np.zeros_like(exact)
    np.add.at(normals, corners, weights[:, None] * faces)
    area = np.linalg.norm(normals, axis=1, keepdims=True)
    flat = np.minimum(area / FLAT_AREA, 1)
    mixed = (1 - flat) * exact + flat * normals / np.maximum(area, 1e-18)
    return mixed / np.linalg.norm(mixed, axis=1, keepdims=True)
