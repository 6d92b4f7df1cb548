"""What explains the path in the scene: Gaussians, forces at contact changes."""

from math import hypot

import numpy as np
import trimesh
import viser

from keyphase.demonstration import Array
from keyphase.labeling.labeling import LabeledBoundary, Labeling
from keyphase.web.scene.palette import Theme, painted, segment_color
from keyphase.web.scene.path_geometry import MOST_ARROWS, Path, arrow, ellipsoids, heaviest


def draw_gaussians(server: viser.ViserServer, labeling: Labeling, path: Path) -> None:
    """Ellipsoids of one standard deviation in position, in the colour of their segment."""
    gaussians = heaviest(labeling.segmentation.gaussians)
    if not gaussians:
        server.scene.remove_by_name("/gaussians/ellipsoids")
        return
    positions, turns, half_axes = ellipsoids(gaussians, 2.4 * path.radius_m)
    segments = [labeling.segments[labeling.segment_at(g.mean_time_s)] for g in gaussians]
    ball = trimesh.creation.icosphere(subdivisions=_roundness(len(gaussians)), radius=1.0)
    server.scene.add_batched_meshes_simple(
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


def draw_forces(server: viser.ViserServer, labeling: Labeling, path: Path, theme: Theme) -> None:
    """An arrow at each contact change: the change of force, 1 cm per N within bounds.

    Of very many the greatest changes only.
    """
    changes = sorted(labeling.boundaries, key=_change_n, reverse=True)[:MOST_ARROWS]
    found = [_force_arrow(boundary, labeling, path) for boundary in changes]
    arrows = np.array([points for points in found if points is not None])
    if len(arrows) == 0:
        server.scene.remove_by_name("/forces/arrows")
        return
    radius = path.radius_m
    server.scene.add_arrows(
        "/forces/arrows",
        arrows,
        np.array(painted(theme.origins["force"]), np.uint8),
        shaft_radius=1.2 * radius,
        head_radius=2.6 * radius,
        head_length=6 * radius,
    )


def _change_n(boundary: LabeledBoundary) -> float:
    """Size of the change of force, where the boundary is a contact change."""
    peak = boundary.automatic.peak if boundary.automatic else None
    return hypot(*peak.force_step_N) if boundary.contact_change and peak else 0.0


def _force_arrow(
    boundary: LabeledBoundary, labeling: Labeling, path: Path
) -> tuple[Array, Array] | None:
    peak = boundary.automatic.peak if boundary.automatic else None
    if not boundary.contact_change or peak is None:
        return None
    at_m = _position_m(labeling, boundary.time_s)
    return arrow(at_m, peak.force_step_N, 9 * path.radius_m, 0.45 * path.size_m)


def _position_m(labeling: Labeling, time_s: float) -> Array:
    demonstration = labeling.segmentation.demonstration
    return demonstration.position_m[demonstration.index_at(time_s)]
