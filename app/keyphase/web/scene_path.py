"""The path in the scene: a tube in the colours of the segments that can be clicked."""

from collections.abc import Callable

import numpy as np
import trimesh
import viser
from numpy.typing import NDArray

from keyphase.labeling.labeling import Labeling
from keyphase.web.palette import painted, segment_color
from keyphase.web.path_geometry import Path, tube

_SELECTED = 1.7


class ScenePath:
    """Two batches: straight pieces, and balls where they meet. `on_click` is told a time."""

    def __init__(
        self, server: viser.ViserServer, path: Path, on_click: Callable[[float], None]
    ) -> None:
        self._path = path
        self._segment_of_piece = np.zeros(len(path.time_s), np.intp)
        self._selected: int | None = None
        self._pieces = _batch(server, "/path/pieces", tube(), path.wxyz, path.middle_m)
        upright = np.tile([1.0, 0.0, 0.0, 0.0], (len(path.position_m), 1))
        self._joints = _batch(server, "/path/joints", _ball(len(upright)), upright, path.position_m)
        self._scale()

        @self._pieces.on_click
        def _(event: viser.SceneNodePointerEvent[viser.BatchedMeshHandle]) -> None:
            index = event.instance_index
            if index is not None and 0 <= index < len(path.time_s):
                on_click(float(path.time_s[index]))

    def color(self, labeling: Labeling) -> None:
        """Give each piece the colour of its segment."""
        cuts = np.array([boundary.time_s for boundary in labeling.boundaries])
        self._segment_of_piece = np.searchsorted(cuts, self._path.time_s, side="left")
        colors = np.array(
            [painted(segment_color(s.color, s.kept)) for s in labeling.segments], np.uint8
        )
        of_piece = colors[self._segment_of_piece]
        self._pieces.batched_colors = of_piece
        self._joints.batched_colors = np.concatenate([of_piece[:1], of_piece])
        if self._selected is not None:
            self._scale()

    def select(self, segment: int | None) -> None:
        """Draw a segment thicker."""
        if segment != self._selected:
            self._selected = segment
            self._scale()

    def _scale(self) -> None:
        radius = np.full(len(self._path.time_s), self._path.radius_m)
        if self._selected is not None:
            radius[self._segment_of_piece == self._selected] *= _SELECTED
        scales = np.stack([radius, radius, self._path.length_m], axis=1)
        self._pieces.batched_scales = scales.astype(np.float32)
        self._joints.batched_scales = np.concatenate([radius[:1], radius]).astype(np.float32)


def _batch(
    server: viser.ViserServer,
    name: str,
    shape: tuple[NDArray[np.float64], NDArray[np.uint32]],
    wxyz: NDArray[np.float64],
    position_m: NDArray[np.float64],
) -> viser.BatchedMeshHandle:
    vertices, faces = shape
    return server.scene.add_batched_meshes_simple(
        name,
        vertices,
        faces,
        wxyz,
        position_m,
        batched_scales=np.ones((len(position_m), 3), np.float32)
        if name.endswith("pieces")
        else np.ones(len(position_m), np.float32),
        batched_colors=np.zeros((len(position_m), 3), np.uint8),
        lod="off",
        cast_shadow=False,
        receive_shadow=False,
    )


def _ball(count: int) -> tuple[NDArray[np.float64], NDArray[np.uint32]]:
    """Round; where there are very many, so that they can still be drawn, a little less."""
    ball = trimesh.creation.icosphere(subdivisions=2 if count <= 1000 else 1, radius=1.0)
    return np.asarray(ball.vertices), np.asarray(ball.faces, np.uint32)
