"""The 3D scene: the path coloured by segment, Gaussians, contact changes, names, the playhead.

It holds no logic: it draws what it is told and reports clicks. A document of the same recording
changes colours and few small things; only another recording builds the scene anew.
"""

from collections.abc import Callable, Iterator

import numpy as np
import viser
from numpy.typing import NDArray

from keyphase.labeling.labeling import Labeling
from keyphase.web.opened import Opened
from keyphase.web.palette import DARK, LIGHT, segment_color
from keyphase.web.path_geometry import (
    Path,
    arrow,
    ellipsoids,
    path_of,
    piece_scales,
    tube,
    view_of,
)
from keyphase.web.playback import Playhead
from keyphase.web.session import PARTS
from keyphase.web.views import View

MOST_NAMES = 12
"""With more segments than this only the selected one is named in the scene."""


class Scene(View):
    """viser's scene for one session."""

    def __init__(self, server: viser.ViserServer, on_click: Callable[[float], None]) -> None:
        self._server = server
        self._on_click = on_click
        self._opened: Opened | None = None
        self._path: Path | None = None
        self._pieces: viser.BatchedMeshHandle | None = None
        self._segment_of_piece: NDArray[np.intp] = np.zeros(0, np.intp)
        self._drawn_gaussians: object = None
        self._selected: int | None = None
        self._playhead = Playhead()
        self._theme = LIGHT
        self._hidden: frozenset[str] = frozenset()
        self._frame: viser.FrameHandle | None = None
        self._light()

    def show_document(self, opened: Opened) -> None:
        """Draw what the document of the current recording has become."""
        with self._server.atomic():
            if self._opened is None or self._opened.demonstration is not opened.demonstration:
                self._build(opened)
            self._opened = opened
            self._color_pieces()
            self._draw_gaussians()
            self._draw_contacts()
            self._draw_names()
        self._server.flush()

    def show_selection(self, segment: int | None) -> None:
        """Draw the selected segment thicker."""
        self._selected = segment
        if self._opened is not None:
            self._thicken_selected()
            self._draw_names()
            self._server.flush()

    def show_playhead(self, playhead: Playhead) -> None:
        """Put the frame where the tool was."""
        self._playhead = playhead
        if self._opened is None or self._frame is None:
            return
        demonstration = self._opened.demonstration
        index = demonstration.index_at(playhead.time_s)
        with self._server.atomic():
            self._frame.position = demonstration.position_m[index]
            if demonstration.orientation_wxyz is not None:
                self._frame.wxyz = demonstration.orientation_wxyz[index]

    def show_parts(self, hidden: frozenset[str]) -> None:
        """Hide these parts and show the others."""
        self._hidden = hidden
        for part in PARTS:
            self._server.scene.add_frame(f"/{part}", show_axes=False, visible=part not in hidden)

    def show_theme(self, dark: bool) -> None:
        """Draw light or dark."""
        self._theme = DARK if dark else LIGHT
        self._light()
        if self._opened is not None and self._path is not None:
            self._draw_ground()
            self._draw_contacts()
            self._draw_names()

    # -- building

    def _light(self) -> None:
        self._server.gui.configure_theme(
            dark_mode=self._theme is DARK,
            show_logo=False,
            show_share_button=False,
            brand_color=self._theme.accent,
        )
        self._server.scene.configure_default_lights(cast_shadow=False)

    def _build(self, opened: Opened) -> None:
        self._clear()
        self.show_parts(self._hidden)
        self._opened = opened
        self._path = path_of(opened.demonstration)
        self._drawn_gaussians = None
        self._draw_ground()
        self._draw_path(self._path)
        size = self._path.size_m
        self._frame = self._server.scene.add_frame(
            "/frame/tool", axes_length=0.16 * size, axes_radius=0.5 * self._path.radius_m
        )
        self.show_playhead(self._playhead)
        self._look(opened)

    def _clear(self) -> None:
        for part in PARTS:
            self._server.scene.remove_by_name(f"/{part}")

    def _draw_ground(self) -> None:
        assert self._opened is not None
        assert self._path is not None
        position, size = self._opened.demonstration.position_m, self._path.size_m
        x, y = 0.5 * (position.min(axis=0) + position.max(axis=0))[:2]
        cell = _round_length(size / 4)
        self._server.scene.add_grid(
            "/grid/ground",
            width=40 * cell,
            height=40 * cell,
            cell_size=cell,
            section_size=5 * cell,
            cell_color=self._theme.cell,
            section_color=self._theme.section,
            plane_color=self._theme.ground,
            plane_opacity=1.0,
            fade_distance=60 * cell,
            position=(x, y, float(position[:, 2].min()) - 0.1 * size),
        )

    def _draw_path(self, path: Path) -> None:
        vertices, faces = tube()
        pieces = self._server.scene.add_batched_meshes_simple(
            "/path/pieces",
            vertices,
            faces,
            path.wxyz,
            path.middle_m,
            batched_scales=piece_scales(path, np.zeros(len(path.time_s), np.intp), None),
            lod="off",
            side="double",
            cast_shadow=False,
            receive_shadow=False,
        )
        self._pieces = pieces

        @pieces.on_click
        def _(event: viser.SceneNodePointerEvent[viser.BatchedMeshHandle]) -> None:
            if event.instance_index is not None and event.instance_index < len(path.time_s):
                self._on_click(float(path.time_s[event.instance_index]))

    def _look(self, opened: Opened) -> None:
        from_m, at_m = view_of(opened.demonstration.position_m)
        camera = self._server.initial_camera
        camera.position, camera.look_at = from_m, at_m
        for client in self._server.get_clients().values():
            with client.atomic():
                client.camera.position, client.camera.look_at = from_m, at_m

    # -- what a document changes

    def _color_pieces(self) -> None:
        assert self._opened is not None
        assert self._path is not None
        assert self._pieces is not None
        labeling = self._opened.labeling
        cuts = np.array([boundary.time_s for boundary in labeling.boundaries])
        self._segment_of_piece = np.searchsorted(cuts, self._path.time_s, side="right")
        colors = np.array([segment_color(s.color, s.kept) for s in labeling.segments], np.uint8)
        self._pieces.batched_colors = colors[self._segment_of_piece]
        if self._selected is not None:
            self._thicken_selected()

    def _thicken_selected(self) -> None:
        assert self._path is not None
        assert self._pieces is not None
        self._pieces.batched_scales = piece_scales(
            self._path, self._segment_of_piece, self._selected
        ).astype(np.float32)

    def _draw_gaussians(self) -> None:
        assert self._opened is not None
        assert self._path is not None
        labeling = self._opened.labeling
        gaussians = labeling.segmentation.gaussians
        if not gaussians:
            self._server.scene.remove_by_name("/gaussians/ellipsoids")
            return
        positions, turns, half_axes = ellipsoids(gaussians, 1.3 * self._path.radius_m)
        segments = [labeling.segments[labeling.segment_at(g.mean_time_s)] for g in gaussians]
        vertices, faces = _sphere()
        self._server.scene.add_batched_meshes_simple(
            "/gaussians/ellipsoids",
            vertices,
            faces,
            turns,
            positions,
            batched_scales=half_axes,
            batched_colors=np.array([segment_color(s.color, s.kept) for s in segments], np.uint8),
            opacity=0.25,
            lod="off",
            cast_shadow=False,
            receive_shadow=False,
        )

    def _draw_contacts(self) -> None:
        assert self._opened is not None
        assert self._path is not None
        arrows, colors = self._arrows(self._opened.labeling)
        if len(arrows) == 0:
            self._server.scene.remove_by_name("/forces/arrows")
            return
        radius = self._path.radius_m
        self._server.scene.add_arrows(
            "/forces/arrows",
            arrows,
            colors,
            shaft_radius=1.2 * radius,
            head_radius=2.6 * radius,
            head_length=6 * radius,
        )

    def _arrows(self, labeling: Labeling) -> tuple[NDArray[np.float64], NDArray[np.uint8]]:
        assert self._path is not None
        demonstration = labeling.segmentation.demonstration
        shortest, longest = 9 * self._path.radius_m, 0.6 * self._path.size_m
        found, colors = [], []
        for boundary in labeling.boundaries:
            peak = boundary.automatic.peak if boundary.automatic else None
            if not boundary.contact_change or peak is None:
                continue
            at_m = demonstration.position_m[demonstration.index_at(boundary.time_s)]
            drawn = arrow(at_m, peak.force_step_N, shortest, longest)
            if drawn is not None:
                found.append(drawn)
                colors.append(self._theme.origins["force"])
        return np.array(found), np.array(colors, np.uint8)

    def _draw_names(self) -> None:
        self._server.scene.remove_by_name("/labels/names")
        assert self._opened is not None
        assert self._path is not None
        self._server.scene.add_frame("/labels/names", show_axes=False)
        lines = []
        for number, (text, at_m, name_at_m) in enumerate(self._names()):
            self._server.scene.add_label(
                f"/labels/names/{number}", text, position=name_at_m, anchor="center-left"
            )
            lines.append((at_m, name_at_m))
        if lines:
            self._server.scene.add_line_segments(
                "/labels/names/leaders",
                np.array(lines),
                np.array(self._theme.leader, np.uint8),
                thickness=1.0,
                thickness_units="screen",
            )

    def _names(self) -> Iterator[tuple[str, NDArray[np.float64], NDArray[np.float64]]]:
        """Text, what it names and where it stands, of each name in the scene."""
        assert self._opened is not None
        assert self._path is not None
        labeling = self._opened.labeling
        demonstration = labeling.segmentation.demonstration
        kept = [i for i, segment in enumerate(labeling.segments) if segment.kept]
        shown = kept if len(kept) <= MOST_NAMES else []
        if self._selected is not None and self._selected not in shown:
            shown = [*shown, self._selected]
        for index in shown:
            segment = labeling.segments[index]
            at_m = demonstration.position_m[demonstration.index_at(segment.middle_s)]
            yield (
                f"{index + 1} {segment.label}",
                at_m,
                at_m + np.array([0.0, 0.12, 0.06]) * self._path.size_m,
            )


def _sphere() -> tuple[NDArray[np.float64], NDArray[np.int64]]:
    import trimesh

    ball = trimesh.creation.icosphere(subdivisions=3, radius=1.0)
    return np.asarray(ball.vertices), np.asarray(ball.faces)


def _round_length(length_m: float) -> float:
    """The nearest of 1, 2 and 5 times a power of ten."""
    steps = np.array([1.0, 2.0, 5.0, 10.0]) * 10.0 ** np.floor(np.log10(length_m))
    return float(steps[np.argmin(np.abs(np.log(steps / length_m)))])
