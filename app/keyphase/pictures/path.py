"""The path of the tool in space, each segment in its colour, with the ellipsoids of the mixture."""

from typing import Any

import numpy as np

from keyphase.demonstration import Array
from keyphase.labeling.labeling import Labeling
from keyphase.pictures.look import GRID, INK, color_of
from keyphase.segmentation.segmentation import Gaussian

_RINGS = 24


def draw_path(axes: Any, labeling: Labeling) -> None:
    """Draw on three-dimensional axes; lengths are equal along all of them, in cm."""
    demonstration = labeling.segmentation.demonstration
    place = 1e2 * demonstration.position_m
    for segment in labeling.segments:
        first, last = np.searchsorted(demonstration.time_s, (segment.start_s, segment.end_s))
        along = place[first : last + 1]
        width = 2.2 if segment.kept else 1.0
        axes.plot(*along.T, color=color_of(segment), lw=width, solid_capstyle="round")
    for gaussian in labeling.segmentation.gaussians:
        for ring in rings(gaussian):
            axes.plot(*(1e2 * ring).T, color=INK, lw=0.5, alpha=0.35)
    rows = [demonstration.index_at(boundary.time_s) for boundary in labeling.boundaries]
    if rows:
        axes.scatter(*place[rows].T, color=INK, s=14, depthshade=False, zorder=5)
    _equal(axes, place)


def rings(gaussian: Gaussian) -> tuple[Array, ...]:
    """Three rings (24, 3) [m] of the ellipsoid at one standard deviation, about its main axes."""
    values, vectors = np.linalg.eigh(gaussian.covariance_m2)
    axes = vectors * np.sqrt(np.maximum(values, 0.0))
    turn = np.linspace(0.0, 2 * np.pi, _RINGS)
    return tuple(
        gaussian.mean_position_m
        + np.outer(np.cos(turn), axes[:, i])
        + np.outer(np.sin(turn), axes[:, j])
        for i, j in ((0, 1), (0, 2), (1, 2))
    )


def _equal(axes: Any, place: Array) -> None:
    low, high = place.min(axis=0), place.max(axis=0)
    middle, half = (low + high) / 2, max(float((high - low).max()) / 2, 0.1)
    for name, at in zip("xyz", middle.tolist(), strict=True):
        getattr(axes, f"set_{name}lim")(at - half, at + half)
        getattr(axes, f"set_{name}label")(f"{name} [cm]", fontsize=8)
        axis = getattr(axes, f"{name}axis")
        axis.pane.set_facecolor("white")
        axis.pane.set_edgecolor(GRID)
        axis.line.set_color(GRID)
    axes.set_box_aspect((1, 1, 1), zoom=0.86)
    axes.tick_params(labelsize=7, pad=0)
    axes.grid(visible=False)
    axes.view_init(elev=22, azim=-60)
