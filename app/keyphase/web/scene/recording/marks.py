"""What explains the path in the scene: Gaussians, forces at contact changes."""

from math import hypot, inf

import numpy as np
import trimesh
import viser

from keyphase.demonstration import Array
from keyphase.labeling.labeling import LabeledBoundary, Labeling
from keyphase.web.scene.palette import Theme, painted, segment_color
from keyphase.web.scene.recording.path_geometry import (
    MAX_ARROW,
    MAX_ARROWS,
    Path,
    arrow,
    ellipsoids,
    heaviest,
)
from keyphase.workbench.showing.force_steps import force_step

EVER = (-inf, inf)
"""From when to when [s]: all of a recording."""


def draw_gaussians(
    client: viser.ClientHandle,
    labeling: Labeling,
    path: Path,
    in_view: tuple[float, float] = EVER,
) -> None:
    """Ellipsoids of one standard deviation in position, in the colour of their segment."""
    found = labeling.segmentation.gaussians
    gaussians = heaviest([g for g in found if in_view[0] <= g.mean_time_s <= in_view[1]])
    if not gaussians:
        client.scene.remove_by_name("/gaussians/ellipsoids")
        return
    positions, turns, half_axes = ellipsoids(gaussians, 2.4 * path.radius_m)
    segments = [labeling.segments[labeling.segment_at(g.mean_time_s)] for g in gaussians]
    ball = trimesh.creation.icosphere(subdivisions=_roundness(len(gaussians)), radius=1.0)
    client.scene.add_batched_meshes_simple(
        "/gaussians/ellipsoids",
        np.asarray(ball.vertices),
        np.asarray(ball.faces),
        turns,
        positions,
        batched_scales=half_axes,
        batched_colors=np.array(
            [painted(segment_color(s.color, s.kept)) for s in segments], np.uint8
        ),
        opacity=0.34,
        lod="off",
        cast_shadow=False,
        receive_shadow=False,
    )


def _roundness(count: int) -> int:
    """Many ellipsoids have fewer faces each, or no frame would end."""
    return 3 if count <= 20 else 2


def draw_forces(
    client: viser.ClientHandle,
    labeling: Labeling,
    path: Path,
    theme: Theme,
    selected: tuple[int, int] | None = None,
    in_view: tuple[float, float] = EVER,
) -> None:
    """An arrow at each contact change: the change of force, the greatest a third of the path.

    With segments selected only those at their ends; of very many the greatest only. What is in view
    changes no arrow's length.
    """
    found = [(one, force_step(one, labeling)) for one in labeling.boundaries]
    steps = [(hypot(*step), one, step) for one, step in found if step is not None]
    steps = sorted(steps, key=lambda one: -one[0])[:MAX_ARROWS]
    scale = MAX_ARROW * path.size_m / max(steps[0][0] if steps else 0.0, 1e-9)
    pointed = [
        arrow(_position_m(labeling, one.time_s), step, scale, 6 * path.radius_m)
        for _, one, step in steps
        if in_view[0] <= one.time_s <= in_view[1]
        and (selected is None or _ends(one, labeling, selected))
    ]
    arrows = np.array([points for points in pointed if points is not None])
    if len(arrows) == 0:
        client.scene.remove_by_name("/forces/arrows")
        return
    radius = path.radius_m
    client.scene.add_arrows(
        "/forces/arrows",
        arrows,
        np.array(painted(theme.origins["force"]), np.uint8),
        shaft_radius=0.7 * radius,
        head_radius=1.7 * radius,
        head_length=4.5 * radius,
    )


def _ends(boundary: LabeledBoundary, labeling: Labeling, stretch: tuple[int, int]) -> bool:
    """Whether a boundary is at an end of one of the segments from the first to the last."""
    chosen = labeling.segments[stretch[0] : stretch[1] + 1]
    return bool(chosen) and chosen[0].start_s <= boundary.time_s <= chosen[-1].end_s


def _position_m(labeling: Labeling, time_s: float) -> Array:
    demonstration = labeling.segmentation.demonstration
    return demonstration.position_m[demonstration.index_at(time_s)]
