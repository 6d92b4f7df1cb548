"""The path in the scene: a tube in the colours of the segments that can be clicked."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
import trimesh
import viser
from numpy.typing import NDArray

from keyphase.labeling.labeling import Labeling
from keyphase.web.scene.palette import painted, segment_color
from keyphase.web.scene.path_geometry import MOST_PIECES, Path, bent, tube

_SELECTED = 1.7


class ScenePath:
    """The whole path, and over it the selected segment thicker. `on_click` is told a time."""

    def __init__(
        self, server: viser.ViserServer, path: Path, on_click: Callable[[float], None]
    ) -> None:
        self._server = server
        self._path = path
        self._on_click = on_click
        self._color_of_piece = np.zeros((len(path.time_s), 3), np.uint8)
        self._segment_of_piece = np.zeros(len(path.time_s), np.intp)
        self._selected: int | None = None
        self._shown: tuple[object, ...] = ()
        self._tube = self._add("/path", path.drawn, path.radius_m)

    def color(self, labeling: Labeling) -> None:
        """Give each piece the colour of its segment."""
        cuts = np.array([boundary.time_s for boundary in labeling.boundaries])
        self._segment_of_piece = np.searchsorted(cuts, self._path.time_s, side="left")
        colors = np.array(
            [painted(segment_color(s.color, s.kept)) for s in labeling.segments], np.uint8
        )
        self._color_of_piece = colors[self._segment_of_piece]
        self._tube.paint(self._color_of_piece)
        self._draw_selected()

    def select(self, segment: int | None) -> None:
        """Draw a segment thicker."""
        if segment != self._selected:
            self._selected = segment
            self._draw_selected()

    def _draw_selected(self) -> None:
        """All of the selected segment, whatever of it was left out of the whole path."""
        chosen = np.flatnonzero(self._segment_of_piece == self._selected)
        chosen = chosen[:: -(-len(chosen) // MOST_PIECES)] if len(chosen) else chosen
        shown = (chosen.tobytes(), self._color_of_piece[chosen[:1]].tobytes())
        if shown == self._shown:
            return
        self._shown = shown
        self._server.scene.remove_by_name("/path/selected")
        if len(chosen):
            thick = self._add("/path/selected", chosen, _SELECTED * self._path.radius_m)
            thick.paint(self._color_of_piece)

    def _add(self, name: str, chosen: NDArray[np.intp], radius_m: float) -> "_Tube":
        tube = _tube_of(self._server, name, self._path, chosen, radius_m)
        time_s = self._path.time_s[chosen]

        @tube.pieces.on_click
        def _(event: viser.SceneNodePointerEvent[viser.BatchedMeshHandle]) -> None:
            index = event.instance_index
            if index is not None and 0 <= index < len(time_s):
                self._on_click(float(time_s[index]))

        return tube


@dataclass(frozen=True, eq=False)
class _Tube:
    """Two batches: straight pieces, and balls at its ends and wherever it bends.

    chosen  (D,) which pieces of the path these are
    joined  (J,) the piece of the path that each ball takes its colour from
    """

    pieces: viser.BatchedMeshHandle
    joints: viser.BatchedMeshHandle
    chosen: NDArray[np.intp]
    joined: NDArray[np.intp]

    def paint(self, color_of_piece: NDArray[np.uint8]) -> None:
        """Take the colours (M, 3) of the path's pieces."""
        self.pieces.batched_colors = color_of_piece[self.chosen]
        self.joints.batched_colors = color_of_piece[self.joined]


def _tube_of(
    server: viser.ViserServer, name: str, path: Path, chosen: NDArray[np.intp], radius_m: float
) -> _Tube:
    scales = np.full((len(chosen), 3), radius_m, np.float32)
    scales[:, 2] = path.length_m[chosen]
    pieces = _batch(
        server, f"{name}/pieces", tube(), path.wxyz[chosen], path.middle_m[chosen], scales
    )
    ends, joined = _joints(path, chosen)
    upright = np.tile([1.0, 0.0, 0.0, 0.0], (len(ends), 1))
    radii = np.full(len(ends), radius_m, np.float32)
    ball = _ball(len(ends))
    joints = _batch(server, f"{name}/joints", ball, upright, path.position_m[ends], radii)
    return _Tube(pieces, joints, chosen, joined)


def _joints(path: Path, chosen: NDArray[np.intp]) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
    """Points of the path that need a ball, and for each the piece it belongs to."""
    directions = np.diff(path.position_m, axis=0)[chosen]
    breaks = np.diff(chosen) != 1
    bends = bent(directions)
    starts = chosen[np.concatenate([[True], breaks])]
    after = chosen[np.concatenate([breaks | bends, [True]])]
    return np.concatenate([starts, after + 1]), np.concatenate([starts, after])


def _batch(
    server: viser.ViserServer,
    name: str,
    shape: tuple[NDArray[np.float64], NDArray[np.uint32]],
    wxyz: NDArray[np.float64],
    position_m: NDArray[np.float64],
    scales: NDArray[np.float32],
) -> viser.BatchedMeshHandle:
    vertices, faces = shape
    return server.scene.add_batched_meshes_simple(
        name,
        vertices,
        faces,
        wxyz,
        position_m,
        batched_scales=scales,
        batched_colors=np.zeros((len(position_m), 3), np.uint8),
        lod="off",
        cast_shadow=False,
        receive_shadow=False,
    )


def _ball(count: int) -> tuple[NDArray[np.float64], NDArray[np.uint32]]:
    """Round; where there are very many, so that they can still be drawn, a little less."""
    ball = trimesh.creation.icosphere(subdivisions=2 if count <= 150 else 1, radius=1.0)
    return np.asarray(ball.vertices), np.asarray(ball.faces, np.uint32)
