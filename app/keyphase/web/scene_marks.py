"""What explains the path in the scene: Gaussians, forces at contact changes, names."""

from collections.abc import Sequence

import numpy as np
import trimesh
import viser

from keyphase.demonstration import Array
from keyphase.labeling.labeling import LabeledBoundary, Labeling
from keyphase.web.palette import Theme, painted, segment_color
from keyphase.web.path_geometry import Path, arrow, ellipsoids
from keyphase.web.viewpoint import Viewpoint, placed

MOST_NAMES = 12
"""With more names than this only the selected segment is named in the scene."""


def draw_gaussians(server: viser.ViserServer, labeling: Labeling, path: Path) -> None:
    """Ellipsoids of one standard deviation in position, in the colour of their segment."""
    gaussians = labeling.segmentation.gaussians
    if not gaussians:
        server.scene.remove_by_name("/gaussians/ellipsoids")
        return
    positions, turns, half_axes = ellipsoids(gaussians, 1.8 * path.radius_m)
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
        opacity=0.28,
        lod="off",
        cast_shadow=False,
        receive_shadow=False,
    )


def _roundness(count: int) -> int:
    """Thousands of ellipsoids are small in the view: fewer faces each, or no frame would end."""
    return 3 if count <= 60 else 2 if count <= 300 else 1


def draw_forces(server: viser.ViserServer, labeling: Labeling, path: Path, theme: Theme) -> None:
    """An arrow at each contact change: the change of force, 1 cm per N within bounds."""
    found = [_force_arrow(boundary, labeling, path) for boundary in labeling.boundaries]
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


def _force_arrow(
    boundary: LabeledBoundary, labeling: Labeling, path: Path
) -> tuple[Array, Array] | None:
    peak = boundary.automatic.peak if boundary.automatic else None
    if not boundary.contact_change or peak is None:
        return None
    at_m = _position_m(labeling, boundary.time_s)
    return arrow(at_m, peak.force_step_N, 9 * path.radius_m, 0.45 * path.size_m)


def draw_names(
    server: viser.ViserServer,
    labeling: Labeling,
    view: Viewpoint,
    selected: int | None,
    theme: Theme,
) -> None:
    """Names of segments and times of contact changes, each with a line to what it is about."""
    server.scene.remove_by_name("/labels/names")
    names = placed(_names(labeling, selected), view)
    if not names:
        return
    server.scene.add_frame("/labels/names", show_axes=False)
    for number, name in enumerate(names):
        anchor = "center-left" if name.side == "right" else "center-right"
        server.scene.add_label(
            f"/labels/names/{number}", name.text, position=name.at_m, anchor=anchor
        )
    server.scene.add_line_segments(
        "/labels/names/leaders",
        np.array([(name.about_m, name.at_m) for name in names]),
        np.array(theme.leader, np.uint8),
        thickness=1.0,
        thickness_units="screen",
    )


def _names(labeling: Labeling, selected: int | None) -> Sequence[tuple[str, Array]]:
    contacts = [
        (f"contact change {boundary.time_s:.3f} s", _position_m(labeling, boundary.time_s))
        for boundary in labeling.boundaries
        if boundary.contact_change
    ]
    kept = [index for index, segment in enumerate(labeling.segments) if segment.kept]
    if len(kept) + len(contacts) > MOST_NAMES:
        contacts = []
    if len(kept) > MOST_NAMES:
        kept = []
    shown = sorted({*kept, selected}) if selected is not None else kept
    return contacts + [
        (
            f"{index + 1} {labeling.segments[index].label}",
            _position_m(labeling, labeling.segments[index].middle_s),
        )
        for index in shown
        if index < len(labeling.segments)
    ]


def _position_m(labeling: Labeling, time_s: float) -> Array:
    demonstration = labeling.segmentation.demonstration
    return demonstration.position_m[demonstration.index_at(time_s)]
